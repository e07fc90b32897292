// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file math.h
/// Small vectors of the public interface. Units are SI, frames right-handed. The world's z axis
/// points up, unless a scene sets another direction of gravity.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace hawser {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;  ///< Rotation from a body's frame to the world frame.

/// Position and orientation of a body. A scalar body stores its coordinate in position.x().
struct Pose {
    Vec3 position{0.0, 0.0, 0.0};         ///< Centre of mass, world frame [m].
    Quat orientation = Quat::Identity();  ///< Body frame to world frame, unit length.
};

/// Velocity of a body. A scalar body stores its rate in linear.x().
struct Twist {
    Vec3 linear{0.0, 0.0, 0.0};   ///< Velocity of the centre of mass, world frame [m/s].
    Vec3 angular{0.0, 0.0, 0.0};  ///< Angular velocity, world frame [rad/s].
};

/// Return the smallest rotation from the direction `from` to the direction `to`, both of any length
/// but 0. For opposite directions the axis is the part of z perpendicular to `from`, or of -x if
/// `from` is closer to z. The result equals Quat::FromTwoVectors(). That function needs ten seconds
/// of compile time in each use, due to its singular value decomposition.
[[nodiscard]] inline Quat turn_between(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized(), b = to.normalized();
    const double cosine = b.dot(a);
    if (cosine < -1.0 + 1e-6) {
        // 1 + cosine has lost digits; the sum and the cross product have not.
        const Vec3 across = a.cross(b);
        const Vec3 aside = across.norm() > 1e-14   ? across
                           : std::abs(a.z()) < 0.8 ? Vec3(0.0, 0.0, 1.0)
                                                   : Vec3(-1.0, 0.0, 0.0);
        const double w = 0.5 * (a + b).norm();
        const Vec3 axis = (aside - a.dot(aside) * a).normalized() * std::sqrt(1.0 - w * w);
        return {w, axis.x(), axis.y(), axis.z()};
    }
    const double s = std::sqrt(2.0 * (1.0 + cosine));
    const Vec3 axis = a.cross(b) * (1.0 / s);
    return {0.5 * s, axis.x(), axis.y(), axis.z()};
}

}  // namespace hawser
