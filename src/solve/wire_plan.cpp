// SPDX-License-Identifier: Apache-2.0
#include "solve/wire_plan.h"

#include "assembly/geo.h"
#include "base/index.h"
#include "context/copies.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "context/wires_data.h"
#include "solve/wires.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

using assembly::View;
using generic::V3;

constexpr int kNoReturn = 2;   ///< Level from which the stiffness returns no energy.
constexpr int kLastStiff = 3;  ///< Last level with stiffness alone.
constexpr int kHoldsAll = 7;   ///< Level at which all slack elements count as taut.

/// An element between its ends: now, half a step ago and half a step ahead [m], and the relative
/// velocities of slot 0 to slot 1 used by K.
struct Line {
    V3 arm[2], back, ahead, separation;
    V3 before, started;  ///< Velocity of point 1 relative to point 0: now, and as expected next.
    double rest, stiffness;
};

/// Return the velocity of a body from a packed vector, as kernels read it.
void velocity_of(const View& v, const double* packed, std::int32_t body, V3& lin, V3& ang) {
    const double* fixed_velocities = packed == v.v ? v.v_before : v.v_fixed;
    const double* p = v.dof[body] == 0 ? fixed_velocities + 6 * body : packed + v.dof_begin[body];
    lin = generic::load3(p);
    ang = v.dof[body] == 6 || v.dof[body] == 0 ? generic::load3(p + 3) : V3{0, 0, 0};
}

V3 turned(const V3& r, const V3& b) {
    const V3 c = cross(b, r);
    return r + (2.0 / (1.0 + dot(b, b))) * (c + cross(b, c));
}

Line line_of(const View& v, std::int32_t id) noexcept {
    Line o{};
    const double* record = v.geo_record + v.geo[id].record;
    V3 point[2], back[2], ahead[2], speed[2], start[2];
    for (int b = 0; b < 2; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        V3 lin, ang, to, turn, first, spin;
        velocity_of(v, v.v, body, lin, ang);
        velocity_of(v, v.v_new, body, to, turn);
        velocity_of(v, v.v_ahead, body, first, spin);
        o.arm[b] = v.geo[id].dof == 3 ? V3{0, 0, 0} : generic::load3(record + 4 + 3 * b);
        const V3 x = generic::load3(v.x + 3 * body);
        point[b] = x + o.arm[b];
        back[b] = x - (0.5 * v.h) * lin + turned(o.arm[b], (-0.25 * v.h) * ang);
        ahead[b] = x + (0.5 * v.h) * to + turned(o.arm[b], (0.25 * v.h) * turn);
        speed[b] = lin + cross(ang, o.arm[b]);
        start[b] = first + cross(spin, o.arm[b]);
    }
    o.separation = point[1] - point[0];
    o.back = back[1] - back[0];
    o.ahead = ahead[1] - ahead[0];
    o.before = speed[1] - speed[0];
    o.started = start[1] - start[0];
    const std::int32_t row = v.row_begin[id];
    o.rest = norm(o.separation) - v.g[row];
    o.stiffness = 1.0 / v.epsilon[row];
    return o;
}

/// Return the tension of a line by its elastic law, half a step after the poses of the current
/// solution [N].
double tension_after(const Line& l) noexcept { return l.stiffness * (norm(l.ahead) - l.rest); }

/// Write the replacement law of an element: the stiffness matrix K = w (E − uuᵀ), and the
/// additional impulse `past` on slot 0.
void write_line(const View& v, std::int32_t id, double w, const V3& u, const Line& l,
                const V3& past) noexcept {
    const assembly::GeoSlot& place = v.geo[id];
    double* record = v.geo_record + place.record;
    record[0] = w;
    generic::store3(record + 1, u);
    double* slot[2] = {v.geo_force + place.slot(0), v.geo_force + place.slot(1)};
    // Effect of K on the start velocities, then the part that it returns.
    const V3 now = v.v_start ? (-w) * (l.started - dot(u, l.started) * u) : V3{0, 0, 0};
    if (place.dof == 3) {
        const double pair = pair_mass_of(v, id);
        generic::store3(slot[0], v.v_start ? now + pair * l.started : now);
        generic::store3(slot[0] + 3, past + pair * l.before);
        return;
    }
    for (int b = 0; b < 2; ++b) {
        const double sign = b == 0 ? 1.0 : -1.0;
        generic::store3(slot[b], sign * now);
        generic::store3(slot[b] + 3, cross(l.arm[b], sign * now));
        generic::store3(slot[b] + 6, sign * past);
        generic::store3(slot[b] + 9, cross(l.arm[b], sign * past));
    }
}

/// Write the geometric stiffness of an element as its replacement law.
/// @param pull  Tension to use [N].
void write_stiff(const View& v, std::int32_t id, const Line& l, double pull, bool back) noexcept {
    const double length = std::max(norm(l.separation), 1e-9);
    const V3 u = generic::load3(v.geo_record + v.geo[id].record + 1);
    const double full = v.h * v.h * v.geometric_stiffness * std::max(pull, 0.0) / length;
    if (!back) return write_line(v, id, full, u, l, {0, 0, 0});
    const auto [late, ahead] = generic::across_fractions(full * v.lightness[id], 1.0);
    const V3 mix = late * l.before + ahead * l.started;
    write_line(v, id, (late + ahead) * full, u, l, (-full) * (mix - dot(u, mix) * u));
}

