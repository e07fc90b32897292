// SPDX-License-Identifier: Apache-2.0
#include "stepper/step.h"

#include "stepper/bounds.h"
#include "stepper/completion.h"
#include "stepper/contact.h"
#include "stepper/guarded.h"
#include "stepper/impact.h"
#include "stepper/judge_start.h"
#include "stepper/nonsmooth.h"
#include "stepper/regroup.h"
#include "stepper/sleep.h"
#include "stepper/stages.h"
#include "stepper/timer.h"

#include <algorithm>
#include <chrono>

namespace hawser::stepper {
namespace {

using Clock = std::chrono::steady_clock;

/// Stage 2. Contacts at the present poses.
Status find_contacts(StepContext& ctx) noexcept {
    const std::int64_t growths = ctx.collider.growths();
    const bool found = ctx.collider.collide(ctx.bodies, ctx.def.step, ctx.contacts, ctx.pool);
    ctx.stats.growths += ctx.collider.growths() - growths;
    ctx.stats.contacts = static_cast<std::int32_t>(ctx.contacts.contacts.size());
    if (ctx.pool.stopping()) return Status::cancelled;
    if (found) return Status::ok;
    if (!ctx.collider.finite()) return Status::not_finite;
    ctx.stats.bound_met = ctx.collider.over();
    return ctx.stats.bound_met.bound == Bound::none ? Status::out_of_memory : Status::over_bound;
}

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

/// What levels of cuts there are, in the first step in which forces are known.
Status prepare_levels(StepContext& ctx) noexcept {
    if (!may_cut(ctx) || ctx.cut_levels.known()) return Status::ok;
    const StageTimer timer(ctx, Stage::analyse);
    return guarded(ctx, [&] { ctx.cut_levels.set(find_cut_levels(ctx)); });
}

/// Cuts of this step. Only those who ask by themselves have some without a budget.
Status choose_cuts(StepContext& ctx) noexcept {
    std::uint64_t cuts = ctx.imposed.cuts;
    if (may_cut(ctx))
        cuts = ctx.cut_levels.choose(ctx.deadline, load_of(ctx), kAim * ctx.def.budget,
                                     ctx.cuts.asked);
    const Status status = ask_for_cuts(ctx, cuts);
    ctx.stats.degradation.cuts = cuts;
    return status;
}

/// Limits of the solve that begins now.
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

/// What the step's times teach, and what it left out.
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

/// Contacts of the step, after impacts.
Status start_moving(StepContext& ctx) noexcept {
    bool found = false;
    Status status = start_contacts(ctx, Phase::regular);
    if (status == Status::ok)
        status = timed(ctx, Stage::nonsmooth, [&](StepContext& c) { return impact(c, found); });
    return status == Status::ok && found ? start_contacts(ctx, Phase::regular) : status;
}

/// Stages assemble, factor, nonsmooth; analyse where bodies touch that have not done so before.
Status solve_velocities(StepContext& ctx) noexcept {
    if (const Status status = choose_cuts(ctx); status != Status::ok) return status;
    remember(ctx);
    if (ctx.collider.count() > 0)
        if (const Status status = start_moving(ctx); status != Status::ok) return status;
    assemble_rows(ctx);
    begin_budget(ctx);
    const Status status = solve_assembled(ctx);
    return status == Status::ok ? guard_wires(ctx) : status;
}

}  // namespace

void remember(StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.interactions;
    std::copy(in.lambda.begin(), in.lambda.end(), ctx.lambda_before.begin());
    std::copy(in.repeats.begin(), in.repeats.end(), ctx.repeats_before.begin());
    ctx.remembered = true;
    ctx.refine_unasked_before = ctx.refine_unasked;
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i)
        ctx.active_before[i] = in.active[static_cast<std::size_t>(ctx.system.bounded[i])];
}

void recall(StepContext& ctx) noexcept {
    model::Interactions& in = ctx.interactions;
    std::copy(ctx.lambda_before.begin(), ctx.lambda_before.end(), in.lambda.begin());
    std::copy(ctx.repeats_before.begin(), ctx.repeats_before.end(), in.repeats.begin());
    ctx.refine_unasked = ctx.refine_unasked_before;
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i)
        in.active[static_cast<std::size_t>(ctx.system.bounded[i])] = ctx.active_before[i];
}

Status solve_assembled(StepContext& ctx) noexcept {
    const Status status = solve_linear(ctx);
    return status == Status::ok ? complete(ctx) : status;
}

Status solve_linear(StepContext& ctx) noexcept {
    if (ctx.def.nonsmooth == Nonsmooth::pgs) return timed(ctx, Stage::nonsmooth, solve_pgs);
    if (ctx.system.contacts.count() > 0) return timed(ctx, Stage::nonsmooth, solve_contacts);
    const Status status = factor_and_solve(ctx);
    return status == Status::ok ? timed(ctx, Stage::nonsmooth, settle_bounds) : status;
}

