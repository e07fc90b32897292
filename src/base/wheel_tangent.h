// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wheel_tangent.h
/// Straight part of a line between two wheels whose axes are not parallel, such as a tackle whose
/// block yaws or swings.
///
/// The line leaves each wheel in the plane of that wheel, at s q from its centre. Here s is the
/// radius with the sense of passing, and q a unit vector perpendicular to the axis n. Let S be the
/// vector from the first point to the second. Conditions of tangency to both wheels:
/// ```
///     q₀·S = 0,   q₁·S = 0,   S = d + s₁ q₁ − s₀ q₀.
/// ```
/// A component of S along an axis counts in the length but not in the tangent, as for one wheel.
/// Method: Newton's method on the two angles, dq/dφ = n × q.

#include "base/small.h"

namespace hawser::HAWSER_ISA {

/// True if two unit vectors are parallel or antiparallel up to rounding.
inline bool are_parallel(const V3& a, const V3& b) {
    const V3 across = cross(a, b);
    return dot(across, across) < 1e-24;
}

/// Compute the tangent points of a line on two wheels. No tangent exists if a centre lies within
/// the other circle or the line is along an axis. Then q is set to unit vectors perpendicular to
/// the axes. @param d  Vector from the first centre to the second [m]. @param n  Axes, unit
/// vectors.
/// @param s  Signed radii [m]. @param straight  Approximate direction of the line from the first
/// wheel to the second. @param q  Output, see above.
inline void tangent_between_wheels(const V3& d, const V3 (&n)[2], const double (&s)[2],
                                   const V3& straight, V3 (&q)[2]) {
    for (int k = 0; k < 2; ++k) {
        q[k] = cross(straight, n[k]);
        if (dot(q[k], q[k]) <= 1e-20 * dot(straight, straight)) {
            const double x = n[k].x * n[k].x, y = n[k].y * n[k].y;
            q[k] = cross(x <= y ? V3{1, 0, 0} : V3{0, 1, 0}, n[k]);
        }
        q[k] = (1.0 / norm(q[k])) * q[k];
    }
    // Quadratic convergence from a few degrees on: after three iterations only rounding changes.
    constexpr int kMaxIterations = 20;
    constexpr double kTangentTolerance = 1e-10, kMaxTangentStep = 0.5;  // [rad]
    for (int i = 0; i < kMaxIterations; ++i) {
        const V3 t[2] = {cross(n[0], q[0]), cross(n[1], q[1])};
        const V3 S = d + s[1] * q[1] - s[0] * q[0];
        const double f0 = dot(q[0], S), f1 = dot(q[1], S);
        const double a = dot(t[0], S) - s[0] * dot(q[0], t[0]), b = s[1] * dot(q[0], t[1]),
                     c = -s[0] * dot(q[1], t[0]), e = dot(t[1], S) + s[1] * dot(q[1], t[1]);
        const double det = a * e - b * c;
        if (det == 0.0) return;
        double turn[2] = {(b * f1 - e * f0) / det, (c * f0 - a * f1) / det};
        double most = 0.0;
        for (int k = 0; k < 2; ++k) {
            turn[k] = turn[k] > kMaxTangentStep    ? kMaxTangentStep
                      : turn[k] < -kMaxTangentStep ? -kMaxTangentStep
                                                   : turn[k];
            const V3 to = q[k] + turn[k] * t[k];
            q[k] = (1.0 / norm(to)) * to;
            const double size = turn[k] < 0.0 ? -turn[k] : turn[k];
            most = size > most ? size : most;
        }
        if (!(most > kTangentTolerance)) return;
    }
}

}  // namespace hawser::HAWSER_ISA
