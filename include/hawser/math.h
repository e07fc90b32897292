// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file math.h
/// Vectors, rotations, poses and velocities of the public interface. Units are SI, frames are
/// right-handed. The world's z axis points up, against WorldDef::gravity by default.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace hawser {

using Vec3 = Eigen::Vector3d;     ///< Vector with the components x, y, z.
using Mat3 = Eigen::Matrix3d;     ///< Matrix of 3 rows and 3 columns.
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

/// Return the rotation of smallest angle that turns the direction `from` into the direction `to`.
/// Both vectors may have any length except 0. For opposite directions the axis is perpendicular to
/// `from`: the z direction made perpendicular to it, or −x if `from` is within 37° of ±z. The
/// result equals Quat::FromTwoVectors(), which costs ten seconds of compile time in each use (it
/// contains a singular value decomposition).
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
