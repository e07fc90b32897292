// SPDX-License-Identifier: Apache-2.0
#include "base/index.h"
#include "stepper/cuts.h"
#include "stepper/guarded.h"
#include "stepper/stages.h"
#include "stepper/step.h"

#include <algorithm>
#include <vector>

namespace hawser::stepper {
namespace {

/// What the trial step says about the torques on a body, for its gyroscopic impulse.
void keep_spin_change(model::Bodies& bodies, const assembly::View& v, std::int32_t body) noexcept {
    const double* w = v.v_new + v.dof_begin[body] + 3;
    const double* r = &bodies.r[9 * at(body)];
    double change[3];
    for (std::size_t i = 0; i < 3; ++i) change[i] = w[i] - bodies.spin_free[3 * at(body) + i];
    for (std::size_t i = 0; i < 3; ++i)
        bodies.spin_change[3 * at(body) + i] =
            r[i] * change[0] + r[3 + i] * change[1] + r[6 + i] * change[2];
}

/// Violations of all rows with every body moved by time t at its velocity.
void violations_at(StepContext& ctx, double t, std::vector<double>& g) {
    model::Bodies& b = ctx.bodies;
    g.resize(ctx.interactions.g.size());
    const auto x = b.x;
    const auto q = b.q;
    const auto r = b.r;
    for (std::int32_t body : b.moving) {
        const double* v = &b.v[at(b.dof_begin[at(body)])];
        const int dof = b.dof(body);
        if (dof == 1)
            b.x[3 * at(body)] += t * v[0];
        else
            b.drift(body, v, dof == 6 ? v + 3 : nullptr, t);
    }
    for (std::int32_t body : b.driven) {
        const double* v = &b.v_fixed[6 * at(body)];
        b.drift(body, v, v + 3, t);
    }
    place_images(ctx);
    evaluate_rows(ctx);
    std::copy(ctx.interactions.g.begin(), ctx.interactions.g.end(), g.begin());
    b.x = x;
    b.q = q;
    b.r = r;
}

/// Ġ v of every row [m/s² or rad/s²]: the second difference of g along the motion. Zero for
/// velocity rows.
std::vector<double> row_curvature(StepContext& ctx) {
    std::vector<double> before, now, after;
    const double h = ctx.def.step;
    violations_at(ctx, -h, before);
    violations_at(ctx, h, after);
    violations_at(ctx, 0.0, now);
    for (std::size_t i = 0; i < now.size(); ++i)
        now[i] = (before[i] + after[i] - 2.0 * now[i]) / (h * h);
    return now;
}

/// The trial steps; on success v₋ has replaced v₀.
Status try_stagger(StepContext& ctx) noexcept {
    std::vector<double> curvature;
    base::Array<double> active;
    const Status room = guarded(ctx, [&] {
        curvature = row_curvature(ctx);
        active = ctx.interactions.active;
    });
    if (room != Status::ok) return room;
    const assembly::View v = view(ctx);
    // The first trial finds λ without geometric stiffness, the second uses it.
    for (int trial = 0; trial < 2; ++trial) {
        assemble_rows(ctx);
        for (std::size_t i = 0; i < curvature.size(); ++i)
            ctx.interactions.c[i] -= ctx.def.step * curvature[i];
        ctx.rhs_ready = false;
        const Status status = solve_assembled(ctx);
        if (status != Status::ok) return status;
        for (std::int32_t body : ctx.bodies.rigid) keep_spin_change(ctx.bodies, v, body);
    }
    for (std::int32_t i = 0; i < ctx.bodies.dofs; ++i) v.v[i] -= 0.5 * (v.v_new[i] - v.v[i]);
    calm_start(ctx);
    // Which lines are slack is for the first step to find, and to report.
    std::copy(active.begin(), active.end(), ctx.interactions.active.begin());
    return Status::ok;
}

}  // namespace

/// The acceleration at time 0 obeys g̈ = G a + Ġ v = 0 on a rigid row. A trial step at the
/// velocity v₀ asks for G v₊ = G v₀ there, so h Ġ v is taken off its right-hand side; on a soft
/// row that changes v₋ by O(h²) only.
///
/// When it fails the world has not started: nothing of a trial remains, and the next step tries
/// again.
Status stagger(StepContext& ctx) noexcept {
    if (!ctx.def.staggered_start) {
        ctx.started = true;
        return Status::ok;
    }
    ctx.undo.keep_motion(ctx);
    remember(ctx);
    const Status status = try_stagger(ctx);
    ctx.started = status == Status::ok;
    return status;
}

}  // namespace hawser::stepper
