// SPDX-License-Identifier: Apache-2.0
/// Terms of bodies in the equations of a step: their blocks M̃ and right-hand sides a. Consecutive
/// rigid bodies are processed eight at a time.
#include "assembly/geo.h"
#include "assembly/isa/links.h"
#include "assembly/isa/rows.h"
#include "assembly/isa/spin.h"
#include "base/lanes.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::kBodyBlock;
using assembly::View;

void store_sym(double* out, const M3& m) {
    out[0] = m.a[0];
    out[1] = m.a[1];
    out[2] = m.a[2];
    out[3] = m.a[4];
    out[4] = m.a[5];
    out[5] = m.a[8];
}

/// Return the drag D of a body in the world frame: R diag(d) Rᵀ.
M3 world_diagonal(const double* r, const double* d) {
    const double s[9] = {d[0], 0, 0, 0, d[1], 0, 0, 0, d[2]};
    return congruence(load9(r), s);
}

/// Compute block and right-hand side of a single body.
void own_terms(const View& view, std::int32_t body) {
    const double h = view.h;
    const int dof = view.dof[body];
    double* block = view.body_block + assembly::block_offset(view.dof_begin[body]);
    const double* v = view.v + view.dof_begin[body];
    double* a = view.a + view.dof_begin[body];
    const double* f = view.force + 6 * body;
    const double *d = view.drag_after + 6 * body, *past = view.drag_before + 6 * body;
    const double m = view.mass[body];
    if (dof == 1) {
        block[0] = m + h * d[0];
        a[0] = (m - h * past[0]) * v[0] + h * f[0];
        return;
    }
    M3 lin{{m, 0, 0, 0, m, 0, 0, 0, m}};
    if (dof == 3) {  // the axes of a point mass are the world axes
        for (int i = 0; i < 3; ++i) lin.a[4 * i] += h * d[i];
    } else if (any3(d)) {
        const M3 drag = world_diagonal(view.r + 9 * body, d);
        for (int i = 0; i < 9; ++i) lin.a[i] += h * drag.a[i];
    }
    store_sym(block, lin);
    const double w = view.weight[body] ? h * m : 0.0;
    for (int i = 0; i < 3; ++i) a[i] = m * v[i] + h * f[i] + w * view.gravity[i];
    if (dof == 3) {
        for (int i = 0; i < 3; ++i) a[i] -= h * past[i] * v[i];
        return;
    }
    const M3 r = load9(view.r + 9 * body);
    const Spin<double> spin =
        spin_terms(load9(view.inertia + 9 * body), load9(view.inv_inertia + 9 * body), r,
                   load3(v + 3), load3(view.spin_change + 3 * body), h);
    M3 world = spin.inertia;
    store3(view.spin_free + 3 * body, spin.free);
    store3(view.spin_momentum + 3 * body, spin.momentum);
    store3(a + 3, spin.momentum + h * load3(f + 3));
    if (any3(d)) add3(a, (-h) * (world_diagonal(view.r + 9 * body, past) * load3(v)));
    if (any3(d + 3)) {
        const M3 drag = world_diagonal(view.r + 9 * body, d + 3);
        for (int i = 0; i < 9; ++i) world.a[i] += h * drag.a[i];
        add3(a + 3, (-h) * (world_diagonal(view.r + 9 * body, past + 3) * load3(v + 3)));
    }
    store_sym(block + 6, world);
}

/// Add the geometric stiffness of a compact joint to the block and the right-hand side of a body.
void add_arm(const View& view, const assembly::Incidence& in, const double* v, double* block,
             double* a) {
    const ArmsT<double> arms = load_arms(view.jacobian + in.jacobian - 3 * in.slot);
    const double sign = in.slot == 0 ? -1.0 : 1.0;
    const V3 f = (view.active[in.geo_arm] / view.h) * load3(view.lambda + in.row);
    const double n0 = norm(arms.r0), n1 = norm(arms.r1), nf = norm(f);
    const double stiff = joint_terms(view, nf, n0, n1, arms.vibration).stiff;
    double arm[6];
    arm_stiffness(sign * f, nf, in.slot == 0 ? arms.r0 : arms.r1, in.slot == 0 ? n0 : n1, stiff,
                  arm);
    for (int i = 0; i < 6; ++i) block[6 + i] += arm[i];
    add3(a + 3, mul6(arm, load3(v + 3)) - sign * load3(view.geo_force + in.geo_force + 3));
}

