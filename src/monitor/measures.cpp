// SPDX-License-Identifier: Apache-2.0
/// Samples for the monitors.
#include "monitor/measures.h"

#include "assembly/kernels.h"
#include "assembly/kinetic.h"
#include "assembly/rows.h"
#include "base/index.h"
#include "context/monitor_data.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "solve/wire_plan.h"

#include <algorithm>
#include <cmath>

namespace hawser::monitor {
namespace {

using assembly::View;

void measure_body(const context::Model& model, std::int32_t body, const double* after, double half,
                  assembly::BodyEnergies& e) noexcept {
    const model::Bodies& b = model.bodies;
    const auto i = at(body);
    const int dof = b.dof(body);
    const double* v = &b.v[at(b.dof_begin[i])];
    e.before += assembly::kinetic_energy_of(b, body, b.v.data());
    e.after += assembly::kinetic_energy_of(b, body, after);
    if (dof == 1) return;
    if (b.weight[i])
        for (int k = 0; k < 3; ++k) {
            const double weight = b.mass[i] * model.def.gravity[k];
            e.half_way -= weight * (b.x[3 * i + at(k)] - half * v[k]);
            e.pose -= weight * b.x[3 * i + at(k)];
        }
    if (dof < 6) return;
    const double turn = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
    if (!(turn <= e.turn)) {
        e.turn = turn;
        e.turn_body = body;
    }
}

/// Add the energies of the moving bodies [begin, end) to a sample, and update its largest rotation
/// in a step.
void measure_bodies(const context::Model& model, const View& v, std::int32_t begin,
                    std::int32_t end, const double* after, double half,
                    context::MonitorPart& p) noexcept {
    const std::vector<std::int32_t>& moving = model.bodies.moving;
    assembly::BodyEnergies e;
    for (std::int32_t i = begin; i < end;) {
        if (v.dof[moving[at(i)]] == 6) {
            const std::int32_t done =
                assembly::kernels().rigid_energies(v, moving.data() + i, end - i, after, half, &e);
            i += done;
            if (done > 0) continue;
        }
        measure_body(model, moving[at(i++)], after, half, e);
    }
    p.kinetic += e.before;
    p.potential += e.half_way;
    p.at_pose += 0.5 * (e.before + e.after) + e.pose;
    p.turn = e.turn;
    p.turn_body = e.turn_body;
}

void measure_rows(const context::State& state, const View& v, std::int32_t begin, std::int32_t end,
                  context::MonitorPart& p) noexcept {
    const std::int32_t row =
        assembly::kernels().widest_row(v.g, state.monitor.allowed.data(), begin, end, &p.open);
    if (row >= 0) p.open_row = row;
}

/// Find the range with the largest violation. Rows of coordinates inside their range are ignored.
void measure_ranges(const context::State& state, const View& v, context::MonitorPart& p) noexcept {
    for (std::size_t i = 0; i < state.monitor.ranges.size(); ++i) {
        const std::int32_t row = state.monitor.ranges[i];
        const double beyond = std::fabs(v.g[row]) * state.monitor.range_allowed[i];
        if (beyond <= p.beyond) continue;
        p.beyond = beyond;
        p.beyond_row = row;
    }
}

/// Find the contact with the largest depth, relative to the thickness of the thinner shape.
void measure_contacts(const context::Model& model, const context::State& state,
                      context::MonitorPart& p) noexcept {
    const std::vector<collide::Shape>& shapes = model.collider.shapes();
    for (std::size_t i = 0; i < state.contacts.awake; ++i) {
        const collide::Contact& c = state.contacts.contacts[i];
        const double deep =
            -c.gap / std::min(shapes[at(c.shape[0])].thickness, shapes[at(c.shape[1])].thickness);
        if (deep <= p.deep) continue;
        p.deep = deep;
        p.deep_contact = static_cast<std::int32_t>(i);
    }
}

/// Return the elastic energy ½ f² ε of a row for its force f in the last step [J].
double elastic_energy_from_force(const View& v, std::int32_t row) noexcept {
    return 0.5 * v.force_of_row[row] * v.force_of_row[row] * v.epsilon[row];
}

/// Add the elastic energies ½ g²/ε of the rows of an interaction (violation g, compliance ε) to the
/// sample p. @param half  Time of the violations before the poses [s]: h/2 or 0.
void measure_elastic(context::Model& model, const View& v, std::int32_t id, bool between_points,
                     double half, context::MonitorPart& p) noexcept {
    // For a wire use its true length, as the guard does.
    if (half > 0.0 && model.wires.wire_of[at(id)] >= 0 && !model.system.rests(id) &&
        !v.parted[id] && (v.flags[id] & model::kCarried) == 0) {
        const std::int32_t row = v.row_begin[id];
        if (model::holds_energy(v.epsilon[row], v.rest_length[id])) {
            const double held = solve::elastic_energy_of_element(v, id);
            p.elastic += held;
            p.by_length += held;
            p.by_force += elastic_energy_from_force(v, row);
            if (v.g[row] > 0.0 || !(v.flags[id] & model::kOneSided))
                p.at_pose += 0.5 * v.g[row] * v.g[row] / v.epsilon[row];
        }
        return;
    }
    const bool line = (v.flags[id] & model::kOneSided) != 0;
    if (line ? v.parted[id] != 0 : v.active[id] == 0.0) return;
    const bool rests = model.system.rests(id);
    const bool state = rests || (v.flags[id] & model::kCarried) != 0;
    const model::RowState s =
        state ? model.interactions.row_state(id, model.bodies) : model::RowState{};
    double buffer[model::kArmBufferSize];
    const double* jac = rests ? nullptr : packed_rows(v, id, buffer);
    double secant[kMaxInteractionRows];
    const bool secants = half > 0.0 && model.interactions.uses_secants(id);
    if (secants) model.interactions.secants_before(id, model.bodies, v.h, secant);
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        double speed = state ? s.carried[r] + (rests ? s.rate[r] : 0.0) : 0.0;
        if (!rests) speed = assembly::along_row(v, id, jac, v.v, v.dof_begin, speed);
        if (secants) speed = secant[r];
        if ((v.row_flags[row] & model::kRowVelocity) ||
            !model::holds_energy(v.epsilon[row], v.rest_length[id]))
            continue;
        const double now = rests ? s.g[r] : v.g[row];
        const double g = !rests && (v.flags[id] & model::kRange)
                             ? model::range_gap(v.low[id], v.high[id], -half * speed)
                             : model::half_step_gap(v.row_flags[row], now, half, speed);
        if (half > 0.0) p.by_force += elastic_energy_from_force(v, row);
        if (!line || now > 0.0) p.at_pose += 0.5 * now * now / v.epsilon[row];
        const double held = !line || g > 0.0 ? 0.5 * g * g / v.epsilon[row] : 0.0;
        p.elastic += held;
        p.by_length +=
            between_points && !state && half > 0.0 ? solve::elastic_energy_of_element(v, id) : held;
    }
}

/// Correct the kinetic energy of a sample for the mass of an element, which moves as a straight bar
/// (consistent mass). Its end nodes count half of this mass each.
void measure_piece(const View& v, std::int32_t id, const double* after,
                   context::MonitorPart& p) noexcept {
    const double before = assembly::pair_energy(v, id, v.v);
    p.kinetic -= before;
    p.at_pose -= 0.5 * (before + assembly::pair_energy(v, id, after));
}

/// Find the largest deviation of an element from the cable law, and its largest rotation in a step.
void measure_line(const context::Model& model, const View& v, std::int32_t id,
                  context::MonitorPart& p) noexcept {
    if (v.parted[id] || model.system.rests(id)) return;
    const std::int32_t row = v.row_begin[id];
    const double length = v.rest_length[id];
    const std::int32_t* body = v.body + kMaxInteractionBodies * id;
    // An end on a body with arms moves with it; the rotation of the body is checked instead.
    if (v.dof[body[0]] == 3 && v.dof[body[1]] == 3) {
        double separation = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double d = v.v[v.dof_begin[body[1]] + k] - v.v[v.dof_begin[body[0]] + k];
            separation += d * d;
        }
        const double twist = separation / (length * length);
        if (!(twist <= p.twist)) {
            p.twist = twist;
            p.twist_id = id;
        }
    }
    if (v.active[id] == 0.0 || v.lambda[row] >= 0.0) return;
    // The element was slack at the start of the step: it tightens within it, and its force belongs
    // to the end of the step.
    if ((v.flags[id] & model::kOneSided) && v.g[row] < 0.0) return;
    // The force of its damper at this speed, and the motion of half a step, are part of the law.
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(v, id, buffer);
    const double speed = assembly::along_row(v, id, jac, v.v, v.dof_begin);
    const double late = 0.25 * v.h * (1.0 / v.upsilon[row] - 1.0) + 0.5 * v.h;
    const double off = std::fabs(v.g[row] + v.epsilon[row] * v.lambda[row] / v.h);
    const double stretch = std::max(0.0, off - late * std::fabs(speed)) / length;
    if (!(stretch <= p.stretch)) {
        p.stretch = stretch;
        p.stretch_id = id;
    }
}

