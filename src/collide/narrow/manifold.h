// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file manifold.h
/// From the normal of two convex shapes to the contact points between them.
///
/// The parts of both cores that face each other (polygon, segment or point) are seen along the
/// normal; the corners of where they overlap, lifted back onto both, are the contact points. The
/// gap is a linear function on the overlap of two flat parts, so the smallest one is at a corner.
/// Where the smallest gap of the cores is not there (a rim, a vertex of a part tilted by more than
/// `kTilt`) the point that has it is added.
///
/// Of more than four points four are kept: the one furthest from their middle, the one furthest
/// from that, the one furthest from the line between those, and the one furthest outside the
/// triangle of the three; the deepest one takes the place of the nearest of them where it is not
/// among them. Ties within 1e-7 of the size go to the smaller feature, so that symmetric shapes do
/// not flicker between equal choices. Of points in a row the ends are kept.

#include "collide/narrow/convex.h"
#include "collide/narrow/points.h"

namespace hawser::collide::narrow {

/// Faces and edges tilted by up to 11.5 degrees take part in a manifold.
inline constexpr double kTilt = 0.2;

/// Contact points of two cores whose largest s(n) is `separation`, at the unit normal `n`; those
/// with a gap (roundings taken off) below `margin`.
void add_points(const Convex& a, const Convex& b, const V3& n, double separation, double margin,
                Points& out);

/// Keep four of points of (nearly) one normal, in their order; with `row`, the ends of the row and
/// the deepest.
void reduce(Points& points, double size, bool row = false);
/// Sort by feature, keep the deeper one of equal names, write with `origin` added; at most
/// kMaxManifold.
void write_sorted(Points& points, const double* origin, Manifold& out);
/// Reduce to four, sort by feature, and write with `origin` added.
void finish(Points& points, const double* origin, double size, Manifold& out);
/// As above, of a manifold of one point: write it with `origin` added.
void finish(const Point& point, const double* origin, Manifold& out);

}  // namespace hawser::collide::narrow
