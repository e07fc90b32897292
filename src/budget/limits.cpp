// SPDX-License-Identifier: Apache-2.0
#include "budget/limits.h"

#include "access/guarded.h"
#include "access/timer.h"
#include "budget/level_search.h"
#include "context/budget.h"
#include "context/deadline.h"
#include "split/analyse.h"
#include "split/open_cuts.h"

#include <algorithm>
#include <cstdint>

namespace hawser::stepper {
namespace {

/// Work of the step's solver.
Load load_of(const StepContext& ctx) noexcept {
    const double rows = ctx.interactions.row_count + ctx.bodies.dofs +
                        12.0 * static_cast<double>(ctx.contacts.awake);
    return {rows, matrix_work(static_cast<double>(ctx.stats.factor_flops),
                              static_cast<double>(ctx.stats.factor_nnz)) +
                      kRowWork * rows};
}

constexpr double kAim = 0.95;  ///< Of the budget; the rest is left to what no one foresees.

/// Whether deadlines may ask for cuts in this step.
bool may_cut(const StepContext& ctx) noexcept {
    return ctx.def.budget > 0.0 && ctx.cuts.interfaces > 0 && !ctx.imposed.any() && ctx.step > 0;
}

}  // namespace

Status prepare_levels(StepContext& ctx) noexcept {
    if (!may_cut(ctx) || ctx.cut_levels.known()) return Status::ok;
    const StageTimer timer(ctx, Stage::analyse);
    return guarded(ctx, [&] { ctx.cut_levels.set(find_cut_levels(ctx)); });
}

Status choose_cuts(StepContext& ctx) noexcept {
    std::uint64_t cuts = ctx.imposed.cuts;
    if (may_cut(ctx))
        cuts = ctx.cut_levels.choose(ctx.deadline, load_of(ctx), kAim * ctx.def.budget,
                                     ctx.cuts.asked);
    const Status status = ask_for_cuts(ctx, cuts);
    ctx.stats.degradation.cuts = cuts;
    return status;
}

void begin_budget(StepContext& ctx) noexcept {
    Limits limits{.seconds = kAim * ctx.def.budget,
                  .work = 0.0,
                  .most = 0,
                  .foreseen = 0.0,
                  .imposed = ctx.imposed};
    // Impacts are not limited. Ending a solve takes one factorisation; 0 is no limit.
    if (ctx.def.budget_work > 0.0)
        limits.work =
            std::max(1.0, ctx.def.budget_work - static_cast<double>(ctx.stats.factor_flops));
    ctx.budget.begin(limits, {});
    if (!ctx.budget.needs_time()) return;
    ctx.laps.start = ctx.laps.first = ctx.laps.last = ctx.stopwatch->seconds();
    const Load load = load_of(ctx);
    if (ctx.deadline.knows()) {
        // What has passed since the step began is known; what is to come is reckoned.
        const double left = limits.seconds - ctx.laps.start + ctx.deadline.predict_start(load);
        limits.most = ctx.deadline.iterations_by(left, load);
        limits.next = ctx.deadline.predict_next(load);
        limits.foreseen = limits.seconds - left + ctx.deadline.predict(load, limits.most + 1);
    }
    ctx.budget.begin(limits, {ctx.laps.start, static_cast<double>(ctx.step_flops)});
}

void end_budget(StepContext& ctx) noexcept {
    StepStats& s = ctx.stats;
    s.compliant = open_interfaces(ctx);
    ctx.budget.finished(s.solver_cpu_seconds);
    if (ctx.budget.needs_time()) {
        ctx.laps.end = s.solver_cpu_seconds;
        ctx.deadline.learn(load_of(ctx), ctx.laps);
    }
    if (s.cut) {
        s.degraded_by = ctx.budget.cause();
        s.foreseen_seconds = ctx.budget.foreseen();
        ctx.deadline.refused();
    } else if (s.degradation.iterations > 0 || s.compliant != 0) {
        s.degraded_by = ctx.imposed.any() ? DegradedBy::order : DegradedBy::prediction;
    }
    ctx.budget.end();  // a trial step is not limited
}

}  // namespace hawser::stepper