void keep_larger(double value, std::int32_t which, double& most, std::int32_t& who) noexcept {
    if (value <= most) return;
    most = value;
    who = which;
}

}  // namespace

// Sample energies, rows and lines of a state. Chunks are merged in order, so that the result does
// not depend on threads.
context::MonitorPart sample(context::Model& model, context::State& state, runtime::Pool& pool,
                            SampleTime when) noexcept {
    const View v = context::row_view(model);
    context::MonitorData& data = state.monitor;
    const double half = when == SampleTime::pose ? 0.0 : 0.5 * model.def.step;
    const double* after = when == SampleTime::half_step ? v.v_new : v.v;
    const auto count_of = [](const auto& list) { return static_cast<std::int32_t>(list.size()); };
    const std::int32_t bodies = count_of(model.bodies.moving), rows = count_of(data.allowed),
                       elastic = count_of(data.elastic), lines = count_of(data.lines);
    const std::int32_t most = std::max({bodies, rows, elastic, lines});
    context::over(pool, most, [&](std::int32_t a, std::int32_t b) {
        context::MonitorPart p;
        measure_bodies(model, v, a, std::min(b, bodies), after, half, p);
        measure_rows(state, v, a, std::min(b, rows), p);
        for (std::int32_t i = a; i < std::min(b, elastic); ++i)
            measure_elastic(model, v, data.elastic[at(i)], data.line[at(i)] != 0, half, p);
        for (std::int32_t i = a; v.pair_mass != nullptr && i < std::min(b, elastic); ++i)
            measure_piece(v, data.elastic[at(i)], after, p);
        for (std::int32_t i = a; i < std::min(b, lines); ++i)
            measure_line(model, v, data.lines[at(i)], p);
        data.part[at(a / context::StepContext::kChunk)] = p;
    });
    context::MonitorPart sum;
    measure_ranges(state, v, sum);
    if (when == SampleTime::half_step)
        measure_contacts(model, state, sum);  // no contacts at the start
    for (int i = 0; i < context::StepContext::chunks(most); ++i) {
        const context::MonitorPart& p = data.part[at(i)];
        sum.kinetic += p.kinetic;
        sum.potential += p.potential;
        sum.elastic += p.elastic;
        sum.at_pose += p.at_pose;
        sum.by_length += p.by_length;
        sum.by_force += p.by_force;
        keep_larger(p.open, p.open_row, sum.open, sum.open_row);
        keep_larger(p.stretch, p.stretch_id, sum.stretch, sum.stretch_id);
        keep_larger(p.turn, p.turn_body, sum.turn, sum.turn_body);
        keep_larger(p.twist, p.twist_id, sum.twist, sum.twist_id);
    }
    // Energy of the added mass. Its change since the last step counts as work of this step.
    const double added = state.loads.added;
    sum.kinetic += added;
    sum.at_pose += when == SampleTime::pose ? added : 0.5 * (added + state.loads.added_after());
    if (when == SampleTime::pose) sum.by_force = sum.elastic;  // no step has been taken yet
    // Projected poses have moved further than by the velocity: at the midpoint, by half of the
    // projection.
    if (when == SampleTime::half_step) {
        sum.potential -= 0.5 * data.state.closed;
        sum.by_length -= data.state.closed_elastic;
    }
    return sum;
}