void write_bound(const View& v, std::int32_t id, const Line& l, bool holds) noexcept {
    v.active[id] = 0.0;
    const double length = norm(l.back), k = l.stiffness;
    const bool taut = (v.flags[id] & model::kOneSided) == 0 || length >= l.rest;
    const V3 none{0, 0, 0};
    if (!taut && !holds) return write_line(v, id, 0.0, none, l, none);
    V3 past = (0.5 * v.h * v.h * k) * l.before;
    if (taut) past = past + (v.h * k * (1.0 - l.rest / std::max(length, 1e-12))) * l.back;
    write_line(v, id, 0.5 * v.h * v.h * k, none, l, past);
}

}  // namespace

void plan_wires(context::Model& model, const context::Before& kept, std::int32_t wire) noexcept {
    context::Wires& w = model.wires;
    const View v = context::row_view(model);
    const int refused = w.level[at(wire)]++;
    for (const context::WirePart& p : w.parts) {
        if (p.wire != wire) continue;
        for (std::int32_t i = p.element_begin; i < p.element_end; ++i) {
            const std::int32_t id = w.element[at(i)], row = v.row_begin[id];
            if (v.parted[id] || model.system.rests(id)) continue;
            const Line l = line_of(v, id);
            const double after = tension_after(l);
            double& pull = w.pull[at(i)];
            if (refused == 0) {
                pull = std::max(0.0, -kept.lambda[at(row)] / v.h);
                w.holds[at(i)] = 0;
            }
            if (refused <= kNoReturn)
                pull = std::max({pull, v.active[id] * -v.lambda[row] / v.h, after});
            if (refused == kNoReturn)
                pull = std::max(4.0 * pull, 0.01 * l.stiffness * norm(l.separation));
            if (refused > kLastStiff && (after > 0.0 || refused + 1 >= kHoldsAll))
                w.holds[at(i)] = 1;
        }
    }
}

void replan_wires(context::Model& model, const View& v, int strip) noexcept {
    context::Wires& w = model.wires;
    if (!w.again) return;
    context::each(model.system.strips.interactions(strip), [&](std::int32_t begin,
                                                               std::int32_t end) {
        for (std::int32_t id = begin; id < std::min(end, context::interaction_count(model)); ++id) {
            const std::int32_t wire = w.wire_of[at(id)];
            if (wire < 0 || w.level[at(wire)] == 0 || v.parted[id]) continue;
            const auto i = at(w.place[at(id)]);
            const Line l = line_of(v, id);
            if (w.level[at(wire)] > kLastStiff)
                write_bound(v, id, l, w.holds[i] != 0);
            else
                write_stiff(v, id, l, w.pull[i], w.level[at(wire)] < kNoReturn);
        }
    });
}

void settle_wires(context::StepContext& ctx) noexcept {
    context::Wires& w = ctx.model.wires;
    remember_gains(ctx.model);
    // The loss of a guarded wire is known exactly, and replaces the one computed from its rows.
    if (w.measured)
        for (std::size_t k = 0; k < w.count(); ++k)
            if (w.fast[k]) ctx.state.ledger.damped += w.gain[k].unbooked;
    if (!w.replacing) return;
    const View v = context::row_view(ctx.model);
    for (const std::int32_t id : w.element) {
        const std::int32_t row = v.row_begin[id];
        if (!w.replaced[at(id)]) continue;
        w.replaced[at(id)] = 0;
        const Line l = line_of(v, id);
        const bool pulls = (v.flags[id] & model::kOneSided) != 0;
        const double tension = tension_after(l);
        const bool taut = !pulls || tension > 0.0;
        v.active[id] = taut ? 1.0 : 0.0;
        v.lambda[row] = taut ? -v.h * tension : 0.0;
    }
    w.replacing = false;
    ctx.work.solve.losses_known = false;
}

double elastic_energy_of_element(const View& v, std::int32_t id) noexcept {
    const std::int32_t* body = v.body + kMaxInteractionBodies * id;
    const double* record = v.geo_record + v.geo[id].record;
    const bool lumps = v.geo[id].dof == 3;
    V3 now[2], back[2];
    for (int b = 0; b < 2; ++b) {
        V3 lin, ang;
        velocity_of(v, v.v, body[b], lin, ang);
        now[b] = generic::load3(v.x + 3 * body[b]);
        back[b] = now[b] - (0.5 * v.h) * lin;
        if (lumps) continue;
        const V3 arm = generic::load3(record + 4 + 3 * b);
        // Half of the rotation by 2 atan(h|ω|/2). A stiff spring needs the third-order term that
        // Line::back leaves out.
        const double whole = 0.25 * v.h * v.h * dot(ang, ang);
        const double half = -0.5 * v.h / (1.0 + std::sqrt(1.0 + whole));
        now[b] = now[b] + arm;
        back[b] = back[b] + turned(arm, half * ang);
    }
    const std::int32_t row = v.row_begin[id];
    const double rest = norm(now[1] - now[0]) - v.g[row];
    const double longer = norm(back[1] - back[0]) - rest;
    if ((v.flags[id] & model::kOneSided) && longer < 0.0) return 0.0;
    return 0.5 * longer * longer / v.epsilon[row];
}

}  // namespace hawser::solve
