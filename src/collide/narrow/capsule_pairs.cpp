// SPDX-License-Identifier: Apache-2.0
// Capsule against capsule and box.
//
// Capsules: the nearest points of two segments (C. Ericson, Real-Time Collision Detection, 5.1.9).
// Nearly parallel ones also touch at the ends of their common length, each with its own normal.
//
// Box: the squared distance from the point at t of the segment is convex and piecewise quadratic in
// t. A safeguarded Newton iteration on its slope ends after a few pieces. A segment that enters the
// box leaves along the axis of least depth. The candidates are three face normals and three normals
// to an edge and the segment.
#include "collide/narrow/manifold.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/segment.h"

#include <algorithm>

namespace hawser::collide::narrow {
namespace {

Segment segment(const Geometry& g, const Placement& p, const double* origin) {
    return {generic::load3(p.x) - generic::load3(origin), axis(generic::load9(p.r), 2),
            g.half_length};
}

/// Return the contact of the points at s and t. @param fallback  Normal if the points coincide.
Point contact(const Segment& a, double ra, const Segment& b, double rb, double s, double t,
              const V3& fallback, std::uint32_t name) {
    const V3 p = a.at(s), q = b.at(t), d = q - p;
    const double length = norm(d);
    const V3 n = length > 1e-12 * (a.half + b.half + ra + rb) ? (1.0 / length) * d : fallback;
    return {p + ra * n, q - rb * n, n, dot(d, n) - ra - rb, name};
}

/// Return the normal of intersecting segments, perpendicular to both.
V3 crossing_normal(const Segment& a, const Segment& b) {
    V3 n = cross(a.d, b.d);
    const double length = norm(n);
    if (a.half > 0.0 && b.half > 0.0 && length > 1e-9)
        n = (1.0 / length) * n;
    else
        n = any_perpendicular(a.half > 0.0 ? a.d : b.d);
    return dot(b.c - a.c, n) < 0.0 ? -n : n;
}

/// Return the contact that separates two intersecting segments by the shortest way: perpendicular
/// to both, or along a past an end.
Point separating_contact(const Segment& a, double ra, const Segment& b, double rb, double s,
                         double t) {
    return contact(a, ra, b, rb, s, t, crossing_normal(a, b), 0);
}

}  // namespace

HAWSER_PAIR(capsule_capsule) {
    out.count = 0;
    const Segment p = segment(a, pa, pa.x), q = segment(b, pb, pa.x);
    const double ra = a.radius, rb = b.radius;
    double s = 0.0, t = 0.0;
    nearest(p, q, s, t);
    const Point deepest = separating_contact(p, ra, q, rb, s, t);
    if (!(deepest.gap < margin)) return;
    const V3 across = cross(p.d, q.d);
    const double size = p.half + q.half + ra + rb;
    // Up to 6 degrees from parallel: add both ends of the common length.
    if (p.half == 0.0 || q.half == 0.0 || dot(across, across) > 0.01)
        return finish(deepest, pa.x, out);
    Points points;
    bool has_deepest = false;
    const auto propose = [&](double x, double y, std::uint32_t name) {
        const Point c = contact(p, ra, q, rb, x, y, deepest.normal, name);
        has_deepest = has_deepest || c.gap <= deepest.gap + 1e-8 * size;
        if (c.gap < margin) points.add(c);
    };
    // Ends of the common length along a. If an end of b is within 1e-6 of an end of a, the point
    // has the name of a.
    const bool along = dot(p.d, q.d) >= 0.0;
    for (int end = 0; end < 2; ++end) {
        const double side = end ? 1.0 : -1.0, y = (along ? side : -side) * q.half;
        const double x = dot(q.at(y) - p.c, p.d);
        if (side * x < p.half - 1e-6 * size) {
            if (side * x >= -p.half) propose(x, y, feature(1, along ? end : 1 - end, 0));
        } else {
            const double on_q = dot(p.at(side * p.half) - q.c, q.d);
            if (std::fabs(on_q) <= q.half + 1e-6 * size)
                propose(side * p.half, clamp(on_q, -q.half, q.half),
                        feature(0, static_cast<unsigned>(end), 0));
        }
    }
    if (!has_deepest) {
        Point c = deepest;
        c.feature = feature(3, 0, 0);
        points.add(c);
    }
    finish(points, pa.x, size, out);
}

namespace {

/// Return the slope at t of half the squared distance from c + t d to the box, and its derivative
/// `rate`.
double slope(const V3& c, const V3& d, const V3& half, double t, double& rate) {
    double sum = 0.0;
    rate = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double x = component(c, k) + t * component(d, k), h = component(half, k);
        const double over = x > h ? x - h : (x < -h ? x + h : 0.0);
        if (over != 0.0) {
            sum += over * component(d, k);
            rate += component(d, k) * component(d, k);
        }
    }
    return sum;
}

/// Return the parameter of a point of the segment nearest to the box.
double nearest_to_box(const V3& c, const V3& d, double length, const V3& half) {
    double low = -length, high = length, rate = 0.0;
    if (slope(c, d, half, low, rate) >= 0.0) return low;
    if (slope(c, d, half, high, rate) <= 0.0) return high;
    double t = clamp(-dot(c, d), low, high);
    for (int i = 0; i < 60; ++i) {
        const double s = slope(c, d, half, t, rate);
        if (s == 0.0) return t;
        (s > 0.0 ? high : low) = t;
        const double next = t - s / rate;
        if (next == t) return t;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

/// Compute the signed distance of a segment that intersects the box, along six axes. The normal
/// points out of the box.
Separation separate_from_box(const V3& c, const V3& d, double length, const V3& half) {
    Separation best{{0, 0, 1}, -1e300};
    const double tie = 1e-9 * norm(half);
    for (int k = 0; k < 3; ++k) {
        const double s =
            std::fabs(component(c, k)) - component(half, k) - length * std::fabs(component(d, k));
        if (s <= best.s + tie) continue;
        const double sign = component(c, k) < 0.0 ? -1.0 : 1.0;
        best = {{k == 0 ? sign : 0.0, k == 1 ? sign : 0.0, k == 2 ? sign : 0.0}, s};
    }
    if (!(length > 0.0)) return best;
    for (int k = 0; k < 3; ++k) {
        V3 m = cross({k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}, d);
        const double size = norm(m);
        if (size < 1e-9) continue;
        m = ((dot(m, c) < 0.0 ? -1.0 : 1.0) / size) * m;
        const double s =
            dot(m, c) - half.x * std::fabs(m.x) - half.y * std::fabs(m.y) - half.z * std::fabs(m.z);
        if (s > best.s + tie) best = {m, s};
    }
    return best;
}

}  // namespace

HAWSER_PAIR(capsule_box) {
    out.count = 0;
    const M3 r = generic::load9(pb.r);
    const V3 half = generic::load3(b.half_size);
    const V3 c = tmul(r, generic::load3(pa.x) - generic::load3(pb.x));
    const V3 d = tmul(r, axis(generic::load9(pa.r), 2));
    // Reject early by the axes of the box.
    for (int k = 0; k < 3; ++k)
        if (std::fabs(component(c, k)) - component(half, k) -
                a.half_length * std::fabs(component(d, k)) >=
            a.radius + margin)
            return;
    const double t = nearest_to_box(c, d, a.half_length, half);
    const V3 p = c + t * d;
    const V3 over = p - V3{clamp(p.x, -half.x, half.x), clamp(p.y, -half.y, half.y),
                           clamp(p.z, -half.z, half.z)};
    const double distance = norm(over);
    Separation apart{{0, 0, 0}, distance};
    if (distance > 1e-9 * (norm(half) + a.half_length))
        apart.n = (1.0 / distance) * over;
    else
        apart = separate_from_box(c, d, a.half_length, half);
    if (!(apart.s - a.radius < margin)) return;
    const Convex s = make_convex(a, pa, pb.x), box = make_convex(b, pb, pb.x);
    Points points;
    add_points(s, box, -(r * apart.n), apart.s, margin, points);
    finish(points, pb.x, s.size + a.radius + box.size, out);
}

}  // namespace hawser::collide::narrow
