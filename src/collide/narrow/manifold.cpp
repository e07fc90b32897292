// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/manifold.h"

#include "collide/narrow/overlap.h"

#include <algorithm>

namespace hawser::collide::narrow {
namespace {

/// A point closer to an edge than this fraction of the size counts as on it. Rounding and the noise
/// of a body at rest are far smaller.
constexpr double kSnapDistance = 1e-6;
/// Gaps that differ by less than this fraction of the size count as equal.
constexpr double kGapTie = 1e-7;
/// A point is added if its gap is smaller than those at the corners by more than this fraction of
/// the size.
constexpr double kMinDeeperGap = 1e-8;
/// Parts with a smaller tilt count as exactly parallel; n is accurate to 1e-8 or better.
constexpr double kMaxParallelTilt = 1e-6;

/// Return the point of smallest gap in the overlap of the faces of both cores that are
/// perpendicular to n.
Point deepest_point(const Convex& a, const Convex& b, const V3& n, double separation, double size) {
    Poly pa, pb;
    facing_polygon(a, n, kMaxParallelTilt, pa);
    facing_polygon(b, -n, kMaxParallelTilt, pb);
    Points found;
    overlap(pa, pb, n, separation, kSnapDistance * size, found);
    const std::uint32_t name = feature(3, pa.vertex[0], pb.vertex[0]);
    const Point* best = nullptr;
    for (int i = 0; i < found.count; ++i)
        if (!best || found.p[i].gap < best->gap) best = &found.p[i];
    if (best) return {best->on0, best->on1, n, best->gap, name};
    // Rounding has moved parallel parts past each other: use the point between their nearest
    // corners.
    V3 on0 = pa.p[0], on1 = pb.p[0];
    double least = -1.0;
    for (int i = 0; i < pa.count; ++i)
        for (int j = 0; j < pb.count; ++j) {
            const V3 d = pb.p[j] - pa.p[i];
            const double distance = norm(d - dot(d, n) * n);
            if (least < 0.0 || distance < least) least = distance, on0 = pa.p[i], on1 = pb.p[j];
        }
    const V3 middle = 0.5 * (on0 + on1);
    const double half = 0.5 * separation;
    return {middle - half * n, middle + half * n, n, separation, name};
}

/// Return the index of the largest value. A later value must exceed it by `tie`.
template <class Value>
int largest(const Points& points, double tie, Value value) {
    int best = 0;
    double most = value(points.p[0]);
    for (int i = 1; i < points.count; ++i) {
        const double x = value(points.p[i]);
        if (x > most + tie) most = x, best = i;
    }
    return best;
}

void write(const Point& p, const double* origin, ManifoldPoint& out) {
    const V3 o = generic::load3(origin);
    generic::store3(out.on[0], p.on0 + o);
    generic::store3(out.on[1], p.on1 + o);
    generic::store3(out.normal, p.normal);
    out.gap = p.gap;
    out.feature = p.feature;
}

}  // namespace

void reduce(Points& points, double size, bool row) {
    const double length_tie = kGapTie * size, tie = length_tie * size;
    const V3 n = points.p[0].normal;
    const int deep = largest(points, length_tie, [](const Point& p) { return -p.gap; });
    V3 centre{0, 0, 0};
    for (int i = 0; i < points.count; ++i) centre = centre + points.p[i].on0;
    centre = (1.0 / points.count) * centre;
    const auto from = [&](const V3& o) {
        return largest(points, tie, [&](const Point& p) { return dot(p.on0 - o, p.on0 - o); });
    };
    int keep[4];
    keep[0] = from(centre);
    const V3 p0 = points.p[keep[0]].on0;
    keep[1] = from(p0);
    const V3 p1 = points.p[keep[1]].on0, across = cross(n, p1 - p0);
    const auto side = [&](const Point& p) { return dot(p.on0 - p0, across); };
    keep[2] = largest(points, tie, [&](const Point& p) { return std::fabs(side(p)); });
    const double turn = side(points.p[keep[2]]);
    if (row || std::fabs(turn) <= tie) {
        keep[2] = keep[3] = keep[0];  // collinear points need only their ends
    } else {
        // Return the distance outside the triangle of the three points.
        const V3 p2 = points.p[keep[2]].on0;
        const double sign = turn > 0.0 ? 1.0 : -1.0;
        const V3 from_1 = sign * cross(n, p2 - p1), from_2 = sign * cross(n, p0 - p2);
        const auto outside = [&](const Point& p) {
            return std::max({-sign * side(p), -dot(p.on0 - p1, from_1), -dot(p.on0 - p2, from_2)});
        };
        keep[3] = largest(points, tie, outside);
        if (outside(points.p[keep[3]]) <= tie) keep[3] = keep[0];
    }
    double least = 1e300;
    for (const int k : keep) least = std::fmin(least, points.p[k].gap);
    if (least > points.p[deep].gap + length_tie) {
        // Replace a duplicate, or else the nearest point.
        int place = 0;
        double nearest = 1e300;
        for (int k = 0; k < 4; ++k) {
            const V3 d = points.p[keep[k]].on0 - points.p[deep].on0;
            const bool twice = k > 1 && (keep[k] == keep[0] || keep[k] == keep[1]);
            const double distance = twice ? -1.0 : dot(d, d);
            if (distance < nearest - tie) nearest = distance, place = k;
        }
        keep[place] = deep;
    }
    std::sort(keep, keep + 4);
    int count = 0;
    for (int k = 0; k < 4; ++k)
        if (k == 0 || keep[k] != keep[k - 1]) points.p[count++] = points.p[keep[k]];
    points.count = count;
}

void add_points(const Convex& a, const Convex& b, const V3& n, double separation, double margin,
                Points& out) {
    const double rounding = a.rounding + b.rounding;
    if (separation - rounding >= margin) return;
    const double size = a.size + b.size + rounding;
    Poly pa, pb;
    facing_polygon(a, n, kMaxManifoldTilt, pa);
    facing_polygon(b, -n, kMaxManifoldTilt, pb);
    const int first = out.count;
    overlap(pa, pb, n, separation, kSnapDistance * size, out);
    double least = separation + 1.0 + size;
    for (int i = first; i < out.count; ++i) least = std::fmin(least, out.p[i].gap);
    if (least > separation + kMinDeeperGap * size)
        out.add(deepest_point(a, b, n, separation, size));
    int kept = first;
    for (int i = first; i < out.count; ++i) {
        Point p = out.p[i];
        p.on0 = p.on0 + a.rounding * n;
        p.on1 = p.on1 - b.rounding * n;
        p.gap -= rounding;
        if (p.gap < margin) out.p[kept++] = p;
    }
    out.count = kept;
}

namespace {

/// Sort points by feature number. If numbers are equal, the deeper point is first.
void sort(Points& points) {
    std::sort(points.p, points.p + points.count, [](const Point& p, const Point& q) {
        return p.feature != q.feature ? p.feature < q.feature : p.gap < q.gap;
    });
    int count = 0;
    for (int i = 0; i < points.count; ++i)
        if (i == 0 || points.p[i].feature != points.p[i - 1].feature)
            points.p[count++] = points.p[i];
    points.count = count;
}

}  // namespace

void write_sorted(Points& points, const double* origin, Manifold& out) {
    sort(points);
    out.count = std::min(points.count, kMaxManifold);
    for (int i = 0; i < out.count; ++i) write(points.p[i], origin, out.point[i]);
}

void finish(Points& points, const double* origin, double size, Manifold& out) {
    sort(points);
    if (points.count > 4) reduce(points, size);
    write_sorted(points, origin, out);
}

void finish(const Point& point, const double* origin, Manifold& out) {
    out.count = 1;
    write(point, origin, out.point[0]);
}

}  // namespace hawser::collide::narrow
