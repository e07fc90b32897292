// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file segment.h
/// Cores of capsules against each other, cylinders and triangles, in closed form or nearly so.

#include "collide/narrow/polish.h"

namespace hawser::collide::narrow {

struct Segment {
    V3 c, d;      ///< Centre, unit direction.
    double half;  ///< Half of the length [m]; 0: a point.
    V3 at(double t) const { return c + t * d; }
};
inline Segment segment_of(const Convex& s) {
    return {s.c, axis(s.r, 2), s.kind == ShapeKind::capsule ? s.half_length : 0.0};
}

/// Compute the parameters of the nearest points of two segments (C. Ericson, Real-Time Collision
/// Detection, 5.1.9).
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

/// Compute the separation of a segment or point and a triangle. @return false if they intersect, or
/// are nearer than 1e-10 of their size.
bool segment_triangle(const Segment& a, const Convex& triangle, Separation& out);
/// Compute the separation of a segment or point and a solid cylinder. @return false if they
/// intersect, or are nearer than 1e-10 of their size.
bool segment_cylinder(const Segment& a, const Convex& cylinder, Separation& out);
/// Compute the separation if a segment and a cylinder intersect. Returns the best of the expanding
/// polytope and of the exits through the curved surface, which may be nearly equally short.
Separation separate_from_cylinder(const Convex& segment, const Convex& cylinder);

}  // namespace hawser::collide::narrow
