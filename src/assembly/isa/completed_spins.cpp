// SPDX-License-Identifier: Apache-2.0
/// Right-hand sides with which spins satisfy their equation at the end of a step
/// (step/completion.h).
#include "assembly/isa/rigid_lanes.h"
#include "assembly/isa/rows.h"
#include "assembly/isa/spin.h"
#include "base/simd.h"
#include "base/turn.h"

#include <cstring>

namespace hawser::HAWSER_ISA {
namespace {

using assembly::Turning;
using assembly::View;

/// Request for the terms of completed spins, and their destination.
struct Asked {
    const double* u;  ///< Packed velocities of the linearisation.
    double* spin;     ///< 3 per body.
    bool first;       ///< True for the first call of a step, which also adds to `a`.
};

/// Return the contribution of the rotation of a body to the right-hand side `a`, body frame [N m
/// s]. It is the angular momentum μ₋ of the velocity before the step, minus μ₊ of that after it
/// (base/turn.h), plus I ω₊, which is in the matrix.
template <class T, class Inertia>
V3T<T> spin_impulse(const Inertia& inertia, const V3T<T>& before, const V3T<T>& now,
                    const T& half) {
    return inertia * before + turn_momentum(inertia, before, T(-half)) -
           turn_momentum(inertia, now, half);
}

Turning complete_spin(const View& view, std::int32_t body, const Asked& asked) {
    const M3 r = load9(view.r + 9 * body);
    const std::int32_t at = view.dof_begin[body] + 3;
    const V3 before = tmul(r, load3(view.v + at)), now = tmul(r, load3(asked.u + at));
    const V3 world = r * spin_impulse(load9(view.inertia + 9 * body), before, now, 0.5 * view.h);
    const V3 change = world - load3(view.spin_momentum + 3 * body);
    store3(asked.spin + 3 * body, world);
    if (asked.first) add3(view.a + at, change);
    return {norm(load9(view.inv_inertia + 9 * body) * tmul(r, change)), 0.0, norm(now)};
}

/// Apply complete_spin() to eight consecutive rigid bodies.
Turning complete_eight_spins(const View& view, std::int32_t body, const Asked& asked) {
    const std::int32_t begin = view.dof_begin[body];
    const WM3 r = load_bodies9(view.r + 9L * body);
    V8 v[kLanes], u[kLanes], own[kLanes];
    load_bodies(view.v + begin, 6, v);
    load_bodies(asked.u + begin, 6, u);
    load_bodies(view.principal + 6L * body, 6, own);
    const W3 before = tmul(r, W3{v[3], v[4], v[5]}), now = tmul(r, W3{u[3], u[4], u[5]});
    const W3 last = load_threes(view.spin_momentum + 3L * body);
    const W8 half = W8{} + 0.5 * view.h;
    W3 world, rate;
    auto solve = [&](const auto& inertia, const auto& inverse) {
        world = r * spin_impulse(inertia, before, now, half);
        rate = inverse * tmul(r, world - last);
    };
    if (all_principal(own[0]))
        solve(Principal<W8>{{own[0], own[1], own[2]}}, Principal<W8>{{own[3], own[4], own[5]}});
    else
        solve(load_bodies9(view.inertia + 9L * body), load_bodies9(view.inv_inertia + 9L * body));
    if (asked.first) {
        const W3 change = world - last;
        for (int l = 0; l < kLanes; ++l)
            add3(view.a + begin + 6 * l + 3,
                 {lane(change.x, l), lane(change.y, l), lane(change.z, l)});
    }
    store_threes(asked.spin + 3L * body, world);
    const W8 square = dot(rate, rate);
    return {root(largest(square)) + sum(square - square), 0.0, root(largest(dot(now, now)))};
}

}  // namespace

Turning complete_spins(const View& view, std::int32_t begin, std::int32_t end, const double* u,
                       bool first) noexcept {
    Turning t;
    const Asked asked{u, first ? view.spin_momentum : view.spin_next, first};
    for (std::int32_t body = begin; body < end; ++body) {
        if (!view.turning[body]) continue;
        std::uint64_t turning = 0;
        if (body + kLanes <= end) std::memcpy(&turning, view.turning + body, sizeof turning);
        if (turning == 0x0101010101010101 && eight_rigid(view, body)) {
            t.add(complete_eight_spins(view, body, asked));
            body += kLanes - 1;
        } else if (view.dof[body] == 6) {
            t.add(complete_spin(view, body, asked));
        }
    }
    return t;
}

void adopt_spins(const View& view, std::int32_t begin, std::int32_t end) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        if (!view.turning[body] || view.dof[body] != 6) continue;
        const V3 next = load3(view.spin_next + 3 * body);
        add3(view.a + view.dof_begin[body] + 3, next - load3(view.spin_momentum + 3 * body));
        store3(view.spin_momentum + 3 * body, next);
    }
}

}  // namespace hawser::HAWSER_ISA
