// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state.h
/// View of the poses and velocities of all bodies as arrays, without a copy.

#include <hawser/def.h>

#include <cstdint>
#include <span>

namespace hawser {

/// Arrays of the state by body index (BodyId::index), vacant indices included. Valid until the next
/// step or change of the world; request them again afterwards.
struct StateView {
    double time = 0.0;                     ///< Time of the poses [s].
    std::span<const BodyKind> kinds;       ///< Kind of each body.
    std::span<const double> positions;     ///< 3 for each body: centre of mass, world frame [m];
                                           ///< scalar body: the first is its coordinate.
    std::span<const double> orientations;  ///< 4 for each body: quaternion w, x, y, z.
    /// Packed velocities at time − h/2 (staggered scheme), world frame. Rigid body: 6 (linear
    /// [m/s], angular [rad/s]); lumped mass: 3; scalar: 1; fixed or kinematic: 0.
    std::span<const double> velocities;
    /// Index in `velocities` of each body's first entry; undefined for fixed and kinematic bodies.
    std::span<const std::int32_t> velocity_begin;
    std::span<const double> prescribed;  ///< 6 for each body: velocity of a kinematic body, else 0.
};

}  // namespace hawser
