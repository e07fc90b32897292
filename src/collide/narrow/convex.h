// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file convex.h
/// A convex shape placed in space, as a core and a rounding.
///
/// A sphere is a point, a capsule a segment, each swept by a ball; box, cylinder, hull and
/// triangle have no rounding. Frames are those of the world moved by `origin`, so that shapes far
/// from the world's origin lose no digits.
///
/// For a unit normal n from shape A to shape B let
///     s(n) = min over B of n·b − max over A of n·a,
/// a lower bound of the signed distance of the cores, which is the maximum of s over all n, apart
/// (s > 0) or overlapping (s < 0). Everything in this folder looks for that maximum.

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
/// A unit vector across v, the same one for the same v.
V3 any_across(const V3& v);

struct Convex {
    ShapeKind kind;         ///< sphere: a point; capsule: a segment; mesh: one triangle.
    V3 c;                   ///< Centre [m].
    M3 r;                   ///< Shape to world.
    double rounding;        ///< Radius of the ball swept over the core [m].
    double radius;          ///< Of a cylinder [m].
    double half_length;     ///< Of a segment or a cylinder [m].
    V3 half;                ///< Of a box [m].
    const ShapeData* data;  ///< Of a hull.
    V3 corner[3];           ///< Of a triangle.
    V3 face;                ///< Unit normal of a triangle.
    double size;            ///< No point of the core is further from c [m].
};

Convex make_convex(const Geometry& shape, const Placement& placed, const double* origin);
/// Counter-clockwise seen from its normal.
Convex make_triangle(const V3& a, const V3& b, const V3& c);

/// A point of the core furthest along n; `id` names it.
V3 support(const Convex& shape, const V3& n);

/// Vertices of the part of a core that faces n. Names: `vertex[i]`, and `edge[i]` of the edge
/// from i to i + 1.
inline constexpr int kMaxPoly = 48;
struct Poly {
    int count;
    V3 p[kMaxPoly];
    std::uint16_t vertex[kMaxPoly], edge[kMaxPoly];
};
/// Polygon, segment or point of the core that faces n, where faces and edges tilted from the
/// perpendicular of n by up to asin(tilt) count. Cap of a cylinder: a polygon of kCapPoints.
inline constexpr int kCapPoints = 16;
void facing(const Convex& shape, const V3& n, double tilt, Poly& out);

}  // namespace hawser::collide::narrow