/// Add the geometric stiffness of interactions to the block and the right-hand side of a body.
void add_geometric(const View& view, std::int32_t body) {
    const int dof = view.dof[body];
    double* block = view.body_block + assembly::block_offset(view.dof_begin[body]);
    const double* v = view.v + view.dof_begin[body];
    double* a = view.a + view.dof_begin[body];
    for (std::int32_t k = view.incident_begin[body]; k < view.incident_begin[body + 1]; ++k) {
        const assembly::Incidence& in = view.incident[k];
        if (in.geo_force < 0) continue;
        if (in.width == 0) {
            add_arm(view, in, v, block, a);
            continue;
        }
        if (in.geo_arm < 0) {
            add3(a, (in.slot == 0 ? 1.0 : -1.0) * load3(view.geo_force + in.geo_force + 3));
            continue;
        }
        const double* force = view.geo_force + in.geo_force + 6;
        add3(a, load3(force));
        if (dof < 6) continue;
        // The stiffness of arms affects only this body and is added to its diagonal block.
        const double* arm = view.geo_record + in.geo_arm;
        for (int i = 0; i < 6; ++i) block[6 + i] += arm[i];
        add3(a + 3, load3(force + 3) + mul6(arm, load3(v + 3)));
    }
}

/// Apply spin_terms() to eight rigid bodies.
Spin<W8> eight_spins(const View& view, std::int32_t body, const WM3& r, const W3& w, const W8& h) {
    const W3 change = load_threes(view.spin_change + 3L * body);
    V8 p[kLanes];
    load_bodies(view.principal + 6L * body, 6, p);
    if (all_principal(p[0]))
        return spin_terms(Principal<W8>{{p[0], p[1], p[2]}}, Principal<W8>{{p[3], p[4], p[5]}}, r,
                          w, change, h);
    return spin_terms(load_bodies9(view.inertia + 9L * body),
                      load_bodies9(view.inv_inertia + 9L * body), r, w, change, h);
}

/// Store the diagonal blocks of eight rigid bodies: lower triangles of the linear and the angular
/// part.
HAWSER_INLINE void store_blocks(const View& view, std::int32_t body, const WM3& lin,
                                const WM3& world) {
    V8 low[kLanes] = {lin.a[0], lin.a[1], lin.a[2],   lin.a[4],
                      lin.a[5], lin.a[8], world.a[0], world.a[1]};
    V8 high[kLanes] = {lin.a[5],   lin.a[8],   world.a[0], world.a[1],
                       world.a[2], world.a[4], world.a[5], world.a[8]};
    transpose(low);
    transpose(high);
    double* block = view.body_block + assembly::block_offset(view.dof_begin[body]);
    for (int l = 0; l < kLanes; ++l) {
        store(block + kBodyBlock * l, low[l]);
        store(block + kBodyBlock * l + 4, high[l]);
    }
}

