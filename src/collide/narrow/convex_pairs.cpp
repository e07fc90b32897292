// SPDX-License-Identifier: Apache-2.0
// Two convex shapes by their support functions.
#include "collide/narrow/manifold.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/separate.h"

namespace hawser::collide::narrow {

HAWSER_PAIR(convex_convex) {
    out.count = 0;
    const Convex p = make_convex(a, pa, pa.x), q = make_convex(b, pb, pa.x);
    const double enough = margin + p.rounding + q.rounding;
    const double size = p.size + q.size + p.rounding + q.rounding;
    if (norm(q.c) - size >= margin) return;
    const Separation best = separate(p, q, enough);
    if (!(best.s < enough)) return;
    Points points;
    add_points(p, q, best.n, best.s, margin, points);
    finish(points, pa.x, size, out);
}

HAWSER_PAIR(nothing) {
    (void)a, (void)pa, (void)b, (void)pb, (void)margin;
    out.count = 0;
}

}  // namespace hawser::collide::narrow
