// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joint_gap.h
/// Measure the opening of a joint from its points and axes, without the solver.

#include <hawser/hawser.h>

#include <span>

namespace hawser::verify {

struct JointGap {
    double separation = 0.0;  ///< Distance of its points in the constrained directions [m].
    double turned = 0.0;      ///< Angle of its axes in the constrained directions [rad].
    bool rigid = false;       ///< False: no joint, or an elastic one.
};

/// Return the opening of a joint. @param pose  Poses of all bodies.
[[nodiscard]] JointGap joint_gap(const World& world, InteractionId id, std::span<const Pose> pose);

/// Return the edge of a cube with the mass and inertia of the smaller body of a joint [m]; 0: no
/// body has a size.
[[nodiscard]] double joint_size(const World& world, InteractionId id);

}  // namespace hawser::verify