namespace {

/// From time 0 to −h/2, in the first step.
Status start_world(StepContext& ctx) noexcept {
    ctx.undo.keep_motion(ctx);
    ctx.loads.added = added_energy(ctx, ctx.bodies.v.data());
    begin_judge(ctx);
    Status status = Status::ok;
    if (ctx.collider.count() > 0) status = find_contacts(ctx);
    if (status == Status::ok && ctx.collider.count() > 0)
        status = start_contacts(ctx, Phase::stagger);
    const double before = kinetic_energy(ctx.bodies, ctx.bodies.v.data());
    if (status == Status::ok) status = stagger(ctx);
    excuse_start(kinetic_energy(ctx.bodies, ctx.bodies.v.data()) - before, ctx.judge.state);
    ctx.loads.added = added_energy(ctx, ctx.bodies.v.data());
    return status;
}

void clear_figures(StepContext& ctx) noexcept {
    ctx.stats.stage_seconds.fill(0.0);
    ctx.stats.factorisations = 0;
    ctx.stats.substitutions = ctx.stats.completion_rounds = ctx.stats.undetermined = 0;
    ctx.stats.restiffened = 0;
    ctx.stats.completion_change = 0.0;
    begin_completion(ctx);
    ctx.stats.partial_factorisations = 0;
    ctx.stats.flips_left = 0;
    ctx.stats.wire_repeats = 0;
    ctx.step_flops = 0;
    ctx.newton.iterations = 0;
    ctx.stats.natural_map = 0.0;
    ctx.stats.cut = false;
    ctx.stats.degradation = {};
    ctx.stats.degraded_by = DegradedBy::nothing;
    ctx.stats.foreseen_seconds = 0.0;
}

/// All stages. Where it fails, the state may be that of a step half done.
Status take_step(StepContext& ctx) noexcept {
    const bool starts = !ctx.started;
    if (starts) {
        // Its trial steps need the loads of systems.
        Status status = prestep(ctx);
        if (status == Status::ok) status = start_world(ctx);
        if (status != Status::ok) return status;
    }
    const StepTimer timer(ctx);
    const Clock::time_point begin = Clock::now();
    clear_figures(ctx);

    Status status = starts ? Status::ok : timed(ctx, Stage::prestep, prestep);
    if (status != Status::ok) return status;
    ctx.loads.count_change(ctx.bodies, ctx.pool);
    const bool shapes = ctx.collider.count() > 0;
    if (shapes) status = timed(ctx, Stage::collide, find_contacts);
    if (status == Status::ok) status = wake_disturbed(ctx);
    if (status != Status::ok) return status;
    const Clock::time_point solver_begin = Clock::now();
    ctx.stopwatch->start();
    ctx.laps = {};
    const std::int64_t analyses = ctx.stats.plans + ctx.stats.repairs;
    const bool knew_levels = ctx.cut_levels.known();
    status = regroup(ctx);
    if (status == Status::ok) status = prepare_levels(ctx);
    if (status != Status::ok) return status;
    status = solve_velocities(ctx);
    ctx.stats.solver_seconds = std::chrono::duration<double>(Clock::now() - solver_begin).count();
    ctx.stats.solver_cpu_seconds = ctx.stopwatch->seconds();
    ctx.laps.analysed =
        ctx.stats.plans + ctx.stats.repairs > analyses || (ctx.cut_levels.known() && !knew_levels);
    end_budget(ctx);
    ctx.stats.newton_iterations = ctx.newton.iterations;
    ctx.stats.factor_work = static_cast<double>(ctx.step_flops) /
                            static_cast<double>(std::max<std::int64_t>(1, ctx.stats.factor_flops));
    // What was left out because of it is not to be used.
    if (status == Status::ok && ctx.pool.stopping()) status = Status::cancelled;
    if (status == Status::ok)
        status = timed(ctx, Stage::integrate, [](StepContext& c) {
            c.loads.measure(c.bodies, c.def.step, c.bodies.v.data(), view(c).v_new, c.pool);
            return judge(c);
        });
    if (status == Status::ok) {
        timed(ctx, Stage::integrate, integrate);
        ctx.imposed = {};
        if (shapes) ctx.collider.keep();
        ctx.undo.drop();
        ctx.edits.clear();
        accept_systems(ctx);
        fall_asleep(ctx);
    }
    ctx.stats.step_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return status;
}

/// After a step that failed: the state of the last good one.
void go_back(StepContext& ctx) noexcept {
    if (ctx.remembered && !ctx.undo.moved()) recall(ctx);
    ctx.undo.go_back(ctx);
    take_back_systems(ctx);
}

}  // namespace

Status step(StepContext& ctx) noexcept {
    ctx.stats.bound_met = {};
    ctx.remembered = false;
    Status status = ctx.pool.stopping() ? Status::cancelled : Status::ok;
    if (status == Status::ok) status = guarded(ctx, [&] { make_ready(ctx); });
    if (status == Status::ok) {
        ctx.pool.resume();
        status = take_step(ctx);
        ctx.pool.pause();
    }
    if (status != Status::ok) {
        go_back(ctx);
        // Whatever the step ended with then came of what was left out.
        if (ctx.pool.stopping()) status = Status::cancelled;
    }
    if (status == Status::cancelled) ctx.pool.go_on();
    return ctx.stats.status = status;
}

}  // namespace hawser::stepper
