// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guard.h
/// The guard over wires: no step may leave a wire with created energy.
///
/// A *wire* is a connected set of elastic lines between points, coupled by nodes. A step uses the
/// direction of each element, and the tension of its geometric stiffness, from its start. If an
/// element turns far within a step, this creates energy, and a wire of nodes becomes unstable.
///
/// Therefore the energy of each wire is computed half a step before and after, where velocities are
/// defined, from its true lengths (wire_energy.cpp). The limit of the gain is a thousandth of the
/// exchanged energy plus the recent loss. Beyond it, the step is solved again for the wires
/// concerned, with stronger measures each time (wire_plan.cpp):
///
///   1-3  with a tension as large as that of the rejected step; from 2 on without the
///        part of the stiffness that returns stored energy;
///   4-7  by a force that stores no more energy than the elements do: then there is no gain.
///
/// The last measure is a convex quadratic bound of the energy of the elements, as in
/// majorise-minimise methods (docs/theory/wires.md). Source: Lange, "MM optimization algorithms",
/// SIAM 2016. Wires whose vibration the step resolves are not checked.

#include "context/context.h"

namespace hawser::step {

/// Solve the step again if wires gain energy. Call after the solution and before bodies move.
[[nodiscard]] Status guard_wires(context::StepContext& ctx) noexcept;

/// After the staggered start, set the velocities of nodes of fast wires to those given by the user,
/// which belong to a time half a step later. The staggered velocities come from a trial step, which
/// does not resolve the axial vibration.
void keep_start_velocities(context::Model& model, const context::Before& kept) noexcept;

}  // namespace hawser::step
