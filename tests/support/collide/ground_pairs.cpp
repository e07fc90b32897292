// SPDX-License-Identifier: Apache-2.0
#include "support/collide/ground_pairs.h"

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

constexpr Real kBand = 1e-6L;  ///< Verdicts and depths within it are equal [m].
/// Normals and places this close to the bounds between two rules may follow either.
constexpr Real kEither = 1e-4L;

// --- What a triangle claims ---------------------------------------------------------------

enum class Holds { yes, no, either };

/// Whether m, out of the surface, is a normal at the part of the triangle that faces it.
Holds allowed(const Surface& s, const Face& f, Vec m) {
    int top = 0;
    for (int k = 1; k < 3; ++k)
        if (dot(m, f.corner[k] - f.corner[top]) > 0) top = k;
    bool faces[3], near = false;
    int facing = 0;
    for (int k = 0; k < 3; ++k) {
        const Real tilt = std::fabs(dot(m, unit(f.corner[(k + 1) % 3] - f.corner[k])));
        faces[k] = tilt < 1e-7L;
        facing += faces[k];
        // Only edges at the top can face m.
        near = near || (!faces[k] && tilt < kEither && (k == top || (k + 1) % 3 == top));
    }
    if (near) return Holds::either;
    if (facing >= 2) return Holds::yes;
    const auto rise = [&](int w) { return dot(m, unit(s.world[w] - f.corner[top])); };
    Real most = -1;
    for (int k = 0; k < 3; ++k)
        if (facing == 1 && faces[k] && f.beyond[k] >= 0) most = rise(f.beyond[k]);
    if (facing == 0)
        for (const int w : s.ring[f.vertex[top]]) most = std::max(most, rise(w));
    return std::fabs(most) < kEither ? Holds::either : (most > 0 ? Holds::no : Holds::yes);
}

/// How far p is beyond the edges of the triangle, seen along its normal.
Real beyond_edges(const Face& f, Vec p) {
    Real most = -1e30L;
    for (int k = 0; k < 3; ++k) {
        Vec out = unit(cross(f.corner[(k + 1) % 3] - f.corner[k], f.normal));
        if (dot(out, f.corner[(k + 2) % 3] - f.corner[k]) > 0) out = -1.0L * out;
        most = std::max(most, dot(out, p - f.corner[k]));
    }
    return most;
}

struct Claim {
    Real gap;
    Vec n;  ///< From the shape to the surface.
    const Face* face;
    Real normal_error;
    bool sure;
};

struct Claims {
    std::vector<Claim> nearest;  ///< Signed distances, as they are.
    std::vector<Claim> list;
    std::vector<const Face*> clipped;          ///< Whose normal takes the place of another.
    bool inside = false;                       ///< Overlaps, or is below a solid.
    Real truth = 1e30L;                        ///< Least signed distance to a triangle.
    Claim left{-1e30L, {}, nullptr, 0, true};  ///< Of what no triangle claims.
};

/// The deepest point along the normal of the triangle, on one side.
void claim_along(const Body& a, const Face& f, Vec n, bool sure, Claims& out) {
    const Vec p = support(a, -1.0L * n);
    const Real gap = dot(n, p - f.corner[0]) - a.rounding, beyond = beyond_edges(f, p);
    if (beyond < kEither) out.list.push_back({gap, -1.0L * n, &f, 0, sure && beyond < -kEither});
    out.clipped.push_back(&f);
}

/// Lower bound of the distance: along the normal, and beyond the edges.
Real at_least(const Body& a, const Face& f) {
    Real most = std::max(separation_along(a, f.body, f.normal),
                         separation_along(a, f.body, -1.0L * f.normal));
    for (int k = 0; k < 3; ++k) {
        const Vec out = unit(cross(f.corner[(k + 1) % 3] - f.corner[k], f.normal));
        most = std::max(
            {most, separation_along(a, f.body, out), separation_along(a, f.body, -1.0L * out)});
    }
    return most;
}

