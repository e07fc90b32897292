// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file math.h
/// Small vectors of the public interface. Everything is in SI units and right-handed;
/// z of the world frame points up unless a scene turns gravity.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

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

/// The smallest turn that takes direction `from` to direction `to`; both of any length but zero.
/// Opposite directions leave its axis open: it is then the part of z square to `from`, or of -x
/// where `from` is nearer to z. It is Quat::FromTwoVectors without that one's singular value
/// decomposition, which takes a compiler ten seconds wherever it is used.
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
