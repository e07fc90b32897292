// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file arms.h
/// Compact joints (model/arms.h), single or eight consecutive ones: records, geometric terms and
/// speeds of rows.

#include "assembly/geo.h"
#include "base/lanes.h"
#include "base/transpose.h"

#include <cstring>

namespace hawser::HAWSER_ISA {

/// An arms record; T is double, or eight joints in lanes.
template <class T>
struct ArmsT {
    V3T<T> r0, r1;
    T damping, vibration;
};

inline ArmsT<double> load_arms(const double* record) {
    return {load3(record), load3(record + 3), record[model::kArmsDamping],
            record[model::kArmsVibration]};
}

/// Load eight records, record l from record + from[l].
inline ArmsT<W8> lane_arms(const double* record, const std::int32_t* from) {
    V8 t[kLanes];
    load_lanes(record, from, t);
    return {{t[0], t[1], t[2]}, {t[3], t[4], t[5]}, t[6], t[7]};
}

/// Load the records of eight consecutive joints, one joint per lane.
inline ArmsT<W8> next_arms(const double* record) {
    V8 t[kLanes];
    for (int l = 0; l < kLanes; ++l) t[l] = load(record + model::kArms * l);
    transpose(t);
    return {{t[0], t[1], t[2]}, {t[3], t[4], t[5]}, t[6], t[7]};
}

/// Compute r × e_i, row i of the angular part of G on body 1.
template <class T>
inline void arm_rows(const V3T<T>& r, T (&rows)[3][3]) {
    const T none = zero(r.x);
    rows[0][0] = rows[1][1] = rows[2][2] = none;
    rows[0][1] = r.z;
    rows[0][2] = -r.y;
    rows[1][0] = -r.z;
    rows[1][2] = r.x;
    rows[2][0] = r.y;
    rows[2][1] = -r.x;
}

/// True if the eight interactions from `id` on are compact joints with condensed rows.
inline bool eight_arms(const assembly::View& view, std::int32_t id) {
    static_assert(model::kCompactCondensed == 3);
    std::uint64_t flags;
    std::memcpy(&flags, view.arms + id, sizeof flags);
    return flags == 0x0303030303030303;
}

/// Load the damping torques of eight consecutive joints: their contributions to M̃ v and to the
/// right-hand side a.
inline void load_damping(const double* force, V3T<W8>& momentum, V3T<W8>& start) {
    V8 t[kLanes];
    for (int l = 0; l < kLanes; ++l) t[l] = load_at_least(force + 6 * l, 6);
    transpose(t);
    momentum = {t[0], t[1], t[2]};
    start = {t[3], t[4], t[5]};
}

/// Load the velocities of body `slot` of eight joints, or another vector packed by body.
template <class Offset>
inline void load_slots(const assembly::View& view, std::int32_t id, int slot, const double* packed,
                       Offset offset, V8 (&v)[kLanes]) {
    for (int l = 0; l < kLanes; ++l)
        v[l] =
            load_at_least(packed + offset(view.body[kMaxInteractionBodies * (id + l) + slot]), 6);
    transpose(v);
}

/// Return G u of eight joints for the u of their bodies, six entries per body.
inline V3T<W8> joint_speeds(const V8 (&a)[kLanes], const V8 (&b)[kLanes], const V3T<W8>& r0,
                            const V3T<W8>& r1) {
    return V3T<W8>{b[0], b[1], b[2]} - V3T<W8>{a[0], a[1], a[2]} +
           cross(V3T<W8>{b[3], b[4], b[5]}, r1) - cross(V3T<W8>{a[3], a[4], a[5]}, r0);
}
/// Return ω₀ − ω₁ of eight joints for the u of their bodies, six entries per body.
inline V3T<W8> joint_turns(const V8 (&a)[kLanes], const V8 (&b)[kLanes]) {
    return V3T<W8>{a[3], a[4], a[5]} - V3T<W8>{b[3], b[4], b[5]};
}

/// Compute G u of eight joints, three rows each, for a vector u packed by body; also ω₀ − ω₁ of u.
template <class Offset>
inline void eight_products(const assembly::View& view, std::int32_t id, const ArmsT<W8>& arms,
                           const double* u, Offset offset, V8 (&rows)[3], V3T<W8>& turn) {
    V8 a[kLanes], b[kLanes];
    load_slots(view, id, 0, u, offset, a);
    load_slots(view, id, 1, u, offset, b);
    const V3T<W8> p = joint_speeds(a, b, arms.r0, arms.r1);
    as_threes(p.x, p.y, p.z, rows);
    turn = joint_turns(a, b);
}

/// Apply first_rhs() to the eight joints from `id` on.
inline void first_joints_rhs(const assembly::View& view, std::int32_t id, bool moving) {
    const V8 active = load(view.active + id), none{};
    V8 on[3], inactive[3];
    as_threes(active, active, active, on);
    as_threes((one(active) - active) * load(view.held + id), none, none, inactive);
    for (int k = 0; k < 3; ++k) {
        const std::int32_t r = view.row_begin[id] + kLanes * k;
        const V8 speed = moving ? load(view.residual + r) : none;
        const V8 right_side = on[k] * (load(view.c + r) - speed);
        store(view.residual + r, right_side + load(view.sigma + r) * inactive[k]);
        store(view.multiplier + r, load(view.inv_sigma + r) * right_side + inactive[k]);
    }
}

/// Apply row_update() to the eight joints from `id` on. All values by row are processed as 24
/// consecutive rows.
inline void eight_joints(const assembly::View& view, std::int32_t id, bool first) {
    const ArmsT<W8> arms = next_arms(view.jacobian + view.jac_begin[id]);
    const std::int32_t row = view.row_begin[id];
    V8 change[3], now[3], on[3], kept[3];
    V3T<W8> turn;
    eight_products(
        view, id, arms, view.solution, [&](std::int32_t b) { return view.body_offset[b]; }, change,
        turn);
    eight_products(
        view, id, arms, view.v_new, [&](std::int32_t b) { return view.dof_begin[b]; }, now, turn);
    const V8 active = load(view.active + id), none{};
    as_threes(active, active, active, on);
    as_threes((one(active) - active) * load(view.held + id), none, none, kept);
    for (int k = 0; k < 3; ++k) {
        const std::int32_t r = row + kLanes * k;
        const V8 last = load(view.residual + r), sigma = load(view.sigma + r),
                 inverse = load(view.inv_sigma + r);
        const V8 before = first ? kept[k] : load(view.lambda + r);
        const V8 lambda = before + on[k] * inverse * (last - change[k]);
        // As in row_update_one().
        const V8 residual = first
                                ? last - on[k] * change[k] - sigma * lambda
                                : on[k] * (load(view.c + r) - now[k]) - sigma * (lambda - kept[k]);
        store(view.lambda + r, lambda);
        store(view.residual + r, residual);
        store(view.multiplier + r, on[k] * (lambda + inverse * residual) + kept[k]);
    }
    const V3T<W8> d = W8(arms.damping) * turn;
    V8 force[3];
    as_threes(d.x, d.y, d.z, force);
    double torque[3 * kLanes];
    for (int k = 0; k < 3; ++k) store(torque + kLanes * k, force[k]);
    double* out = view.geo_force + view.geo[id].force;
    for (int l = 0; l < kLanes; ++l)
        for (int i = 0; i < 3; ++i) out[6 * l + i] = torque[3 * l + i];
}

/// Apply row_norms() to the eight joints from `id` on. @return false if not possible: rows without
/// a limit, or a value that is not finite.
inline bool add_joint_norms(const assembly::View& view, std::int32_t id, assembly::Norms& n) {
    constexpr std::uint64_t kPositions = 0x0202020202020202;  // flags as row_norms() tests them
    const std::int32_t row = view.row_begin[id];
    std::uint64_t flags[3];
    std::memcpy(flags, view.row_flags + row, sizeof flags);
    if ((flags[0] & flags[1] & flags[2] & kPositions) != kPositions) return false;
    auto larger = [](const V8& a, const V8& b) { return select_greater(a, b, a, b); };
    V8 other = positive_part(load(view.rest_length + id)), residual{}, gap{}, finite{};
    for (int k = 0; k < 3; ++k) {
        const std::int32_t r = row + kLanes * k;
        const V8 c = load(view.residual + r), g = load(view.g + r);
        other += (c - c) + (g - g);
        residual = larger(residual, larger(c, -c));
        gap = larger(gap, larger(g, -g));
        finite += load(view.lambda + r);
    }
    if (any(other)) return false;
    n.finite += sum(finite);
    const double most = largest(residual), widest = largest(gap);
    if (!(most <= n.constraint)) n.constraint = most;
    if (widest <= n.gap) return true;
    n.gap = widest;
    int r = 0;
    while (__builtin_fabs(view.g[row + r]) != widest) ++r;
    n.gap_id = id + r / model::kArmRows;
    return true;
}

}  // namespace hawser::HAWSER_ISA
