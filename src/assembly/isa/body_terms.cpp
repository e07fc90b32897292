// SPDX-License-Identifier: Apache-2.0
/// What bodies bring to the step's equations: their blocks M̃ and right-hand sides a. Rigid bodies
/// that stand in a row go eight at a time.
#include "assembly/geo.h"
#include "assembly/isa/links.h"
#include "assembly/isa/rows.h"
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

/// Drag D of a body in the world frame: R diag(d) Rᵀ.
M3 world_diagonal(const double* r, const double* d) {
    const double s[9] = {d[0], 0, 0, 0, d[1], 0, 0, 0, d[2]};
    return congruence(load9(r), s);
}

/// Angular velocity after h without torque, body frame: the Cayley form of the discrete
/// Euler equations (Bou-Rabee, Marsden, "Hamilton-Pontryagin integrators on Lie groups", 2009)
///   F(ω₊; +h) = F(ω; −h),  F(ω; s) = Iω + (s/2) ω × Iω + (s²/4)(ω·Iω) ω.
/// Newton from the explicit step; its Jacobian is well conditioned while h|ω| < 1. The next
/// correction is about h|ω| times the square of one, so that slow bodies need one iteration.
template <class T>
HAWSER_INLINE V3T<T> free_rotation(const M3T<T>& inertia, const M3T<T>& inverse, const V3T<T>& w,
                                   const T& h) {
    const V3T<T> iw = inertia * w;
    const T half = 0.5 * h, quarter = half * half;
    const V3T<T> target = iw - half * cross(w, iw) + (quarter * dot(w, iw)) * w;
    V3T<T> u = w - h * (inverse * cross(w, iw));
    for (int n = 0; n < 4; ++n) {
        const V3T<T> iu = inertia * u;
        const T e = dot(u, iu);
        const V3T<T> f = iu + half * cross(u, iu) + (quarter * e) * u - target;
        // J = I + (h/2)(û I − (Iu)^) + (h²/4)(e E + 2 u (Iu)ᵀ).
        const V3T<T> hu = half * u, hi = half * iu, qu = (2.0 * quarter) * u;
        const T qe = quarter * e;
        const T* i = inertia.a;
        const M3T<T> j{{i[0] + hu.y * i[6] - hu.z * i[3] + qe + qu.x * iu.x,
                        i[1] + hu.y * i[7] - hu.z * i[4] + hi.z + qu.x * iu.y,
                        i[2] + hu.y * i[8] - hu.z * i[5] - hi.y + qu.x * iu.z,
                        i[3] + hu.z * i[0] - hu.x * i[6] - hi.z + qu.y * iu.x,
                        i[4] + hu.z * i[1] - hu.x * i[7] + qe + qu.y * iu.y,
                        i[5] + hu.z * i[2] - hu.x * i[8] + hi.x + qu.y * iu.z,
                        i[6] + hu.x * i[3] - hu.y * i[0] + hi.y + qu.z * iu.x,
                        i[7] + hu.x * i[4] - hu.y * i[1] - hi.x + qu.z * iu.y,
                        i[8] + hu.x * i[5] - hu.y * i[2] + qe + qu.z * iu.z}};
        const V3T<T> du = solve3(j, f);
        u = u - du;
        // h|ω| (|δ|/|ω|)² below 1e-17, squared.
        const T square = dot(u, u), change = dot(du, du);
        if (!any(positive_part(4.0 * quarter * square * change * change -
                               1e-34 * (square * square))))
            break;
    }
    // Where h|ω| is far above one that may not have come to an end, and energy would grow without
    // bound: such a spin stays as it is.
    return select_greater(1.5 * dot(w, iw), dot(u, inertia * u), u, w);
}