/// Whether the triangle's cell (of a heightfield) meets the box around the shape, by how much.
Real under_box(const Surface& s, const Body& a, const Face& f) {
    Real least = 1e30L;
    for (int k = 0; k < 2; ++k) {
        const Vec3 axis = k == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const Vec n = turned(s.placed, axis);
        const auto at = [&](Vec p) { return k == 0 ? local(s.placed, p).x : local(s.placed, p).y; };
        const Real high = at(support(a, n)) + a.rounding;
        const Real low = at(support(a, -1.0L * n)) - a.rounding;
        Real from = 1e30L, to = -1e30L;
        for (const int v : f.vertex) {
            from = std::min<Real>(from, s.vertices[v][k]);
            to = std::max<Real>(to, s.vertices[v][k]);
        }
        least = std::min({least, high - from, to - low});
    }
    return least;
}

void claim(const Surface& s, const Body& a, const Face& f, const Answer& answer, Claims& out) {
    const Vec m = -1.0L * answer.n;
    const Real along = dot(m, f.normal);
    const Holds holds = allowed(s, f, m);
    const bool below = s.solid && along <= 0;
    const bool unsure = holds == Holds::either || (s.solid && std::fabs(along) < kEither);
    if (unsure || (!below && holds == Holds::yes))
        out.list.push_back({answer.gap, answer.n, &f, answer.normal_error, !unsure});
    if (!unsure && !below && holds == Holds::yes) return;
    if (!s.solid && answer.gap > 0) return;
    const Real centre = dot(f.normal, a.c - f.corner[0]);
    const bool either = !s.solid && std::fabs(along) < 0.5L + kEither &&
                        (std::fabs(centre) < kEither || std::fabs(along) > 0.5L - kEither);
    const bool up = s.solid || (std::fabs(along) < 0.5L ? centre > 0 : along > 0);
    // Cells beyond the box around the shape may be left out, or not: it need not be the least one.
    const bool sure = !unsure && !either && (!s.solid || under_box(s, a, f) > kEither);
    if (up || either) claim_along(a, f, f.normal, sure, out);
    if (!up || either) claim_along(a, f, -1.0L * f.normal, sure, out);
}

bool is_above(const Surface& s, const Face& f, Vec point) {
    const Vec p = local(s.placed, point);
    const Vec3 *v[3], at(p.x, p.y, 0.0);
    for (int k = 0; k < 3; ++k) v[k] = &s.vertices[f.vertex[k]];
    Real part[3], sum = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &q = *v[(k + 1) % 3], &r = *v[(k + 2) % 3];
        part[k] = (q.x() - at.x()) * Real(r.y() - at.y()) - (q.y() - at.y()) * Real(r.x() - at.x());
        sum += part[k];
    }
    Real height = 0;
    for (int k = 0; k < 3; ++k) {
        if (part[k] / sum < 0) return false;
        height += part[k] / sum * v[k]->z();
    }
    return p.z < height;
}

void claim_left(const Body& a, const Face& f, Vec n, Claims& out) {
    const Real gap = dot(n, support(a, -1.0L * n) - f.corner[0]) - a.rounding;
    if (gap < 0 && gap > out.left.gap) out.left = {gap, -1.0L * n, &f, 0, true};
}

Claims claims_on(const Surface& s, const Body& a, Vec middle, Real margin) {
    std::vector<std::pair<Real, const Face*>> order;
    for (const Face& f : s.faces) order.emplace_back(at_least(a, f), &f);
    std::sort(order.begin(), order.end());
    Claims out;
    for (const auto& [bound, face] : order) {
        const Face& f = *face;
        bool cut = false;
        bool up = s.solid || dot(f.normal, middle - f.corner[0]) > 0;
        if (bound < std::max(std::min(out.truth, margin), Real(0)) + 10 * kBand) {
            const Answer answer = reference::signed_distance(a, f.body);
            out.truth = std::min(out.truth, answer.gap);
            out.nearest.push_back({answer.gap, answer.n, &f, answer.normal_error, true});
            cut = answer.gap < 0;
            const Real along = dot(f.normal, answer.n);
            if (!s.solid && std::fabs(along) > 0.5L) up = along < 0;
            claim(s, a, f, answer, out);
        } else {
            out.truth = std::min(out.truth, bound);
            // Wholly below the triangle: pushed up where it is under it.
            const bool below = separation_along(a, f.body, f.normal) > 0;
            if (s.solid) claim_along(a, f, f.normal, below && under_box(s, a, f) > kEither, out);
        }
        if (s.solid && is_above(s, f, middle)) out.inside = true;
        if (!cut && !(s.solid && is_above(s, f, middle))) continue;
        claim_left(a, f, up ? f.normal : -1.0L * f.normal, out);
    }
    out.inside = out.inside || out.truth < 0;
    return out;
}

