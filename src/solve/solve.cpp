// SPDX-License-Identifier: Apache-2.0
#include "solve/solve.h"

#include "base/index.h"
#include "context/copies.h"
#include "context/sweeps.h"
#include "context/timer.h"
#include "context/view.h"
#include "solve/capstans.h"
#include "solve/contact_rows.h"
#include "solve/factor.h"
#include "solve/losses.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

using assembly::Norms;
using assembly::View;

/// Return the sum of norms, added in order so that it does not depend on threads.
Norms merged(const std::vector<Norms>& parts) noexcept {
    Norms n;
    for (const Norms& p : parts) {
        n.momentum += p.momentum;
        n.impulse += p.impulse;
        n.work += p.work;
        n.drag += p.drag;
        n.finite += p.finite;
        if (!(p.constraint <= n.constraint)) n.constraint = p.constraint;
        if (!(p.stretch <= n.stretch)) n.stretch = p.stretch;
        if (p.gap > n.gap) {
            n.gap = p.gap;
            n.gap_id = p.gap_id;
        }
    }
    return n;
}

/// Compute the right-hand side of the first solve from rows and body terms.
void start_solve(context::Model& model, context::Work& work, runtime::Pool& pool,
                 const View& v) noexcept {
    const assembly::Kernels& k = assembly::kernels();
    release_capstans(model, work.newton);
    context::sweep(
        model, pool,
        [&](int strip) {
            context::each(model.system.strips.interactions(strip),
                          [&](std::int32_t a, std::int32_t b) { k.first_rhs(v, a, b, false); });
        },
        [&](std::int32_t a, std::int32_t b, int) { k.first_body_rhs(v, a, b, false); });
    work.solve.rhs_ready = true;
}

/// Update λ of all rows from the solver's vector, and λ of sliding capstans from their loads.
void update_rows(context::Model& model, const context::Work& work, runtime::Pool& pool,
                 const View& v, bool first) noexcept {
    const assembly::Kernels& k = assembly::kernels();
    context::over_interactions(
        model, pool, [&](std::int32_t a, std::int32_t b) { k.row_update(v, a, b, first); });
    follow_capstans(model, work.newton, v);
}

/// Compute the right-hand side that corrects the current v₊ and λ, after contacts or ranges
/// changed.
void continue_solve(context::Model& model, context::Work& work, runtime::Pool& pool,
                    const View& v) noexcept {
    const assembly::Kernels& k = assembly::kernels();
    std::fill_n(v.solution, model.system.symbolic.scalars, 0.0);
    update_contacts(model, pool, v.v_new);
    const bool runs = !model.system.capstans.empty();
    if (runs) update_rows(model, work, pool, v, false);
    context::sweep(
        model, pool,
        [&](int strip) {
            if (runs) return;
            context::each(model.system.strips.interactions(strip),
                          [&](std::int32_t a, std::int32_t b) { k.row_update(v, a, b, false); });
        },
        [&](std::int32_t a, std::int32_t b, int) { k.body_rhs(v, a, b); });
    work.solve.rhs_ready = true;
}

/// Add the solution vector to v₊ for all bodies.
void add_everywhere(runtime::Pool& pool, const View& v) noexcept {
    context::over(pool, v.body_count, [&](std::int32_t a, std::int32_t b) {
        assembly::kernels().add_solution(v, a, b);
    });
}

/// Next step after a correction of v₊ and λ: the right-hand side of another one, or the
/// norms of the solution.
enum class AfterCorrection { solve, measure };

