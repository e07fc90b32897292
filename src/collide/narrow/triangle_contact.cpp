// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/triangle_contact.h"

#include "collide/narrow/overlap.h"
#include "collide/narrow/separate.h"
#include "collide/narrow/shape_data.h"

#include <algorithm>

namespace hawser::collide::narrow {
namespace {

constexpr double kMaxFlatAngle = 1e-6;    ///< A neighbour that rises by less counts as flat [rad].
constexpr double kMinGroupCosine = 0.99;  ///< Minimum cosine between normals of one group.
constexpr double kSamePoint = 1e-6;       ///< Tolerance of equal points, relative to the size.
/// Minimum additional depth of an added point, relative to the size.
constexpr double kDeeperFace = 1e-8;

/// True if the unit vector m, which points out of the surface, is an admissible normal at the part
/// of the triangle that faces it.
bool is_admissible_normal(const SurfaceTriangle& t, const V3& m) {
    Poly part;
    facing_polygon(t.triangle, m, 1e-5, part);
    if (part.count == 3) return true;
    const V3& v = part.p[0];
    const auto rises = [&](const V3& w) {
        const V3 d = w - v;
        return dot(m, d) > kMaxFlatAngle * norm(d);
    };
    if (part.count == 2) {
        const int k = part.edge[0];
        return !t.has_neighbour[k] || !rises(t.opposite[k]);
    }
    V3 ring[kMaxRing];
    const int count = t.ring(t, part.vertex[0], ring);
    return std::none_of(ring, ring + count, rises);
}

std::uint32_t name_of(const SurfaceTriangle& t, std::uint32_t local) {
    // Mix the bits (finaliser of MurmurHash3), because 32 bits cannot store both names.
    std::uint32_t h = t.name * 0x9e3779b1U ^ local;
    h = (h ^ h >> 16) * 0x85ebca6bU;
    h = (h ^ h >> 13) * 0xc2b2ae35U;
    return h ^ h >> 16;
}

bool over_triangle(const Convex& t, const V3& p, double snap) {
    for (int k = 0; k < 3; ++k) {
        const V3 e = t.corner[(k + 1) % 3] - t.corner[k];
        if (dot(p - t.corner[k], normalized(cross(e, t.face))) > snap) return false;
    }
    return true;
}

/// Add the points that lie over the triangle along its normal n.
void add_points_along_normal(const Convex& shape, const SurfaceTriangle& t, const V3& n,
                             double margin, Points& out) {
    Poly below, face;
    facing_polygon(t.triangle, n, kMaxManifoldTilt, face);
    const double snap = kSamePoint * (shape.size + t.triangle.size);
    // If no flat part touches, accept a facing part with a larger tilt: an edge deep across a
    // ridge.
    for (const double tilt : {kMaxManifoldTilt, 0.5}) {
        facing_polygon(shape, -n, tilt, below);
        Points found;
        if (below.count == 1) {
            const double s = dot(n, below.p[0] - t.triangle.corner[0]);
            if (over_triangle(t.triangle, below.p[0], snap))
                found.add({below.p[0], below.p[0] - s * n, -n, s, feature(0, below.vertex[0], 0)});
        } else {
            overlap(below, face, -n, 0.0, snap, found);
        }
        if (found.count == 0) continue;
        // The corners approximate a rim, whose lowest point may lie between two of them.
        const V3 deep = support(shape, -n);
        const double lowest = dot(n, deep - t.triangle.corner[0]);
        double least = found.p[0].gap;
        for (int i = 1; i < found.count; ++i) least = std::min(least, found.p[i].gap);
        if (lowest < least - kDeeperFace * shape.size && over_triangle(t.triangle, deep, snap))
            found.add({deep, deep - lowest * n, -n, lowest, feature(3, below.vertex[0], 0)});
        for (int i = 0; i < found.count; ++i) {
            Point p = found.p[i];
            p.on0 = p.on0 - shape.rounding * n;
            p.gap -= shape.rounding;
            if (p.gap < margin) out.add(p);
        }
        return;
    }
}

}  // namespace

V3 middle_of(const Convex& shape) {
    if (shape.kind != ShapeKind::hull || shape.data == nullptr) return shape.c;
    return shape.c + shape.r * shape.data->middle;
}

Point deepest_along_normal(const Convex& shape, const SurfaceTriangle& t, const V3& n) {
    const V3 p = support(shape, -n) - shape.rounding * n;
    const double gap = dot(n, p - t.triangle.corner[0]);
    return {p, p - gap * n, -n, gap, t.name};
}

bool none_overlaps(const Points& points) {
    return std::none_of(points.p, points.p + points.count,
                        [](const Point& p) { return p.gap < 0.0; });
}

void touch_triangle(const Convex& shape, const SurfaceTriangle& t, double margin, Points& out,
                    Point& nearest) {
    const Convex& triangle = t.triangle;
    const double enough = margin + shape.rounding;
    V3 n = triangle.face;
    const double height = dot(n, middle_of(shape) - triangle.c);
    if (height < 0.0 && !t.solid) n = -n;
    if (dot(n, support(shape, -n) - triangle.c) >= enough) return;
    // Return if the shape lies beyond an edge by at least that distance.
    for (int k = 0; k < 3; ++k) {
        const V3& v = triangle.corner[k];
        const V3 e = triangle.corner[(k + 1) % 3] - v, outward = cross(e, triangle.face);
        if (dot(outward, support(shape, -outward) - v) >= enough * norm(outward)) return;
    }
    const Separation best = separate(shape, triangle, enough);
    const V3 m = -best.n;
    // A shape below the surface of a solid is pushed up, not down.
    const bool below = t.solid && dot(m, n) <= 0.0;
    if (best.s >= enough && !below) return;
    // Use the side of the middle, unless the other one is clearly nearer. At an edge of the shape m
    // may lie in the plane.
    if (!t.solid && dot(m, n) < -0.5) n = -n;
    if (!t.solid && best.s < shape.rounding) {
        const Point p = deepest_along_normal(shape, t, n);
        if (nearest.gap == 0.0 || p.gap > nearest.gap) nearest = p;
    }
    Points found;
    if (!below && is_admissible_normal(t, m))
        add_points(shape, triangle, best.n, best.s, margin, found);
    else
        add_points_along_normal(shape, t, n, margin, found);
    const double same_point_distance =
        4.0 * kSamePoint * (shape.size + shape.rounding + triangle.size);
    // A shape separated from a two-sided triangle but with deep points lies over its other side.
    if (!t.solid && best.s > shape.rounding + same_point_distance && !none_overlaps(found)) return;
    for (int i = 0; i < found.count; ++i) {
        Point p = found.p[i];
        p.feature = name_of(t, p.feature);
        // If two triangles share a point on an edge, only the first one adds it.
        bool known = false;
        for (int k = 0; k < out.count && !known; ++k) {
            const V3 d = out.p[k].on1 - p.on1;
            known = dot(d, d) < same_point_distance * same_point_distance &&
                    dot(out.p[k].normal, p.normal) > kMinGroupCosine;
        }
        if (!known) out.add(p);
    }
}

namespace {

/// Assign each point to a group by its normal, in the order of the points. @return number of
/// groups.
int group(const Points& points, int* of) {
    int groups = 0, first[kMaxPoints];
    for (int i = 0; i < points.count; ++i) {
        int g = 0;
        while (g < groups && dot(points.p[first[g]].normal, points.p[i].normal) < kMinGroupCosine)
            ++g;
        if (g == groups) first[groups++] = i;
        of[i] = g;
    }
    return groups;
}

void sort_by_gap(Points& points) {
    std::sort(points.p, points.p + points.count, [](const Point& p, const Point& q) {
        return p.gap != q.gap ? p.gap < q.gap : p.feature < q.feature;
    });
}

/// Keep at most `most` points of each group.
void reduce_groups(Points& points, const Convex& shape, int most) {
    const double size = shape.size + shape.rounding;
    const bool row = shape.kind == ShapeKind::capsule;
    int of[kMaxPoints];
    const int groups = group(points, of);
    Points kept;
    for (int g = 0; g < groups; ++g) {
        Points members;
        for (int i = 0; i < points.count; ++i)
            if (of[i] == g) members.add(points.p[i]);
        if (members.count > 2 && most >= 4) {
            Points fewer = members;
            reduce(fewer, size, row);
            // If a group has at most four points, only points in a row are dropped: an edge across
            // several triangles.
            if (row || members.count > 4 || fewer.count == 2) members = fewer;
        }
        if (most < 4) {
            sort_by_gap(members);
            members.count = std::min(members.count, most);
        }
        for (int i = 0; i < members.count; ++i) kept.add(members.p[i]);
    }
    points = kept;
}

}  // namespace

void reduce_if_full(Points& points, const Convex& shape) {
    // One triangle adds at most twelve points.
    if (points.count <= kMaxPoints - 16) return;
    reduce_groups(points, shape, 4);
    if (points.count > kMaxPoints / 2) reduce_groups(points, shape, 1);
    if (points.count > kMaxPoints / 2) {
        sort_by_gap(points);
        points.count = kMaxPoints / 2;
    }
}

Placement view_from(const Placement& shape, const Placement& surface) noexcept {
    const M3 r = generic::load9(surface.r);
    Placement local{};
    generic::store3(local.x, tmul(r, generic::load3(shape.x) - generic::load3(surface.x)));
    for (int k = 0; k < 3; ++k) {
        const V3 column = tmul(r, axis(generic::load9(shape.r), k));
        for (int i = 0; i < 3; ++i) local.r[3 * i + k] = component(column, i);
    }
    return local;
}

void finish_surface(Points& points, const Placement& surface, const V3& centre, const Convex& shape,
                    Manifold& out) {
    const M3 r = generic::load9(surface.r);
    for (int i = 0; i < points.count; ++i) {
        Point& p = points.p[i];
        p.on0 = r * (p.on0 + centre);
        p.on1 = r * (p.on1 + centre);
        p.normal = r * p.normal;
    }
    std::sort(points.p, points.p + points.count, [](const Point& p, const Point& q) {
        return p.feature != q.feature ? p.feature < q.feature : p.gap < q.gap;
    });
    int of[kMaxPoints];
    const int groups = group(points, of);
    if (points.count > 2) reduce_groups(points, shape, groups <= 2 ? 4 : (groups <= 4 ? 2 : 1));
    if (points.count > kMaxManifold) {
        sort_by_gap(points);
        points.count = kMaxManifold;
    }
    write_sorted(points, surface.x, out);
}

}  // namespace hawser::collide::narrow
