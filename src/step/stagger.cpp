// SPDX-License-Identifier: Apache-2.0
#include "step/stagger.h"

#include "assembly/mobility.h"
#include "assembly/rows.h"
#include "base/index.h"
#include "context/copies.h"
#include "context/guarded.h"
#include "context/view.h"
#include "solve/evaluate.h"
#include "split/split.h"
#include "state/remember.h"
#include "state/undo.h"
#include "step/assemble_rows.h"
#include "step/completion.h"
#include "step/guard.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::step {
namespace {

/// Store the angular velocity change of a body due to torques in the trial step, for its gyroscopic
/// impulse.
void keep_spin_change(model::Bodies& bodies, const assembly::View& v, std::int32_t body) noexcept {
    const double* w = v.v_new + v.dof_begin[body] + 3;
    const double* r = &bodies.r[9 * at(body)];
    double change[3];
    for (std::size_t i = 0; i < 3; ++i) change[i] = w[i] - bodies.spin_free[3 * at(body) + i];
    for (std::size_t i = 0; i < 3; ++i)
        bodies.spin_change[3 * at(body) + i] =
            r[i] * change[0] + r[3 + i] * change[1] + r[6 + i] * change[2];
}

/// Compute the violations of all rows with every body moved by time t at its velocity.
void violations_at(context::Model& model, runtime::Pool& pool, double t, std::vector<double>& g) {
    model::Bodies& b = model.bodies;
    g.resize(model.interactions.g.size());
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
    split::copy_ghost_poses(model);
    solve::evaluate_rows(model, pool);
    std::copy(model.interactions.g.begin(), model.interactions.g.end(), g.begin());
    b.x = x;
    b.q = q;
    b.r = r;
}

/// Return Ġ v of every row [m/s² or rad/s²]: the second difference of g along the motion. Zero for
/// velocity rows.
std::vector<double> row_curvature(context::Model& model, runtime::Pool& pool) {
    std::vector<double> before, now, after;
    const double h = model.def.step;
    violations_at(model, pool, -h, before);
    violations_at(model, pool, h, after);
    violations_at(model, pool, 0.0, now);
    for (std::size_t i = 0; i < now.size(); ++i)
        now[i] = (before[i] + after[i] - 2.0 * now[i]) / (h * h);
    return now;
}

/// Return h²W/4ε of a row that stores energy: (hω)²/4 of its vibration with its bodies.
double vibration_of(const context::Model& model, std::int32_t id, int r) {
    const model::Interactions& in = model.interactions;
    const auto row = at(in.row_begin[at(id)] + r);
    if ((in.row_flags[row] & model::kRowVelocity) ||
        !model::holds_energy(in.epsilon[row], in.rest_length[at(id)]))
        return 0.0;
    const double h = model.def.step;
    return 0.25 * h * h * assembly::mobility(model.bodies, in, id, r) / in.epsilon[row];
}

/// Correct the initial energy of springs that the step does not resolve.
///
/// Let z = h²W/4ε. An unstretched spring with the stretching speed w is off by hw/2 half a step
/// earlier in the scheme. Its energy is then (1 + z) w²/2W, of which only w²/2W is physical. At the
/// speed w/√(1 + z) the energy is correct. Up to z = ¼ the staggered start suffices, which is of
/// second order.
///
/// @param add  True to add to the right-hand side of a trial, so that half of the change gives v₋.
/// @return true if there is such a spring.
bool slow_springs(context::Model& model, bool add) noexcept {
    const assembly::View v = context::row_view(model);
    constexpr double kResolvedFraction = 0.25;
    bool any = false;
    for (std::int32_t id = 0; id < context::interaction_count(model); ++id) {
        // Wires are treated by keep_start_velocities().
        if (model.system.rests(id) || v.active[id] == 0.0 || model.wires.wire_of[at(id)] >= 0)
            continue;
        double room[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, room);
        for (int r = 0; r < v.rows[id]; ++r) {
            const double speed = assembly::along_row(v, id, jac, v.v, v.dof_begin);
            const double z = speed == 0.0 ? 0.0 : vibration_of(model, id, r);
            if (!(z > kResolvedFraction)) continue;
            any = true;
            const double less = (1.0 - 1.0 / std::sqrt(1.0 + z)) * (1.0 + z) / z;
            if (add) v.c[v.row_begin[id] + r] += 2.0 * less * speed;
        }
    }
    return any;
}

/// Let the end of a range limit a trial only beyond the initial speed: an approaching coordinate
/// keeps its speed, like a contact.
void keep_approach(context::Model& model, const assembly::View& v) noexcept {
    for (const std::int32_t id : model.system.bounded) {
        const std::int32_t row = v.row_begin[id];
        if ((v.flags[id] & model::kRange) == 0 || v.g[row] != 0.0 || v.parted[id] != 0) continue;
        double buffer[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, buffer);
        const double speed = assembly::along_row(v, id, jac, v.v, v.dof_begin);
        v.c[row] = v.upper[id] != 0 ? std::max(v.c[row], speed) : std::min(v.c[row], speed);
    }
}

/// Set v to v₋ = v₀ − (v₊ − v₀)/2, from a trial.
void step_back(const context::Model& model, const assembly::View& v) noexcept {
    for (std::int32_t i = 0; i < model.bodies.dofs; ++i) v.v[i] -= 0.5 * (v.v_new[i] - v.v[i]);
}

/// Compute the remainder d₋ − G v₋ + (h/2) Ġv of compliant joints (step/completion.h), of second
/// order in h. Their law uses d₋, but a trial solves for G v₋ alone. A stiff row would store the
/// remainder as elastic energy.
///
/// @param curvature  Ġv. @param remainders  By row.
/// @return the largest change of a remainder [m/s or rad/s].
double renew_remainders(context::Model& model, const std::vector<double>& curvature,
                        std::vector<double>& remainders) noexcept {
    const assembly::View v = context::row_view(model);
    const double h = model.def.step;
    double most = 0.0;
    for (std::int32_t id = 0; id < context::interaction_count(model); ++id) {
        if (model.system.rests(id) || !model.interactions.uses_secants(id)) continue;
        double secant[kMaxInteractionRows];
        model.interactions.secants_before(id, model.bodies, h, secant);
        const model::RowState now = model.interactions.row_state(id, model.bodies);
        for (int r = 0; r < v.rows[id]; ++r) {
            const auto row = at(v.row_begin[id] + r);
            const double left = secant[r] - now.rate[r] - now.carried[r] + 0.5 * h * curvature[row];
            most = std::max(most, std::fabs(left - remainders[row]));
            remainders[row] = left;
        }
    }
    return most;
}

/// Compute v₊ and λ of a start at time 0.
/// @param remainders  By row; half of the change of v₊ removes them from v₋.
Status try_step(context::StepContext& ctx, const std::vector<double>& curvature,
                const std::vector<double>& remainders, bool slower) noexcept {
    assemble_rows(ctx);
    for (std::size_t i = 0; i < curvature.size(); ++i)
        ctx.model.interactions.c[i] -= ctx.model.def.step * curvature[i] - 2.0 * remainders[i];
    keep_approach(ctx.model, context::row_view(ctx.model));
    if (slower) (void)slow_springs(ctx.model, true);
    ctx.work.solve.rhs_ready = false;
    return solve_assembled(ctx);
}

/// Run the trial steps. On success v₋ replaces v₀.
Status try_stagger(context::StepContext& ctx) noexcept {
    std::vector<double> curvature, remainders;
    base::Array<double> active, lambda, start;
    const Status room = context::guarded(ctx, [&] {
        curvature = row_curvature(ctx.model, ctx.pool);
        active = ctx.model.interactions.active;
        lambda = ctx.model.interactions.lambda;
        start = ctx.model.bodies.v;
        remainders.assign(curvature.size(), 0.0);
    });
    if (room != Status::ok) return room;
    const assembly::View v = context::row_view(ctx.model);
    // The first trial computes λ without geometric stiffness, the second uses it.
    for (int trial = 0; trial < 2; ++trial) {
        if (const Status s = try_step(ctx, curvature, remainders, false); s != Status::ok) return s;
        for (std::int32_t body : ctx.model.bodies.rigid)
            keep_spin_change(ctx.model.bodies, v, body);
    }
    const bool slower = slow_springs(ctx.model, false);
    std::copy(ctx.model.interactions.lambda.begin(), ctx.model.interactions.lambda.end(),
              lambda.begin());
    if (slower) {
        if (const Status s = try_step(ctx, curvature, remainders, true); s != Status::ok) return s;
    }
    // A pass changes v₋ and thus the remainders, by third order in h. Passes end at 1e-9 m/s, a
    // hundredth of the change at which the iterations of a step end.
    constexpr int kMaxPasses = 3;
    constexpr double kEnough = 1e-9;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        step_back(ctx.model, v);
        const double change = renew_remainders(ctx.model, curvature, remainders);
        std::copy(start.begin(), start.end(), ctx.model.bodies.v.begin());
        if (!(change > kEnough)) break;
        if (const Status s = try_step(ctx, curvature, remainders, slower); s != Status::ok)
            return s;
    }
    std::copy(lambda.begin(), lambda.end(), ctx.model.interactions.lambda.begin());
    step_back(ctx.model, v);
    keep_start_velocities(ctx.model, ctx.work.before);
    // The first step determines and reports which lines are slack.
    std::copy(active.begin(), active.end(), ctx.model.interactions.active.begin());
    return Status::ok;
}

}  // namespace

/// Start the world. The acceleration at time 0 satisfies g̈ = G a + Ġ v = 0 on a rigid row. A trial
/// step at the velocity v₀ has the right-hand side G v₊ = G v₀. Therefore h Ġ v is subtracted; on a
/// soft row this changes v₋ by O(h²) only.
///
/// If a trial fails, all its changes are undone, the world has not started, and the next step tries
/// again.
Status stagger(context::StepContext& ctx) noexcept {
    if (!ctx.model.def.staggered_start) {
        ctx.state.started = true;
        return Status::ok;
    }
    state::save_motion(ctx);
    state::save_solved_state(ctx);
    const Status status = try_stagger(ctx);
    ctx.state.started = status == Status::ok;
    return status;
}

}  // namespace hawser::step
