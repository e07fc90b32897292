// SPDX-License-Identifier: Apache-2.0
#include "step/judge.h"

#include "access/copies.h"
#include "access/rows.h"
#include "base/index.h"
#include "context/context.h"
#include "context/judge_data.h"
#include "context/undo_data.h"
#include "solve/evaluate.h"
#include "step/judge_energy.h"
#include "step/judge_look.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

constexpr std::size_t place(Judge judge) noexcept { return static_cast<std::size_t>(judge); }

Works works(const State& state) noexcept {
    return {state.ledger.work + state.loads.work,
            state.ledger.drive,
            state.ledger.drag,
            state.ledger.friction,
            state.ledger.contact,
            state.ledger.damped};
}

/// Interaction of a row.
std::int32_t owner_of(const Model& model, std::int32_t row) noexcept {
    const auto& begin = model.interactions.row_begin;
    const auto end = begin.begin() + interaction_count(model);
    return static_cast<std::int32_t>(std::upper_bound(begin.begin(), end, row) - begin.begin()) - 1;
}

/// How far the step's equations and laws are from solved.
double certificate(const Model& model, const StepStats& stats) noexcept {
    // The other methods end where they end, as does a step that keeps to a budget.
    if (model.def.nonsmooth != Nonsmooth::newton || stats.degradation.of_solve()) return 0.0;
    return std::max(stats.natural_map, stats.momentum_residual);
}

Finding finding(double value, Limit by, double time) noexcept {
    return {.value = value,
            .doubtful = value / by.doubtful,
            .wrong = value / by.wrong,
            .time = time,
            .interaction = {},
            .body = {}};
}

using Findings = std::array<Finding, kJudgeCount>;

Finding energy_finding(const Model& model, const State& state, const JudgePart& p,
                       JudgeState& memory, double time) noexcept {
    const Unexplained u = follow_energy(p, works(state), time, memory);
    const double nothing = std::max(limit::kNothing * (p.kinetic + p.elastic), state.judge.nothing);
    const auto share = [nothing](double energy, double of) {
        return energy <= nothing ? 0.0 : energy / of;
    };
    const double exchanged = p.kinetic + memory.exchanged, counted = p.kinetic + memory.counted;
    const ByAccount<Swing>&now = u.now, &mean = u.mean;
    // By each account energy comes and goes by different amounts: half-way between two poses, and
    // at the one before, which is half a step away where the last look was a step ago.
    const bool close = time < 1.5 * model.def.step;
    const double posed = close ? u.posed : std::max(now[kAtPoses].rise, u.posed);
    const double created = std::min({now[kBetween].rise, now[kByForce].rise, posed});
    const double stays = std::min({created, memory.risen[0], memory.risen[1]});
    memory.risen = {created, memory.risen[0]};
    const double lasting =
        std::min({mean[kBetween].rise, mean[kByForce].rise, mean[kAtPoses].rise});
    const double hidden = std::max(now[kUnexplained].rise, now[kWithGiven].rise);
    const double lost = now[kUnexplained].fall;
    Finding out;
    const double gained = std::max(share(stays, exchanged) / limit::kCreated.doubtful,
                                   share(hidden, counted) / limit::kHidden.doubtful);
    const double fell = share(lost, counted) / limit::kLost.doubtful;
    out.value = gained >= fell ? std::max(created, now[kUnexplained].rise) : -lost;
    out.doubtful = std::max(gained, fell);
    out.wrong = std::max({share(lasting, exchanged) / limit::kCreated.wrong,
                          share(std::max(mean[kUnexplained].rise, mean[kWithGiven].rise), counted) /
                              limit::kHidden.wrong,
                          share(mean[kUnexplained].fall, counted) / limit::kLost.wrong});
    // A split is approximate by choice, and says itself what it does to momentum and forces.
    if (has_cuts(model)) out.wrong = 0.0;
    if (!std::isfinite(now[kUnexplained].rise)) out.doubtful = out.wrong = HUGE_VAL;
    out.time = state.time;
    return out;
}

Finding open_finding(const Model& model, const State& state, const JudgePart& p, JudgeState& memory,
                     double time) noexcept {
    memory.open_start *= std::exp(-time / (limit::kSettled * model.def.step));
    Finding out = finding(p.open * limit::kOpen.doubtful, limit::kOpen, state.time);
    // What the scene opened may close without being refused; that it stood open is said.
    const double open = std::max(0.0, p.open - memory.open_start);
    out.wrong = open * limit::kOpen.doubtful / limit::kOpen.wrong;
    if (p.open_row < 0) return out;
    out.value = std::fabs(model.interactions.g[at(p.open_row)]);
    out.interaction = model.interactions.id(owner_of(model, p.open_row));
    return out;
}

Finding solved_finding(const StepContext& ctx, JudgeState& state, double time) noexcept {
    const double residual = certificate(ctx.model, ctx.work.stats);
    state.unsolved = residual > limit::kCertificate.doubtful ? state.unsolved + time : 0.0;
    const bool counts = state.unsolved >= limit::kSustained;
    return finding(counts ? residual : 0.0, limit::kCertificate, ctx.state.time);
}

/// A line that comes taut is off its law for a moment, one that rings is at every look.
Finding stretch_finding(const Model& model, const State& state, const JudgePart& p,
                        JudgeState& memory) noexcept {
    std::array<double, 2>& before = memory.stretched;
    Finding out = finding(std::min({p.stretch, before[0], before[1]}), limit::kCable, state.time);
    out.interaction = model.interactions.id(p.stretch_id);
    before = {p.stretch, before[0]};
    return out;
}

