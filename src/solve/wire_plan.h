// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_plan.h
/// Laws for steps with rejected wires.
///
/// Let d be the vector between an element's ends half a step before, d₊ the one half a step after,
/// and l₀ the rest length.
///
/// *Stiffness.* The tension T in K = (T/l)(E − nnᵀ) becomes that of the rejected step. K then acts
/// with h² in full on the velocity after the step, without a part before it.
///
/// *Bound.* In the last repeats the element pulls with k (d₊ − l₀ d/|d|), the gradient of k/2 |d₊ −
/// l₀ d/|d||². This function equals V at d and is nowhere below V. It is quadratic and convex, and
/// its force is that at the end of the step. The wire therefore cannot gain energy
/// (docs/theory/wires.md). A slack element that may become taut pulls with k (d₊ − d). The row
/// itself is inactive.

#include "context/context.h"

namespace hawser::solve {

/// Choose the replacement laws for the elements of a rejected wire, from the rejected solution.
void plan_wires(context::Model& model, const context::Before& kept, std::int32_t wire) noexcept;

/// Overwrite the rows of rejected wires in one row block by their replacement laws. Call after
/// evaluate_block().
void replan_wires(context::Model& model, const assembly::View& v, int strip) noexcept;

/// Set multipliers and states of elements with a replacement law, after the losses of their rows
/// have been counted.
void settle_wires(context::StepContext& ctx) noexcept;

/// Return the elastic energy of an element at the half step before the current poses [J].
[[nodiscard]] double elastic_energy_of_element(const assembly::View& v, std::int32_t id) noexcept;

}  // namespace hawser::solve
