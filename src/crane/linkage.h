// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file linkage.h
/// Compute a cylinder, a hinge and their links as a triangle in the crane's plane.
///
/// ```
///              head           a = |foot − pin|, b = |head − pin|, φ between them
///             /    \ b        length² = a² + b² − 2 a b cos φ
///     length /   φ  \         φ = φ₀ + s (θ − θ₀), s = ±1: θ the angle of the link
///        foot ─────── pin     dlength/dθ = s a b sin φ / length = lever
///              a
/// ```

#include <hawser/crane.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::crane {

/// Return the rotation in the plane that raises the x axis by an angle.
[[nodiscard]] inline Quat rotation_raising(double angle) {
    return Quat(Eigen::AngleAxisd(-angle, Vec3::UnitY()));
}

struct Linkage {
    double a = 0.0, b = 0.0;  ///< [m]
    double angle = 0.0;       ///< θ₀ [rad]
    double phi = 0.0;         ///< φ₀ [rad]
    double length = 0.0;      ///< Length at the start [m].
    double lever = 0.0;       ///< dlength/dθ at the start [m].

    [[nodiscard]] double shortest() const { return std::abs(a - b); }
    [[nodiscard]] double longest() const { return a + b; }
    [[nodiscard]] double angle_at(double l) const {
        const double cosine = std::clamp((a * a + b * b - l * l) / (2.0 * a * b), -1.0, 1.0);
        return angle + (lever > 0.0 ? 1.0 : -1.0) * (std::acos(cosine) - phi);
    }
    /// Return the angles at the ends of its stroke, the smaller one first [rad].
    [[nodiscard]] std::pair<double, double> angle_range(const CraneCylinder& c) const {
        const double in = angle_at(c.min_length), out = angle_at(c.max_length);
        return {std::min(in, out), std::max(in, out)};
    }
};

/// Return the linkage of a cylinder. @param pin  Hinge, in the frame of the link with the foot [m].
/// @param angle  Angle θ₀ of the other link at the start [rad].
[[nodiscard]] inline Linkage linkage_of(const CraneCylinder& cylinder, const Vec3& pin,
                                        double angle) {
    const Vec3 foot = cylinder.foot - pin, head = rotation_raising(angle) * cylinder.head;
    Linkage out;
    out.a = foot.norm();
    out.b = head.norm();
    out.angle = angle;
    out.phi = std::atan2(foot.cross(head).norm(), foot.dot(head));
    out.length = (head - foot).norm();
    // Raising rotates about −y.
    out.lever = (head - foot).dot((-Vec3::UnitY()).cross(head)) / std::max(out.length, 1e-12);
    return out;
}

[[nodiscard]] inline Linkage boom_linkage(const KnuckleCraneDef& d) {
    return linkage_of(d.boom_cylinder, d.boom_foot, d.boom_angle);
}
[[nodiscard]] inline Linkage jib_linkage(const KnuckleCraneDef& d) {
    return linkage_of(d.jib_cylinder, {d.boom.length, 0.0, 0.0}, d.jib_angle);
}

/// Return the point where the pendants hold a lattice boom, in the column's frame [m].
[[nodiscard]] inline Vec3 pendant_head(const LatticeCraneDef& d) {
    return d.boom_foot +
           rotation_raising(d.boom_angle) * Vec3(d.boom.length, 0.0, 0.5 * d.boom.height);
}
/// Return the distance from that point to the gantry [m].
[[nodiscard]] inline double pendant_top_to_gantry(const LatticeCraneDef& d) {
    return (d.gantry - pendant_head(d)).norm();
}

}  // namespace hawser::crane