/// Apply own_terms() to eight rigid bodies. For eight links also add the terms of their joints.
template <bool kLinks>
void rigid_terms(const View& view, std::int32_t body) {
    const W8 h = W8{} + view.h, none{};
    V8 v[kLanes];
    load_bodies(view.v + view.dof_begin[body], 6, v);
    const W8 m = load(view.mass + body);
    const WM3 r = load_bodies9(view.r + 9L * body);
    const Spin<W8> spin = eight_spins(view, body, r, {v[3], v[4], v[5]}, h);
    WM3 world = spin.inertia;
    W3 turn = spin.momentum;
    WM3 lin{{m, none, none, none, m, none, none, none, m}};
    W3 past{none, none, none};  // impulse of drag on the velocity before the step
    auto add_drag = [&](const V8* diagonal, const V8* before, const V8* u, WM3& to) {
        const W8 s[9] = {diagonal[0], none, none, none, diagonal[1], none, none, none, diagonal[2]};
        const WM3 drag = congruence(r, s);
        for (int i = 0; i < 9; ++i) to.a[i] += h * drag.a[i];
        const W3 w = tmul(r, W3{u[0], u[1], u[2]});
        return h * (r * W3{before[0] * w.x, before[1] * w.y, before[2] * w.z});
    };
    const double* damping = view.drag_after + 6L * body;
    if (any_of_six(damping)) {
        V8 d[kLanes], e[kLanes];
        load_bodies(damping, 6, d);
        load_bodies(view.drag_before + 6L * body, 6, e);
        if (any(d[0]) || any(d[1]) || any(d[2])) past = add_drag(d, e, v, lin);
        if (any(d[3]) || any(d[4]) || any(d[5])) turn = turn - add_drag(d + 3, e + 3, v + 3, world);
    }

    if constexpr (kLinks) {
        const LinkJoints joints(view, body);
        LinkArms arms;
        stiffen_links(view, joints, arms);
        W8 sum[6];
        for (int i = 0; i < 6; ++i) sum[i] = arms.first[i] + arms.second[i];
        constexpr int kPlace[6] = {0, 1, 2, 4, 5, 8};
        for (int i = 0; i < 6; ++i) world.a[kPlace[i]] += sum[i];
        const double* torques = view.geo_force + joints.place->geo_force;
        W3 unused, in;
        load_damping(torques, unused, in);
        const W3 next = shift_in(in, torques + 6 * kLanes + 3);
        turn = turn + mul6(sum, W3{v[3], v[4], v[5]}) + next - in;
    }
    double weight[kLanes];
    for (int l = 0; l < kLanes; ++l) weight[l] = view.weight[body + l] ? view.h : 0.0;
    const V8 w = load(weight) * m;
    V8 a[kLanes] = {m * v[0] + w * view.gravity[0] - past.x,
                    m * v[1] + w * view.gravity[1] - past.y,
                    m * v[2] + w * view.gravity[2] - past.z,
                    turn.x,
                    turn.y,
                    turn.z,
                    none,
                    none};
    transpose(a);
    double* out = view.a + view.dof_begin[body];
    const double* force = view.force + 6L * body;
    // Store lane by lane. Each store overwrites the surplus of the one before; the last one has no
    // surplus.
    for (int l = 0; l + 1 < kLanes; ++l) store(out + 6 * l, a[l] + h * load(force + 6 * l));
    constexpr int kLast = kLanes - 1;
    const V8 last = a[kLast] + h * load_first(force + 6 * kLast, 6);
    store_lanes(out + 6 * kLast, last, 0, 6);
    store_threes(view.spin_free + 3L * body, spin.free);
    store_threes(view.spin_momentum + 3L * body, spin.momentum);
    store_blocks(view, body, lin, world);
}

}  // namespace

void body_terms(const View& view, std::int32_t begin, std::int32_t end) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        const std::int32_t first = links_with(view, begin, body, end);
        if (first >= 0 && eight_rigid(view, first)) {
            rigid_terms<true>(view, first);
            body = first + kLanes - 1;
            continue;
        }
        if (body + kLanes <= end && eight_rigid(view, body) && !before_links(view, body, end)) {
            rigid_terms<false>(view, body);
            for (int l = 0; l < kLanes; ++l) add_geometric(view, body + l);
            body += kLanes - 1;
            continue;
        }
        if (view.dof[body] == 0) continue;
        own_terms(view, body);
        add_geometric(view, body);
    }
}

}  // namespace hawser::HAWSER_ISA
