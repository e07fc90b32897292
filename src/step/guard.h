// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guard.h
/// The guard over wires: no step leaves a wire with energy that nothing gave it.
///
/// A *wire* is a connected set of elastic lines between points, coupled by lumps. A step holds the
/// direction of each element, and the tension behind its geometric stiffness, as they were where it
/// began. Where an element swings far within a step, that brings energy out of nothing, and a wire
/// of lumps then shakes itself to pieces. So the energy of each wire is counted at the half steps
/// before and after, where velocities live, from its true lengths (wire_energy.cpp); a step that
/// gains more than a thousandth of what was exchanged, and more than lately was lost, is solved
/// again for the wires that gained, each time more carefully (wire_plan.cpp):
///
///   1-3  with a tension as large as the refused step has brought about; from 2 on without the
///        part of the stiffness that gives back what it held;
///   4-7  by a force that holds no more energy than the elements do: the step cannot gain then.
///
/// Source of the last: a convex quadratic bound of the elements' energy, as in
/// majorise-minimise methods (Lange, *MM optimization algorithms*, SIAM 2016): docs/methods.md, 12.
/// Wires whose swing the step resolves are not looked at.

#include "context/context.h"

namespace hawser::stepper {

/// After the step has been solved, and before bodies move: solve it again where wires gain energy.
[[nodiscard]] Status guard_wires(StepContext& ctx) noexcept;

/// After the staggered start: lumps of fast wires begin with the velocity that they were given,
/// which is half a step late. That of half a step before follows from a trial step, which does not
/// resolve how fast elements swing along.
void calm_start(Model& model, const Before& kept) noexcept;

}  // namespace hawser::stepper
