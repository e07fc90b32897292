// SPDX-License-Identifier: Apache-2.0
#include "collide/touch.h"

#include "base/small.h"
#include "collide/collide_function.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::collide {
namespace {

using generic::dot;
using generic::load3;
using generic::store3;
using generic::V3;
/// A point on a segment nearer to an end than this fraction of the length is the end.
constexpr double kAtEnd = 1e-9;
/// Limit for two wires attached to one body, over the sum of the radii of two capsules. They do not
/// touch if the contact is nearer than this to both attachment points.
constexpr double kMinAttachmentRatio = 2.0;
constexpr double kSameNormal = 0.95;  ///< Cosine of 18°.

/// Append the bodies of one side of a contact to its slots. @param on  Point on the surface. @param
/// inward Unit vector from this point into the shape. @return the position along a segment, from −1
/// at its first end to 1; 0 for other shapes.
double add_side(Contact& c, const Shape& s, const Placed& p, const double* on,
                const V3& inward) noexcept {
    auto add = [&](std::int32_t body, double weight) {
        c.body[c.slots] = body;
        c.weight[c.slots++] = weight;
    };
    if (!s.segment()) {
        add(s.body[0], 1.0);
        return 0.0;
    }
    // Use the point on the axis: the force is distributed to the ends as for a beam on two
    // supports.
    const V3 from = load3(on) + p.geometry.radius * inward - load3(p.at.x);
    const double along = dot(from, {p.at.r[2], p.at.r[5], p.at.r[8]});
    const double half = p.geometry.half_length;
    double t = half > 0.0 ? 0.5 + 0.5 * along / half : 0.5;
    // The body that holds an end has its weight at the point on the surface (Contacts::set). This
    // differs from a contact of the body alone.
    if (s.held == 0) t = std::max(t, 2.0 * kAtEnd);
    if (s.held == 1) t = std::min(t, 1.0 - 2.0 * kAtEnd);
    if (t <= kAtEnd) {
        add(s.body[0], 1.0);
        return -1.0;
    }
    if (t >= 1.0 - kAtEnd) {
        add(s.body[1], 1.0);
        return 1.0;
    }
    add(s.body[0], 1.0 - t);
    add(s.body[1], t);
    return 2.0 * t - 1.0;
}

/// Return the velocity of a shape at `point`. @param place  Position along a segment, from
/// add_side().
V3 velocity(const Placed& p, double place, const V3& point) noexcept {
    return load3(p.motion.v) + generic::cross(load3(p.motion.w), point - load3(p.origin)) +
           place * load3(p.stretch);
}

/// True if the point at which a body holds a segment lies within the bounding sphere of another
/// shape, enlarged by the radius and the margin.
bool is_near_held_end(const Shape& s, const Placed& p, const Placed& other,
                      double margin) noexcept {
    if (other.unbounded) return true;
    const V3 separation = load3(p.held) - load3(other.centre);
    const double reach = other.radius + s.geometry.radius + margin;
    return dot(separation, separation) <= reach * reach;
}

/// Return the distance along a segment from its hold to a position that add_side() returned [m].
double distance_from_hold(const Shape& s, const Placed& p, double place) noexcept {
    return p.geometry.half_length * (s.held == 0 ? 1.0 + place : 1.0 - place);
}

/// Return twice the area of triangle a b c.
double area(const ManifoldPoint& a, const ManifoldPoint& b, const ManifoldPoint& c) noexcept {
    const V3 o = load3(a.on[0]);
    return generic::norm(generic::cross(load3(b.on[0]) - o, load3(c.on[0]) - o));
}

/// Choose kMaxPoints points from the list `of` of `count` > kMaxPoints points. If points are equal,
/// choose the first.
void choose_points(const Manifold& m, const int* of, int count, bool* keep) noexcept {
    int chosen[kMaxPoints] = {of[0], -1, -1, -1};
    for (int i = 1; i < count; ++i)
        if (m.point[of[i]].gap < m.point[chosen[0]].gap) chosen[0] = of[i];
    for (int k = 1; k < kMaxPoints; ++k) {
        double best = -1.0;
        for (int i = 0; i < count; ++i) {
            const int p = of[i];
            if (std::find(chosen, chosen + k, p) != chosen + k) continue;
            const ManifoldPoint& q = m.point[p];
            double gain = 0.0;
            if (k == 1) {
                const V3 d = load3(q.on[0]) - load3(m.point[chosen[0]].on[0]);
                gain = dot(d, d);
            } else if (k == 2) {
                gain = area(m.point[chosen[0]], m.point[chosen[1]], q);
            } else {
                // Area that the point adds to a triangle; the minimum is reached if it is inside.
                const double whole =
                    area(m.point[chosen[0]], m.point[chosen[1]], m.point[chosen[2]]);
                gain = area(m.point[chosen[0]], m.point[chosen[1]], q) +
                       area(m.point[chosen[1]], m.point[chosen[2]], q) +
                       area(m.point[chosen[2]], m.point[chosen[0]], q) - whole;
                gain = std::max(gain, 0.0);
            }
            if (gain > best) {
                best = gain;
                chosen[k] = p;
            }
        }
    }
    for (const int p : chosen) keep[p] = true;
}

}  // namespace

