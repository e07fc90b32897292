// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file links.h
/// Eight links of a chain at once (View::links): rigid bodies with two ball joints each, one per
/// lane. Joint l is the first joint of link l, joint l + 1 its second:
/// ```
///      joint l   ┌────────┐  joint l + 1
///   ──────●──────┤ link l ├──────●──────      r₁ of joint l and r₀ of joint l + 1 end here
///                └────────┘
/// ```

#include "assembly/isa/arms.h"
#include "assembly/isa/rigid_lanes.h"

namespace hawser::HAWSER_ISA {

/// Both joints of each link.
struct LinkJoints {
    ArmsT<W8> first, second;
    /// Incidence of joint 0 at link 0; arrays by joint are consecutive.
    const assembly::Incidence* place;

    LinkJoints(const assembly::View& view, std::int32_t body)
        : place(view.incident + view.incident_begin[body]) {
        const double* record = view.jacobian + place->jacobian - 3;
        first = next_arms(record);
        const double* last = record + model::kArms * kLanes;
        second = {shift_in(first.r0, last), shift_in(first.r1, last + 3),
                  shift_in(first.damping, last[model::kArmsDamping]),
                  shift_in(first.vibration, last[model::kArmsVibration])};
    }
};

/// True if at least eight links of a chain begin at `body`.
inline bool eight_links(const assembly::View& view, std::int32_t body) {
    return view.links[body] >= kLanes;
}

/// Return the first of the eight links that include `body`. If fewer links of the chain follow in
/// [begin, end), the group starts earlier and ends with the last of them. Some links are then
/// processed twice, with the same result. Return −1 if the body must be processed alone.
inline std::int32_t links_with(const assembly::View& view, std::int32_t begin, std::int32_t body,
                               std::int32_t end) {
    const std::int32_t run = view.links[body];
    if (run == 0) return -1;
    const std::int32_t left = run < end - body ? run : end - body;
    const std::int32_t from = left < kLanes ? body + left - kLanes : body;
    return from >= begin && eight_links(view, from) ? from : -1;
}

/// True if `body` is no link and a group of eight links begins less than eight bodies behind it.
/// The body is then processed alone, so that the group stays complete.
inline bool before_links(const assembly::View& view, std::int32_t body, std::int32_t end) {
    if (view.links[body] > 0) return false;
    for (std::int32_t next = body + 1; next < body + kLanes && next + kLanes <= end; ++next)
        if (eight_links(view, next)) return true;
    return false;
}

/// Gᵀ y for the multipliers y of the rows.
struct LinkPush {
    W3 linear, turn;
};
inline LinkPush push_links(const LinkJoints& joints, const double* y) {
    y += joints.place->row;
    const W3 in = load_threes(y), out = shift_in(in, y + 3 * kLanes);
    return {in - out, cross(joints.first.r1, in) - cross(joints.second.r0, out)};
}

/// Arm stiffness of a link, in the form of a record.
struct LinkArms {
    W8 first[6], second[6];
};
inline void stiffen_links(const assembly::View& view, const LinkJoints& joints, LinkArms& out) {
    const double* active = view.active + joints.place->geo_arm;
    const double* lambda = view.lambda + joints.place->row;
    const double per_h = 1.0 / view.h;
    const W3 f = W8(load(active) * per_h) * load_threes(lambda);
    const W3 g = W8(load(active + 1) * per_h) * load_threes(lambda + 3);
    const ArmsT<W8>&a = joints.first, &b = joints.second;
    const W8 nf = norm(f), ng = norm(g), n1 = norm(a.r1), n0 = norm(b.r0);
    arm_stiffness(f, nf, a.r1, n1, joint_terms(view, nf, norm(a.r0), n1, a.vibration).stiff,
                  out.first);
    arm_stiffness(-g, ng, b.r0, n0, joint_terms(view, ng, n0, norm(b.r1), b.vibration).stiff,
                  out.second);
}

/// Compute r = a − M̃ v₊ + Jᵀ y of eight links, like momentum_rhs(). @param out  Six vectors.
template <bool kAtRest>
inline void eight_rhs(const assembly::View& view, std::int32_t body, const double* y,
                      V8 (&out)[kLanes]) {
    const LinkJoints joints(view, body);
    const LinkPush push = push_links(joints, y);
    const std::int32_t begin = view.dof_begin[body];
    V8 a[kLanes];
    load_bodies(view.a + begin, 6, a);
    W3 linear = W3{a[0], a[1], a[2]} + push.linear, turn = W3{a[3], a[4], a[5]} + push.turn;
    if constexpr (!kAtRest) {
        const double* torques = view.geo_force + joints.place->geo_force;
        W3 in, unused;
        load_damping(torques, in, unused);
        const W3 next = shift_in(in, torques + 6 * kLanes);
        V8 v[kLanes], low[kLanes], high[kLanes];  // block: entries 0-7 and 4-11
        load_bodies(view.v_new + begin, 6, v);
        const double* block = view.body_block + assembly::block_offset(view.dof_begin[body]);
        load_bodies(block, assembly::kBodyBlock, low);
        load_bodies(block + 4, assembly::kBodyBlock, high);
        linear = linear - mul6(low, W3{v[0], v[1], v[2]});
        turn = turn + in - next - mul6(high + 2, W3{v[3], v[4], v[5]});
    }
    out[0] = linear.x;
    out[1] = linear.y;
    out[2] = linear.z;
    out[3] = turn.x;
    out[4] = turn.y;
    out[5] = turn.z;
    if (view.contact_impulse) {
        load_bodies(view.contact_impulse + begin, 6, a);
        for (int i = 0; i < 6; ++i) out[i] += a[i];
    }
    out[6] = out[7] = V8{};
}

}  // namespace hawser::HAWSER_ISA
