// SPDX-License-Identifier: Apache-2.0
// Capsule, box, cylinder or hull against a half-space: the corners of the facing part.
#include "collide/narrow/manifold.h"
#include "collide/narrow/pairs.h"

namespace hawser::collide::narrow {
namespace {

/// Return the contact of the point p of a core with rounding. @param n  Normal of the plane through
/// the origin.
Point on_plane(const V3& p, const V3& n, double rounding, std::uint32_t name) {
    const double height = dot(n, p);
    return {p - rounding * n, p - height * n, -n, height - rounding, name};
}

}  // namespace

HAWSER_PAIR(capsule_plane) {
    (void)b;
    const V3 n = axis(generic::load9(pb.r), 2);
    const V3 d = generic::load3(pa.x) - generic::load3(pb.x);
    const V3 arm = a.half_length * axis(generic::load9(pa.r), 2);
    const bool is_ball = !(a.half_length > 0.0);
    Points points;
    for (int end = 0; end < (is_ball ? 1 : 2); ++end) {
        const Point p =
            on_plane(end ? d + arm : d - arm, n, a.radius, static_cast<std::uint32_t>(end));
        if (p.gap < margin) points.add(p);
    }
    finish(points, pb.x, a.half_length + a.radius, out);
}

HAWSER_PAIR(convex_plane) {
    (void)b;
    out.count = 0;
    const Convex s = make_convex(a, pa, pb.x);
    const V3 n = axis(generic::load9(pb.r), 2);
    const V3 lowest = support(s, -n);
    const double least = dot(n, lowest);
    if (!(least < margin)) return;
    Poly face;
    facing_polygon(s, -n, kMaxManifoldTilt, face);
    Points points;
    bool has_lowest = false;
    for (int i = 0; i < face.count; ++i) {
        const Point p = on_plane(face.p[i], n, 0.0, feature(0, face.vertex[i], 0));
        has_lowest = has_lowest || p.gap <= least + 1e-8 * s.size;
        if (p.gap < margin) points.add(p);
    }
    if (!has_lowest) points.add(on_plane(lowest, n, 0.0, feature(3, 0, 0)));
    finish(points, pb.x, s.size, out);
}

}  // namespace hawser::collide::narrow
