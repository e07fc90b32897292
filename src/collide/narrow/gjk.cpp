// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/gjk.h"

namespace hawser::collide::narrow {
namespace {

struct Simplex {
    int count = 0;
    V3 w[4];
};

V3 nearest_on_segment(const V3& a, const V3& b, Simplex& out) {
    const V3 d = b - a;
    const double dd = dot(d, d), t = -dot(a, d);
    if (!(dd > 0.0) || t <= 0.0) {
        out = {1, {a}};
        return a;
    }
    if (t >= dd) {
        out = {1, {b}};
        return b;
    }
    out = {2, {a, b}};
    return a + (t / dd) * d;
}

/// Return the point of a triangle nearest to the origin (C. Ericson, Real-Time Collision Detection,
/// 5.1.5). In the interior the normal of the plane is used, which avoids cancellation in the
/// distance.
V3 nearest_on_triangle(const V3& a, const V3& b, const V3& c, Simplex& out) {
    const V3 ab = b - a, ac = c - a, n = cross(ab, ac);
    const double nn = dot(n, n), longest = std::fmax(dot(ab, ab), dot(ac, ac));
    if (nn > 1e-28 * longest * longest) {
        const double u = dot(n, cross(b, c)), v = dot(n, cross(c, a)), w = dot(n, cross(a, b));
        if (u > 0.0 && v > 0.0 && w > 0.0) {
            out = {3, {a, b, c}};
            return (dot(n, a) / nn) * n;
        }
    }
    Simplex s;
    V3 best = nearest_on_segment(a, b, out);
    for (int k = 0; k < 2; ++k) {
        const V3 p = k ? nearest_on_segment(c, a, s) : nearest_on_segment(b, c, s);
        if (dot(p, p) < dot(best, best)) best = p, out = s;
    }
    return best;
}

/// Return the nearest point of the simplex and reduce the simplex to the part that contains it. A
/// tetrahedron that is kept contains the origin.
V3 nearest(Simplex& s) {
    const Simplex in = s;
    if (in.count == 1) return in.w[0];
    if (in.count == 2) return nearest_on_segment(in.w[0], in.w[1], s);
    if (in.count == 3) return nearest_on_triangle(in.w[0], in.w[1], in.w[2], s);
    static constexpr int kTetrahedronFaces[4][4] = {
        {0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    bool outside[4], any = false;
    double weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        const auto& f = kTetrahedronFaces[i];
        const V3& a = in.w[f[0]];
        const V3 n = cross(in.w[f[1]] - a, in.w[f[2]] - a);
        const double origin = -dot(n, a), other = dot(n, in.w[f[3]] - a);
        outside[i] = origin * other <= 0.0;
        any = any || outside[i];
        weights += origin / other;
    }
    // The barycentric coordinates of the origin add up to 1, unless the tetrahedron is too flat to
    // determine its inside.
    if (!any && std::fabs(weights - 1.0) < 1e-6) return {0, 0, 0};
    bool first = true;
    V3 best{0, 0, 0};
    for (int i = 0; i < 4; ++i) {
        if (any && !outside[i]) continue;
        const auto& f = kTetrahedronFaces[i];
        Simplex t;
        const V3 p = nearest_on_triangle(in.w[f[0]], in.w[f[1]], in.w[f[2]], t);
        if (first || dot(p, p) < dot(best, best)) best = p, s = t, first = false;
    }
    return best;
}

}  // namespace

GjkResult gjk(const Convex& a, const Convex& b, double enough) {
    const double size = a.size + b.size + norm(b.c - a.c);
    const double touching = 1e-10 * size;
    GjkResult result{false, {1, 0, 0}, 0.0};
    Simplex s;
    V3 v = b.c - a.c;
    if (dot(v, v) == 0.0) v = {1, 0, 0};
    double last = 1e300;
    for (int iteration = 0; iteration < 96; ++iteration) {
        const double length = norm(v);
        const V3 n = (1.0 / length) * v;
        const V3 w = support(b, -n) - support(a, n);
        const double bound = dot(w, n);
        if (bound > enough) return {true, n, bound};
        if (s.count > 0) {
            if (length - bound <= 1e-14 * size + 1e-13 * length) return {true, n, length};
            for (int i = 0; i < s.count; ++i)
                if (dot(w - s.w[i], w - s.w[i]) == 0.0) return {true, n, length};
        }
        s.w[s.count++] = w;
        const V3 next = nearest(s);
        const double now = norm(next);
        if (s.count == 4 || now <= touching) return result;
        if (now >= last) return {true, n, length};  // as near as rounding permits
        last = now;
        v = next;
    }
    result.separated = true;
    result.distance = norm(v);
    result.n = (1.0 / result.distance) * v;
    return result;
}

}  // namespace hawser::collide::narrow
