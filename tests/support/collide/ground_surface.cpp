// SPDX-License-Identifier: Apache-2.0
#include "support/collide/ground_surface.h"

#include <algorithm>
#include <cmath>

namespace hawser::test {

using collide::Placement;
using reference::Real;
using reference::Vec;

Vec local(const Placement& p, Vec x) {
    const Vec d = x - Vec{p.x[0], p.x[1], p.x[2]};
    const auto column = [&](int k) { return Vec{p.r[k], p.r[3 + k], p.r[6 + k]}; };
    return {dot(column(0), d), dot(column(1), d), dot(column(2), d)};
}

Vec turned(const Placement& p, const Vec3& v) {
    Real x[3];
    for (int i = 0; i < 3; ++i) {
        x[i] = 0;
        for (int j = 0; j < 3; ++j) x[i] += Real(p.r[3 * i + j]) * v[j];
    }
    return {x[0], x[1], x[2]};
}

namespace {

constexpr int kNodes = 4;
constexpr double kCell = 4.0;

void add_grid(Surface& s, Random& random) {
    for (int i = 0; i < kNodes; ++i)
        for (int j = 0; j < kNodes; ++j) {
            s.def.heights.push_back(random.uniform(-1.0, 1.0));
            s.vertices.emplace_back(kCell * (j - 1.5), kCell * (i - 1.5), s.def.heights.back());
        }
    for (int i = 0; i + 1 < kNodes; ++i)
        for (int j = 0; j + 1 < kNodes; ++j) {
            const int v = kNodes * i + j;
            s.def.triangles.push_back({v, v + 1, v + kNodes + 1});
            s.def.triangles.push_back({v, v + kNodes + 1, v + kNodes});
        }
}

/// Add a rock: nine vertices around, a top and a bottom.
void add_rock(Surface& s, Random& random) {
    constexpr int kAround = 9;
    for (int k = 0; k < kAround; ++k) {
        const double angle = 2.0 * M_PI * k / kAround, r = random.uniform(2.0, 5.0);
        s.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                random.uniform(-0.5, 0.5));
    }
    s.vertices.emplace_back(random.uniform(-0.5, 0.5), 0.0, random.uniform(0.8, 2.0));
    s.vertices.emplace_back(0.0, random.uniform(-0.5, 0.5), random.uniform(-2.0, -0.8));
    for (int k = 0; k < kAround; ++k) {
        s.def.triangles.push_back({k, (k + 1) % kAround, kAround});
        s.def.triangles.push_back({k, (k + 1) % kAround, kAround + 1});
    }
}

void connect(Surface& s) {
    s.ring.resize(s.vertices.size());
    for (std::size_t t = 0; t < s.def.triangles.size(); ++t) {
        const auto& v = s.def.triangles[t];
        Face face{{v[0], v[1], v[2]}, {-1, -1, -1}, {}, {}, {}};
        for (int k = 0; k < 3; ++k) {
            const int p = v[k], q = v[(k + 1) % 3];
            for (const auto& [from, to] : {std::pair(p, q), std::pair(q, p)})
                if (std::find(s.ring[from].begin(), s.ring[from].end(), to) == s.ring[from].end())
                    s.ring[from].push_back(to);
            for (std::size_t other = 0; other < s.def.triangles.size(); ++other) {
                const auto& w = s.def.triangles[other];
                const auto has = [&](int x) { return std::find(w.begin(), w.end(), x) != w.end(); };
                if (other == t || !has(p) || !has(q)) continue;
                for (const int x : w)
                    if (x != p && x != q) face.beyond[k] = x;
            }
        }
        s.faces.push_back(face);
    }
}

void put(Surface& s, const Placement& placed) {
    s.placed = placed;
    for (const Vec3& v : s.vertices)
        s.world.push_back(turned(placed, v) + Vec{placed.x[0], placed.x[1], placed.x[2]});
    const Vec up = turned(placed, Vec3(0, 0, 1));
    for (Face& f : s.faces) {
        std::vector<Vec> edges;
        for (int k = 0; k < 3; ++k) f.corner[k] = s.world[f.vertex[k]];
        for (int k = 0; k < 3; ++k) edges.push_back(unit(f.corner[(k + 1) % 3] - f.corner[k]));
        f.normal = unit(cross(edges[0], edges[1]));
        if (dot(f.normal, up) < 0) f.normal = -1.0L * f.normal;
        f.body = reference::make_points({f.corner[0], f.corner[1], f.corner[2]}, {f.normal}, edges);
    }
}

}  // namespace

Surface random_surface(Random& random, Ground kind) {
    Surface s;
    s.solid = kind == Ground::heightfield;
    if (kind == Ground::rock)
        add_rock(s, random);
    else
        add_grid(s, random);
    connect(s);
    if (s.solid) {
        s.def.kind = ShapeKind::heightfield;
        s.def.rows = s.def.columns = kNodes;
        s.def.cell = {kCell, kCell};
    } else {
        s.def.kind = ShapeKind::mesh;
        s.def.vertices = s.vertices;
        for (auto& t : s.def.triangles)
            if (random.chance(0.5)) std::swap(t[1], t[2]);
    }
    s.data = collide::make_shape_data(s.def);
    put(s, random_placement(random, 5.0));
    return s;
}

}  // namespace hawser::test
