// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file reference.h
/// Signed distance of two convex shapes in long double, by a slow and direct method, as a reference
/// for the collision code. It shares no code with it. For a unit normal n from A to B,
///     s(n) = min over B of n·b − max over A of n·a
/// is a lower bound of the signed distance, which is its maximum.
///
/// Separated: minimisation of |b − a| over both sets by corrected Frank-Wolfe steps; the duality
/// gap bounds the error of the result.
///
/// Overlapping: all local maxima of s are collected. They are at normals of faces; on the circles
/// of normals perpendicular to each edge (golden section from a scan); and, for curved shapes, on
/// the sphere (a scan, then a pattern search). For two boxes these are the 15 axes, in closed form.

#include "collide/geometry.h"

#include <array>
#include <cmath>
#include <vector>

namespace hawser::reference {

using Real = long double;
struct Vec {
    Real x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec unit(Vec a) { return (1 / length(a)) * a; }

/// A convex core in the world, with a rounding radius.
struct Body {
    ShapeKind kind;
    Vec c, axis[3];
    Real rounding = 0, radius = 0, half_length = 0, half[3] = {0, 0, 0};
    std::vector<Vec> points;        ///< Hull or triangle: points in the world.
    std::vector<Vec> faces, edges;  ///< Normals (one of each opposite pair is sufficient) and
                                    ///< directions.
};

Body make_body(const collide::Geometry& shape, const collide::Placement& placed);
/// Make a body of points in the world; all edges and faces of their hull are tried.
Body make_points(const std::vector<Vec>& points, const std::vector<Vec>& faces,
                 const std::vector<Vec>& edges);
Vec support(const Body& body, Vec n);
Real separation_along(const Body& a, const Body& b, Vec n);  ///< Includes rounding radii.

struct Answer {
    Real gap;           ///< Signed distance.
    Vec n;              ///< From a to b.
    Real normal_error;  ///< Bound of the error of n; large if n is not well defined.
};
Answer signed_distance(const Body& a, const Body& b);

}  // namespace hawser::reference
