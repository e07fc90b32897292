// SPDX-License-Identifier: Apache-2.0
/// Right-hand sides with which rows and spins hold at the end of a step (stepper/completion.h).
#include "assembly/isa/arms.h"
#include "assembly/isa/rows.h"
#include "base/simd.h"
#include "model/kinds/all.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::Turning;
using assembly::View;

constexpr int kSlots = kMaxInteractionBodies;

/// The rotation by h ω as the step makes it, E + 2 (â + â²)/(1 + a²), a = h ω/2: the Cayley map.
M3 step_rotation(const V3& a) {
    const double k = 2.0 / (1.0 + dot(a, a)), s = 1.0 - k * dot(a, a);
    return {{s + k * a.x * a.x, k * (a.x * a.y - a.z), k * (a.x * a.z + a.y), k * (a.x * a.y + a.z),
             s + k * a.y * a.y, k * (a.y * a.z - a.x), k * (a.x * a.z - a.y), k * (a.y * a.z + a.x),
             s + k * a.z * a.z}};
}

M3 product(const M3& a, const M3& b) {
    M3 out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out.a[3 * i + j] =
                a.a[3 * i] * b.a[j] + a.a[3 * i + 1] * b.a[3 + j] + a.a[3 * i + 2] * b.a[6 + j];
    return out;
}

/// Pose of a body at the end of a step with packed velocities u. @param room  For its rotation.
BodyRef end_pose(const View& view, std::int32_t body, const double* u, M3& room) {
    const int dof = view.dof[body];
    const V3 x = load3(view.x + 3 * body);
    if (dof == 3 || dof == 1) {
        const double* v = u + view.dof_begin[body];
        return {x + view.h * (dof == 3 ? load3(v) : V3{v[0], 0.0, 0.0}), view.r + 9 * body, false};
    }
    const double* v = dof == 6 ? u + view.dof_begin[body] : view.v_fixed + 6 * body;
    room = product(step_rotation((0.5 * view.h) * load3(v + 3)), load9(view.r + 9 * body));
    return {x + view.h * load3(v), room.a, true};
}

/// G u of the rows of one interaction.
template <int R>
void row_speeds(const View& view, std::int32_t id, const double* u, double (&speed)[R]) {
    double room[model::kArmRoom];
    const double* jac = packed_rows(view, id, room);
    for (int r = 0; r < R; ++r) {
        speed[r] = 0.0;
        for (int b = 0; b < view.bodies[id]; ++b) {
            const std::int32_t body = view.body[kSlots * id + b];
            const double* v = u + view.dof_begin[body];
            for (int j = 0; j < view.dof[body]; ++j) speed[r] += *jac++ * v[j];
        }
    }
}

/// A ball joint in short. With a = h ω/2 of a body, what its arm r ends at beyond h ω × r is
///     (2/h) (a × (a × r) − a² a × r)/(1 + a²)    [m/s]
/// so that c = −(g/h + that of body 1 − that of body 0) needs neither poses nor a difference.
void complete_arms(const View& view, std::int32_t id, const double* u, Turning& t) {
    const ArmsT<double> arms = load_arms(view.jacobian + view.jac_begin[id]);
    const std::int32_t* body = view.body + kSlots * id;
    V3 beyond{0.0, 0.0, 0.0}, closing = beyond;
    for (int b = 0; b < 2; ++b) {
        const double* v = u + view.dof_begin[body[b]];
        const V3 a = (0.5 * view.h) * load3(v + 3), r = b == 0 ? arms.r0 : arms.r1;
        const V3 turn = cross(a, r);
        const double square = dot(a, a), scale = (b == 0 ? -2.0 : 2.0) / (view.h * (1.0 + square));
        beyond = beyond + scale * (cross(a, turn) - square * turn);
        closing = closing + (b == 0 ? -1.0 : 1.0) * (load3(v) + cross(load3(v + 3), r));
    }
    const std::int32_t row = view.row_begin[id];
    const double per_h = 1.0 / view.h;
    const V3 c = -(per_h * load3(view.g + row) + beyond);
    const double to[3] = {c.x, c.y, c.z};
    const double gap[3] = {closing.x - c.x, closing.y - c.y, closing.z - c.z};
    for (int r = 0; r < 3; ++r) {
        t.add({__builtin_fabs(to[r] - view.c[row + r]), view.h * __builtin_fabs(gap[r])});
        view.c[row + r] = to[r];
    }
}

template <class K>
Turning complete_kind(const View& view, const std::int32_t* ids, const typename K::Data* data,
                      std::int32_t begin, std::int32_t end, const double* u) {
    constexpr int B = K::kBodies, R = K::kRows;
    constexpr bool kMayBeShort = requires { requires K::kInShort; };
    Turning t;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t id = ids[k];
        if (!view.completed[id]) continue;
        if (kMayBeShort && view.arms[id]) {
            complete_arms(view, id, u, t);
            continue;
        }
        BodyRef refs[B];
        M3 room[B];
        for (int b = 0; b < B; ++b)
            refs[b] = end_pose(view, view.body[kSlots * id + b], u, room[b]);
        Rows<B, R> rows;
        K::evaluate(data[k], refs, rows);
        double speed[R];
        row_speeds<R>(view, id, u, speed);
        const std::int32_t row = view.row_begin[id];
        for (int r = 0; r < R; ++r) {
            const double c = speed[r] - rows.g[r] / view.h;
            t.add({__builtin_fabs(c - view.c[row + r]), __builtin_fabs(rows.g[r])});
            view.c[row + r] = c;
        }
    }
    return t;
}

/// I w with the gyroscopic impulse of half a step before (sign −1) or behind (+1), body frame. The
/// Cayley map turns one into the other, so that angular momentum is exact; about a fixed axis both
/// are I w.
V3 half_step_momentum(const M3& inertia, const V3& w, double h, double sign) {
    const V3 momentum = inertia * w;
    return momentum + (sign * 0.5 * h) * cross(w, momentum);
}

}  // namespace

Turning complete_rows(const View& view, InteractionKind kind, const std::int32_t* ids,
                      const void* data, std::int32_t begin, std::int32_t end,
                      const double* u) noexcept {
    Turning t;
    with_kind(kind, [&]<class K>() {
        if constexpr (requires { requires K::kCompletes; })
            t = complete_kind<K>(view, ids, static_cast<const typename K::Data*>(data), begin, end,
                                 u);
    });
    return t;
}

Turning complete_spins(const View& view, std::int32_t begin, std::int32_t end,
                       const double* u) noexcept {
    Turning t;
    const double h = view.h;
    for (std::int32_t body = begin; body < end; ++body) {
        if (!view.turning[body] || view.dof[body] != 6) continue;
        const M3 r = load9(view.r + 9 * body), inertia = load9(view.inertia + 9 * body);
        const std::int32_t at = view.dof_begin[body] + 3;
        const V3 before = tmul(r, load3(view.v + at)), now = tmul(r, load3(u + at));
        // The matrix has I ω₊; what the momentum after the step has beyond that goes to the right.
        const V3 momentum = half_step_momentum(inertia, before, h, -1.0) -
                            (half_step_momentum(inertia, now, h, 1.0) - inertia * now);
        const V3 world = r * momentum, change = world - load3(view.spin_momentum + 3 * body);
        const V3 rate = load9(view.inv_inertia + 9 * body) * tmul(r, change);
        t.add({norm(rate), 0.0});
        add3(view.a + at, change);
        store3(view.spin_momentum + 3 * body, world);
    }
    return t;
}

}  // namespace hawser::HAWSER_ISA