/// Add the solver's vector to v₊ and λ, and update the residuals.
/// @param first  True if the vector is the solution itself, not a correction.
/// @param next  Result that is needed afterwards.
Norms correct(context::Model& model, context::Work& work, runtime::Pool& pool, const View& v,
              bool first, AfterCorrection next) noexcept {
    context::SolveWork& solve = work.solve;
    const assembly::Kernels& k = assembly::kernels();
    const assembly::RowBlocks& strips = model.system.strips;
    const bool touching = model.system.contacts.count() > 0;
    const bool runs = !model.system.capstans.empty();  // their impulses need those of their loads
    auto add = [&](std::int32_t a, std::int32_t b) { k.add_solution(v, a, b); };
    if (touching || runs) {
        add_everywhere(pool, v);
        if (touching) update_contacts(model, pool, v.v_new);
        if (runs) update_rows(model, work, pool, v, first);
    } else {
        auto add_shared = [&](int i, int) noexcept { context::each(strips.shared(i), add); };
        pool.for_each(strips.groups(), add_shared);
    }
    if (next == AfterCorrection::measure)
        std::fill(solve.norms.begin(), solve.norms.end(), Norms{});
    // With contacts, the last measured solution need not be that of the step.
    solve.losses_known = next == AfterCorrection::measure && !touching;
    context::sweep(
        model, pool,
        [&](int strip) {
            if (!touching && !runs) context::each(strips.bodies(strip), add);
            double absorbed = 0.0;
            context::each(strips.interactions(strip), [&](std::int32_t a, std::int32_t b) {
                if (!runs) k.row_update(v, a, b, first);
                if (next == AfterCorrection::measure) k.row_norms(v, a, b, &solve.norms[at(strip)]);
                if (solve.losses_known) absorbed += losses_between(model, v, a, b);
            });
            solve.losses[at(strip)] = absorbed;
        },
        [&](std::int32_t a, std::int32_t b, int norm) {
            if (next == AfterCorrection::measure)
                k.body_norms(v, a, b, &solve.norms[at(norm)]);
            else
                k.body_rhs(v, a, b);
        });
    return next == AfterCorrection::measure ? merged(solve.norms) : Norms{};
}

double momentum_residual(const context::Model& model, const Norms& n) noexcept {
    return std::sqrt(n.momentum) / std::max(std::sqrt(n.impulse), model.residual_floor);
}

Status report(const context::Model& model, context::Work& work, const Norms& n) noexcept {
    if (!std::isfinite(n.finite) || !std::isfinite(n.momentum)) return Status::not_finite;
    work.stats.momentum_residual = momentum_residual(model, n);
    work.stats.constraint_residual = n.constraint;
    work.stats.violation_max = n.gap;
    work.stats.violation_worst = model.interactions.id(context::original(model, n.gap_id));
    work.stats.stretch_error_max = n.stretch;
    work.solve.step_work = n.work;
    work.solve.step_drag = n.drag;
    return Status::ok;
}

/// Tolerance of a corrected solution. For a million links rounding leaves 1e-12 to 3e-12. Another
/// correction, a third of the step's time, leaves the same.
constexpr double kCorrectedTolerance = 1e-11;

/// Return true if a residual requires a correction. The residual of momentum is relative, those of
/// rows are in [m/s, rad/s].
bool needs_refinement(const context::Model& model, const StepStats& stats,
                      const Norms& n) noexcept {
    const double good = stats.refinements > 0 ? kCorrectedTolerance : model.def.solution_tolerance;
    return momentum_residual(model, n) > good || n.constraint > good;
}

/// Return the largest number of corrections: two more than defined, which stiff rows on very light
/// bodies need.
int max_refinements(const context::Model& model) noexcept {
    return model.def.refinements > 0 ? model.def.refinements + 2 : 0;
}

/// Repeat corrections as long as the residual requires them, and write the residual into the
/// statistics.
Status finish_solve(context::Model& model, context::Work& work, runtime::Pool& pool, const View& v,
                    Norms n, int most) noexcept {
    for (int extra = 0; extra < most; ++extra) {
        if (!needs_refinement(model, work.stats, n)) break;
        const Norms before = n;
        context::over(pool, v.body_count, [&](std::int32_t a, std::int32_t b) {
            assembly::kernels().body_rhs(v, a, b);
        });
        model.system.numeric.solve(model.system.symbolic, v.solution, pool);
        ++work.stats.refinements;
        ++work.stats.substitutions;
        n = correct(model, work, pool, v, false, AfterCorrection::measure);
        if (!(n.momentum < 0.25 * before.momentum)) break;
    }
    return report(model, work, n);
}

}  // namespace

