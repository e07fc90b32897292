// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state.h
/// Poses and velocities of all bodies at once, without a copy.

#include <hawser/def.h>

#include <cstdint>
#include <span>

namespace hawser {

/// The world's own arrays, by body in the order of ids. They are valid until the world is stepped
/// or changed next: it is a handful of pointers, to be asked for anew each time.
struct StateView {
    double time = 0.0;                     ///< At which it was asked for [s].
    std::span<const BodyKind> kinds;       ///< 1 a body.
    std::span<const double> positions;     ///< 3 a body: centre of mass [m]; scalar: the first.
    std::span<const double> orientations;  ///< 4 a body: quaternion w, x, y, z.
    /// Packed, at time − h/2 (the scheme is staggered), world frame: of a rigid body 6 (linear
    /// [m/s], angular [rad/s]), of a lump 3, of a scalar body 1, of a fixed or kinematic one none.
    std::span<const double> velocities;
    /// 1 a body: where its velocity begins in `velocities`. Of no meaning for a fixed or kinematic
    /// body.
    std::span<const std::int32_t> velocity_begin;
    std::span<const double> prescribed;  ///< 6 a body: velocity of a kinematic body, else 0.
};

}  // namespace hawser
