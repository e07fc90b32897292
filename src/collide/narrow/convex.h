// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file convex.h
/// A convex shape placed in space, as a core and a rounding.
///
/// A sphere is a point and a capsule a segment, each swept by a ball. Box, cylinder, hull and
/// triangle have no rounding. Frames are the world frame moved by `origin`, so that shapes far from
/// the origin of the world lose no digits.
///
/// Let n be a unit normal from shape A to shape B. The separation along n is
///     s(n) = min over B of n·b − max over A of n·a.
/// It is a lower bound of the signed distance of the cores. The maximum of s over all n is the
/// signed distance, both apart (s > 0) and overlapping (s < 0). All algorithms in this folder
/// search for that maximum.

#include "base/small.h"
#include "collide/geometry.h"

#include <cmath>
#include <cstdint>

namespace hawser::collide::narrow {

using generic::M3;
using generic::V3;

struct HullView;

inline V3 axis(const M3& r, int k) { return {r.a[k], r.a[3 + k], r.a[6 + k]}; }
inline V3 normalized(const V3& v) { return (1.0 / norm(v)) * v; }
inline double component(const V3& v, int k) { return k == 0 ? v.x : (k == 1 ? v.y : v.z); }
inline double clamp(double x, double low, double high) {
    return x < low ? low : (x > high ? high : x);
}
/// Return a unit vector perpendicular to v. It depends on v alone.
V3 any_perpendicular(const V3& v);

struct Convex {
    ShapeKind kind;         ///< sphere: a point; capsule: a segment; mesh: one triangle.
    V3 c;                   ///< Centre [m].
    M3 r;                   ///< Rotation from shape to world.
    double rounding;        ///< Radius of the ball swept over the core [m].
    double radius;          ///< Radius of a cylinder [m].
    double half_length;     ///< Half length of a segment or a cylinder [m].
    V3 half;                ///< Half extents of a box [m].
    const ShapeData* data;  ///< Data of a hull.
    V3 corner[3];           ///< Corners of a triangle [m].
    V3 face;                ///< Unit normal of a triangle.
    double size;            ///< Maximum distance of a point of the core from c [m].
};

Convex make_convex(const Geometry& shape, const Placement& placed, const double* origin);
/// Make a triangle with corners counter-clockwise seen from its normal.
Convex make_triangle(const V3& a, const V3& b, const V3& c);

/// Return a point of the core furthest along n. @param id  Output: name of the point.
V3 support(const Convex& shape, const V3& n);

/// Vertices of the part of a core that faces n. `vertex[i]`: name of a vertex. `edge[i]`: name of
/// the edge from i to i + 1.
inline constexpr int kMaxPoly = 48;
struct Poly {
    int count;
    V3 p[kMaxPoly];
    std::uint16_t vertex[kMaxPoly], edge[kMaxPoly];
};
/// Compute the polygon, segment or point of the core that faces n. Faces and edges with an angle of
/// up to asin(tilt) to the plane perpendicular to n are included. The cap of a cylinder is a
/// polygon of kCapPoints.
inline constexpr int kCapPoints = 16;
void facing_polygon(const Convex& shape, const V3& n, double tilt, Poly& out);

}  // namespace hawser::collide::narrow