Finding turn_finding(const Model& model, const State& state, const JudgePart& p) noexcept {
    Finding out =
        finding(model.def.step * std::sqrt(std::max(p.turn, p.twist)), limit::kTurn, state.time);
    if (p.turn >= p.twist)
        out.body = model.bodies.id(p.turn_body);
    else
        out.interaction = model.interactions.id(p.twist_id);
    return out;
}

/// What all judges say of a state. `state` goes on to it.
Findings judged(StepContext& ctx, JudgeState& state) noexcept {
    const JudgePart p = look(ctx.model, ctx.state, ctx.pool, At::half_step);
    const double time = ctx.model.def.step * static_cast<double>(ctx.state.step - state.step);
    if (state.begun == 0) state.open_start = p.open;  // bodies were put where they are
    Findings out{};
    out[place(Judge::energy)] = energy_finding(ctx.model, ctx.state, p, state, time);
    out[place(Judge::violation)] = open_finding(ctx.model, ctx.state, p, state, time);
    out[place(Judge::cable)] = stretch_finding(ctx.model, ctx.state, p, state);
    out[place(Judge::certificate)] = solved_finding(ctx, state, time);
    out[place(Judge::speed)] = turn_finding(ctx.model, ctx.state, p);
    state.step = ctx.state.step;
    return out;
}

/// The worse of two findings, with the largest shares of both: a moment and a mean differ.
void take(const Finding& f, Finding& worst) noexcept {
    const double wrong = std::max(f.wrong, worst.wrong);
    const double doubtful = std::max(f.doubtful, worst.doubtful);
    if (!(f.doubtful <= worst.doubtful)) worst = f;
    worst.wrong = wrong;
    worst.doubtful = doubtful;
}

/// @return The grade of these findings, which join those of before.
Grade add(const Findings& now, Verdict& verdict) noexcept {
    Grade grade = Grade::good;
    for (int k = 0; k < kJudgeCount; ++k) {
        const Finding& f = now[at(k)];
        Finding& worst = verdict.worst[at(k)];
        take(f, worst);
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
        const double share = verdict.grade == Grade::wrong ? f.wrong : f.doubtful;
        if (share <= most ||
            (verdict.grade == Grade::doubtful && static_cast<Judge>(k) == Judge::speed))
            continue;
        most = share;
        verdict.judge = static_cast<Judge>(k);
    }
    return grade;
}

/// An event for each judge that has become doubtful.
void tell(State& state, StepStats& stats, const Findings& now, JudgeState& memory) noexcept {
    constexpr EventKind kKinds[kJudgeCount] = {EventKind::energy_created, EventKind::joint_open,
                                               EventKind::cable_law, EventKind::uncertified,
                                               EventKind::fast};
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = now[k];
        const bool doubtful = !(f.doubtful <= 1.0);
        if (doubtful && memory.told[k] == 0) {
            Event event;
            event.time = state.time;
            event.kind = kKinds[k];
            event.interaction = f.interaction;
            event.value = f.value;
            event.body = f.body;
            state.events.push(event);
            ++stats.event_count[static_cast<std::size_t>(kKinds[k])];
        }
        memory.told[k] = doubtful ? 1 : 0;
    }
}

}  // namespace

void begin_judge(StepContext& ctx) noexcept {
    JudgeState& state = ctx.state.judge.state;
    if (state.begun != 0) return;
    const KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                          ctx.model.system.bounded);
    evaluate_rows(ctx.model, ctx.pool);
    const JudgePart p = look(ctx.model, ctx.state, ctx.pool, At::pose);
    state = {};
    state.step = ctx.state.step;
    state.open_start = p.open > 1.0 ? p.open : 0.0;
    begin_energy(p, works(ctx.state), state);
}

double power_of_forces(StepContext& ctx) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    double power = ctx.state.loads.power(b, b.v.data(), ctx.pool);
    for (const std::int32_t body : b.moving)
        for (int j = 0; j < b.dof(body); ++j)
            power += b.force[at(6 * body + j)] * b.v[at(b.dof_begin[at(body)] + j)];
    return power;
}

void judge_from_half_a_step_before(StepContext& ctx, double power) noexcept {
    // At the speed of the start itself forces do work in the first step as well, which is allowed
    // for there; what would have to be taken away is left.
    const double work = 0.5 * ctx.model.def.step * (power - power_of_forces(ctx));
    begin_with_work(std::max(0.0, work), ctx.state.judge.state);
}

Status judge(StepContext& ctx) noexcept {
    JudgeData& d = ctx.state.judge;
    // Joints are looked at in each step, at no cost: in between they may open and close.
    const bool open = ctx.work.stats.violation_max > limit::kOpen.doubtful;
    if (ctx.state.step == 0 || (ctx.state.step > 1 && ctx.state.step % d.every != 0 && !open))
        return Status::ok;
    JudgeState next = d.state;
    const Findings now = judged(ctx, next);
    const Grade grade = add(now, d.verdict);
    const bool split = has_cuts(ctx.model);
    if (grade == Grade::wrong && ctx.model.def.on_diverged == OnDiverged::stop && !split)
        return Status::diverged;
    d.state = next;
    tell(ctx.state, ctx.work.stats, now, d.state);
    return Status::ok;
}

Verdict verdict(StepContext& ctx) noexcept {
    Verdict out = ctx.state.judge.verdict;
    if (ctx.state.changed != Changed::nothing || ctx.state.mend != Mend::nothing ||
        ctx.state.step == 0)
        return out;
    const KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                          ctx.model.system.bounded);
    evaluate_rows(ctx.model, ctx.pool);
    JudgeState next = ctx.state.judge.state;
    (void)add(judged(ctx, next), out);
    return out;
}

}  // namespace hawser::stepper
