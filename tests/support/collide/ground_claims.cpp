// SPDX-License-Identifier: Apache-2.0
#include "support/collide/ground_claims.h"

#include <algorithm>
#include <cmath>

namespace hawser::test {

using reference::Answer;
using reference::Body;
using reference::Real;
using reference::Vec;

Real beyond_edges(const Face& f, Vec p) {
    Real most = -1e30L;
    for (int k = 0; k < 3; ++k) {
        Vec out = unit(cross(f.corner[(k + 1) % 3] - f.corner[k], f.normal));
        if (dot(out, f.corner[(k + 2) % 3] - f.corner[k]) > 0) out = -1.0L * out;
        most = std::max(most, dot(out, p - f.corner[k]));
    }
    return most;
}

namespace {

/// Normals and positions this close to the bounds between two rules may follow either.
constexpr Real kEither = 1e-4L;

enum class Holds { yes, no, either };

/// Check whether m, out of the surface, is a normal at the part of the triangle that faces it.
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

/// Add the deepest point along the normal of the triangle, on one side.
void claim_along_normal(const Body& a, const Face& f, Vec n, bool sure, Claims& out) {
    const Vec p = support(a, -1.0L * n);
    const Real gap = dot(n, p - f.corner[0]) - a.rounding, beyond = beyond_edges(f, p);
    if (beyond < kEither) out.list.push_back({gap, -1.0L * n, &f, 0, sure && beyond < -kEither});
    out.clipped.push_back(&f);
}

/// Return a lower bound of the distance: along the normal, and beyond the edges.
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

/// Return by how much the triangle's cell (of a heightfield) meets the box around the shape.
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

void add_claims(const Surface& s, const Body& a, const Face& f, const Answer& answer, Claims& out) {
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
    // Cells beyond the box around the shape may be left out or not: the depth need not be the
    // least.
    const bool sure = !unsure && !either && (!s.solid || under_box(s, a, f) > kEither);
    if (up || either) claim_along_normal(a, f, f.normal, sure, out);
    if (!up || either) claim_along_normal(a, f, -1.0L * f.normal, sure, out);
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

void claim_unclaimed(const Body& a, const Face& f, Vec n, Claims& out) {
    const Real gap = dot(n, support(a, -1.0L * n) - f.corner[0]) - a.rounding;
    if (gap < 0 && gap > out.left.gap) out.left = {gap, -1.0L * n, &f, 0, true};
}

}  // namespace

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
            add_claims(s, a, f, answer, out);
        } else {
            out.truth = std::min(out.truth, bound);
            // Entirely below the triangle: pushed up where it is under it.
            const bool below = separation_along(a, f.body, f.normal) > 0;
            if (s.solid)
                claim_along_normal(a, f, f.normal, below && under_box(s, a, f) > kEither, out);
        }
        if (s.solid && is_above(s, f, middle)) out.inside = true;
        if (!cut && !(s.solid && is_above(s, f, middle))) continue;
        claim_unclaimed(a, f, up ? f.normal : -1.0L * f.normal, out);
    }
    out.inside = out.inside || out.truth < 0;
    return out;
}

}  // namespace hawser::test
