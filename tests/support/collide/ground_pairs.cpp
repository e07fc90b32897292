// SPDX-License-Identifier: Apache-2.0
#include "support/collide/ground_pairs.h"

#include "collide/collide_function.h"
#include "support/collide/ground_claims.h"

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

namespace {

bool on_triangle(const Face& f, Vec p) {
    return std::fabs(dot(f.normal, p - f.corner[0])) < kBand && beyond_edges(f, p) < 10 * kBand;
}

/// Return the distance of a point to the boundary of the shape's core, moved by its rounding along
/// n.
Real off_boundary(Body a, Vec p, Vec n) {
    p = p - a.rounding * n;
    a.rounding = 0;
    return std::fabs(reference::signed_distance(a, reference::make_points({p}, {}, {})).gap);
}

/// Compare the normal with those of all claims that have this gap.
void check_normal(const std::vector<Claim>& claims, Real gap, const Body& a, Vec n,
                  std::uint64_t seed, GroundScore& score) {
    Real error = 1e30L;
    bool known = false, as_good = false;
    for (const Claim& c : claims) {
        if (std::fabs(c.gap - gap) > kBand) continue;
        if (c.normal_error <= 1e-7L) known = true;
        error = std::min(error, length(n - c.n));
        as_good = as_good || separation_along(a, c.face->body, n) > c.gap - 1e-9L;
    }
    if (!known || (as_good && error > 1e-3L)) return void(++score.ambiguous);
    ++score.normals;
    if (static_cast<double>(error) <= score.worst_normal) return;
    score.worst_normal = static_cast<double>(error);
    score.normal_pair = seed;
}

void check_joint_gap(Real error, std::uint64_t seed, GroundScore& score) {
    if (std::fabs(static_cast<double>(error)) <= score.worst_gap) return;
    score.worst_gap = std::fabs(static_cast<double>(error));
    score.gap_pair = seed;
}

void check_inside(const Claims& claims, const Body& a, const ManifoldPoint& p, std::uint64_t seed,
                  GroundScore& score) {
    const Vec n{p.normal[0], p.normal[1], p.normal[2]};
    const Vec on0{p.on[0][0], p.on[0][1], p.on[0][2]}, on1{p.on[1][0], p.on[1][1], p.on[1][2]};
    Real sure = 0;
    for (const Claim& c : claims.list)
        if (c.sure) sure = std::min(sure, c.gap);
    const Claim* own = nullptr;
    Real error = 1e30L;
    for (const Claim& c : claims.list) {
        if (std::fabs(c.gap - p.gap) > kBand || p.gap > sure + kBand) continue;
        if (length(n - c.n) < error) own = &c, error = length(n - c.n);
    }
    // A point beside its triangle may happen to be as deep as the claim of another one.
    for (const Face* f : claims.clipped) {
        if (error < kBand || p.gap > sure + kBand || !on_triangle(*f, on1)) continue;
        if (1 - std::fabs(dot(n, f->normal)) > 1e-13L || off_boundary(a, on0, n) > kBand) continue;
        return void(++score.beside);
    }
    if (own != nullptr) {
        ++score.own;
        check_joint_gap(own->gap - p.gap, seed, score);
        return check_normal(claims.list, p.gap, a, n, seed, score);
    }
    if (sure < 0) return check_joint_gap(sure - p.gap, seed, score);
    ++score.left;
    check_joint_gap(claims.left.gap - p.gap, seed, score);
    check_normal({claims.left}, p.gap, a, n, seed, score);
}

struct GroundPair {
    RandomShape shape;
    Surface surface;
    Placement placed;
    double margin;
};

GroundPair random_ground_pair(ShapeKind kind, Ground ground, std::uint64_t seed) {
    Random random(seed);
    GroundPair pair{random_shape(random, kind), random_surface(random, ground), {}, 0.0};
    pair.placed = random_placement(random, 0.0);
    // About half of the pairs overlap.
    Vec3 x(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-0.5, 3.0));
    if (ground != Ground::heightfield) x.z() = random.uniform(-2.5, 2.5);
    if (ground == Ground::rock) x.head<2>() *= 4.0;
    const Vec at = turned(pair.surface.placed, x);
    pair.placed.x[0] = pair.surface.placed.x[0] + static_cast<double>(at.x);
    pair.placed.x[1] = pair.surface.placed.x[1] + static_cast<double>(at.y);
    pair.placed.x[2] = pair.surface.placed.x[2] + static_cast<double>(at.z);
    pair.margin = random.chance(0.5) ? 0.01 : 0.6;
    return pair;
}

void check_ground_pair(const GroundPair& pair, std::uint64_t seed, GroundScore& score) {
    const Surface& s = pair.surface;
    const Body body = body_of(pair.shape, pair.placed);
    const Claims claims = claims_on(s, body, body.c, pair.margin);
    Geometry geometry;
    geometry.kind = s.def.kind;
    geometry.data = s.data.get();
    const Geometry& shape = pair.shape.geometry;
    Manifold m;
    collide::collide_function(shape.kind, geometry.kind)(shape, pair.placed, geometry, s.placed,
                                                         pair.margin, m);
    ++score.pairs;
    ++(claims.inside ? score.touching : score.separated);
    if (!well_formed(m, pair.margin)) ++score.bad_points;
    const ManifoldPoint* deepest = &m.point[0];
    for (int i = 1; i < m.count; ++i)
        if (m.point[i].gap < deepest->gap) deepest = &m.point[i];
    const Real truth = claims.truth;
    if (claims.inside) {
        const bool touches = m.count > 0 && deepest->gap < 0;
        if (!touches && std::fabs(truth) > kBand) score.wrong(seed);
        if (touches) check_inside(claims, body, *deepest, seed, score);
        return;
    }
    if ((m.count > 0) != (truth < pair.margin) && std::fabs(truth - pair.margin) > kBand)
        score.wrong(seed);
    if (m.count == 0 || !(truth < pair.margin)) return;
    check_joint_gap(truth - deepest->gap, seed, score);
    const Vec n{deepest->normal[0], deepest->normal[1], deepest->normal[2]};
    check_normal(claims.nearest, truth, body, n, seed, score);
}

}  // namespace

GroundScore check_ground(ShapeKind a, Ground ground, int count, std::uint64_t seed) {
    GroundScore score;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t s = seed + static_cast<std::uint64_t>(i);
        check_ground_pair(random_ground_pair(a, ground, s), s, score);
    }
    return score;
}

std::vector<ShapeKind> ground_kinds() {
    using enum ShapeKind;
    return {sphere, capsule, box, cylinder, hull};
}

std::vector<Ground> grounds() { return {Ground::heightfield, Ground::terrain, Ground::rock}; }

std::string describe(ShapeKind a, Ground ground, const GroundScore& s) {
    static const char* const kNames[] = {"heightfield", "terrain", "rock"};
    char text[400];
    std::snprintf(text, sizeof text,
                  "%-8s %-11s pairs %6d overlap %6d (own %d beside %d left %d) wrong %d (%llu) bad "
                  "%d gap %.1e m (%llu) normals %d worst %.1e (%llu) not unique %d",
                  kind_name(a).c_str(), kNames[static_cast<int>(ground)], s.pairs, s.touching,
                  s.own, s.beside, s.left, s.wrong_results,
                  static_cast<unsigned long long>(s.wrong_pair), s.bad_points, s.worst_gap,
                  static_cast<unsigned long long>(s.gap_pair), s.normals, s.worst_normal,
                  static_cast<unsigned long long>(s.normal_pair), s.ambiguous);
    return text;
}

}  // namespace hawser::test
