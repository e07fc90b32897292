// SPDX-License-Identifier: Apache-2.0
/// Method pivoting: box friction with the bounds of an earlier pass (nonsmooth/box.h).
///
/// Within a pass the bounds are constant, and the problem is a linear complementarity problem with
/// a P-matrix. The rows that change in an iteration are chosen by nonsmooth/pivot.h. Each iteration
/// is one symmetric factorisation of the changed columns. Passes end when the bounds stop changing.
#include "contact/iterate.h"
#include "context/context.h"
#include "nonsmooth/box.h"
#include "nonsmooth/pivot.h"
#include "solve/active_set.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>

namespace hawser::methods {
namespace {

using nonsmooth::Cone;

constexpr int kMaxBoundPasses = 8;

void make_laws(context::Model& model, context::Newton& newton) noexcept {
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        Cone& c = model.system.contacts.cones[k];
        const nonsmooth::Bound* rows = &newton.bounds[3 * k];
        newton.laws[k] = nonsmooth::box_law(c, rows, newton.limit[k]);
        c.touch = nonsmooth::contact_state(rows, newton.limit[k]);
    }
}

/// Run one pass: pivot until the rows satisfy their bounds with fixed friction bounds.
/// @param rounds  Increased by the number of factorisations.
Status run_pass(context::StepContext& ctx, int& rounds) noexcept {
    nonsmooth::PivotProgress progress;
    for (bool again = false;;) {
        if (const Status s = solve::newton_solve(ctx, rounds == 0, rounds == 0 || again);
            s != Status::ok)
            return s;
        ++rounds;
        again = solve::update_active_set(ctx.model, ctx.work, rounds - 1);
        const int count =
            nonsmooth::pivot(ctx.model.system.contacts.cones, ctx.work.newton.bounds,
                             ctx.work.newton.limit, ctx.model.contact_floor, progress);
        ctx.work.stats.flips_left += count;  // added to the flips of rows
        if (count == 0 && !again) return Status::ok;
        if (rounds >= ctx.model.def.contact_iterations) return Status::ok;
        make_laws(ctx.model, ctx.work.newton);
        contact::adopt_laws(ctx.model, ctx.work.newton, ctx.pool, false);
    }
}

/// Set the bounds of the next pass. @return largest relative change.
double renew_limits(const context::Model& model, context::Newton& newton) noexcept {
    double change = 0.0;
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        const Cone& c = model.system.contacts.cones[k];
        double& limit = newton.limit[k];
        const double now = c.friction * std::max(0.0, c.lambda[0]);
        // A bound may change without another pass if no row is at the bound.
        const bool held = newton.bounds[3 * k + 1] == nonsmooth::Bound::free &&
                          newton.bounds[3 * k + 2] == nonsmooth::Bound::free &&
                          std::max(std::fabs(c.lambda[1]), std::fabs(c.lambda[2])) <= now;
        if (!held)
            change = std::max(change,
                              std::fabs(now - limit) / std::max({now, limit, model.contact_floor}));
        limit = now;
    }
    return change;
}

}  // namespace

void begin_pivoting(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept {
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        const Cone& c = model.system.contacts.cones[k];
        newton.limit[k] = c.friction * std::max(0.0, c.lambda[0]);
        // Status at the end of the last step, by the law of the rows at its velocities.
        nonsmooth::Bound* rows = &newton.bounds[3 * k];
        rows[0] = c.u[0] - c.b[0] < 0.0 ? nonsmooth::Bound::free : nonsmooth::Bound::low;
        for (int i = 1; i < 3; ++i) {
            const double y = (c.b[i] - c.u[i]) / c.sigma_t;
            rows[i] = y > newton.limit[k]    ? nonsmooth::Bound::high
                      : y < -newton.limit[k] ? nonsmooth::Bound::low
                                             : nonsmooth::Bound::free;
        }
    }
    make_laws(model, newton);
    contact::adopt_laws(model, newton, pool, true);
}

Status solve_pivoting(context::StepContext& ctx) noexcept {
    int rounds = 0;
    for (int i = 0; i < kMaxBoundPasses; ++i) {
        if (const Status s = run_pass(ctx, rounds); s != Status::ok) return s;
        // Tolerance of the bounds, 0.1 %. The box itself deviates by up to 41 %, so a smaller one
        // is useless.
        constexpr double kBoundTolerance = 1e-3;
        if (rounds >= ctx.model.def.contact_iterations || i + 1 == kMaxBoundPasses) break;
        if (renew_limits(ctx.model, ctx.work.newton) <= kBoundTolerance) break;
        make_laws(ctx.model, ctx.work.newton);
        contact::adopt_laws(ctx.model, ctx.work.newton, ctx.pool, false);
    }
    ctx.work.newton.iterations = rounds;
    ctx.work.stats.natural_map = contact::largest_residual(ctx.model, ctx.work.solve, ctx.pool);
    if (!std::isfinite(ctx.work.stats.natural_map)) return Status::not_finite;
    return solve::refine(ctx);
}

}  // namespace hawser::methods
