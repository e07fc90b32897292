// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/separate.h"

#include "collide/narrow/epa.h"
#include "collide/narrow/gjk.h"
#include "collide/narrow/segment.h"

namespace hawser::collide::narrow {
namespace {

/// Find the separation of two intersecting cores without volume. Candidates are normals of
/// triangles and normals to one edge of each core.
Separation separate_flat_cores(const Convex& a, const Convex& b) {
    V3 along = b.c - a.c;
    if (!(dot(along, along) > 0.0)) along = {0, 0, 1};
    Separation best{normalized(along), -1e300};
    // In a tie, use the side on which the centres lie.
    const double tie = 1e-12 * (a.size + b.size);
    const auto propose = [&](V3 n) {
        if (dot(n, along) < 0.0) n = -n;
        for (const V3& m : {n, -n}) {
            const double s = separation_along(a, b, m);
            if (s > best.s + tie) best = {m, s};
        }
    };
    V3 edge[2][3];
    int edges[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
        const Convex& s = i ? b : a;
        if (s.kind == ShapeKind::mesh) {
            propose(s.face);
            for (int k = 0; k < 3; ++k)
                edge[i][edges[i]++] = normalized(s.corner[(k + 1) % 3] - s.corner[k]);
        } else if (s.kind == ShapeKind::capsule && s.half_length > 0.0) {
            edge[i][edges[i]++] = axis(s.r, 2);
        }
    }
    for (int i = 0; i < edges[0]; ++i)
        for (int j = 0; j < edges[1]; ++j) {
            const V3 n = cross(edge[0][i], edge[1][j]);
            if (norm(n) > 1e-9) propose(normalized(n));
        }
    if (best.s == -1e300) best.s = separation_along(a, b, best.n);
    return best;
}

bool is_flat(const Convex& s) {
    return s.kind == ShapeKind::sphere || s.kind == ShapeKind::capsule || s.kind == ShapeKind::mesh;
}

/// Find the separation of two intersecting cores, at least one of which has a volume.
Separation separate_solid_cores(const Convex& a, const Convex& b) {
    Separation best = polish(a, b, epa(a, b), 0.0);
    // Near the axis of a round body all exits are nearly equally short; also try the radial one.
    for (const Convex* round : {&a, &b}) {
        if (round->kind != ShapeKind::cylinder) continue;
        const V3 z = axis(round->r, 2), d = b.c - a.c, across = d - dot(d, z) * z;
        const double length = norm(across);
        if (!(length > 1e-9 * round->radius)) continue;
        const Separation other = polish(a, b, (1.0 / length) * across, 0.0);
        if (other.s > best.s + 1e-14 * round->size) best = other;
    }
    return best;
}

}  // namespace

Separation separate(const Convex& a, const Convex& b, double enough) {
    const bool first_thin = a.kind == ShapeKind::sphere || a.kind == ShapeKind::capsule;
    Separation closed{};
    if (first_thin && b.kind == ShapeKind::mesh)
        return segment_triangle(segment_of(a), b, closed) ? closed : separate_flat_cores(a, b);
    if (first_thin && b.kind == ShapeKind::cylinder)
        return segment_cylinder(segment_of(a), b, closed) ? closed : separate_from_cylinder(a, b);
    const GjkResult gjk_result = gjk(a, b, enough);
    if (gjk_result.separated && gjk_result.distance > enough)
        return {gjk_result.n, gjk_result.distance};
    if (!gjk_result.separated && is_flat(a) && is_flat(b)) return separate_flat_cores(a, b);
    if (!gjk_result.separated) return separate_solid_cores(a, b);
    const Separation best = polish(a, b, gjk_result.n, gjk_result.distance);
    // If GJK could not distinguish separation from contact, its normal is inaccurate.
    const double size = a.size + b.size;
    if (best.s > gjk_result.distance - 1e-6 * size || gjk_result.distance > 1e-3 * size)
        return best;
    const Separation other =
        is_flat(a) && is_flat(b) ? separate_flat_cores(a, b) : separate_solid_cores(a, b);
    return other.s > best.s ? other : best;
}

}  // namespace hawser::collide::narrow