// --- Judging ------------------------------------------------------------------------------

bool on_triangle(const Face& f, Vec p) {
    return std::fabs(dot(f.normal, p - f.corner[0])) < kBand && beyond_edges(f, p) < 10 * kBand;
}

/// Distance of a point to the boundary of the shape's core, moved by its rounding along n.
Real off_boundary(Body a, Vec p, Vec n) {
    p = p - a.rounding * n;
    a.rounding = 0;
    return std::fabs(reference::signed_distance(a, reference::make_points({p}, {}, {})).gap);
}

/// Compare the normal with those of all claims that have this gap.
void judge_normal(const std::vector<Claim>& claims, Real gap, const Body& a, Vec n,
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

void judge_gap(Real error, std::uint64_t seed, GroundScore& score) {
    if (std::fabs(static_cast<double>(error)) <= score.worst_gap) return;
    score.worst_gap = std::fabs(static_cast<double>(error));
    score.gap_pair = seed;
}

void judge_inside(const Claims& claims, const Body& a, const ManifoldPoint& p, std::uint64_t seed,
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
    // One beside its triangle may happen to be as deep as the claim of another.
    for (const Face* f : claims.clipped) {
        if (error < kBand || p.gap > sure + kBand || !on_triangle(*f, on1)) continue;
        if (1 - std::fabs(dot(n, f->normal)) > 1e-13L || off_boundary(a, on0, n) > kBand) continue;
        return void(++score.beside);
    }
    if (own != nullptr) {
        ++score.own;
        judge_gap(own->gap - p.gap, seed, score);
        return judge_normal(claims.list, p.gap, a, n, seed, score);
    }
    if (sure < 0) return judge_gap(sure - p.gap, seed, score);
    ++score.left;
    judge_gap(claims.left.gap - p.gap, seed, score);
    judge_normal({claims.left}, p.gap, a, n, seed, score);
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

void judge_ground_pair(const GroundPair& pair, std::uint64_t seed, GroundScore& score) {
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
    ++(claims.inside ? score.touching : score.apart);
    if (!well_formed(m, pair.margin)) ++score.bad_points;
    const ManifoldPoint* deepest = &m.point[0];
    for (int i = 1; i < m.count; ++i)
        if (m.point[i].gap < deepest->gap) deepest = &m.point[i];
    const Real truth = claims.truth;
    if (claims.inside) {
        const bool touches = m.count > 0 && deepest->gap < 0;
        if (!touches && std::fabs(truth) > kBand) score.wrong(seed);
        if (touches) judge_inside(claims, body, *deepest, seed, score);
        return;
    }
    if ((m.count > 0) != (truth < pair.margin) && std::fabs(truth - pair.margin) > kBand)
        score.wrong(seed);
    if (m.count == 0 || !(truth < pair.margin)) return;
    judge_gap(truth - deepest->gap, seed, score);
    const Vec n{deepest->normal[0], deepest->normal[1], deepest->normal[2]};
    judge_normal(claims.nearest, truth, body, n, seed, score);
}

}  // namespace

GroundScore judge_ground(ShapeKind a, Ground ground, int count, std::uint64_t seed) {
    GroundScore score;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t s = seed + static_cast<std::uint64_t>(i);
        judge_ground_pair(random_ground_pair(a, ground, s), s, score);
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
                  s.own, s.beside, s.left, s.wrong_verdicts,
                  static_cast<unsigned long long>(s.wrong_pair), s.bad_points, s.worst_gap,
                  static_cast<unsigned long long>(s.gap_pair), s.normals, s.worst_normal,
                  static_cast<unsigned long long>(s.normal_pair), s.ambiguous);
    return text;
}

}  // namespace hawser::test
