// SPDX-License-Identifier: Apache-2.0
#include "step/completion.h"

#include "base/index.h"
#include "contact/newton.h"
#include "context/completion_data.h"
#include "context/context.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "graph/bridges.h"
#include "solve/active_set.h"
#include "solve/joints.h"
#include "solve/self_stress.h"
#include "solve/solve.h"
#include "state/remember.h"
#include "step/assemble_rows.h"
#include "step/contact.h"
#include "step/solve_linear.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace hawser::step {
namespace {

using context::IterationChange;

/// Change of an iteration at which the step ends [m/s or rad/s], if bodies turn by up to kSlowTurn
/// [rad/s]. For faster ones it is multiplied by the cube of the ratio. Near singular poses of
/// closed loops a smaller limit would only add rounding. A user who requests solutions below
/// kSolution gets it.
constexpr double kTurning = 1e-7, kSlowTurn = 5.0, kSolution = 1e-10;
constexpr int kMaxRounds = 12;
constexpr double kGap = 1e-4;  ///< Maximum gap that a step may leave [m or rad].
/// Value of s from the force of the step itself that ends a trial.
constexpr double kTooFast = 2.0 * solve::kResolvedVibration;

/// Perform end-of-step constraint iterations with the present factorisation. @return result of the
/// last iteration; the iterations diverged if it is not finite or too large.
IterationChange iterate_joints(context::StepContext& ctx) noexcept {
    double first = 0.0;
    const double enough = kTurning * std::min(1.0, ctx.model.def.solution_tolerance / kSolution);
    const auto change_of = [](const IterationChange& turning) {
        return turning.weighted > turning.change ? turning.weighted : turning.change;
    };
    const auto ended = [&](const IterationChange& turning) {
        const double fast = std::max(1.0, turning.spin / kSlowTurn);
        return change_of(turning) <= enough * fast * fast * fast;
    };
    IterationChange t = solve::renew_completed(ctx);
    for (int round = 0; round < kMaxRounds && !ended(t); ++round) {
        solve::adopt_completed(ctx);
        solve::continue_with_factor(ctx);
        ctx.work.solve.losses_known = false;
        ++ctx.work.stats.completion_rounds;
        t = solve::renew_completed(ctx);
        if (round == 0) first = change_of(t);
        constexpr double kGrowth = 4.0;
        if (!std::isfinite(t.change) || (round > 1 && change_of(t) > kGrowth * first)) {
            t.gap = 1e300;
            break;
        }
    }
    ctx.work.stats.completion_change = t.change;
    return t;
}

/// Solve the step again, with the joints that choose_completed() now selects.
Status assemble_and_solve(context::StepContext& ctx) noexcept {
    if (ctx.model.collider.count() > 0)
        if (const Status s = start_contacts(ctx, Phase::regular); s != Status::ok) return s;
    assemble_rows(ctx);
    return solve_linear(ctx);
}

/// Solve the step again with all joints linearised once, without end-of-step constraint iterations.
Status solve_linearised(context::StepContext& ctx) noexcept {
    ctx.model.completion.banned = true;
    ++ctx.work.stats.completion_failures;
    state::restore_solved_state(ctx);
    return assemble_and_solve(ctx);
}

/// True if the force of a joint has become much larger within the step than the value used in the
/// solution. A completed joint then oscillates too fast and is rejected; for another joint the
/// stiffness used is too small. @param k  Index of the joint. @param iterated  True after the
/// iterations. Before them the force of a compliant joint is that of linearised rows.
bool has_outgrown(context::Model& model, std::int32_t k, bool iterated) noexcept {
    context::Completion& c = model.completion;
    const model::Interactions& in = model.interactions;
    const std::int32_t id = c.joints[at(k)];
    // The force of a redundant joint is not known before the filter.
    if (in.repeats[at(id)]) return false;
    if (in.completed[at(id)] == assembly::kCompliant && !iterated) return false;
    if (in.completed[at(id)]) {
        if (solve::squared_vibration(model, k, in.lambda.data()) <= kTooFast * kTooFast)
            return false;
        c.refused[at(k)] = 1;
        return true;
    }
    constexpr double kGrown = 1.5;
    const context::JointSlot& joint = c.joint_slots[at(k)];
    return !(solve::squared_impulse(joint, in.lambda.data()) <=
                 kGrown * kGrown * solve::squared_impulse(joint, c.lambda_with.data()) ||
             solve::squared_vibration(model, k, in.lambda.data()) <=
                 solve::kResolvedVibration * solve::kResolvedVibration);
}

/// Check all joints by has_outgrown(). @return true if it is true for any joint.
bool outgrown(context::StepContext& ctx, bool iterated) noexcept {
    std::atomic<bool> found{false};  // without order: it is only set
    const auto count = static_cast<std::int32_t>(ctx.model.completion.joints.size());
    context::over(ctx.pool, count, [&](std::int32_t a, std::int32_t b) {
        bool any = false;
        for (std::int32_t k = a; k < b; ++k) any |= has_outgrown(ctx.model, k, iterated);
        if (any) found.store(true, std::memory_order_relaxed);
    });
    return found.load(std::memory_order_relaxed);
}

/// Solve the step again with the geometric stiffness of the new forces, if the forces have grown.
Status solve_with_new_forces(context::StepContext& ctx) noexcept {
    model::Interactions& in = ctx.model.interactions;
    context::Completion& c = ctx.model.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        const std::int32_t id = c.joints[k];
        const bool larger = in.vibration[at(id)] > 0.0 &&
                            solve::squared_impulse(c.joint_slots[k], in.lambda.data()) >
                                solve::squared_impulse(c.joint_slots[k], c.lambda_with.data());
        const auto row = in.row_begin[at(id)];
        if (larger) std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &c.lambda_with[at(row)]);
    }
    state::restore_solved_state(ctx);
    ++ctx.work.stats.restiffened;
    for (const std::int32_t id : c.joints)
        std::copy_n(&c.lambda_with[at(in.row_begin[at(id)])], in.rows[at(id)],
                    &in.lambda[at(in.row_begin[at(id)])]);
    return assemble_and_solve(ctx);
}

