// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file math.h
/// Small vectors of the public interface. Everything is in SI units and right-handed;
/// z of the world frame points up unless a scene turns gravity.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hawser {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;  ///< Rotation from a body's frame to the world frame.

/// Position and orientation of a body. A scalar body keeps its coordinate in position.x().
struct Pose {
    Vec3 position{0.0, 0.0, 0.0};         ///< Centre of mass, world frame [m].
    Quat orientation = Quat::Identity();  ///< Body frame to world frame, unit length.
};

/// Velocity of a body. A scalar body keeps its rate in linear.x().
struct Twist {
    Vec3 linear{0.0, 0.0, 0.0};   ///< Of the centre of mass, world frame [m/s].
    Vec3 angular{0.0, 0.0, 0.0};  ///< World frame [rad/s].
};

}  // namespace hawser
