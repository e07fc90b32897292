// SPDX-License-Identifier: Apache-2.0
#include "support/collide/random_pairs.h"

#include "collide/collide_function.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hawser::test {

using collide::Geometry;
using collide::Manifold;
using collide::ManifoldPoint;
using collide::Placement;
using reference::Answer;
using reference::Body;
using reference::Real;
using reference::Vec;

Placement random_placement(Random& random, double reach) {
    Placement p{};
    const Vec3 x = random.vector(reach);
    const Mat3 r = random.rotation().toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        p.x[i] = x[i];
        for (int j = 0; j < 3; ++j) p.r[3 * i + j] = r(i, j);
    }
    return p;
}

namespace {

/// Find the faces of the hull of a few points (no four in one plane), and its edges, by trying all;
/// points inside it are dropped.
void find_faces(RandomShape& s) {
    const std::size_t count = s.points.size();
    std::vector<std::vector<int>> uses(count, std::vector<int>(count, 0));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            for (std::size_t k = j + 1; k < count; ++k) {
                const Vec3 n = (s.points[j] - s.points[i]).cross(s.points[k] - s.points[i]);
                int above = 0, below = 0;
                for (std::size_t m = 0; m < count; ++m) {
                    if (m == i || m == j || m == k) continue;
                    ++(n.dot(s.points[m] - s.points[i]) > 0.0 ? above : below);
                }
                if (above > 0 && below > 0) continue;
                s.faces.push_back(n.normalized());
                ++uses[i][j], ++uses[j][k], ++uses[i][k];
            }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (uses[i][j] > 0) s.edges.push_back((s.points[j] - s.points[i]).normalized());
    std::vector<Vec3> surface;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            if (uses[std::min(i, j)][std::max(i, j)] > 0) {
                surface.push_back(s.points[i]);
                break;
            }
    s.points = surface;
}

}  // namespace

RandomShape random_shape(Random& random, ShapeKind kind) {
    RandomShape s;
    Geometry& g = s.geometry;
    g.kind = kind;
    g.radius = random.uniform(0.05, 1.0);
    g.half_length = random.uniform(0.05, 1.5);
    for (double& h : g.half_size) h = random.uniform(0.05, 1.5);
    if (kind != ShapeKind::hull && kind != ShapeKind::mesh) return s;
    ShapeDef def;
    def.kind = kind;
    const int count = kind == ShapeKind::mesh ? 3 : random.integer(5, 12);
    for (int i = 0; i < count; ++i) def.vertices.push_back(random.vector(1.2));
    if (kind == ShapeKind::mesh) def.triangles = {{0, 1, 2}};
    s.points = def.vertices;
    find_faces(s);
    s.data = collide::make_shape_data(def);
    g.data = s.data.get();
    return s;
}

namespace {

Vec vec(const double* x) { return {x[0], x[1], x[2]}; }

Answer against_plane(const Body& a, const Body& plane) {
    const Vec n = plane.axis[2];
    return {dot(n, support(a, -1.0L * n) - plane.c) - a.rounding, -1.0L * n, 0};
}

}  // namespace

bool well_formed(const Manifold& m, double margin) {
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& p = m.point[i];
        const Vec n = vec(p.normal), d = vec(p.on[1]) - vec(p.on[0]);
        if (!std::isfinite(p.gap + p.on[0][0] + p.on[0][1] + p.on[0][2])) return false;
        if (std::fabs(length(n) - 1) > 1e-12L || !(p.gap < margin)) return false;
        // (on[1] − on[0]) · n is the gap, to rounding of coordinates of a few metres.
        if (std::fabs(dot(d, n) - p.gap) > 1e-12L) return false;
        if (i > 0 && m.point[i - 1].feature >= p.feature) return false;
    }
    return m.count <= collide::kMaxManifold;
}

