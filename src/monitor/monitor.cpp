// SPDX-License-Identifier: Apache-2.0
#include "monitor/monitor.h"

#include "assembly/rows.h"
#include "base/index.h"
#include "context/context.h"
#include "context/copies.h"
#include "context/monitor_data.h"
#include "context/undo_data.h"
#include "context/view.h"
#include "monitor/bearing.h"
#include "monitor/energy_account.h"
#include "monitor/findings.h"
#include "monitor/measures.h"
#include "solve/drives.h"
#include "solve/evaluate.h"

#include <algorithm>
#include <cmath>

namespace hawser::monitor {
namespace {

constexpr std::size_t place(Judge judge) noexcept { return static_cast<std::size_t>(judge); }

using Findings = std::array<Finding, kJudgeCount>;

/// Replace `worst` by the finding `f` if `f` is worse. The ratios to both limits become the larger
/// of both findings, because one compares momentary values and the other mean values.
void keep_worse(const Finding& f, Finding& worst) noexcept {
    const double wrong = std::max(f.wrong, worst.wrong);
    const double doubtful = std::max(f.doubtful, worst.doubtful);
    if (!(f.doubtful <= worst.doubtful)) worst = f;
    worst.wrong = wrong;
    worst.doubtful = doubtful;
}

/// Run all monitors on the present state and update the data that they keep between samples.
Findings run_all(context::StepContext& ctx, context::MonitorState& state) noexcept {
    const context::MonitorPart p = sample(ctx.model, ctx.state, ctx.pool, SampleTime::half_step);
    const double time = ctx.model.def.step * static_cast<double>(ctx.state.step - state.step);
    if (state.begun == 0) state.open_start = p.open;  // the poses were set by the user
    Findings out{};
    out[place(Judge::energy)] = energy_finding(ctx.model, ctx.state, p, state, time);
    out[place(Judge::violation)] = open_finding(ctx.model, ctx.state, p, state, time);
    keep_worse(range_finding(ctx.model, ctx.state, p, state), out[place(Judge::violation)]);
    keep_worse(depth_finding(ctx.model, ctx.state, p, state), out[place(Judge::violation)]);
    out[place(Judge::cable)] = stretch_finding(ctx.model, ctx.state, p, state);
    out[place(Judge::certificate)] = solved_finding(ctx, state, time);
    out[place(Judge::speed)] = turn_finding(ctx.model, ctx.state, p);
    state.step = ctx.state.step;
    return out;
}

bool is_good(const Findings& findings) noexcept {
    return std::all_of(findings.begin(), findings.end(),
                       [](const Finding& f) { return f.doubtful <= 1.0; });
}

/// Add the findings of the present state to the result of the run.
/// @return the grade of these findings.
Grade add(const Findings& now, Verdict& verdict) noexcept {
    Grade grade = Grade::good;
    for (int k = 0; k < kJudgeCount; ++k) {
        const Finding& f = now[at(k)];
        Finding& worst = verdict.worst[at(k)];
        keep_worse(f, worst);
        const bool speed = static_cast<Judge>(k) == Judge::speed;
        const Grade own = !(f.wrong <= 1.0)                ? Grade::wrong
                          : !(f.doubtful <= 1.0) && !speed ? Grade::doubtful
                                                           : Grade::good;
        grade = std::max(grade, own);
    }
    if (grade > verdict.grade) verdict.grade = grade;
    double most = -1.0;
    for (int k = 0; k < kJudgeCount; ++k) {
        const Finding& f = verdict.worst[at(k)];
        const double fraction = verdict.grade == Grade::wrong ? f.wrong : f.doubtful;
        if (fraction <= most ||
            (verdict.grade == Grade::doubtful && static_cast<Judge>(k) == Judge::speed))
            continue;
        most = fraction;
        verdict.judge = static_cast<Judge>(k);
    }
    return grade;
}

/// Run the monitors of strain and wound length, which check every step before overloaded elements
/// break.
Findings check_before_breaking(context::StepContext& ctx, context::MonitorState& state) noexcept {
    Findings out{};
    out[place(Judge::cable)] = strain_finding(ctx.model, ctx.state, state);
    out[place(Judge::violation)] = wound_finding(ctx.model, ctx.state, state);
    return out;
}

/// Send an event for each monitor that was not suspect before and is now.
/// @param all  True if all monitors were run; otherwise only those of check_before_breaking().
void report_findings(context::State& state, StepStats& stats, const Findings& now, bool all,
                     context::MonitorState& memory) noexcept {
    constexpr EventKind kKinds[kJudgeCount] = {EventKind::energy_created, EventKind::joint_open,
                                               EventKind::cable_law, EventKind::uncertified,
                                               EventKind::fast};
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = now[k];
        const bool doubtful = !(f.doubtful <= 1.0);
        if (!all && !doubtful) continue;
        if (doubtful && memory.reported[k] == 0) {
            Event event;
            event.time = state.time;
            event.kind = kKinds[k];
            event.interaction = f.interaction;
            event.value = f.value;
            event.body = f.body;
            state.events.push(event);
            ++stats.event_count[static_cast<std::size_t>(kKinds[k])];
        }
        memory.reported[k] = doubtful ? 1 : 0;
    }
}

/// Send an event for a step with failed end-of-step constraint iterations (completion.h). The event
/// is sent again only after a time kMemory without a failure. The remaining time is stored in
/// ticks.
void report_incomplete(context::StepContext& ctx) noexcept {
    constexpr std::uint8_t kMemoryTicks = 200;
    std::uint8_t& left = ctx.state.monitor.state.reported[kJudgeCount];
    const auto tick =
        std::max<std::int64_t>(1, std::llround(limit::kMemory / kMemoryTicks / ctx.model.def.step));
    if (!ctx.model.completion.banned) {
        if (left > 0 && ctx.state.step % tick == 0) --left;
        return;
    }
    if (left == 0) {
        Event event;
        event.time = ctx.state.time;
        event.kind = EventKind::incomplete;
        event.value = static_cast<double>(ctx.work.stats.completion_failures);
        ctx.state.events.push(event);
        ++ctx.work.stats.event_count[static_cast<std::size_t>(event.kind)];
    }
    left = kMemoryTicks;
}

/// Return the energy that the first sample contains in excess of the start, less half of the work
/// of the first step. Forces are constant in the first step. follow_energy() counts the other half
/// as work before the start.
///
/// Let v₋ and v₊ be the velocities half a step before and after the start. Forces F do work; the
/// potential energy of the forces N of gravity and springs counts at the midpoint between poses:
/// ```
///     W(−h/2 … 0) = (h/8) F·(3v₋ + v₊) = W(−h/2 … h/2)/2 − (h/8) F·(v₊ − v₋)
///     (x₀ + x₁)/2 = x(h/2) + (h/8)(v₊ − v₋)
/// ```
/// So (h/8)(F − N)·(v₊ − v₋) remains. From rest, where v₋ = −v₊, the first step's work is zero. For
/// N = 0 the remainder then equals the kinetic energy at its end.
double gain_before_first_step(context::StepContext& ctx) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const assembly::View v = context::view(ctx);
    double gain = solve::drive_gain(ctx.model) + ctx.state.loads.gain(b, v.h, v.v, v.v_new) -
                  solve::spring_gain(ctx.model, ctx.state.monitor.elastic);
    // Half a step before the start, springs are longer or shorter by (h/2)|ġ| and store that energy
    // too.
    gain += solve::spring_travel_energy(ctx.model, ctx.state.monitor.elastic);
    for (const std::int32_t body : b.moving) {
        const bool falls = b.weight[at(body)] && b.dof(body) >= 3;
        for (int i = 0; i < b.dof(body); ++i) {
            const std::int32_t k = v.dof_begin[body] + i;
            const double weight =
                falls && i < 3 ? b.mass[at(body)] * ctx.model.def.gravity[i] : 0.0;
            gain += v.h * (b.force[at(6 * body + i)] - weight) * (v.v_new[k] - v.v[k]);
        }
    }
    return std::max(0.0, 0.125 * gain);
}

}  // namespace

