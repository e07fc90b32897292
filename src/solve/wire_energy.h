// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_energy.h
/// What wires gained in a step. At a half step, where velocities live, an element holds
/// V(d) = k/2 (|d| − l₀)², none of it where it is slack and only pulls; in the step it gives the
/// bodies at its ends p·w̄, its impulse times their mean relative velocity. What it holds more
/// afterwards and what it gave are together energy out of nothing, whatever else acts on the
/// bodies.
///
/// **Wires that may touch** (a lump has a shape) leave out the part along the rows. For an element
/// that moves along its direction only, SPOOK's law (docs/theory/step.md) gives
/// ```
///   gain = −h k τ w₊ (w + w₊)/2        w, w₊ its rate before and after the step
/// ```
/// plus ½ k (h w/2)² if it was slack and comes taut: of either sign, up to a thousand times the
/// kinetic energy of a stiff element, and gone within steps, since the damping τ = 2h is beyond
/// critical. The ledger books it as damped (losses.h). A line that slides on a deck and comes taut
/// was refused for it in step after step; the bound of wire_plan.cpp then turned it into speeds
/// along the line, which the bound keeps, and which were refused again.

#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

/// Mark wires whose swing the step does not resolve. @return whether there are any.
[[nodiscard]] bool find_fast_wires(Model& model, const Before& kept) noexcept;

/// True if a wire has a shape on one of its lumps.
[[nodiscard]] bool may_touch(const Model& model, std::int32_t wire) noexcept;

/// Compute for the marked wires what energy they gained (Wires::gain [J]).
void measure_wires(Model& model, runtime::Pool& pool) noexcept;

}  // namespace hawser::stepper
