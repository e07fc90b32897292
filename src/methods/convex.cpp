// SPDX-License-Identifier: Apache-2.0
/// Method convex: Newton's method on ½‖v − v*‖² + ½ Σ ‖P_K(y)‖² over the velocities that joints
/// allow (nonsmooth/associated.h). The matrix stays symmetric. The exact line search on this convex
/// function needs contacts only, because momentum and joints hold at every point of a step.
#include "contact/iterate.h"
#include "contact/krylov.h"
#include "context/context.h"
#include "methods/nonsmooth.h"
#include "nonsmooth/associated.h"
#include "solve/active_set.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>

namespace hawser::methods {
namespace {

using nonsmooth::Cone;

std::int32_t linearise_cones(context::Model& model, context::Newton& newton) noexcept {
    std::int32_t flips = 0;
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        Cone& c = model.system.contacts.cones[k];
        const nonsmooth::Touch before = c.touch;
        newton.laws[k] = nonsmooth::linearise_associated(c, c.touch);
        flips += c.touch != before ? 1 : 0;
    }
    return flips;
}

/// Return the derivative of the function along the step, at fraction t of the way from the stored
/// iterate [J]. There the momentum balance uses the impulses of the linear law; the gradient uses
/// those of the exact law.
double slope(const context::Model& model, const context::Newton& newton, double t) noexcept {
    double sum = 0.0;
    const base::Array<Cone>& cones = model.system.contacts.cones;
    for (std::size_t k = 0; k < cones.size(); ++k) {
        const Cone& c = cones[k];
        const double* from = &newton.contact[6 * k];
        double u[3], law[3];
        for (int i = 0; i < 3; ++i) u[i] = from[i] + t * (c.u[i] - from[i]);
        nonsmooth::associated_impulse(c, u, law);
        for (int i = 0; i < 3; ++i) {
            const double linear = from[3 + i] + t * (c.lambda[i] - from[3 + i]);
            sum += (linear - law[i]) * (c.u[i] - from[i]);
        }
    }
    return sum;
}

/// Shorten the step to the point where the slope vanishes. The full step is used if the function
/// still descends at its end.
void search(context::Model& model, const context::Newton& newton) noexcept {
    const double start = slope(model, newton, 0.0), end = slope(model, newton, 1.0);
    // If the slope at the end is at most a tenth of that at the start, the full step is accurate
    // enough.
    if (!(end > 0.1 * std::fabs(start))) return;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 20 && high - low > 0.01 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (slope(model, newton, middle) > 0.0 ? high : low) = middle;
    }
    contact::return_to_fraction(model, newton, 0.5 * (low + high));
}

double largest_model_residual(const context::Model& model) noexcept {
    double largest = 0.0;
    for (const Cone& c : model.system.contacts.cones)
        largest = std::max(largest, nonsmooth::associated_map(c, model.contact_floor));
    return largest;
}

}  // namespace

void begin_convex(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept {
    (void)linearise_cones(model, newton);
    contact::adopt_laws(model, newton, pool, true);
}

Status solve_convex(context::StepContext& ctx) noexcept {
    ctx.work.newton.iterations = 0;
    constexpr int kKrylovFrom = 2;  // same value as in newton.cpp
    bool again = false;
    for (int it = 0;; ++it) {
        ++ctx.work.newton.iterations;
        if (it == 0 || again || it < kKrylovFrom || !contact::find_impulses(ctx)) {
            if (it > 0) contact::adopt_laws(ctx.model, ctx.work.newton, ctx.pool, false);
            if (const Status s = solve::newton_solve(ctx, it == 0, it == 0 || again);
                s != Status::ok)
                return s;
        } else {
            solve::continue_with_factor(ctx);
        }
        if (it > 0) search(ctx.model, ctx.work.newton);
        again = solve::update_active_set(ctx.model, ctx.work, it);
        const double left = largest_model_residual(ctx.model);
        if (!std::isfinite(left)) return Status::not_finite;
        if ((left <= ctx.model.def.contact_tolerance && !again) ||
            it + 1 >= ctx.model.def.contact_iterations)
            break;
        contact::save_iterate(ctx.model, ctx.work.newton);
        ctx.work.stats.flips_left +=
            linearise_cones(ctx.model, ctx.work.newton);  // added to the flips of rows
    }
    ctx.work.stats.natural_map = contact::largest_residual(ctx.model, ctx.work.solve, ctx.pool);
    return solve::refine(ctx);
}

}  // namespace hawser::methods
