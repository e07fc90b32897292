// SPDX-License-Identifier: Apache-2.0
// Sphere against sphere, capsule, box, cylinder, plane: the nearest point in closed form.
#include "collide/narrow/manifold.h"
#include "collide/narrow/pairs.h"

namespace hawser::collide::narrow {
namespace {

/// Nearest point on the surface of a solid, and the outward normal there.
struct Nearest {
    V3 nearest_point, n;
    double distance;  ///< Signed distance [m]; negative inside.
};

void add_contact_point(const V3& centre, double radius, const Nearest& to, double margin,
                       const double* origin, Manifold& out) {
    const double gap = to.distance - radius;
    out.count = 0;
    if (!(gap < margin)) return;
    finish({centre - radius * to.n, to.nearest_point, -to.n, gap, 0}, origin, out);
}

/// Compute the nearest point for a core without volume. If both points coincide, the normal is
/// `fallback`.
Nearest from_point(const V3& p, const V3& core, double radius, const V3& fallback) {
    const V3 d = p - core;
    const double length = norm(d);
    const V3 n = length > 0.0 ? (1.0 / length) * d : fallback;
    return {core + radius * n, n, length - radius};
}

Nearest from_box(const V3& p, const V3& half) {
    const V3 nearest_point{clamp(p.x, -half.x, half.x), clamp(p.y, -half.y, half.y),
                           clamp(p.z, -half.z, half.z)};
    const V3 d = p - nearest_point;
    const double length = norm(d);
    if (length > 0.0) return {nearest_point, (1.0 / length) * d, length};
    // The point is inside: use the nearest face.
    const double x = half.x - std::fabs(p.x), y = half.y - std::fabs(p.y),
                 z = half.z - std::fabs(p.z);
    if (x < y && x < z) {
        const double s = p.x < 0.0 ? -1.0 : 1.0;
        return {{s * half.x, p.y, p.z}, {s, 0, 0}, -x};
    }
    if (y < z) {
        const double s = p.y < 0.0 ? -1.0 : 1.0;
        return {{p.x, s * half.y, p.z}, {0, s, 0}, -y};
    }
    const double s = p.z < 0.0 ? -1.0 : 1.0;
    return {{p.x, p.y, s * half.z}, {0, 0, s}, -z};
}

Nearest from_cylinder(const V3& p, double radius, double half_length) {
    const double across = std::sqrt(p.x * p.x + p.y * p.y);
    const V3 out = across > 0.0 ? V3{p.x / across, p.y / across, 0.0} : V3{1, 0, 0};
    const double s = p.z < 0.0 ? -1.0 : 1.0;
    const double over_rim = across - radius, over_cap = std::fabs(p.z) - half_length;
    if (over_rim <= 0.0 && over_cap <= 0.0) {
        if (over_cap >= over_rim) return {{p.x, p.y, s * half_length}, {0, 0, s}, over_cap};
        return {{radius * out.x, radius * out.y, p.z}, out, over_rim};
    }
    const V3 nearest_point{clamp(across, 0.0, radius) * out.x, clamp(across, 0.0, radius) * out.y,
                           clamp(p.z, -half_length, half_length)};
    const V3 d =
        (over_rim > 0.0 ? over_rim : 0.0) * out + V3{0, 0, over_cap > 0.0 ? s * over_cap : 0.0};
    const double length = norm(d);
    return {nearest_point, (1.0 / length) * d, length};
}

/// Compute the contacts of a sphere with a solid shape in the frame of the solid, by `solid`.
template <class Solid>
void in_frame(const Geometry& a, const Placement& pa, const Placement& pb, double margin,
              Manifold& out, Solid solid) {
    const M3 r = generic::load9(pb.r);
    const V3 d = generic::load3(pa.x) - generic::load3(pb.x);
    Nearest to = solid(tmul(r, d));
    to.nearest_point = r * to.nearest_point;
    to.n = r * to.n;
    add_contact_point(d, a.radius, to, margin, pb.x, out);
}

}  // namespace

HAWSER_PAIR(sphere_sphere) {
    const V3 d = generic::load3(pa.x) - generic::load3(pb.x);
    const V3 up = axis(generic::load9(pb.r), 2);
    add_contact_point(d, a.radius, from_point(d, {0, 0, 0}, b.radius, up), margin, pb.x, out);
}

HAWSER_PAIR(sphere_capsule) {
    in_frame(a, pa, pb, margin, out, [&](const V3& p) {
        const V3 core{0, 0, clamp(p.z, -b.half_length, b.half_length)};
        return from_point(p, core, b.radius, {1, 0, 0});
    });
}

HAWSER_PAIR(sphere_box) {
    in_frame(a, pa, pb, margin, out,
             [&](const V3& p) { return from_box(p, generic::load3(b.half_size)); });
}

HAWSER_PAIR(sphere_cylinder) {
    in_frame(a, pa, pb, margin, out,
             [&](const V3& p) { return from_cylinder(p, b.radius, b.half_length); });
}

HAWSER_PAIR(sphere_plane) {
    (void)b;
    const V3 n = axis(generic::load9(pb.r), 2);
    const V3 d = generic::load3(pa.x) - generic::load3(pb.x);
    const double height = dot(n, d);
    add_contact_point(d, a.radius, {d - height * n, n, height}, margin, pb.x, out);
}

}  // namespace hawser::collide::narrow
