// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_energy.h
/// Energy that wires gained in a step.
///
/// At a half step, where velocities are defined, an element stores V(d) = k/2 (|d| − l₀)², or 0 if
/// it is slack and only pulls. In the step it does the work p·w̄ on the bodies at its ends, its
/// impulse times their mean relative velocity. The increase of its stored energy plus this work is
/// created energy, whatever else acts on the bodies.
///
/// **Wires that may touch** (a node has a shape) omit the part along the rows. For an element
/// that moves along its direction only, SPOOK's law (docs/theory/step.md) gives
/// ```
///   gain = −h k τ w₊ (w + w₊)/2        w, w₊ its rate before and after the step
/// ```
/// plus ½ k (h w/2)² if it was slack and becomes taut. This has either sign and may be a thousand
/// times the kinetic energy of a stiff element. It vanishes within a few steps, because the damping
/// τ = 2h is beyond critical. The energy account counts it as damped (losses.h). With this part, a
/// line that slides on a deck and becomes taut was rejected in step after step. The bound of
/// wire_plan.cpp then turned it into speeds along the line, which the bound preserves, and which
/// were rejected again.

#include "context/context.h"

#include <cstdint>

namespace hawser::solve {

/// Mark wires whose transverse vibration the step does not resolve.
/// @return true if there are any.
[[nodiscard]] bool find_fast_wires(context::Model& model, const context::Before& kept) noexcept;

/// True if a node of a wire has a collision shape.
[[nodiscard]] bool may_touch(const context::Model& model, std::int32_t wire) noexcept;

/// Compute the energy gain of the marked wires (Wires::gain [J]).
void measure_wires(context::Model& model, runtime::Pool& pool) noexcept;

}  // namespace hawser::solve
