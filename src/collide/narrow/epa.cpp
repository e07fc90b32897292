// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/epa.h"

#include <cstdint>
#include <utility>

namespace hawser::collide::narrow {
namespace {

constexpr int kVertices = 192, kFaces = 2 * kVertices;

/// Polytope inside the difference b − a. Faces are counter-clockwise from outside.
struct Polytope {
    struct Face {
        std::int16_t v[3];
        bool alive;
        V3 n;      ///< Unit, outward.
        double d;  ///< Distance of the plane from the origin, along n.
    };
    int vertices = 0, faces = 0;
    V3 w[kVertices];
    Face face[kFaces * 2];

    bool add_face(int i, int j, int k) {
        if (faces == kFaces * 2) return false;
        const V3 n = cross(w[j] - w[i], w[k] - w[i]);
        const double length = norm(n);
        if (!(length > 0.0)) return false;
        Face& f = face[faces++];
        f.v[0] = static_cast<std::int16_t>(i);
        f.v[1] = static_cast<std::int16_t>(j);
        f.v[2] = static_cast<std::int16_t>(k);
        f.alive = true;
        f.n = (1.0 / length) * n;
        // The corner nearest to the foot of the origin loses the fewest digits; any will do.
        f.d = dot(f.n, w[i]);
        return true;
    }

    /// Replace the faces that see `p` by a cone from it. Seeds at `start`, which sees it, and
    /// grows over neighbours, so that what is cut out is one patch whatever rounding says.
    bool expand(const V3& p, int start, double tolerance);
    int nearest() const {
        int best = -1;
        for (int i = 0; i < faces; ++i)
            if (face[i].alive && (best < 0 || face[i].d < face[best].d)) best = i;
        return best;
    }
    void compact() {
        int kept = 0;
        for (int i = 0; i < faces; ++i)
            if (face[i].alive) face[kept++] = face[i];
        faces = kept;
    }
};

bool Polytope::expand(const V3& p, int start, double tolerance) {
    if (vertices == kVertices) return false;
    if (faces > kFaces) return false;
    // Directed edges of the patch whose reverse is not in it make its rim.
    std::int16_t edge[3 * kFaces][2];
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
        f.alive = false;
        for (int k = 0; k < 3; ++k) toggle(f.v[k], f.v[(k + 1) % 3]);
    };
    remove(face[start]);
    for (bool grown = true; grown;) {
        grown = false;
        for (int i = 0; i < faces; ++i) {
            Face& f = face[i];
            if (!f.alive || dot(f.n, p) - f.d <= tolerance) continue;
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

V3 difference(const Convex& a, const Convex& b, const V3& m) {
    return support(b, m) - support(a, -m);
}

/// Four corners that are not flat.
bool start(const Convex& a, const Convex& b, double size, Polytope& out) {
    static constexpr double kWays[7][3] = {{1, 0.03, 0.07},  {0.05, 1, 0.02},   {0.04, 0.06, 1},
                                           {0.6, 0.5, 0.62}, {-0.6, 0.5, 0.61}, {0.6, -0.52, 0.6},
                                           {0.6, 0.51, -0.6}};
    V3 p[14];
    for (int i = 0; i < 7; ++i) {
        const V3 way = normalized(generic::load3(kWays[i]));
        p[2 * i] = difference(a, b, way);
        p[2 * i + 1] = difference(a, b, -way);
    }
    const auto furthest = [&](auto&& measure, int& best) {
        double most = -1.0;
        for (int i = 0; i < 14; ++i) {
            const double x = measure(p[i]);
            if (x > most) most = x, best = i;
        }
        return most;
    };
    int i1 = 0, i2 = 0, i3 = 0;
    const V3 o = p[0];
    if (furthest([&](const V3& q) { return norm(q - o); }, i1) < 1e-9 * size) return false;
    const V3 u = normalized(p[i1] - o);
    if (furthest([&](const V3& q) { return norm(cross(q - o, u)); }, i2) < 1e-9 * size)
        return false;
    const V3 n = normalized(cross(p[i1] - o, p[i2] - o));
    if (furthest([&](const V3& q) { return std::fabs(dot(q - o, n)); }, i3) < 1e-9 * size)
        return false;
    out.vertices = 4;
    out.w[0] = o;
    out.w[1] = p[i1];
    out.w[2] = p[i2];
    out.w[3] = p[i3];
    if (dot(p[i3] - o, n) > 0.0) std::swap(out.w[1], out.w[2]);
    return out.add_face(0, 1, 2) && out.add_face(0, 3, 1) && out.add_face(1, 3, 2) &&
           out.add_face(2, 3, 0);
}

}  // namespace

V3 epa(const Convex& a, const Convex& b) {
    const double size = a.size + b.size;
    Polytope polytope;
    V3 best = normalized(any_across(a.c - b.c + V3{1e-30, 0, 0}));
    if (!start(a, b, size, polytope)) return best;
    double least = 1e300;
    for (;;) {
        const int i = polytope.nearest();
        if (i < 0) return best;
        const V3 n = polytope.face[i].n;
        const V3 w = difference(a, b, n);
        const double reach = dot(w, n);  // −s(−n)
        if (reach < least) least = reach, best = -n;
        if (reach - polytope.face[i].d <= 1e-12 * size) return best;
        if (polytope.face[i].d >= least - 1e-12 * size) return best;
        if (!polytope.expand(w, i, 1e-14 * size)) return best;
    }
}

}  // namespace hawser::collide::narrow