namespace {

/// Call f(row, is_line, violation, rate of the violation) for the active rows of springs.
template <class F>
void each_spring(const context::Model& model, const context::State& state, const View& v,
                 F&& f) noexcept {
    for (const std::int32_t id : state.monitor.elastic) {
        const bool line = (v.flags[id] & model::kOneSided) != 0;
        if (line ? v.parted[id] != 0 : v.active[id] == 0.0) continue;
        const model::RowState now = model.interactions.row_state(id, model.bodies);
        double secant[kMaxInteractionRows];
        const bool secants = model.interactions.uses_secants(id);
        if (secants) model.interactions.secants_before(id, model.bodies, v.h, secant);
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            if ((v.row_flags[row] & model::kRowVelocity) ||
                !model::holds_energy(v.epsilon[row], v.rest_length[id]))
                continue;
            f(row, line, now.g[r], secants ? secant[r] : now.rate[r] + now.carried[r]);
        }
    }
}

}  // namespace

void read_spring_gaps(context::Model& model, const context::State& state, double* gaps) noexcept {
    each_spring(model, state, context::row_view(model),
                [&](std::int32_t row, bool, double g, double) { gaps[row] = g; });
}

double held_by_closing(context::Model& model, const context::State& state,
                       const double* before) noexcept {
    const View v = context::row_view(model);
    double sum = 0.0;
    each_spring(model, state, v, [&](std::int32_t row, bool line, double now, double rate) {
        const auto held = [&](double g) { return !line || g > 0.0 ? g * g : 0.0; };
        const double g = now - 0.5 * v.h * rate;
        sum += 0.5 * (held(g) - held(g - 0.5 * (now - before[row]))) / v.epsilon[row];
    });
    return sum;
}

}  // namespace hawser::monitor