namespace {

struct Pair {
    RandomShape a, b;
    Placement pa, pb;
    double margin;
};

Pair random_pair(ShapeKind a, ShapeKind b, std::uint64_t seed) {
    Random random(seed);
    Pair pair{random_shape(random, a), random_shape(random, b), {}, {}, 0.0};
    pair.pa = random_placement(random, 5.0);
    pair.pb = random_placement(random, 0.0);
    // About half of the pairs overlap.
    const Vec3 offset = random.vector(random.uniform(0.0, 1.8));
    for (int k = 0; k < 3; ++k) pair.pb.x[k] = pair.pa.x[k] + offset[k];
    pair.margin = random.chance(0.5) ? 0.01 : 0.6;
    return pair;
}

Placement on_grid(Random& random) {
    const Quat q = Quat(Eigen::AngleAxisd(random.integer(0, 7) * M_PI / 4, Vec3(0, 0, 1))) *
                   Quat(Eigen::AngleAxisd(random.integer(0, 7) * M_PI / 4, Vec3(1, 0, 0))) *
                   Quat(Eigen::AngleAxisd(random.integer(0, 1) * M_PI / 2, Vec3(0, 1, 0)));
    const Mat3 r = q.toRotationMatrix();
    Placement p{};
    for (int i = 0; i < 3; ++i) {
        p.x[i] = 0.25 * random.integer(-6, 6);
        for (int j = 0; j < 3; ++j) p.r[3 * i + j] = r(i, j);
    }
    return p;
}

Pair aligned_pair(ShapeKind a, ShapeKind b, std::uint64_t seed) {
    Random random(seed);
    Pair pair{random_shape(random, a), random_shape(random, b), {}, {}, 0.1};
    for (RandomShape* s : {&pair.a, &pair.b}) {
        Geometry& g = s->geometry;
        g.radius = 0.25 * random.integer(1, 3);
        g.half_length = 0.25 * random.integer(1, 4);
        for (double& h : g.half_size) h = 0.25 * random.integer(1, 4);
    }
    pair.pa = on_grid(random);
    pair.pb = on_grid(random);
    return pair;
}

Pair extreme_pair(ShapeKind a, ShapeKind b, std::uint64_t seed) {
    Random random(seed);
    Pair pair{random_shape(random, a), random_shape(random, b), {}, {}, 0.05};
    double reach = 0.0;
    for (RandomShape* s : {&pair.a, &pair.b}) {
        Geometry& g = s->geometry;
        g.radius = std::pow(10.0, random.uniform(-3, 2));
        g.half_length = std::pow(10.0, random.uniform(-3, 2));
        for (double& h : g.half_size) h = std::pow(10.0, random.uniform(-3, 2));
        reach += std::max({g.radius, g.half_length, g.half_size[0], g.half_size[1]});
    }
    pair.pa = random_placement(random, 100.0);
    pair.pb = random_placement(random, 0.0);
    const Vec3 offset = random.vector(reach * std::pow(10.0, random.uniform(-3, 0)));
    for (int k = 0; k < 3; ++k) pair.pb.x[k] = pair.pa.x[k] + offset[k];
    return pair;
}

}  // namespace

Body body_of(const RandomShape& s, const Placement& placed) {
    if (s.points.empty()) return reference::make_body(s.geometry, placed);
    const auto turned = [&](const std::vector<Vec3>& list, bool shifted) {
        std::vector<Vec> out;
        for (const Vec3& v : list) {
            Real x[3];
            for (int i = 0; i < 3; ++i) {
                x[i] = shifted ? placed.x[i] : 0.0;
                for (int j = 0; j < 3; ++j) x[i] += Real(placed.r[3 * i + j]) * v[j];
            }
            out.push_back({x[0], x[1], x[2]});
        }
        return out;
    };
    return reference::make_points(turned(s.points, true), turned(s.faces, false),
                                  turned(s.edges, false));
}

