// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file manifold.h
/// From the normal of two convex shapes to the contact points between them.
///
/// Project the facing parts of both cores (polygon, segment or point) along the normal. The corners
/// of their overlap, lifted back onto both parts, are the contact points. On the overlap of two
/// flat parts the gap is linear, so that its minimum is at a corner. If the smallest gap of the
/// cores is elsewhere (a rim, a vertex of a part with a tilt above `kMaxManifoldTilt`), its point
/// is added.
///
/// At most four points are kept:
/// 1. the point furthest from their middle;
/// 2. the point furthest from point 1;
/// 3. the point furthest from the line between points 1 and 2;
/// 4. the point furthest outside the triangle of points 1 to 3.
/// If the deepest point is not among them, it replaces the nearest of them. Ties within 1e-7 of the
/// size go to the smaller feature, so that symmetric shapes do not alternate between equal choices.
/// If the points are collinear, the ends are kept.

#include "collide/narrow/convex.h"
#include "collide/narrow/points.h"

namespace hawser::collide::narrow {

/// Faces and edges tilted by up to 11.5 degrees take part in a manifold.
inline constexpr double kMaxManifoldTilt = 0.2;

/// Add the contact points of two cores at the unit normal `n`, along which their separation has its
/// maximum `separation`. Only points with a gap (minus roundings) below `margin` are added.
void add_points(const Convex& a, const Convex& b, const V3& n, double separation, double margin,
                Points& out);

/// Reduce points of (nearly) one normal to four, in their order. If `row` is true, keep both ends
/// of the row and the deepest point.
void reduce(Points& points, double size, bool row = false);
/// Sort the points by feature, keep the deeper of two points with equal features, and write at most
/// kMaxManifold points with `origin` added.
void write_sorted(Points& points, const double* origin, Manifold& out);
/// Reduce the points to four, sort them by feature, and write them with `origin` added.
void finish(Points& points, const double* origin, double size, Manifold& out);
/// Write a manifold of one point, with `origin` added.
void finish(const Point& point, const double* origin, Manifold& out);

}  // namespace hawser::collide::narrow
