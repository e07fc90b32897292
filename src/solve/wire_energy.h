// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_energy.h
/// What wires gained in a step. At a half step, where velocities live, an element holds
/// V(d) = k/2 (|d| − l₀)², none of it where it is slack and only pulls; in the step it gives the
/// bodies at its ends p·w̄, its impulse times their mean relative velocity. What it holds more
/// afterwards and what it gave are together energy out of nothing, whatever else acts on the
/// bodies.

#include "context/context.h"

namespace hawser::stepper {

/// Mark wires whose swing the step does not resolve. @return whether there are any.
[[nodiscard]] bool find_fast_wires(Model& model, const Before& kept) noexcept;

/// Compute for the marked wires what energy they gained (Wires::gain [J]).
void measure_wires(Model& model, runtime::Pool& pool) noexcept;

}  // namespace hawser::stepper