namespace {

void check_one(const Pair& pair, std::uint64_t seed, Draw draw, Score& score) {
    const Body a = body_of(pair.a, pair.pa), b = body_of(pair.b, pair.pb);
    const Geometry &ga = pair.a.geometry, &gb = pair.b.geometry;
    Answer truth =
        gb.kind == ShapeKind::plane ? against_plane(a, b) : reference::signed_distance(a, b);
    Manifold m;
    collide::collide_function(ga.kind, gb.kind)(ga, pair.pa, gb, pair.pb, pair.margin, m);
    ++score.pairs;
    ++(truth.gap < 0 ? score.touching : score.separated);
    if (!well_formed(m, pair.margin)) ++score.bad_points;
    const bool expected = truth.gap < pair.margin;
    if (expected != (m.count > 0) && std::fabs(truth.gap - pair.margin) > 1e-6L)
        ++score.wrong_results;
    if (m.count == 0 || !expected) return;
    const ManifoldPoint* deepest = &m.point[0];
    for (int i = 1; i < m.count; ++i)
        if (m.point[i].gap < deepest->gap) deepest = &m.point[i];
    const Vec n = vec(deepest->normal);
    // Along any normal the distance is at least this: the scan of the reference may miss a maximum.
    const Real along = gb.kind == ShapeKind::plane ? truth.gap : separation_along(a, b, n);
    const bool missed = along > truth.gap + 1e-9L;
    truth.gap = std::max(truth.gap, along);
    if ((deepest->gap < 0) != (truth.gap < 0) && std::fabs(truth.gap) > 1e-6L)
        ++score.wrong_results;
    const double gap_error = std::fabs(static_cast<double>(deepest->gap - truth.gap));
    if (gap_error > score.worst_gap) score.worst_gap = gap_error, score.gap_pair = seed;
    if (missed) return void(++score.ambiguous);
    const double normal_error = static_cast<double>(length(n - truth.n));
    if (normal_error <= score.worst_normal || truth.normal_error > 1e-7L) return;
    // Not unique: a different normal has an equal distance.
    const bool as_good =
        gb.kind != ShapeKind::plane && along > truth.gap - (draw == Draw::aligned ? 1e-8L : 1e-9L);
    if (as_good && (normal_error > 1e-3 || draw == Draw::aligned)) {
        ++score.ambiguous;
    } else {
        score.worst_normal = normal_error;
        score.normal_pair = seed;
    }
}

}  // namespace

Score compare_pairs(ShapeKind a, ShapeKind b, int count, std::uint64_t seed, Draw draw) {
    Score score;
    const auto make =
        draw == Draw::random ? random_pair : (draw == Draw::aligned ? aligned_pair : extreme_pair);
    for (int i = 0; i < count; ++i) {
        const std::uint64_t s = seed + static_cast<std::uint64_t>(i);
        check_one(make(a, b, s), s, draw, score);
    }
    return score;
}

std::vector<std::pair<ShapeKind, ShapeKind>> exact_pairs() {
    using enum ShapeKind;
    return {{sphere, sphere},     {sphere, capsule},  {sphere, box},   {sphere, cylinder},
            {sphere, plane},      {capsule, capsule}, {capsule, box},  {capsule, cylinder},
            {capsule, plane},     {box, box},         {box, cylinder}, {box, plane},
            {cylinder, cylinder}, {cylinder, plane}};
}

std::vector<std::pair<ShapeKind, ShapeKind>> vertex_pairs() {
    using enum ShapeKind;
    return {{sphere, hull}, {capsule, hull},  {box, hull},    {cylinder, hull},
            {hull, hull},   {hull, plane},    {sphere, mesh}, {capsule, mesh},
            {box, mesh},    {cylinder, mesh}, {hull, mesh}};
}

std::string kind_name(ShapeKind kind) {
    static const char* const kNames[] = {"sphere", "capsule",     "box",  "cylinder",
                                         "plane",  "heightfield", "hull", "mesh"};
    return kNames[static_cast<int>(kind)];
}

std::string describe(ShapeKind a, ShapeKind b, const Score& s) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "%-8s %-9s pairs %6d overlap %6d wrong %d bad %d gap %.1e m (%llu) normal %.1e "
                  "(%llu) not unique %d",
                  kind_name(a).c_str(), kind_name(b).c_str(), s.pairs, s.touching, s.wrong_results,
                  s.bad_points, s.worst_gap, static_cast<unsigned long long>(s.gap_pair),
                  s.worst_normal, static_cast<unsigned long long>(s.normal_pair), s.ambiguous);
    return text;
}

}  // namespace hawser::test
