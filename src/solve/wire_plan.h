// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_plan.h
/// What refused wires are stepped with. Let d be the vector between an element's ends at the half
/// step before, d₊ that at the one after, l₀ its length at rest.
///
/// *Stiffness.* The tension T behind K = (T/l)(E − nnᵀ) becomes what the refused step has brought
/// about, and then K acts with h² in full on the velocity after the step, with no share before it.
///
/// *Bound.* At last the element pulls with k (d₊ − l₀ d/|d|): the gradient of k/2 |d₊ − l₀ d/|d||²,
/// which is V at d and nowhere below it. It is quadratic and convex, and its force is that at the
/// end of the step, so the wire cannot gain (docs/theory/wires.md); a slack one, which may end
/// taut, pulls with k (d₊ − d). The row itself gives way.

#include "context/context.h"

namespace hawser::stepper {

/// What refused wires are to be solved with next, from the solution that was refused.
void plan_wires(Model& model, const Before& kept, std::int32_t wire) noexcept;

/// Write what refused wires are stepped with over what evaluate() wrote, of one strip.
void replan_wires(Model& model, const assembly::View& v, int strip) noexcept;

/// Multipliers and states of elements that gave way, once their losses are counted.
void settle_wires(StepContext& ctx) noexcept;

/// Elastic energy of an element at the half step before the poses at hand [J].
[[nodiscard]] double held_by_element(const assembly::View& v, std::int32_t id) noexcept;

}  // namespace hawser::stepper
