// SPDX-License-Identifier: Apache-2.0
#include "split/limits.h"

#include "budget/budget.h"
#include "budget/deadline.h"
#include "context/guarded.h"
#include "context/timer.h"
#include "split/level_search.h"
#include "split/split.h"

#include <algorithm>
#include <cstdint>

namespace hawser::split {
namespace {

/// Return the work of the solver in this step.
budget::Load solver_load(const context::StepContext& ctx) noexcept {
    const double rows = ctx.model.interactions.row_count + ctx.model.bodies.dofs +
                        12.0 * static_cast<double>(ctx.state.contacts.awake);
    return {rows, budget::matrix_work(static_cast<double>(ctx.work.stats.factor_flops),
                                      static_cast<double>(ctx.work.stats.factor_nnz)) +
                      budget::kRowWork * rows};
}

/// Fraction of the budget that is planned; the rest is a margin for prediction errors.
constexpr double kPlannedFraction = 0.95;

/// True if a deadline may activate cuts in this step.
bool may_cut(const context::Model& model, const context::State& state) noexcept {
    return model.def.budget > 0.0 && model.cuts.interfaces > 0 && !state.imposed.any() &&
           state.step > 0;
}

}  // namespace

void begin_laps(context::Work& work) noexcept {
    context::LimitWork& limits = work.limits;
    limits.laps = {};
    limits.analyses = work.stats.plans + work.stats.repairs;
    limits.knew_levels = limits.cut_levels.known();
}

Status prepare_levels(context::StepContext& ctx) noexcept {
    if (!may_cut(ctx.model, ctx.state) || ctx.work.limits.cut_levels.known()) return Status::ok;
    const context::StageTimer timer(ctx, Stage::analyse);
    return context::guarded(ctx, [&] { ctx.work.limits.cut_levels.set(find_cut_levels(ctx)); });
}

Status choose_cuts(context::StepContext& ctx) noexcept {
    std::uint64_t cuts = ctx.state.imposed.cuts;
    if (may_cut(ctx.model, ctx.state))
        cuts = ctx.work.limits.cut_levels.choose(ctx.work.limits.deadline, solver_load(ctx),
                                                 kPlannedFraction * ctx.model.def.budget,
                                                 ctx.model.cuts.asked);
    const Status status = request_cuts(ctx, cuts);
    ctx.work.stats.degradation.cuts = cuts;
    return status;
}

void begin_budget(context::StepContext& ctx) noexcept {
    ctx.work.newton.iterations = 0;  // counts all solves of the step from here on
    budget::Limits limits{.seconds = kPlannedFraction * ctx.model.def.budget,
                          .work = 0.0,
                          .most = 0,
                          .foreseen = 0.0,
                          .imposed = ctx.state.imposed};
    ctx.work.stats.degradation.wires =
        ctx.state.imposed.any() ? ctx.state.imposed.wires : ctx.work.limits.coarsening.level();
    if (ctx.work.limits.coarsening.has_priority() && !ctx.state.imposed.any()) limits.seconds = 0.0;
    // Impacts are not limited. Ending a solve takes one factorisation; 0 means no limit.
    if (ctx.model.def.budget_work > 0.0 && !ctx.work.limits.coarsening.has_priority())
        limits.work = std::max(
            1.0, ctx.model.def.budget_work - static_cast<double>(ctx.work.stats.factor_flops));
    ctx.work.limits.budget.begin(limits, {});
    if (!ctx.work.limits.budget.needs_time()) return;
    ctx.work.limits.laps.start = ctx.work.limits.laps.first = ctx.work.limits.laps.last =
        ctx.stopwatch->seconds();
    const budget::Load load = solver_load(ctx);
    if (ctx.work.limits.deadline.has_samples()) {
        // The time since the start of the step is measured; the remaining time is predicted.
        const double left = limits.seconds - ctx.work.limits.laps.start +
                            ctx.work.limits.deadline.predict_start(load);
        limits.most = ctx.work.limits.deadline.iterations_by(left, load);
        limits.next = ctx.work.limits.deadline.predict_next(load);
        limits.foreseen =
            limits.seconds - left + ctx.work.limits.deadline.predict(load, limits.most + 1);
    }
    ctx.work.limits.budget.begin(
        limits, {ctx.work.limits.laps.start, static_cast<double>(ctx.work.solve.step_flops)});
}

namespace {

/// Return the used fraction of the budget, at least kMinUsedIfCut if the step was cut; 0: no
/// budget.
double budget_fraction_used(const context::StepContext& ctx) noexcept {
    const WorldDef& def = ctx.model.def;
    const StepStats& s = ctx.work.stats;
    double demand = 0.0;
    if (def.budget > 0.0) demand = s.solver_cpu_seconds / (kPlannedFraction * def.budget);
    if (def.budget_work > 0.0)
        demand = std::max(demand, static_cast<double>(ctx.work.solve.step_flops) / def.budget_work);
    // The predicted demand of the whole step contains a margin, so it is not used here.
    constexpr double kMinUsedIfCut = 1.05;
    if (s.cut) demand = std::max(demand, kMinUsedIfCut);
    return demand;
}

}  // namespace

void end_budget(context::StepContext& ctx) noexcept {
    StepStats& s = ctx.work.stats;
    ctx.work.limits.laps.analysed =
        s.plans + s.repairs > ctx.work.limits.analyses ||
        (ctx.work.limits.cut_levels.known() && !ctx.work.limits.knew_levels);
    s.compliant = open_interfaces(ctx.model);
    ctx.work.limits.budget.record_end_of_solve(s.solver_cpu_seconds);
    if (ctx.work.limits.budget.needs_time()) {
        ctx.work.limits.laps.end = s.solver_cpu_seconds;
        ctx.work.limits.deadline.add_sample(solver_load(ctx), ctx.work.limits.laps);
    }
    if (s.cut) {
        s.degraded_by = ctx.work.limits.budget.cause();
        s.foreseen_seconds = ctx.work.limits.budget.foreseen();
        ctx.work.limits.deadline.record_refusal();
    } else if (s.degradation.iterations > 0 || s.compliant != 0 || s.degradation.wires > 0) {
        s.degraded_by = ctx.state.imposed.any() ? DegradedBy::order : DegradedBy::prediction;
    }
    if (const double demand = budget_fraction_used(ctx);
        demand > 0.0 && !ctx.work.limits.laps.analysed && !ctx.state.imposed.any())
        ctx.work.limits.coarsening.add_sample(demand);
    ctx.work.limits.budget.end();  // a trial step is not limited
}

}  // namespace hawser::split
