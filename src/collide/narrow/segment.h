// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file segment.h
/// Cores of capsules against each other, cylinders and triangles, in closed form or nearly so.

#include "collide/narrow/polish.h"

namespace hawser::collide::narrow {

struct Segment {
    V3 c, d;      ///< Centre, unit direction.
    double half;  ///< Half the length [m]; 0: a point.
    V3 at(double t) const { return c + t * d; }
};
inline Segment segment_of(const Convex& s) {
    return {s.c, axis(s.r, 2), s.kind == ShapeKind::capsule ? s.half_length : 0.0};
}

/// Parameters of the nearest points of two segments (C. Ericson, Real-Time Collision Detection,
/// 5.1.9).
inline void nearest(const Segment& a, const Segment& b, double& s, double& t) {
    const V3 w = b.c - a.c;
    const double k = dot(a.d, b.d), wa = dot(w, a.d), wb = dot(w, b.d);
    const V3 across = cross(a.d, b.d);
    const double det = dot(across, across);
    s = det > 1e-24 ? clamp(dot(cross(w, b.d), across) / det, -a.half, a.half)
                    : clamp(wa, -a.half, a.half);
    t = k * s - wb;
    if (t < -b.half || t > b.half) {
        t = clamp(t, -b.half, b.half);
        s = clamp(wa + k * t, -a.half, a.half);
    }
}

/// Segment or point and triangle. @return false where they meet, or are nearer than 1e-10 of
/// their size.
bool segment_triangle(const Segment& a, const Convex& triangle, Separation& out);
/// Segment or point and solid cylinder. @return false where they meet, or are nearer than 1e-10 of
/// their size.
bool segment_cylinder(const Segment& a, const Convex& cylinder, Separation& out);
/// Where they meet: the best of what the expanding polytope gives and of the ways out of the round
/// side, which may all be nearly as short.
Separation leave_cylinder(const Convex& segment, const Convex& cylinder);

}  // namespace hawser::collide::narrow