void reduce(Manifold& m) noexcept {
    if (m.count <= kMaxPoints) return;
    bool keep[kMaxManifold] = {}, done[kMaxManifold] = {};
    for (int i = 0; i < m.count; ++i) {
        if (done[i]) continue;
        int group[kMaxManifold], count = 0;
        for (int j = i; j < m.count; ++j)
            if (!done[j] && dot(load3(m.point[i].normal), load3(m.point[j].normal)) > kSameNormal)
                group[count++] = j;
        for (int j = 0; j < count; ++j) done[group[j]] = true;
        if (count > kMaxPoints)
            choose_points(m, group, count, keep);
        else
            for (int j = 0; j < count; ++j) keep[group[j]] = true;
        done[i] = true;
    }
    int kept = 0;
    for (int i = 0; i < m.count; ++i)
        if (keep[i]) m.point[kept++] = m.point[i];
    m.count = kept;
}

int touch(const Shape& a, const Placed& pa, const Shape& b, const Placed& pb, double h,
          double margin, bool share_host, Contact* out) noexcept {
    const Collide collide = collide_function(a.geometry.kind, b.geometry.kind);
    if (collide == nullptr) return 0;
    const bool both_held = a.held >= 0 && b.held >= 0;
    if (share_host && !both_held &&
        (a.held >= 0 ? is_near_held_end(a, pa, pb, margin) : is_near_held_end(b, pb, pa, margin)))
        return 0;
    margin = std::max({margin, a.margin, b.margin});
    Manifold m;
    m.count = 0;
    collide(pa.geometry, pa.at, pb.geometry, pb.at, margin + h * relative_speed(pa, pb), m);
    reduce(m);
    int count = 0;
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& p = m.point[i];
        Contact& c = out[count];
        c = Contact{};
        std::fill_n(c.body, kMaxContactBodies, -1);
        const V3 n = load3(p.normal);
        // Skip contacts of shapes so far away that their size is below the rounding there.
        if (!(std::fabs(dot(n, n) - 1.0) < 1e-6) || !std::isfinite(p.gap)) continue;
        const double ta = add_side(c, a, pa, p.on[0], -n);
        c.side_0 = c.slots;
        const double tb = add_side(c, b, pb, p.on[1], n);
        const double attachment_distance =
            kMinAttachmentRatio * (a.geometry.radius + b.geometry.radius);
        if (share_host && both_held && distance_from_hold(a, pa, ta) < attachment_distance &&
            distance_from_hold(b, pb, tb) < attachment_distance)
            continue;
        const V3 middle = 0.5 * (load3(p.on[0]) + load3(p.on[1]));
        const double opening = dot(n, velocity(pb, tb, middle) - velocity(pa, ta, middle));
        if (!(p.gap < margin + h * std::max(0.0, -opening))) continue;
        c.feature = p.feature;
        c.previous = -1;
        store3(c.normal, n);
        for (int s = 0; s < 2; ++s) std::copy_n(p.on[s], 3, c.on[s]);
        c.gap = p.gap;
        ++count;
    }
    // Stable insertion sort of a few contacts.
    for (int i = 1; i < count; ++i)
        for (int j = i; j > 0 && out[j].feature < out[j - 1].feature; --j)
            std::swap(out[j], out[j - 1]);
    return count;
}

}  // namespace hawser::collide
