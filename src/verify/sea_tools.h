// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_tools.h
/// Geometry for the verification of hulls in the sea.

#include <hawser/math.h>

#include <cmath>
#include <numbers>

namespace hawser::verify {

using M6 = Eigen::Matrix<double, 6, 6>;
using V6 = Eigen::Matrix<double, 6, 1>;
inline constexpr double kHalfTurn = std::numbers::pi;

inline double wrap_angle(double angle) { return std::remainder(angle, 2.0 * kHalfTurn); }

inline double heading_about_z(const Pose& pose) {
    const Vec3 forward = pose.orientation * Vec3(1, 0, 0);
    return std::atan2(forward.y(), forward.x());
}

/// Return the matrix whose columns are the velocities at a point for unit rates of the six motions.
inline M6 motions_at(const Vec3& point) {
    M6 out = M6::Identity();
    for (int k = 0; k < 3; ++k) {
        Vec3 turn = Vec3::Zero();
        turn[k] = 1.0;
        out.block<3, 1>(0, 3 + k) = turn.cross(point);
    }
    return out;
}

inline M6 block_diagonal(const Mat3& axes) {
    M6 out = M6::Zero();
    out.block<3, 3>(0, 0) = out.block<3, 3>(3, 3) = axes;
    return out;
}

}  // namespace hawser::verify