/// Refine the solution, and switch rows that the iterations have moved across their bounds.
Status settle_free(context::StepContext& ctx) noexcept {
    constexpr int kMaximum = 4;
    Status status = Status::ok;
    for (int i = 0; i < kMaximum && status == Status::ok; ++i) {
        status = solve::settle_iterations(ctx, ctx.work.stats.completion_rounds == 0);
        const std::int32_t before = ctx.work.stats.factorisations;
        if (status == Status::ok) status = solve::settle_bounds(ctx);
        if (ctx.work.stats.factorisations == before || status != Status::ok) break;
        (void)iterate_joints(ctx);
    }
    return status;
}

/// Refine a solution with contacts, and switch rows as in settle_free().
Status settle_touching(context::StepContext& ctx) noexcept {
    constexpr int kMaximum = 4;
    Status status = contact::settle_newton(ctx);
    for (int i = 0; i < kMaximum && status == Status::ok && contact::rows_request_switch(ctx);
         ++i) {
        status = contact::settle_rows(ctx);
        if (status != Status::ok) break;
        (void)iterate_joints(ctx);
        status = contact::settle_newton(ctx);
    }
    return status;
}

/// Finish the iterations: satisfy the contact laws, switch bounded rows, and refine. If this needed
/// substitutions, the change of a further iteration is measured again.
Status settle(context::StepContext& ctx) noexcept {
    const std::int32_t before = ctx.work.stats.substitutions;
    const bool contacts = ctx.model.system.contacts.count() > 0;
    const Status status = contacts ? settle_touching(ctx) : settle_free(ctx);
    if (status == Status::ok && ctx.work.stats.substitutions != before)
        ctx.work.stats.completion_change = solve::renew_completed(ctx).change;
    return status;
}

constexpr int kMaxGrowths = 2;  // number of repeated solves for new forces

/// Iterate and finish. The step is solved again if a compliant joint vibrates too fast with the
/// force that the iterations find.
Status iterate_and_settle(context::StepContext& ctx) noexcept {
    IterationChange t = iterate_joints(ctx);
    for (int i = 0; i < kMaxGrowths && t.gap <= kGap && ctx.model.completion.any_compliant &&
                    outgrown(ctx, true);
         ++i) {
        const Status status = solve_with_new_forces(ctx);
        if (status != Status::ok || !ctx.model.completion.any) return status;
        t = iterate_joints(ctx);
    }
    return t.gap <= kGap ? settle(ctx) : solve_linearised(ctx);
}

}  // namespace

Status complete(context::StepContext& ctx) noexcept {
    Status status = Status::ok;
    if (ctx.state.started)
        for (int i = 0; i < kMaxGrowths && status == Status::ok && outgrown(ctx, false); ++i)
            status = solve_with_new_forces(ctx);
    if (ctx.model.completion.any && status == Status::ok) status = iterate_and_settle(ctx);
    if (status == Status::ok) solve::take_self_stress(ctx);
    return status;
}

Status solve_assembled(context::StepContext& ctx) noexcept {
    const Status status = solve_linear(ctx);
    return status == Status::ok ? complete(ctx) : status;
}

}  // namespace hawser::step
