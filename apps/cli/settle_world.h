// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file settle_world.h
/// The world in which a scene comes to rest (`hawser settle`).

#include <hawser/world.h>

namespace hawser::cli {

/// Whether it moves by forces: rigid bodies, lumps, scalar ones.
[[nodiscard]] bool moves(const World& world, BodyId body);

/// The scene as it stands, at rest, with all its systems: the sea without waves and gusts and at
/// the level of now, with its mean current and wind; winches hold by what holds them in the scene,
/// motors at no speed or brakes. @throws DefError where a system has no copy.
[[nodiscard]] World still_world(const World& from);

/// Such a world with drag on every body that would stop it alone within `stop_time` [s]. Drag is
/// implicit in the step and takes nothing from the equilibrium, which has no motion. (Scaling or
/// zeroing velocities between steps instead makes stiff rows unstable: the scheme keeps half of
/// their force in the velocity of the step before.) Contacts forget what friction held, so that a
/// scene settles to where little friction is needed. Without systems no element parts by its load;
/// with them one may, and tells of it by an event. @throws DefError
[[nodiscard]] World with_drag(const World& still, double stop_time);

}  // namespace hawser::cli
