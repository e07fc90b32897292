// SPDX-License-Identifier: Apache-2.0
/// Samples for the monitors (monitor/monitor.h), eight at a time: energies of consecutive rigid
/// bodies, and violations.
#include "assembly/isa/rigid_lanes.h"
#include "assembly/isa/rows.h"
#include "assembly/isa/spin.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::BodyEnergies;
using assembly::View;

/// Return twice the kinetic energy of eight bodies at the velocities u.
template <class Inertia>
V8 twice_kinetic(const V8& mass, const Inertia& inertia, const WM3& r, const V8 (&u)[kLanes]) {
    const W3 move{u[0], u[1], u[2]}, spin = tmul(r, W3{u[3], u[4], u[5]});
    return mass * dot(move, move) + dot(spin, inertia * spin);
}

/// Sums in lanes; sum() adds the lanes at the end of a run of bodies.
struct Sums {
    V8 before{}, after{};  ///< Twice the kinetic energies.
    V8 half_way{}, pose{};
    double turn;
    std::int32_t turn_body;
};

/// True if any lane is ≥ limit or NaN, like the scalar path.
bool any_not_below(const V8& some, double limit) {
    return any(select_greater(V8{} + limit, some, V8{}, one(some)));
}

/// Return the masses of eight bodies on which gravity acts, 0 for others.
V8 heavy_masses(const View& view, std::int32_t body, const V8& mass) {
    std::uint64_t weight;
    std::memcpy(&weight, view.weight + body, sizeof weight);
    if (weight == 0x0101010101010101) return mass;
    double heavy[kLanes];
    for (int l = 0; l < kLanes; ++l) heavy[l] = view.weight[body + l] ? view.mass[body + l] : 0.0;
    return load(heavy);
}

void add_eight(const View& view, std::int32_t body, const double* after, double half, Sums& s) {
    const std::int32_t begin = view.dof_begin[body];
    V8 v[kLanes], u[kLanes], own[kLanes];
    load_bodies(view.v + begin, 6, v);
    load_bodies(after + begin, 6, u);
    load_bodies(view.principal + 6L * body, 6, own);
    const V8 mass = load(view.mass + body);
    const WM3 r = load_bodies9(view.r + 9L * body);
    const auto add_kinetic = [&](const auto& inertia) {
        s.before += twice_kinetic(mass, inertia, r, v);
        s.after += twice_kinetic(mass, inertia, r, u);
    };
    if (all_principal(own[0]))
        add_kinetic(Principal<W8>{{own[0], own[1], own[2]}});
    else
        add_kinetic(load_bodies9(view.inertia + 9L * body));

    const V8 heavy = heavy_masses(view, body, mass);
    const W3 x = load_threes(view.x + 3L * body);
    const double* g = view.gravity;
    const V8 fall = g[0] * x.x + g[1] * x.y + g[2] * x.z;
    s.pose -= heavy * fall;
    s.half_way -= heavy * (fall - half * (g[0] * v[0] + g[1] * v[1] + g[2] * v[2]));

    const V8 turn = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
    if (!any_not_below(turn, s.turn)) return;
    for (int l = 0; l < kLanes; ++l) {
        if (lane(turn, l) <= s.turn) continue;
        s.turn = lane(turn, l);
        s.turn_body = body + l;
    }
}

}  // namespace

std::int32_t rigid_energies(const View& view, const std::int32_t* bodies, std::int32_t count,
                            const double* after, double half, BodyEnergies* sums) noexcept {
    Sums s{};
    s.turn = sums->turn;
    s.turn_body = sums->turn_body;
    std::int32_t done = 0;
    while (done + kLanes <= count && bodies[done + kLanes - 1] == bodies[done] + kLanes - 1 &&
           eight_rigid(view, bodies[done])) {
        add_eight(view, bodies[done], after, half, s);
        done += kLanes;
    }
    if (done == 0) return 0;
    sums->before += 0.5 * sum(s.before);
    sums->after += 0.5 * sum(s.after);
    sums->half_way += sum(s.half_way);
    sums->pose += sum(s.pose);
    sums->turn = s.turn;
    sums->turn_body = s.turn_body;
    return done;
}

std::int32_t widest_row(const double* g, const double* fraction, std::int32_t begin,
                        std::int32_t end, double* most) noexcept {
    std::int32_t found = -1;
    const auto take = [&](std::int32_t row) {
        const double open = __builtin_fabs(g[row]) * fraction[row];
        if (open <= *most) return;
        *most = open;
        found = row;
    };
    std::int32_t row = begin;
    for (; row + kLanes <= end; row += kLanes) {
        const V8 some = load(g + row) * load(fraction + row);
        const V8 open = select_greater(some, -some, some, -some);
        if (!any_not_below(open, *most)) continue;
        for (int l = 0; l < kLanes; ++l) take(row + l);
    }
    for (; row < end; ++row) take(row);
    return found;
}

}  // namespace hawser::HAWSER_ISA
