// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/epa.h"

#include <cstdint>
#include <utility>

namespace hawser::collide::narrow {
namespace {

constexpr int kMaxVertices = 192, kMaxFaces = 2 * kMaxVertices;

/// Polytope inside the difference b − a. Faces are counter-clockwise seen from outside.
struct Polytope {
    struct Face {
        std::int16_t v[3];
        bool is_alive;
        V3 n;      ///< Unit normal, outward.
        double d;  ///< Distance of the plane from the origin along n.
    };
    int vertices = 0, faces = 0;
    V3 w[kMaxVertices];
    Face face[kMaxFaces * 2];

    bool add_face(int i, int j, int k) {
        if (faces == kMaxFaces * 2) return false;
        const V3 n = cross(w[j] - w[i], w[k] - w[i]);
        const double length = norm(n);
        if (!(length > 0.0)) return false;
        Face& f = face[faces++];
        f.v[0] = static_cast<std::int16_t>(i);
        f.v[1] = static_cast<std::int16_t>(j);
        f.v[2] = static_cast<std::int16_t>(k);
        f.is_alive = true;
        f.n = (1.0 / length) * n;
        f.d = dot(f.n, w[i]);
        return true;
    }

    /// Replace the faces that `p` is above by a cone from p. The patch grows from the face `start`
    /// over neighbours, so that it is connected despite rounding. `p` must be above `start`.
    bool expand(const V3& p, int start, double tolerance);
    int nearest() const {
        int best = -1;
        for (int i = 0; i < faces; ++i)
            if (face[i].is_alive && (best < 0 || face[i].d < face[best].d)) best = i;
        return best;
    }
    void compact() {
        int kept = 0;
        for (int i = 0; i < faces; ++i)
            if (face[i].is_alive) face[kept++] = face[i];
        faces = kept;
    }
};

bool Polytope::expand(const V3& p, int start, double tolerance) {
    if (vertices == kMaxVertices) return false;
    if (faces > kMaxFaces) return false;
    // A directed edge belongs to the rim of the patch if its reverse is not in the patch.
    std::int16_t edge[3 * kMaxFaces][2];
    int edges = 0;
    const auto toggle = [&](std::int16_t i, std::int16_t j) {
        for (int k = 0; k < edges; ++k)
            if (edge[k][0] == j && edge[k][1] == i) {
                --edges;
                edge[k][0] = edge[edges][0];
                edge[k][1] = edge[edges][1];
                return;
            }
        edge[edges][0] = i;
        edge[edges++][1] = j;
    };
    const auto remove = [&](Face& f) {
        f.is_alive = false;
        for (int k = 0; k < 3; ++k) toggle(f.v[k], f.v[(k + 1) % 3]);
    };
    remove(face[start]);
    for (bool grown = true; grown;) {
        grown = false;
        for (int i = 0; i < faces; ++i) {
            Face& f = face[i];
            if (!f.is_alive || dot(f.n, p) - f.d <= tolerance) continue;
            bool next = false;
            for (int k = 0; k < edges && !next; ++k)
                for (int m = 0; m < 3; ++m)
                    next = next || (edge[k][0] == f.v[(m + 1) % 3] && edge[k][1] == f.v[m]);
            if (next) remove(f), grown = true;
        }
    }
    const int apex = vertices++;
    w[apex] = p;
    for (int k = 0; k < edges; ++k)
        if (!add_face(edge[k][0], edge[k][1], apex)) return false;
    compact();
    return true;
}

V3 support_difference(const Convex& a, const Convex& b, const V3& m) {
    return support(b, m) - support(a, -m);
}

/// Find four corners that are not coplanar, each in directions perpendicular to the earlier ones.
/// @return false if none exist.
bool start(const Convex& a, const Convex& b, double size, Polytope& out) {
    const double flat = 1e-9 * size;
    V3 p[4];
    // Find the furthest difference point along and against the given directions.
    const auto find = [&](const V3* ways, int count, V3& best, auto&& measure) {
        double most = -1.0;
        for (int i = 0; i < 2 * count; ++i) {
            const V3 q = support_difference(a, b, i % 2 ? -ways[i / 2] : ways[i / 2]);
            const double x = measure(q);
            if (x > most) most = x, best = q;
        }
        return most > flat;
    };
    const V3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    p[0] = support_difference(a, b, axes[0]);
    if (!find(axes, 3, p[1], [&](const V3& q) { return norm(q - p[0]); })) return false;
    const V3 u = normalized(p[1] - p[0]), v = any_perpendicular(u), across[2] = {v, cross(u, v)};
    if (!find(across, 2, p[2], [&](const V3& q) { return norm(cross(q - p[0], u)); })) return false;
    const V3 n = normalized(cross(p[1] - p[0], p[2] - p[0]));
    if (!find(&n, 1, p[3], [&](const V3& q) { return std::fabs(dot(q - p[0], n)); })) return false;
    out.vertices = 4;
    for (int i = 0; i < 4; ++i) out.w[i] = p[i];
    if (dot(p[3] - p[0], n) > 0.0) std::swap(out.w[1], out.w[2]);
    return out.add_face(0, 1, 2) && out.add_face(0, 3, 1) && out.add_face(1, 3, 2) &&
           out.add_face(2, 3, 0);
}

}  // namespace

V3 epa(const Convex& a, const Convex& b) {
    const double size = a.size + b.size;
    Polytope polytope;
    V3 best = normalized(any_perpendicular(a.c - b.c + V3{1e-30, 0, 0}));
    if (!start(a, b, size, polytope)) return best;
    double least = 1e300;
    for (;;) {
        const int i = polytope.nearest();
        if (i < 0) return best;
        const V3 n = polytope.face[i].n;
        const V3 w = support_difference(a, b, n);
        const double reach = dot(w, n);  // Support −s(−n).
        if (reach < least) least = reach, best = -n;
        if (reach - polytope.face[i].d <= 1e-12 * size) return best;
        if (polytope.face[i].d >= least - 1e-12 * size) return best;
        if (!polytope.expand(w, i, 1e-14 * size)) return best;
    }
}

}  // namespace hawser::collide::narrow