/// Gyroscopic impulse between the spin and the change δ that torques make to it in this step,
/// −(h/2)(δ × Iω + ω × Iδ): the mean of both ends of the step instead of its start, without
/// which a spinning body under torque (a top) is of first order only. δ is that of the last
/// step: explicit, so damped where h|ω| is large.
template <class T>
V3T<T> forced_gyro(const M3T<T>& inertia, const V3T<T>& w, const V3T<T>& change, const T& h) {
    const T half = 0.5 * h, limit = half * (1.0 / (one(h) + half * half * dot(w, w)));
    const V3T<T> sum = cross(change, inertia * w) + cross(w, inertia * change);
    return V3T<T>{zero(h), zero(h), zero(h)} - limit * sum;
}
/// Block and right-hand side of one body on its own.
void own_terms(const View& view, std::int32_t body) {
    const double h = view.h;
    const int dof = view.dof[body];
    double* block = view.body_block + assembly::block_place(view.dof_begin[body]);
    const double* v = view.v + view.dof_begin[body];
    double* a = view.a + view.dof_begin[body];
    const double* f = view.force + 6 * body;
    const double* d = view.damping + 6 * body;
    const double m = view.mass[body];
    if (dof == 1) {
        block[0] = m + h * d[0];
        a[0] = m * v[0] + h * f[0];
        return;
    }
    M3 lin{{m, 0, 0, 0, m, 0, 0, 0, m}};
    if (dof == 3) {  // a lump's axes are the world's
        for (int i = 0; i < 3; ++i) lin.a[4 * i] += h * d[i];
    } else if (any3(d)) {
        const M3 drag = world_diagonal(view.r + 9 * body, d);
        for (int i = 0; i < 9; ++i) lin.a[i] += h * drag.a[i];
    }
    store_sym(block, lin);
    const double w = view.weight[body] ? h * m : 0.0;
    for (int i = 0; i < 3; ++i) a[i] = m * v[i] + h * f[i] + w * view.gravity[i];
    if (dof < 6) return;
    const M3 r = load9(view.r + 9 * body);
    const M3 inertia = load9(view.inertia + 9 * body);
    M3 world = congruence(r, inertia.a);
    const V3 spin = tmul(r, load3(v + 3));
    const V3 free = r * free_rotation(inertia, load9(view.inv_inertia + 9 * body), spin, h);
    const V3 gyro = forced_gyro(inertia, spin, load3(view.spin_change + 3 * body), h);
    store3(view.spin_free + 3 * body, free);
    store3(a + 3, world * free + r * gyro + h * load3(f + 3));
    if (any3(d + 3)) {
        const M3 drag = world_diagonal(view.r + 9 * body, d + 3);
        for (int i = 0; i < 9; ++i) world.a[i] += h * drag.a[i];
    }
    store_sym(block + 6, world);
}

/// What a joint in short adds to a body's own terms.
void add_arm(const View& view, const assembly::Incidence& in, const double* v, double* block,
             double* a) {
    const ArmsT<double> arms = load_arms(view.jacobian + in.jacobian - 3 * in.slot);
    const double sign = in.slot == 0 ? -1.0 : 1.0;
    const V3 f = (view.active[in.geo_arm] / view.h) * load3(view.lambda + in.row);
    const double n0 = norm(arms.r0), n1 = norm(arms.r1), nf = norm(f);
    const double stiff = joint_terms(view, nf, n0, n1, arms.swing).stiff;
    double arm[6];
    arm_stiffness(sign * f, nf, in.slot == 0 ? arms.r0 : arms.r1, in.slot == 0 ? n0 : n1, stiff,
                  arm);
    for (int i = 0; i < 6; ++i) block[6 + i] += arm[i];
    add3(a + 3, mul6(arm, load3(v + 3)) - sign * load3(view.geo_force + in.geo_force + 3));
}

/// What interactions' geometric stiffness adds to a body's own terms.
void add_geometric(const View& view, std::int32_t body) {
    const int dof = view.dof[body];
    double* block = view.body_block + assembly::block_place(view.dof_begin[body]);
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
        // The arms' stiffness touches this body alone: it joins the body's own block.
        const double* arm = view.geo_record + in.geo_arm;
        for (int i = 0; i < 6; ++i) block[6 + i] += arm[i];
        add3(a + 3, load3(force + 3) + mul6(arm, load3(v + 3)));
    }
}

