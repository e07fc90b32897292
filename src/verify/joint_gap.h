// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joint_gap.h
/// How far a joint stands open, by its points and axes: nothing of the solver.

#include <hawser/hawser.h>

#include <span>

namespace hawser::verify {

struct JointGap {
    double apart = 0.0;   ///< Of its points, as far as it holds them [m].
    double turned = 0.0;  ///< Of its axes, as far as it holds them [rad].
    bool rigid = false;   ///< False: no joint, or one that is meant to give way.
};

/// @param pose  Of all bodies.
[[nodiscard]] JointGap joint_gap(const World& world, InteractionId id, std::span<const Pose> pose);

/// Edges of a cube with the same mass and inertia, of the smaller of a joint's bodies [m]; 0: none
/// of them has a size.
[[nodiscard]] double joint_size(const World& world, InteractionId id);

}  // namespace hawser::verify
