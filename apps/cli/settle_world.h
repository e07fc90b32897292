// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file settle_world.h
/// Build the world in which a scene comes to rest (`hawser settle`).

#include <hawser/world.h>

namespace hawser::cli {

/// True if forces move the body: rigid bodies, nodes, scalar bodies.
[[nodiscard]] bool moves(const World& world, BodyId body);

/// Return a copy of the world for the search of a rest position, with all its systems. Waves and
/// gusts of the sea are off; its present level, mean current and mean wind remain. Winches with an
/// active motor hold at zero speed, others by their brakes.
/// @throws DefError if a system cannot be cloned.
[[nodiscard]] World still_world(const World& from);

/// Return a world with the same definitions and drag on every body. Drag alone would stop it within
/// `stop_time` [s]. Drag is implicit in the step and does not change the equilibrium, which has no
/// motion. Scaling or zeroing velocities between steps instead would make stiff rows unstable. The
/// scheme keeps half of their force in the velocity of the previous step. Contacts lose their
/// stored friction forces, so that a scene settles to a state with little friction. Without systems
/// no element breaks. With systems one may, and an event reports it. @throws DefError
[[nodiscard]] World with_drag(const World& still, double stop_time);

}  // namespace hawser::cli