/// own_terms() of eight rigid bodies; of eight links also what their joints add.
template <bool kLinks>
void rigid_terms(const View& view, std::int32_t body) {
    const W8 h = W8{} + view.h, none{};
    V8 v[kLanes];
    load_bodies(view.v + view.dof_begin[body], 6, v);
    const W3 change = load_threes(view.spin_change + 3L * body);
    const W8 m = load(view.mass + body);
    const WM3 r = load_bodies9(view.r + 9L * body);
    const WM3 inertia = load_bodies9(view.inertia + 9L * body);
    const WM3 inverse = load_bodies9(view.inv_inertia + 9L * body);

    WM3 world = congruence(r, inertia.a);
    const W3 spin = tmul(r, W3{v[3], v[4], v[5]});
    const W3 free = r * free_rotation(inertia, inverse, spin, h);
    const W3 gyro = forced_gyro(inertia, spin, change, h);
    W3 turn = world * free + r * gyro;
    WM3 lin{{m, none, none, none, m, none, none, none, m}};
    auto add_drag = [&](const V8* diagonal, WM3& to) {
        const W8 s[9] = {diagonal[0], none, none, none, diagonal[1], none, none, none, diagonal[2]};
        const WM3 drag = congruence(r, s);
        for (int i = 0; i < 9; ++i) to.a[i] += h * drag.a[i];
    };
    const double* damping = view.damping + 6L * body;
    if (any_of_six(damping)) {
        V8 d[kLanes];
        load_bodies(damping, 6, d);
        if (any(d[0]) || any(d[1]) || any(d[2])) add_drag(d, lin);
        if (any(d[3]) || any(d[4]) || any(d[5])) add_drag(d + 3, world);
    }

    if constexpr (kLinks) {
        const LinkJoints joints(view, body);
        LinkArms arms;
        stiffen_links(view, joints, arms);
        W8 sum[6];
        for (int i = 0; i < 6; ++i) sum[i] = arms.first[i] + arms.second[i];
        constexpr int kPlace[6] = {0, 1, 2, 4, 5, 8};
        for (int i = 0; i < 6; ++i) world.a[kPlace[i]] += sum[i];
        const double* twists = view.geo_force + joints.place->geo_force;
        W3 unused, in;
        load_twists(twists, unused, in);
        const W3 next = shift_in(in, twists + 6 * kLanes + 3);
        turn = turn + mul6(sum, W3{v[3], v[4], v[5]}) + next - in;
    }
    double weight[kLanes];
    for (int l = 0; l < kLanes; ++l) weight[l] = view.weight[body + l] ? view.h : 0.0;
    const V8 w = load(weight) * m;
    V8 a[kLanes] = {m * v[0] + w * view.gravity[0],
                    m * v[1] + w * view.gravity[1],
                    m * v[2] + w * view.gravity[2],
                    turn.x,
                    turn.y,
                    turn.z,
                    none,
                    none};
    transpose(a);
    double* out = view.a + view.dof_begin[body];
    const double* force = view.force + 6L * body;
    // Lane by lane, each overwriting the surplus of the one before; the last without surplus.
    for (int l = 0; l + 1 < kLanes; ++l) store(out + 6 * l, a[l] + h * load(force + 6 * l));
    constexpr int kLast = kLanes - 1;
    const V8 last = a[kLast] + h * load_first(force + 6 * kLast, 6);
    store_lanes(out + 6 * kLast, last, 0, 6);
    store_threes(view.spin_free + 3L * body, free);

    V8 low[kLanes] = {lin.a[0], lin.a[1], lin.a[2],   lin.a[4],
                      lin.a[5], lin.a[8], world.a[0], world.a[1]};
    V8 high[kLanes] = {lin.a[5],   lin.a[8],   world.a[0], world.a[1],
                       world.a[2], world.a[4], world.a[5], world.a[8]};
    transpose(low);
    transpose(high);
    double* block = view.body_block + assembly::block_place(view.dof_begin[body]);
    for (int l = 0; l < kLanes; ++l) {
        store(block + kBodyBlock * l, low[l]);
        store(block + kBodyBlock * l + 4, high[l]);
    }
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
