// SPDX-License-Identifier: Apache-2.0
/// Right-hand sides with which rows hold at the end of a step (step/completion.h).
#include "assembly/isa/arms.h"
#include "assembly/isa/rigid_lanes.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/simd.h"
#include "base/turn.h"
#include "model/kinds/all.h"

#include <cstring>

namespace hawser::HAWSER_ISA {
namespace {

using assembly::Turning;
using assembly::View;

constexpr int kSlots = kMaxInteractionBodies;

/// Return the rotation of a step by h ω: E + 2 (s â + â²)/(s² + a²), a = h ω/2 (base/turn.h).
M3 step_rotation(const V3& a) {
    const double y = dot(a, a), s = 1.0 - y * turn_bend(y), k = 2.0 / (s * s + y), d = 1.0 - k * y;
    const V3 b = s * a;
    return {{d + k * a.x * a.x, k * (a.x * a.y - b.z), k * (a.x * a.z + b.y), k * (a.x * a.y + b.z),
             d + k * a.y * a.y, k * (a.y * a.z - b.x), k * (a.x * a.z - b.y), k * (a.y * a.z + b.x),
             d + k * a.z * a.z}};
}

M3 product(const M3& a, const M3& b) {
    M3 out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out.a[3 * i + j] =
                a.a[3 * i] * b.a[j] + a.a[3 * i + 1] * b.a[3 + j] + a.a[3 * i + 2] * b.a[6 + j];
    return out;
}

/// Return the pose of a body after `time` [s] with packed velocities u. @param fixed  Velocities of
/// fixed bodies. @param buffer  Buffer for its rotation.
BodyRef moved_pose(const View& view, std::int32_t body, const double* u, const double* fixed,
                   double time, M3& buffer) {
    const int dof = view.dof[body];
    const V3 x = load3(view.x + 3 * body);
    if (dof == 3 || dof == 1) {
        const double* v = u + view.dof_begin[body];
        return {x + time * (dof == 3 ? load3(v) : V3{v[0], 0.0, 0.0}), view.r + 9 * body, false};
    }
    const double* v = dof == 6 ? u + view.dof_begin[body] : fixed + 6 * body;
    buffer = product(step_rotation((0.5 * time) * load3(v + 3)), load9(view.r + 9 * body));
    return {x + time * load3(v), buffer.a, true};
}

/// Compute the violations of an interaction at the poses of moved_pose().
template <class K>
void moved_rows(const View& view, std::int32_t id, const typename K::Data& data, const double* u,
                const double* fixed, double time, Rows<K::kBodies, K::kRows>& rows) {
    BodyRef refs[K::kBodies];
    M3 buffer[K::kBodies];
    for (int b = 0; b < K::kBodies; ++b)
        refs[b] = moved_pose(view, view.body[kSlots * id + b], u, fixed, time, buffer[b]);
    K::evaluate(data, refs, rows);
}

/// Compute G u of the rows of one interaction.
template <int R>
void row_speeds(const View& view, std::int32_t id, const double* u, double (&speed)[R]) {
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(view, id, buffer);
    for (int r = 0; r < R; ++r) {
        speed[r] = 0.0;
        for (int b = 0; b < view.bodies[id]; ++b) {
            const std::int32_t body = view.body[kSlots * id + b];
            const double* v = u + view.dof_begin[body];
            for (int j = 0; j < view.dof[body]; ++j) speed[r] += *jac++ * v[j];
        }
    }
}

/// Request for the right-hand sides of completed rows, and their destination.
struct Asked {
    const double* u;  ///< Packed velocities of the linearisation.
    double* c;        ///< Right-hand sides, by row.
    /// True for the first call of a step: c still contains ġ at its start, which is saved.
    bool first;
};

/// Save ġ at the start of the step, derived from c.
void keep_rate(const View& view, std::int32_t row) {
    view.rate[row] =
        (view.c[row] / view.upsilon[row] + 4.0 / view.h * view.g[row]) / view.recall[row];
}

/// Compute the right-hand sides c with which the rows of a compact joint hold at the end of the
/// step. Let a = h ω/2 of a body. The finite rotation moves the end of its arm r by h t more than
/// h ω × r. With s and b of base/turn.h, and the violation g at the start of the step:
/// ```
///     t = (2/h) (a × (a × r) − a² (1 − s b) a × r)/(s² + a²)    [m/s]
///     c = −(g/h + t of body 1 − t of body 0)
/// ```
/// This needs no poses at the end of the step, and no difference of nearly equal positions.
void complete_arms(const View& view, std::int32_t id, const Asked& asked, Turning& t) {
    const ArmsT<double> arms = load_arms(view.jacobian + view.jac_begin[id]);
    const std::int32_t* body = view.body + kSlots * id;
    V3 beyond{0.0, 0.0, 0.0}, closing = beyond;
    for (int b = 0; b < 2; ++b) {
        const double* v = asked.u + view.dof_begin[body[b]];
        const V3 a = (0.5 * view.h) * load3(v + 3), r = b == 0 ? arms.r0 : arms.r1;
        const V3 turn = cross(a, r);
        const double square = dot(a, a), bend = turn_bend(square), s = 1.0 - square * bend;
        const double scale = (b == 0 ? -2.0 : 2.0) / (view.h * (s * s + square));
        beyond = beyond + scale * (cross(a, turn) - (square * (1.0 - s * bend)) * turn);
        closing = closing + (b == 0 ? -1.0 : 1.0) * (load3(v) + cross(load3(v + 3), r));
    }
    const std::int32_t row = view.row_begin[id];
    const double per_h = 1.0 / view.h;
    const V3 c = -(per_h * load3(view.g + row) + beyond);
    const double to[3] = {c.x, c.y, c.z};
    const double gap[3] = {closing.x - c.x, closing.y - c.y, closing.z - c.z};
    for (int r = 0; r < 3; ++r) {
        if (asked.first) keep_rate(view, row + r);
        t.add({__builtin_fabs(to[r] - view.c[row + r]), view.h * __builtin_fabs(gap[r]), 0.0});
        asked.c[row + r] = to[r];
    }
}

/// True if the eight interactions from `id` on are completed compact joints.
bool eight_completed(const View& view, std::int32_t id) {
    std::uint64_t flags;
    std::memcpy(&flags, view.completed + id, sizeof flags);
    if (flags != 0x0101010101010101 || !eight_arms(view, id)) return false;
    if constexpr (kExactLoads) return true;
    // Loads of six velocities read eight, which must not exceed the array.
    std::int32_t last = 0;
    for (int l = 0; l < kLanes; ++l)
        for (int b = 0; b < 2; ++b) {
            const std::int32_t begin = view.dof_begin[view.body[kSlots * (id + l) + b]];
            last = begin > last ? begin : last;
        }
    return last + kLanes <= view.dof_count;
}

/// Apply complete_arms() to eight joints.
void complete_eight(const View& view, std::int32_t id, const Asked& asked, Turning& t) {
    const ArmsT<W8> arms = next_arms(view.jacobian + view.jac_begin[id]);
    const W8 none{}, unit = one(none), half = none + 0.5 * view.h, two_per_h = none + 2.0 / view.h;
    V8 v[2][kLanes];
    W3 beyond[2];
    for (int b = 0; b < 2; ++b) {
        load_slots(view, id, b, asked.u, [&](std::int32_t i) { return view.dof_begin[i]; }, v[b]);
        const W3 a = half * W3{v[b][3], v[b][4], v[b][5]}, &r = b == 0 ? arms.r0 : arms.r1;
        const W3 turn = cross(a, r);
        const W8 square = dot(a, a), bend = turn_bend(square), s = unit - square * bend;
        const W8 scale = two_per_h * (1.0 / (s * s + square));
        beyond[b] = scale * (cross(a, turn) - (square * (unit - s * bend)) * turn);
    }
    const W3 over = beyond[1] - beyond[0], closing = joint_speeds(v[0], v[1], arms.r0, arms.r1);
    V8 over3[3], closing3[3];
    as_threes(over.x, over.y, over.z, over3);
    as_threes(closing.x, closing.y, closing.z, closing3);
    const V8 per_h = none + 1.0 / view.h, per_h4 = 4.0 * per_h;
    auto larger = [&](const V8& a, const V8& b) {
        const V8 size = select_greater(b, none, b, -b);
        return select_greater(a, size, a, size);
    };
    V8 change{}, gap{}, finite{};
    const std::int32_t row = view.row_begin[id];
    for (int k = 0; k < 3; ++k) {
        const std::int32_t r = row + kLanes * k;
        const V8 g = load(view.g + r), c = load(view.c + r);
        if (asked.first)
            store(view.rate + r, (c * (1.0 / load(view.upsilon + r)) + per_h4 * g) *
                                     (1.0 / load(view.recall + r)));
        const V8 to = none - (per_h * g + over3[k]);
        change = larger(change, to - c);
        gap = larger(gap, closing3[k] - to);
        finite += to - to;
        store(asked.c + r, to);
    }
    t.add({largest(change) + sum(finite), view.h * largest(gap) + sum(finite), 0.0});
}

template <class K>
Turning complete_kind(const View& view, const std::int32_t* ids, const typename K::Data* data,
                      std::int32_t begin, std::int32_t end, const Asked& asked) {
    constexpr int B = K::kBodies, R = K::kRows;
    constexpr bool kCompactKind = requires { requires K::kMayBeCompact; };
    Turning t;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t id = ids[k];
        if (!view.completed[id]) continue;
        const bool rigid = view.completed[id] == assembly::kRigid;
        if (kCompactKind && view.arms[id] && rigid) {
            const bool run = k + kLanes <= end && ids[k + kLanes - 1] - id == kLanes - 1;
            if (run && eight_completed(view, id)) {
                complete_eight(view, id, asked, t);
                k += kLanes - 1;
            } else {
                complete_arms(view, id, asked, t);
            }
            continue;
        }
        Rows<B, R> after;
        moved_rows<K>(view, id, data[k], asked.u, view.v_fixed, view.h, after);
        double speed[R];
        row_speeds<R>(view, id, asked.u, speed);
        const std::int32_t row = view.row_begin[id];
        Rows<B, R> before;
        if (!rigid) moved_rows<K>(view, id, data[k], view.v, view.v_before, -view.h, before);
        for (int r = 0; r < R; ++r) {
            double c = speed[r] - after.g[r] / view.h;
            if (!rigid) {
                const double ups = view.upsilon[row + r], g = view.g[row + r];
                c += (1.0 - 4.0 * ups) * g / view.h +
                     ups * view.recall[row + r] * (g - before.g[r]) / view.h;
            }
            if (asked.first) keep_rate(view, row + r);
            const double change = __builtin_fabs(c - view.c[row + r]);
            t.add({change, rigid ? __builtin_fabs(after.g[r]) : view.h * change, 0.0});
            asked.c[row + r] = c;
        }
    }
    return t;
}

}  // namespace

Turning complete_rows(const View& view, InteractionKind kind, const std::int32_t* ids,
                      const void* data, std::int32_t begin, std::int32_t end, const double* u,
                      bool first) noexcept {
    Turning t;
    const Asked asked{u, first ? view.c : view.c_next, first};
    with_kind(kind, [&]<class K>() {
        if constexpr (requires { requires K::kCompletes; })
            t = complete_kind<K>(view, ids, static_cast<const typename K::Data*>(data), begin, end,
                                 asked);
    });
    return t;
}

void adopt_completed(const View& view, const std::int32_t* ids, std::int32_t begin,
                     std::int32_t end) noexcept {
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t id = ids[k];
        if (!view.completed[id]) continue;
        for (std::int32_t r = view.row_begin[id]; r < view.row_begin[id] + view.rows[id]; ++r)
            view.c[r] = view.c_next[r];
    }
}

}  // namespace hawser::HAWSER_ISA
