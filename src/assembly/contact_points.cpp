// SPDX-License-Identifier: Apache-2.0
/// Single contact points: rows and law from geometry and memory, and the update of the memory.
#include "assembly/contacts.h"

#include "base/index.h"
#include "base/small.h"

#include <hawser/row_constants.h>

#include <algorithm>
#include <cmath>

namespace hawser::assembly {
namespace {

using namespace hawser::generic;

/// A point farther than this from its anchors [m] rolls: the anchors are reset.
constexpr double kMaxAnchorDistance = 1e-3;

V3 body_position(const model::Bodies& b, std::int32_t body) { return load3(&b.x[3 * at(body)]); }

/// Compute two unit vectors that form a right-handed frame with n.
void tangents(const V3& n, V3& t1, V3& t2) {
    const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    const V3 e = x <= y && x <= z ? V3{1, 0, 0} : (y <= z ? V3{0, 1, 0} : V3{0, 0, 1});
    t1 = e - dot(e, n) * n;
    t1 = (1.0 / norm(t1)) * t1;
    t2 = cross(n, t1);
}

/// True if a body that holds a segment moves points of the segment when it turns. Fixed bodies do
/// not.
bool carries(const model::Bodies& b, std::int32_t body) {
    return b.turns(body) && b.kind[at(body)] != BodyKind::fixed;
}

/// Return the body at an end of a segment for which carries() is true; −1 if both are point masses
/// or fixed.
std::int32_t carrier_of(const model::Bodies& b, std::int32_t first, std::int32_t second) {
    return carries(b, first) ? first : carries(b, second) ? second : -1;
}

/// Return the world position of an anchor.
V3 anchor_point(const model::Bodies& b, const ContactMemory& m, int side) {
    const std::int32_t first = m.body[side][0], second = m.body[side][1];
    V3 local = load3(m.anchor[side]);
    if (second >= 0) {
        if (const std::int32_t host = carrier_of(b, first, second); host >= 0)
            local = load9(&b.r[9 * at(host)]) * local;
        return m.fraction[side] * body_position(b, first) +
               (1.0 - m.fraction[side]) * body_position(b, second) + local;
    }
    const V3 offset = b.turns(first) ? load9(&b.r[9 * at(first)]) * local : local;
    return body_position(b, first) + offset;
}

/// Set the anchor of a side to a point given in the world frame.
void set_anchor(const model::Bodies& b, ContactMemory& m, int side, const V3& p) {
    const std::int32_t first = m.body[side][0], second = m.body[side][1];
    if (second >= 0) {
        V3 local = p - m.fraction[side] * body_position(b, first) -
                   (1.0 - m.fraction[side]) * body_position(b, second);
        if (const std::int32_t host = carrier_of(b, first, second); host >= 0)
            local = tmul(load9(&b.r[9 * at(host)]), local);
        store3(m.anchor[side], local);
        return;
    }
    const V3 offset = p - body_position(b, first);
    store3(m.anchor[side], b.turns(first) ? tmul(load9(&b.r[9 * at(first)]), offset) : offset);
}

/// Store the bodies of each side of a contact and their weights in its memory.
void store_sides(const ContactRow& row, ContactMemory& m) {
    for (int side = 0; side < 2; ++side) {
        int found = 0;
        m.body[side][1] = -1;
        for (int i = 0; i < row.slots; ++i) {
            const ContactSlot& s = row.slot[i];
            if ((s.weight > 0.0) != (side == 1)) continue;
            if (found == 0) m.fraction[side] = std::fabs(s.weight);
            m.body[side][found == 0 ? 0 : 1] = s.body;
            ++found;
        }
    }
}

V3 tangential(const V3& v, const V3& n) { return v - dot(v, n) * n; }

/// Return the arm of slot i of a contact at p: the vector from the centre of its body to the point
/// at which its part of the force acts. On a point mass the force acts at its position. If a body
/// and a point mass form one side, the arm of the body is such that the resultant of the side acts
/// at p. Momentum and angular momentum are then those of the force at p.
V3 arm_of(const collide::Contact& in, int i, const model::Bodies& bodies, const V3& p) {
    const std::int32_t body = in.body[i];
    const int begin = i < in.side_0 ? 0 : in.side_0, end = i < in.side_0 ? in.side_0 : in.slots;
    if (end - begin == 1 || !carries(bodies, body)) return p - body_position(bodies, body);
    V3 rest = p;
    for (int k = begin; k < end; ++k)
        if (k != i) rest = rest - in.weight[k] * body_position(bodies, in.body[k]);
    return (1.0 / in.weight[i]) * rest - body_position(bodies, body);
}

/// Return the mean mobility of a body at its part of a contact, w² (1/m + (r × e)ᵀ I⁻¹ (r × e))
/// averaged over the axes e [1/kg].
double slot_mobility(const model::Bodies& b, const ContactSlot& s) {
    if (s.dof == 0) return 0.0;
    double sum = 1.0 / b.mass[at(s.body)];
    if (s.dof == 6) {
        const M3 r = load9(&b.r[9 * at(s.body)]), inverse = load9(&b.inv_inertia[9 * at(s.body)]);
        const V3 arm = load3(s.arm);
        const V3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (const V3& e : axes) {
            const V3 c = tmul(r, cross(arm, e));
            sum += dot(c, inverse * c) / 3.0;
        }
    }
    return s.weight * s.weight * sum;
}

/// Return g_t, the tangential part of friction anchor 1 minus anchor 0, at the contact point p. New
/// anchors are set at p if the contact has none, or if p has rolled away from them.
V3 hold(const ContactRow& row, const model::Bodies& bodies, const V3& n, const V3& p,
        ContactMemory& m) {
    V3 gap_t{0, 0, 0};
    bool renewed = m.body[0][0] < 0;
    if (!renewed) {
        const V3 a0 = anchor_point(bodies, m, 0), a1 = anchor_point(bodies, m, 1);
        renewed = norm(tangential(0.5 * (a0 + a1) - p, n)) > kMaxAnchorDistance;
        gap_t = tangential(renewed ? load3(m.rolled) : a1 - a0, n);
    }
    if (renewed) {
        store_sides(row, m);
        set_anchor(bodies, m, 0, p);
        set_anchor(bodies, m, 1, p + gap_t);
    }
    return gap_t;
}

/// Return N v, including bodies with a prescribed velocity; positive if separating.
double normal_speed(const ContactRow& row, const model::Bodies& bodies, const V3& n) {
    double speed = row.carried[0];
    for (int i = 0; i < row.slots; ++i) {
        const ContactSlot& s = row.slot[i];
        if (s.dof == 0) continue;
        const double* v = &bodies.v[at(s.dof_begin)];
        V3 u = load3(v);
        if (s.dof == 6) u = u + cross(load3(v + 3), load3(s.arm));
        speed += s.weight * dot(n, u);
    }
    return speed;
}

}  // namespace

void Contacts::set(std::size_t index, const collide::Contact& in, const collide::Surface& surface,
                   const model::Bodies& bodies, double h) noexcept {
    ContactRow& row = rows[index];
    nonsmooth::Cone& cone = cones[index];
    ContactMemory& m = next_[index];
    Extra& extra = extra_[index];
    row = {};
    cone = {};
    const V3 n = load3(in.normal), on0 = load3(in.on[0]), on1 = load3(in.on[1]);
    const V3 p = 0.5 * (on0 + on1);
    V3 t1, t2;
    tangents(n, t1, t2);
    store3(row.axis, n);
    store3(row.axis + 3, t1);
    store3(row.axis + 6, t2);
    row.slots = in.slots;
    row.resistance = -1;
    V3 carried{0, 0, 0};
    for (int i = 0; i < in.slots; ++i) {
        ContactSlot& s = row.slot[i];
        s.body = in.body[i];
        s.dof = dof_[at(s.body)];
        s.dof_begin = dof_begin_[at(s.body)];
        s.weight = i < in.side_0 ? -in.weight[i] : in.weight[i];
        const V3 arm = arm_of(in, i, bodies, p);
        store3(s.arm, s.dof == 3 ? V3{0, 0, 0} : arm);
        cone.mobility += slot_mobility(bodies, s);
        if (bodies.kind[at(s.body)] == BodyKind::kinematic) {
            const double* v = &bodies.v_fixed[6 * at(s.body)];
            carried = carried + s.weight * (load3(v) + cross(load3(v + 3), arm));
        }
    }
    store3(row.carried, load9(row.axis) * carried);

    // Copy the memory of the same contact of the last step, if any.
    m = in.previous >= 0 ? memory[at(in.previous)] : kNoMemory;
    const V3 gap_t = hold(row, bodies, n, p, m);
    store3(extra.tangent_gap, gap_t);
    store3(extra.point, p);

    const double upsilon = row_upsilon(surface.damping_time, h);
    const double scale = row_sigma(1.0, upsilon, h);
    const double least = kMinSigma * cone.mobility;
    cone.sigma_n = std::max(scale * surface.compliance, least);
    cone.sigma_t = std::max(scale * surface.tangential_compliance, least);
    extra.epsilon_t = cone.sigma_t / scale;
    cone.friction = surface.friction;
    cone.b[0] = in.gap > 0.0 ? -in.gap / h : -4.0 / h * upsilon * in.gap;
    cone.b[1] = -4.0 / h * upsilon * dot(t1, gap_t);
    cone.b[2] = -4.0 / h * upsilon * dot(t2, gap_t);
    // If a point is already separating, part of its speed is kept (Υ N v of SPOOK).
    const double speed = normal_speed(row, bodies, n);
    if (in.gap <= 0.0 && speed > 0.0) cone.b[0] += upsilon * speed;
}

void Contacts::remember(const model::Bodies& bodies, double h, std::int32_t begin,
                        std::int32_t end) noexcept {
    for (std::size_t k = at(begin); k < at(end); ++k) {
        const ContactRow& row = rows[k];
        const nonsmooth::Cone& c = cones[k];
        ContactMemory& m = next_[k];
        const Extra& extra = extra_[k];
        const M3 e = load9(row.axis);
        const V3 move = tmul(e, V3{0.0, h * c.u[1], h * c.u[2]});
        store3(m.lambda, tmul(e, load3(c.lambda)));
        if (c.touch == nonsmooth::Touch::stick) {
            store3(m.rolled, load3(extra.tangent_gap) + move);
            continue;
        }
        // Sliding: the spring deflection belongs to the friction force. Separate: zero.
        const double spring = c.touch == nonsmooth::Touch::slip ? -extra.epsilon_t / h : 0.0;
        const V3 held = tmul(e, V3{0.0, spring * c.lambda[1], spring * c.lambda[2]});
        store3(m.rolled, held);
        const V3 p = load3(extra.point);
        store_sides(row, m);
        set_anchor(bodies, m, 0, p);
        set_anchor(bodies, m, 1, p + held - move);
    }
}

void Contacts::keep(double h) noexcept {
    memory.swap(next_);
    resistances.remember(rows, h);
}

}  // namespace hawser::assembly
