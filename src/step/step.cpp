// SPDX-License-Identifier: Apache-2.0
#include "step/step.h"

#include "context/guarded.h"
#include "context/timer.h"
#include "context/view.h"
#include "monitor/monitor.h"
#include "solve/joints.h"
#include "split/limits.h"
#include "split/split.h"
#include "state/remember.h"
#include "state/undo.h"
#include "step/assemble_rows.h"
#include "step/completion.h"
#include "step/contact.h"
#include "step/guard.h"
#include "step/impact.h"
#include "step/integrate.h"
#include "step/prestep.h"
#include "step/ready.h"
#include "step/sleep.h"
#include "step/stagger.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace hawser::step {
namespace {

using Clock = std::chrono::steady_clock;

/// Run stage 2: find contacts at the present poses.
Status find_contacts(context::StepContext& ctx) noexcept {
    const std::int64_t growths = ctx.model.collider.growth_count();
    const bool found = ctx.model.collider.collide(ctx.model.bodies, ctx.model.def.step,
                                                  ctx.state.contacts, ctx.pool);
    ctx.work.stats.growths += ctx.model.collider.growth_count() - growths;
    ctx.work.stats.contacts = static_cast<std::int32_t>(ctx.state.contacts.contacts.size());
    if (ctx.pool.stopping()) return Status::cancelled;
    if (found) return Status::ok;
    if (!ctx.model.collider.finite()) return Status::not_finite;
    ctx.work.stats.bound_met = ctx.model.collider.limit_reached();
    return ctx.work.stats.bound_met.bound == Bound::none ? Status::out_of_memory
                                                         : Status::over_bound;
}

/// Start the contacts of the step, after impacts.
Status start_moving(context::StepContext& ctx) noexcept {
    bool found = false;
    Status status = start_contacts(ctx, Phase::regular);
    if (status == Status::ok)
        status = context::timed(ctx, Stage::nonsmooth,
                                [&](context::StepContext& c) { return impact(c, found); });
    return status == Status::ok && found ? start_contacts(ctx, Phase::regular) : status;
}

/// Move velocities from time 0 to −h/2, in the first step.
Status start_world(context::StepContext& ctx) noexcept {
    // The trial steps need the loads of systems.
    if (const Status acted = prestep(ctx); acted != Status::ok) return acted;
    state::save_motion(ctx);
    ctx.state.loads.added = added_energy(ctx.model, ctx.state, ctx.pool, ctx.model.bodies.v.data());
    monitor::begin_monitors(ctx);
    Status status = Status::ok;
    if (ctx.model.collider.count() > 0) status = find_contacts(ctx);
    if (status == Status::ok && ctx.model.collider.count() > 0)
        status = start_contacts(ctx, Phase::stagger);
    if (status == Status::ok) status = stagger(ctx);
    ctx.state.loads.added = added_energy(ctx.model, ctx.state, ctx.pool, ctx.model.bodies.v.data());
    return status;
}

void clear_figures(context::Model& model, context::Work& work) noexcept {
    work.stats.stage_seconds.fill(0.0);
    work.stats.factorisations = 0;
    work.stats.substitutions = work.stats.completion_rounds = work.stats.undetermined = 0;
    work.stats.restiffened = 0;
    work.stats.completion_change = 0.0;
    solve::begin_completion(model);
    work.stats.partial_factorisations = 0;
    work.stats.flips_left = 0;
    work.stats.wire_repeats = 0;
    work.solve.step_flops = 0;
    work.newton.iterations = 0;
    work.stats.natural_map = 0.0;
    work.stats.cut = false;
    work.stats.degradation = {};
    work.stats.degraded_by = DegradedBy::nothing;
    work.stats.foreseen_seconds = 0.0;
}

/// Start the timers of the solver.
/// @return its start time.
Clock::time_point start_solver(context::StepContext& ctx) noexcept {
    const Clock::time_point start = Clock::now();
    ctx.stopwatch->start();
    split::begin_laps(ctx.work);
    return start;
}

void end_solver(context::StepContext& ctx, Clock::time_point start) noexcept {
    StepStats& s = ctx.work.stats;
    s.solver_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    s.solver_cpu_seconds = ctx.stopwatch->seconds();
    split::end_budget(ctx);
    s.newton_iterations = ctx.work.newton.iterations;
    s.factor_work = static_cast<double>(ctx.work.solve.step_flops) /
                    static_cast<double>(std::max<std::int64_t>(1, s.factor_flops));
}

/// Run stage collide: find contacts at the present poses and wake bodies by them.
Status collide(context::StepContext& ctx) noexcept {
    ctx.state.loads.count_change(ctx.model.bodies, ctx.pool);
    Status status = Status::ok;
    if (ctx.model.collider.count() > 0) status = context::timed(ctx, Stage::collide, find_contacts);
    return status == Status::ok ? wake_disturbed(ctx) : status;
}

/// Run stage graph: update groups that follow the state, and the cuts that a deadline may use.
Status graph(context::StepContext& ctx) noexcept {
    const Status status = split::regroup(ctx);
    return status == Status::ok ? split::prepare_levels(ctx) : status;
}

/// Run stage analyse if the system differs from that of the last step, by other cuts or a first
/// contact of bodies. Afterwards contacts are rows and impacts are done.
Status analyse_step(context::StepContext& ctx) noexcept {
    if (const Status status = split::choose_cuts(ctx); status != Status::ok) return status;
    state::save_solved_state(ctx);
    return ctx.model.collider.count() > 0 ? start_moving(ctx) : Status::ok;
}

/// Run stages factor and nonsmooth, which alternate.
Status solve_velocities(context::StepContext& ctx) noexcept {
    split::begin_budget(ctx);
    const Status status = solve_assembled(ctx);
    return status == Status::ok ? guard_wires(ctx) : status;
}

/// Check whether the solution may become the state.
Status accept(context::StepContext& ctx) noexcept {
    // A cancelled solution is incomplete and must not be used.
    if (ctx.pool.stopping()) return Status::cancelled;
    return context::timed(ctx, Stage::integrate, [](context::StepContext& c) {
        c.state.loads.measure(c.model.bodies, c.model.def.step, c.model.bodies.v.data(),
                              context::view(c).v_new, c.pool);
        return monitor::run_monitors(c);
    });
}

/// Run stage integrate, which cannot be undone.
void finish(context::StepContext& ctx) noexcept {
    ctx.state.events.release(true);
    context::timed(ctx, Stage::integrate, integrate);
    ctx.state.imposed = {};
    if (ctx.model.collider.count() > 0) ctx.model.collider.keep();
    state::discard_saved(ctx.work.undo);
    ctx.state.edits.clear();
    accept_systems(ctx);
    fall_asleep(ctx);
}

/// Run all stages. If it fails, the state may be incomplete.
Status take_step(context::StepContext& ctx) noexcept {
    const bool starts = !ctx.state.started;
    // Solves read figures of the step. A start reads none of an earlier step.
    clear_figures(ctx.model, ctx.work);
    Status status = starts ? start_world(ctx) : Status::ok;
    if (status != Status::ok) return status;
    const context::StepTimer timer(ctx);
    const Clock::time_point begin = Clock::now();
    if (starts) clear_figures(ctx.model, ctx.work);

    if (!starts) status = context::timed(ctx, Stage::prestep, prestep);
    if (status == Status::ok) status = collide(ctx);
    if (status != Status::ok) return status;
    const Clock::time_point solver = start_solver(ctx);
    status = graph(ctx);
    if (status != Status::ok) return status;
    status = analyse_step(ctx);
    if (status == Status::ok) {
        assemble_rows(ctx);
        status = solve_velocities(ctx);
    }
    end_solver(ctx, solver);
    if (status == Status::ok) status = accept(ctx);
    if (status == Status::ok) finish(ctx);
    ctx.work.stats.step_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return status;
}

/// Restore the last good state after a failed step.
void go_back(context::StepContext& ctx) noexcept {
    if (ctx.work.before.remembered && !ctx.work.undo.moved) state::restore_solved_state(ctx);
    state::restore_saved_values(ctx);
    take_back_systems(ctx);
    // Report a NaN residual as the largest number, because readers compare and print it.
    StepStats& s = ctx.work.stats;
    for (double* residual : {&s.momentum_residual, &s.constraint_residual, &s.natural_map})
        if (!std::isfinite(*residual)) *residual = std::numeric_limits<double>::max();
}

}  // namespace

Status step(context::StepContext& ctx) noexcept {
    ctx.work.stats.bound_met = {};
    ctx.work.before.remembered = false;
    Status status = ctx.pool.stopping() ? Status::cancelled : Status::ok;
    if (status == Status::ok) status = context::guarded(ctx, [&] { make_ready(ctx); });
    if (status == Status::ok) {
        ctx.pool.resume();
        status = take_step(ctx);
        ctx.pool.pause();
    }
    if (status != Status::ok) {
        go_back(ctx);
        // After cancellation any other status is a consequence of the missing work.
        if (ctx.pool.stopping()) status = Status::cancelled;
    }
    if (status == Status::cancelled) ctx.pool.clear_stop();
    return ctx.work.stats.status = status;
}

}  // namespace hawser::step