void begin_monitors(context::StepContext& ctx) noexcept {
    context::MonitorState& state = ctx.state.monitor.state;
    if (state.begun != 0) return;
    const assembly::KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                                    ctx.model.system.bounded);
    solve::evaluate_rows(ctx.model, ctx.pool);
    const context::MonitorPart p = sample(ctx.model, ctx.state, ctx.pool, SampleTime::pose);
    state = {};
    state.step = ctx.state.step;
    state.open_start = p.open > 1.0 ? p.open : 0.0;
    begin_energy(p, works(ctx.state), state);
}

Status run_monitors(context::StepContext& ctx) noexcept {
    context::MonitorData& d = ctx.state.monitor;
    // Joints are checked in each step at no cost, because they may open and close between samples.
    const bool open = ctx.work.stats.violation_max > limit::kOpen.doubtful;
    // The balance of the start is completed at the first sample, with this rise.
    if (ctx.state.step == 0 && ctx.model.def.staggered_start) {
        const double early = gain_before_first_step(ctx);
        for (double& start : d.state.mean) start += early;
    }
    context::MonitorState next = d.state;
    Findings now = check_before_breaking(ctx, next);
    const bool all =
        ctx.state.step != 0 && (ctx.state.step <= 1 || ctx.state.step % d.every == 0 || open);
    if (!all && is_good(now)) {
        d.state = next;
        report_incomplete(ctx);
        return Status::ok;
    }
    if (all) {
        const Findings next_findings = run_all(ctx, next);
        for (std::size_t k = 0; k < now.size(); ++k) keep_worse(next_findings[k], now[k]);
    }
    const Grade grade = add(now, d.verdict);
    const bool split = context::has_cuts(ctx.model);
    if (grade == Grade::wrong && ctx.model.def.on_diverged == OnDiverged::stop && !split)
        return Status::diverged;
    d.state = next;
    report_findings(ctx.state, ctx.work.stats, now, all, d.state);
    report_incomplete(ctx);
    return Status::ok;
}

Verdict verdict(context::StepContext& ctx) noexcept {
    Verdict out = ctx.state.monitor.verdict;
    if (ctx.state.changed != context::Changed::nothing ||
        ctx.state.repair != context::PendingRepair::nothing || ctx.state.step == 0)
        return out;
    const assembly::KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                                    ctx.model.system.bounded);
    solve::evaluate_rows(ctx.model, ctx.pool);
    context::MonitorState next = ctx.state.monitor.state;
    (void)add(run_all(ctx, next), out);
    return out;
}

}  // namespace hawser::monitor
