// SPDX-License-Identifier: Apache-2.0
#include "contact/newton.h"

#include "base/index.h"
#include "contact/convex_phase.h"
#include "contact/iterate.h"
#include "contact/krylov.h"
#include "contact/line_search.h"
#include "contact/newton_end.h"
#include "contact/newton_laws.h"
#include "contact/wire_newton.h"
#include "context/newton_data.h"
#include "context/view.h"
#include "solve/active_set.h"
#include "solve/bounds.h"
#include "solve/contact_rows.h"
#include "solve/joints.h"
#include "solve/solve.h"
#include "solve/wire_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace hawser::contact {
namespace {

using nonsmooth::Cone;

constexpr int kPatience = 8;  ///< Iterations before slow ones request a factorisation.
constexpr double kSlowMerit =
    0.25;  ///< Fraction of the merit left after an iteration that requests a factorisation.
constexpr int kKrylovFrom = 2;  ///< First iteration that may omit a factorisation.
constexpr int kExactMost = 10;  ///< Exact iterations before the convex phase.
/// Successive exact iterations before the convex phase that were shortened and increased the merit.
constexpr int kAscentMost = 3;
/// Natural map below which the convex phase ends. At 1e-2 steps fall back into it.
constexpr double kConvexEnd = 5e-3;

/// Store the end time of an iteration, from which the time of the next one is predicted.
void record_iteration_time(context::StepContext& ctx) noexcept {
    if (!ctx.work.limits.budget.needs_time()) return;
    ctx.work.limits.laps.last = ctx.stopwatch->seconds();
    ctx.work.limits.laps.iterations = ctx.work.newton.iterations;
    if (ctx.work.limits.laps.iterations == 1)
        ctx.work.limits.laps.first = ctx.work.limits.laps.last;
}

/// Return true if the budget allows another iteration. No iteration follows a cut, even if the step
/// is solved again (guard.h): StepStats::cut then describes the whole step.
bool fits_budget(context::Work& work) noexcept {
    return !work.stats.cut &&
           work.limits.budget.allows_iteration(
               {work.limits.laps.last, static_cast<double>(work.solve.step_flops)},
               work.newton.iterations);
}

/// Store the data that repeat the step (Degradation): the number of iterations of all its solves.
void record_cut(context::StepContext& ctx) noexcept {
    if (ctx.work.stats.cut) return;
    ctx.work.stats.cut = true;
    ctx.work.stats.degradation.iterations = ctx.work.newton.iterations;
    ctx.work.stats.degradation.hasty = ctx.state.step > 0 && ctx.work.limits.budget.exits_early();
}

/// Options of a sequence of Newton iterations.
struct NewtonOptions {
    bool may_exit_early =
        false;  ///< When the budget ends them, rows that ask to switch do so after the step.
    bool begun = false;      ///< The matrix holds the laws of an iterate close by, and its factors.
    bool completes = false;  ///< The second iteration is a round of completion as well.
    bool* strayed = nullptr;  ///< Set to true if an iteration did not descend by a full step.
};

/// Complete the joints (step/completion.h) about an iterate close to the solution. The next
/// iteration then includes an end-of-step constraint iteration at no additional substitution.
void complete_iterate(context::StepContext& ctx) noexcept {
    constexpr double kClose = 1e-2;
    if (!(ctx.work.stats.natural_map <= kClose)) return;
    (void)solve::renew_completed(ctx);
    solve::adopt_completed(ctx);
    ++ctx.work.stats.completion_rounds;
}

/// State of a sequence of Newton iterations.
struct Progress {
    int iteration = 0;
    int exact = 0;   ///< Exact iterations since the start, or since the convex phase.
    int ascent = 0;  ///< Successive exact iterations that were shortened and increased the merit.
    bool rows_switched = false;  ///< Rows have switched.
    bool slow = false;           ///< The merit decreases too slowly without a factorisation.
    bool may_be_convex = true;
    double stored_merit = 0.0;  ///< Merit of the stored iterate.
    Cycle cycle{};
};

Progress begin_iterations(context::StepContext& ctx, nonsmooth::Coupling coupling,
                          const NewtonOptions& course) noexcept {
    context::Newton& newton = ctx.work.newton;
    for (Cone& c : ctx.model.system.contacts.cones) c.coupling = coupling;
    std::fill_n(newton.changes.begin(), ctx.model.system.contacts.count(), std::uint8_t{0});
    newton.convex = false;
    newton.follow.restart();
    forget_best(newton);
    Progress p;
    if (!course.begun) return p;
    p.iteration = kKrylovFrom;
    save_iterate(ctx.model, newton);
    p.stored_merit = merit(ctx.model, newton, 0.0);
    (void)linearise(ctx.model, ctx.work, ctx.pool, LastLaws::known);
    return p;
}

/// Solve once with the laws linearised about the iterate.
Status solve_iteration(context::StepContext& ctx, const NewtonOptions& course,
                       const Progress& p) noexcept {
    context::Newton& newton = ctx.work.newton;
    ++newton.iterations;
    const bool second = p.iteration > 0 && p.iteration < kKrylovFrom;
    // A repeated step starts from its solution (restart_newton), which its laws are close to.
    const bool close = second && ctx.model.wires.again && !course.completes;
    const bool tries = p.iteration >= kKrylovFrom || close;
    const bool factors = !tries || p.rows_switched || p.slow || newton.convex;
    if (!factors && find_impulses(ctx)) {
        solve::continue_with_factor(ctx);
        return Status::ok;
    }
    if (second)
        adopt_changed_laws(ctx.model, newton, ctx.pool);
    else if (p.iteration > 0)
        adopt_laws(ctx.model, newton, ctx.pool, false);
    if (p.iteration == 1 && course.completes) complete_iterate(ctx);
    return solve::newton_solve(ctx, p.iteration == 0, p.iteration == 0);
}

/// Move to the solution of the linear laws, or a fraction of the way to it, and store the new
/// iterate.
Status store_next_iterate(context::StepContext& ctx, const NewtonOptions& course,
                          Progress& p) noexcept {
    context::Newton& newton = ctx.work.newton;
    solve::take_bounds(ctx.model, newton);
    const double cycle_fraction =
        p.iteration > kPatience ? p.cycle.next_fraction(p.stored_merit) : 0.0;
    LineStep way;
    if (newton.convex)
        way = move_fraction(ctx.model, newton, zero_slope_fraction([&](double t) {
                                return convex_slope(ctx.model, newton, t);
                            }));
    else if (p.iteration > 0)
        way = search_line(ctx.model, newton, p.stored_merit, cycle_fraction);
    newton.shortened = way.fraction < 1.0;
    if (course.strayed != nullptr && p.iteration > 0 &&
        (newton.shortened || way.merit > p.stored_merit))
        *course.strayed = true;
    if (!std::isfinite(way.merit)) return Status::not_finite;
    p.slow = p.iteration > kPatience && way.merit > kSlowMerit * p.stored_merit;
    const bool ascends = !newton.convex && newton.shortened && way.merit > p.stored_merit;
    p.ascent = ascends ? p.ascent + 1 : 0;
    if (p.iteration > 0 && way.merit > p.stored_merit && p.stored_merit < newton.best)
        save_if_best(newton, p.stored_merit);
    save_iterate(ctx.model, newton);
    solve::keep_bounds(newton, way.fraction);
    record_iteration_time(ctx);
    return Status::ok;
}

/// Switch the bounded rows whose status does not match the iterate.
/// @param stop  True if the budget allows no other iteration: such rows switch after the step.
/// @return the number of such rows.
std::int32_t switch_rows(context::StepContext& ctx, bool stop, bool last) noexcept {
    const std::int32_t most = last ? 0 : solve::kAnyRows;
    const std::int32_t switch_count =
        solve::switch_bounds(ctx.model, ctx.work, ctx.model.contact_floor, stop ? 0 : most);
    if (stop && switch_count == 0)
        (void)solve::switch_bounds(ctx.model, ctx.work, ctx.model.contact_floor, most);
    if (switch_count > 0 && !stop && !last && !ctx.work.newton.convex)
        solve::settle_wire_bounds(ctx.model, ctx.work);
    return switch_count;
}

/// Enter the convex phase after kExactMost exact iterations, or after kAscentMost that were
/// shortened and increased the merit, and leave it close to the solution.
void choose_phase(const context::Model& model, context::Work& work, Progress& p) noexcept {
    context::Newton& newton = work.newton;
    if (newton.convex) {
        if (p.rows_switched || work.stats.natural_map > kConvexEnd) return;
        newton.convex = false;
        p.exact = p.ascent = 0;
        std::fill_n(newton.changes.begin(), model.system.contacts.count(), std::uint8_t{0});
        return;
    }
    const bool lasts = ++p.exact >= kExactMost || p.ascent >= kAscentMost;
    newton.convex = lasts && p.may_be_convex && work.stats.natural_map > kConvexEnd;
}

/// Leave the convex phase after a failed factorisation, because the laws of this phase are stiffer
/// than the exact ones. The remaining iterations start from the present iterate and use exact laws.
/// @return false: the failed iteration was exact.
bool end_convex_phase(context::StepContext& ctx, Progress& p) noexcept {
    if (!ctx.work.newton.convex) return false;
    ctx.work.newton.convex = p.may_be_convex = false;
    p.rows_switched = true;  // factor
    (void)linearise(ctx.model, ctx.work, ctx.pool, LastLaws::none);
    return true;
}

/// Iterate to the tolerance, or until the limit of iterations or the budget is reached.
Status run_iterations(context::StepContext& ctx, double tolerance, const NewtonOptions& course,
                      Progress p) noexcept {
    context::Newton& newton = ctx.work.newton;
    StepStats& stats = ctx.work.stats;
    for (;; ++p.iteration) {
        if (const Status s = solve_iteration(ctx, course, p); s != Status::ok) {
            if (!end_convex_phase(ctx, p)) return s;
            continue;
        }
        if (const Status s = store_next_iterate(ctx, course, p); s != Status::ok) return s;
        const bool last = p.iteration + 1 >= ctx.model.def.contact_iterations;
        const double moved = solve::bounds_map(ctx.model, newton);
        const bool stop = course.may_exit_early && !fits_budget(ctx.work);
        const std::int32_t switch_count = switch_rows(ctx, stop, last);
        p.rows_switched = switch_count > 0;
        if (p.rows_switched || moved > 0.0) forget_best(newton);  // other rows, or impulses
        stats.natural_map = std::max(largest_residual(ctx.model, ctx.work.solve, ctx.pool), moved);
        if (!std::isfinite(stats.natural_map)) return Status::not_finite;
        if (stats.natural_map <= tolerance && !p.rows_switched) {
            stats.flips_left = 0;
            return Status::ok;
        }
        // Without early exit, do not stop just after lines have switched, because their rows would
        // be left unsolved.
        const bool cut = course.may_exit_early ? stop : !p.rows_switched && !fits_budget(ctx.work);
        if (cut) record_cut(ctx);
        if (cut || last) {
            // Contact statuses follow from the iterate alone.
            newton.convex = false;
            stats.flips_left =
                linearise(ctx.model, ctx.work, ctx.pool, LastLaws::none) + switch_count;
            return Status::ok;
        }
        if (!course.begun) choose_phase(ctx.model, ctx.work, p);
        stats.flips_left = linearise(ctx.model, ctx.work, ctx.pool, LastLaws::known) + switch_count;
        if (!newton.convex && !stop) settle_wire_contacts(ctx.model, ctx.work);
        p.stored_merit = merit(ctx.model, newton, 0.0);
    }
}

/// Run Newton iterations from the current iterate.
/// @param coupling  Coupling of all contacts.
Status iterate(context::StepContext& ctx, nonsmooth::Coupling coupling, double tolerance,
               NewtonOptions course = {}) noexcept {
    const Progress begun = begin_iterations(ctx, coupling, course);
    const Status status = run_iterations(ctx, tolerance, course, begun);
    ctx.work.newton.convex = false;
    return status;
}

/// Restart the iterations from the present velocities and impulses of the contacts.
void restart(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept {
    (void)linearise(model, work, pool, LastLaws::none);
    adopt_laws(model, work.newton, pool, true);
    solve::update_contacts(model, pool, nullptr);
    work.solve.rhs_ready = false;
}

bool solved(const context::Model& model, const StepStats& stats, Status status) noexcept {
    return status == Status::ok && stats.natural_map <= model.def.contact_tolerance &&
           stats.flips_left == 0;
}

void soften_by(context::Model& model, double factor) noexcept {
    for (Cone& c : model.system.contacts.cones) c.sigma_t *= factor;
    for (nonsmooth::Resistance& a : model.system.contacts.resistances.laws) a.sigma *= factor;
}

/// Set lagged coupling and the impulses of the last step for all contacts, with velocities u = 0.
void begin_lagged(context::StepContext& ctx) noexcept {
    restore_last_step(ctx.model, ctx.work.contact_speed);
    for (Cone& c : ctx.model.system.contacts.cones) {
        c.coupling = nonsmooth::Coupling::lagged;
        std::fill_n(c.u, 3, 0.0);
    }
    for (nonsmooth::Resistance& a : ctx.model.system.contacts.resistances.laws)
        std::fill_n(a.u, 3, 0.0);
    restart(ctx.model, ctx.work, ctx.pool);
}

/// End a step whose matrix with lagged coupling has wrong pivots. Without rounding this matrix is
/// positive definite. The pivots are wrong if contacts are so stiff that rounding removes the
/// masses of other bodies. Therefore solve once with contacts softer by powers of 1,024, until the
/// pivots are right. Pivots that remain wrong have another cause.
Status end_softened(context::StepContext& ctx) noexcept {
    constexpr double kSofter = 1024.0;
    constexpr int kMaximum = 3;
    const auto soften = [&](double factor) {
        soften_by(ctx.model, factor);
        for (Cone& c : ctx.model.system.contacts.cones) c.sigma_n *= factor;
    };
    Status status = Status::wrong_pivot;
    double softer = 1.0;
    for (int k = 0; k < kMaximum && status == Status::wrong_pivot; ++k) {
        soften(kSofter);  // powers of two: exactly undone
        softer *= kSofter;
        begin_lagged(ctx);
        status = solve::newton_solve(ctx, true, true);
    }
    if (status == Status::ok) {
        project_all(ctx.model);
        solve::update_contacts(ctx.model, ctx.pool, context::row_view(ctx.model).v_new);
    }
    soften(1.0 / softer);
    return status;
}

/// Solve with contacts softer by factors of 1,024 and 32 first. Each solution is the start for the
/// next one (newton.h).
Status from_soft(context::StepContext& ctx) noexcept {
    constexpr double kRough = 1e-2;  // tolerance of a softer system as a start for the next
    for (const double soften : {1024.0, 32.0}) {  // powers of two: undone exactly
        soften_by(ctx.model, soften);
        restart(ctx.model, ctx.work, ctx.pool);
        const Status status = iterate(ctx, nonsmooth::Coupling::exact, kRough);
        soften_by(ctx.model, 1.0 / soften);
        if (status != Status::ok) return status;
        if (ctx.work.stats.cut) break;
    }
    ctx.work.stats.natural_map = largest_residual(ctx.model, ctx.work.solve, ctx.pool);
    forget_best(ctx.work.newton);  // its merit was that of a softer system
    if (ctx.work.stats.cut) return Status::ok;
    restart(ctx.model, ctx.work, ctx.pool);
    return iterate(ctx, nonsmooth::Coupling::exact, ctx.model.def.contact_tolerance);
}

/// Set the certificate of contacts in the statistics.
void state_certificate(const context::Model& model, context::Work& work,
                       runtime::Pool& pool) noexcept {
    work.stats.natural_map =
        std::max(largest_residual(model, work.solve, pool), solve::bounds_map(model, work.newton));
}

}  // namespace

void reserve_newton(const context::Model& model, context::Newton& newton) {
    context::Newton& n = newton;
    const std::size_t contacts = model.system.contacts.count(),
                      triples = model.system.contacts.triples();
    n.laws.resize(contacts);
    n.changes.resize(contacts);
    reserve_wire_newton(model, n);
    n.turns.resize(triples - contacts);
    n.x.resize(3 * triples);
    n.u.resize(3 * triples);
    n.contact.resize(6 * triples);
    n.gmres.reserve(3 * triples, kKrylovLimit);
    n.v.resize(at(model.bodies.dofs));
    n.lambda.resize(at(model.interactions.row_count));
    n.best_contact.resize(6 * triples);
    n.best_v.resize(at(model.bodies.dofs));
    n.best_lambda.resize(at(model.interactions.row_count));
    n.bounds.resize(3 * contacts);
    n.limit.resize(contacts);
    n.touch.resize(contacts);
}

void begin_newton(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept {
    for (Cone& c : model.system.contacts.cones) c.coupling = nonsmooth::Coupling::exact;
    (void)linearise(model, work, pool, LastLaws::none);
    adopt_laws(model, work.newton, pool, true);
}

bool save_contact_solution(context::Model& model, context::Work& work) noexcept {
    if (model.def.nonsmooth != Nonsmooth::newton || model.system.contacts.count() == 0 ||
        !solved(model, work.stats, Status::ok))
        return false;
    save_iterate(model, work.newton);
    return true;
}

void restart_newton(context::StepContext& ctx) noexcept {
    recall_contacts(ctx.model, ctx.work.newton);
    restart(ctx.model, ctx.work, ctx.pool);
}

bool rows_request_switch(context::StepContext& ctx) noexcept {
    return solved(ctx.model, ctx.work.stats, Status::ok) && !ctx.work.stats.cut &&
           !ctx.model.system.bounded.empty() &&
           solve::asking_rows(ctx.model, ctx.work, ctx.model.contact_floor) > 0;
}

/// Refine the solution. If the residual then exceeds its tolerance, the laws in the factors differ
/// too much from the laws of the iterate. Factor with the laws of the iterate and refine again.
Status refine_iterate(context::StepContext& ctx) noexcept {
    Status status = solve::refine(ctx);
    const StepStats& stats = ctx.work.stats;
    const double left = std::max(stats.momentum_residual, stats.constraint_residual);
    if (status != Status::ok || !(left > ctx.model.def.solution_tolerance)) return status;
    adopt_laws(ctx.model, ctx.work.newton, ctx.pool, true);
    status = solve::newton_solve(ctx, false, true);
    return status == Status::ok ? solve::refine(ctx) : status;
}

/// Repeat iterations until the refined iterate satisfies the contact laws. If a line search has
/// shortened the last iteration, an iterate may satisfy these laws before refinement, but not after
/// it.
Status certify(context::StepContext& ctx) noexcept {
    constexpr int kMaximum = 8;
    const double tolerance = ctx.model.def.contact_tolerance;
    for (int round = 0; round < kMaximum; ++round) {
        if (ctx.work.stats.natural_map <= tolerance || ctx.work.stats.cut) break;
        Status status = iterate(ctx, nonsmooth::Coupling::exact, tolerance, {.begun = true});
        const bool met = ctx.work.stats.natural_map <= tolerance;
        if (status == Status::ok) status = refine_iterate(ctx);
        if (status == Status::ok) status = solve::follow_loads(ctx);
        if (status != Status::ok) return status;
        state_certificate(ctx.model, ctx.work, ctx.pool);
        if (!met) break;  // another iteration would cost as much without progress
    }
    return Status::ok;
}

/// Repeat iterations until no row has to switch its status. Rows may still have to switch if a line
/// search ended the iterations before the solution was reached.
Status settle_rows(context::StepContext& ctx) noexcept {
    constexpr int kMaximum = 8;
    const double tolerance = ctx.model.def.contact_tolerance;
    for (int round = 0; round < kMaximum && !ctx.model.system.bounded.empty(); ++round) {
        if (solve::asking_rows(ctx.model, ctx.work, ctx.model.contact_floor) == 0)
            return Status::ok;
        (void)solve::switch_bounds(ctx.model, ctx.work, ctx.model.contact_floor, solve::kAnyRows);
        restart(ctx.model, ctx.work, ctx.pool);
        Status status = iterate(ctx, nonsmooth::Coupling::exact, tolerance);
        if (status == Status::ok) status = refine_iterate(ctx);
        if (status == Status::ok) status = solve::follow_loads(ctx);
        if (status != Status::ok) return status;
        state_certificate(ctx.model, ctx.work, ctx.pool);
        if (status = certify(ctx); status != Status::ok) return status;
    }
    ctx.work.stats.flips_left += solve::asking_rows(ctx.model, ctx.work, ctx.model.contact_floor);
    return Status::ok;
}

Status solve_newton(context::StepContext& ctx, bool settled_later) noexcept {
    ctx.work.newton.switch_after_step = false;
    const bool cold = ctx.state.step == 0;
    const double tolerance = ctx.model.def.contact_tolerance;
    bool may_exit_early = !cold && ctx.work.limits.budget.exits_early();
    bool strayed = false;
    Status status = iterate(
        ctx, nonsmooth::Coupling::exact, tolerance,
        {.may_exit_early = may_exit_early, .completes = settled_later, .strayed = &strayed});
    may_exit_early = may_exit_early && ctx.work.stats.cut;
    if (((cold && strayed) || !solved(ctx.model, ctx.work.stats, status)) && !ctx.work.stats.cut) {
        restore_last_step(ctx.model, ctx.work.contact_speed);
        status = from_soft(ctx);
    }
    if (!solved(ctx.model, ctx.work.stats, status) && !ctx.work.stats.cut) {
        begin_lagged(ctx);
        status = iterate(ctx, nonsmooth::Coupling::lagged, tolerance);
    }
    const bool drowned = status == Status::wrong_pivot && !ctx.work.stats.cut;
    if (drowned) status = end_softened(ctx);
    const bool early =
        status == Status::ok && (drowned || !solved(ctx.model, ctx.work.stats, status));
    if (early && may_exit_early)
        end_at_best_iterate(ctx.model, ctx.work, ctx.pool);
    else if (early && !drowned)
        status = end_with_lagged_laws(ctx);
    if (early) solve::show_held(ctx.model);
    // Bounds follow loads of refined solutions only, and projected impulses need the refinement.
    const bool refines = early || !settled_later || !ctx.work.newton.loaded.empty();
    ctx.work.stats.refinements = 0;
    // The laws of a drowned step are factored with softer contacts alone.
    if (status == Status::ok && refines)
        status = drowned ? solve::refine(ctx) : refine_iterate(ctx);
    if (status == Status::ok && !early) status = solve::follow_loads(ctx);
    if (status != Status::ok) return status;
    // For the final state of the step.
    state_certificate(ctx.model, ctx.work, ctx.pool);
    if (early) {
        const std::int32_t switch_count =
            solve::asking_rows(ctx.model, ctx.work, ctx.model.contact_floor);
        ctx.work.newton.switch_after_step = may_exit_early && switch_count > 0;
        ctx.work.stats.flips_left += switch_count;
        return Status::ok;
    }
    if (refines) status = certify(ctx);
    return status == Status::ok ? settle_rows(ctx) : status;
}

Status settle_newton(context::StepContext& ctx) noexcept {
    Status status = Status::ok;
    if (ctx.work.stats.completion_rounds > 0 && !ctx.work.newton.shortened)
        status = solve::settle_iterations(ctx, false);
    else if (ctx.work.stats.refinements == 0)
        status = solve::refine(ctx);
    if (status != Status::ok) return status;
    state_certificate(ctx.model, ctx.work, ctx.pool);
    return certify(ctx);
}

}  // namespace hawser::contact