Status factor_and_solve(context::StepContext& ctx) noexcept {
    const context::StageTimer timer(ctx, Stage::factor);
    const View v = context::view(ctx);
    if (!ctx.work.solve.rhs_ready) start_solve(ctx.model, ctx.work, ctx.pool, v);
    if (const Status status = factor(ctx, true); status != Status::ok) return status;
    // Measuring a solution before refining it costs an additional pass over all rows and bodies. If
    // the residuals of two consecutive steps required refinement, the measurement is skipped for
    // some steps. An unneeded correction costs more than such a pass.
    constexpr int kAWhile = 8, kAskedOnce = kAWhile + 1;
    const bool asked_once = ctx.state.refine_unasked >= kAskedOnce;
    const bool measured_first =
        ctx.state.refine_unasked == 0 || asked_once || ctx.model.completion.any;
    const int refinements = measured_first ? 0 : ctx.model.def.refinements;
    if (!measured_first) --ctx.state.refine_unasked;
    Norms n;
    for (int i = 0; i <= refinements; ++i) {
        if (i > 0) ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
        ctx.work.stats.substitutions += i > 0 ? 1 : 0;
        n = correct(ctx.model, ctx.work, ctx.pool, v, i == 0,
                    i < refinements ? AfterCorrection::solve : AfterCorrection::measure);
    }
    ctx.work.stats.refinements = refinements;
    // the constraint iterations also refine
    if (ctx.model.completion.any) return report(ctx.model, ctx.work, n);
    if (measured_first) {
        const bool asks =
            ctx.model.def.refinements > 0 && needs_refinement(ctx.model, ctx.work.stats, n);
        ctx.state.refine_unasked = !asks ? 0 : asked_once ? kAWhile : kAskedOnce;
    }
    return finish_solve(ctx.model, ctx.work, ctx.pool, v, n,
                        max_refinements(ctx.model) - refinements);
}

Status newton_solve(context::StepContext& ctx, bool first, bool whole) noexcept {
    const context::StageTimer timer(ctx, Stage::factor);
    const View v = context::view(ctx);
    if (first) {
        if (!ctx.work.solve.rhs_ready) {
            update_contacts(ctx.model, ctx.pool, nullptr);
            start_solve(ctx.model, ctx.work, ctx.pool, v);
        }
    } else {
        continue_solve(ctx.model, ctx.work, ctx.pool, v);
    }
    if (const Status status = factor(ctx, whole); status != Status::ok) return status;
    add_everywhere(ctx.pool, v);
    update_contacts(ctx.model, ctx.pool, v.v_new);
    update_rows(ctx.model, ctx.work, ctx.pool, v, first);
    return Status::ok;
}

void continue_with_factor(context::StepContext& ctx) noexcept {
    const context::StageTimer timer(ctx, Stage::factor);
    const View v = context::view(ctx);
    continue_solve(ctx.model, ctx.work, ctx.pool, v);
    ctx.work.solve.rhs_ready = false;
    ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
    ++ctx.work.stats.substitutions;
    add_everywhere(ctx.pool, v);
    update_contacts(ctx.model, ctx.pool, v.v_new);
    update_rows(ctx.model, ctx.work, ctx.pool, v, false);
}

Status refine(context::StepContext& ctx) noexcept {
    const context::StageTimer timer(ctx, Stage::factor);
    const View v = context::view(ctx);
    context::over(ctx.pool, v.body_count,
                  [&](std::int32_t a, std::int32_t b) { assembly::kernels().body_rhs(v, a, b); });
    ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
    ctx.work.stats.refinements = 1;
    ++ctx.work.stats.substitutions;
    return finish_solve(ctx.model, ctx.work, ctx.pool, v,
                        correct(ctx.model, ctx.work, ctx.pool, v, false, AfterCorrection::measure),
                        max_refinements(ctx.model) - 1);
}

Status settle_iterations(context::StepContext& ctx, bool measured) noexcept {
    if (!measured)
        if (const Status status = measure(ctx); status != Status::ok) return status;
    const double good = ctx.model.def.solution_tolerance;
    const bool needs_correction =
        ctx.work.stats.momentum_residual > good || ctx.work.stats.constraint_residual > good;
    return needs_correction && ctx.model.def.refinements > 0 ? refine(ctx) : Status::ok;
}

Status measure(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    const assembly::Kernels& k = assembly::kernels();
    std::fill(ctx.work.solve.norms.begin(), ctx.work.solve.norms.end(), Norms{});
    context::sweep(
        ctx.model, ctx.pool,
        [&](int strip) {
            context::each(ctx.model.system.strips.interactions(strip),
                          [&](std::int32_t a, std::int32_t b) {
                              k.row_norms(v, a, b, &ctx.work.solve.norms[at(strip)]);
                          });
        },
        [&](std::int32_t a, std::int32_t b, int norm) {
            k.body_norms(v, a, b, &ctx.work.solve.norms[at(norm)]);
        });
    return report(ctx.model, ctx.work, merged(ctx.work.solve.norms));
}

}  // namespace hawser::solve
