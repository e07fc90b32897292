// SPDX-License-Identifier: Apache-2.0
// Box against box: the 15 separating axes (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996).
// If the boxes overlap, the axis of least penetration is exact. If they are apart and a vertex
// faces a face or two edges cross, the axis of largest separation is the normal of the distance.
// Otherwise GJK is used.
#include "collide/narrow/manifold.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/separate.h"

namespace hawser::collide::narrow {
namespace {

double half_extent_along(const V3& half, const V3& n) {
    return half.x * std::fabs(n.x) + half.y * std::fabs(n.y) + half.z * std::fabs(n.z);
}

/// Return the largest separation over the axes. Stops if it exceeds `enough`.
Separation best_axis(const Convex& a, const Convex& b, double enough) {
    const V3 d = b.c - a.c;
    const V3 da = tmul(a.r, d), db = tmul(b.r, d);
    double across[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) across[i][j] = dot(axis(a.r, i), axis(b.r, j));
    Separation best{{0, 0, 1}, -1e300};
    // In a tie, faces precede edges, and faces of a precede faces of b.
    const double tie = 1e-9 * (a.size + b.size);
    const auto propose = [&](const V3& n, double along, double s) {
        if (s > best.s + tie) best = {along < 0.0 ? -n : n, s};
    };
    for (int i = 0; i < 3; ++i) {
        const V3 row{across[i][0], across[i][1], across[i][2]};
        const double along = component(da, i);
        propose(axis(a.r, i), along,
                std::fabs(along) - component(a.half, i) - half_extent_along(b.half, row));
    }
    for (int j = 0; j < 3; ++j) {
        const V3 column{across[0][j], across[1][j], across[2][j]};
        const double along = component(db, j);
        propose(axis(b.r, j), along,
                std::fabs(along) - component(b.half, j) - half_extent_along(a.half, column));
    }
    if (best.s > enough) return best;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const V3 m = cross(axis(a.r, i), axis(b.r, j));
            const double length = norm(m);
            if (length < 1e-7) continue;  // parallel: covered by the faces
            const V3 n = (1.0 / length) * m;
            const double along = dot(n, d);
            propose(n, along,
                    std::fabs(along) - half_extent_along(a.half, tmul(a.r, n)) -
                        half_extent_along(b.half, tmul(b.r, n)));
        }
    return best;
}

}  // namespace

HAWSER_PAIR(box_box) {
    out.count = 0;
    const Convex p = make_convex(a, pa, pa.x), q = make_convex(b, pb, pa.x);
    const double size = p.size + q.size;
    if (norm(q.c) - size >= margin) return;
    Separation best = best_axis(p, q, margin);
    if (!(best.s < margin)) return;
    Points points;
    if (best.s > 1e-9 * size) {
        // If the normal is one of the axes, GJK finds it again, and polishing keeps the axis
        // itself.
        best = separate(p, q, margin);
        if (!(best.s < margin)) return;
    }
    add_points(p, q, best.n, best.s, margin, points);
    finish(points, pa.x, size, out);
}

}  // namespace hawser::collide::narrow
