// SPDX-License-Identifier: Apache-2.0
#include "step/completion.h"

#include "access/remember.h"
#include "access/sweeps.h"
#include "access/view.h"
#include "base/index.h"
#include "contact/newton.h"
#include "context/completion_data.h"
#include "context/context.h"
#include "graph/bridges.h"
#include "solve/active_set.h"
#include "solve/joints.h"
#include "solve/self_stress.h"
#include "solve/solve.h"
#include "step/assemble_rows.h"
#include "step/contact.h"
#include "step/solve_linear.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace hawser::stepper {
namespace {

using assembly::Turning;

/// A round's change below which the step has ended [m/s or rad/s], of bodies that turn by up to
/// kSlowTurn [rad/s]; of faster ones with the cube of that. Near singular poses of closed loops
/// less would only add rounding, but who asks for solutions below kSolution gets it.
constexpr double kTurning = 1e-7, kSlowTurn = 5.0, kSolution = 1e-10;
constexpr int kMostRounds = 12;
constexpr double kGap = 1e-4;  ///< Largest gap that a step may leave [m or rad].
constexpr double kTooFast = 2.0 * kResolvedSwing;  ///< s by the step's own force that ends a trial.

/// Rounds with the factorisation at hand. @return how the last one ended; not finite or too large:
/// they did not converge.
Turning make_rounds(StepContext& ctx) noexcept {
    double first = 0.0;
    const double enough = kTurning * std::min(1.0, ctx.model.def.solution_tolerance / kSolution);
    const auto ended = [enough](const Turning& turning) {
        const double fast = std::max(1.0, turning.spin / kSlowTurn);
        return turning.change <= enough * fast * fast * fast;
    };
    Turning t = renew_completed(ctx);
    for (int round = 0; round < kMostRounds && !ended(t); ++round) {
        adopt_completed(ctx);
        continue_with_factor(ctx);
        ctx.work.solve.losses_known = false;
        ++ctx.work.stats.completion_rounds;
        t = renew_completed(ctx);
        if (round == 0) first = t.change;
        constexpr double kGrowth = 4.0;
        if (!std::isfinite(t.change) || (round > 1 && t.change > kGrowth * first)) {
            t.gap = 1e300;
            break;
        }
    }
    ctx.work.stats.completion_change = t.change;
    return t;
}

/// Solve the step again, with the joints that choose_completed() now chooses.
Status assemble_and_solve(StepContext& ctx) noexcept {
    if (ctx.model.collider.count() > 0)
        if (const Status s = start_contacts(ctx, Phase::regular); s != Status::ok) return s;
    assemble_rows(ctx);
    return solve_linear(ctx);
}

/// The same with all joints linearised once.
Status solve_linearised(StepContext& ctx) noexcept {
    ctx.model.completion.banned = true;
    ++ctx.work.stats.completion_failures;
    recall(ctx);
    return assemble_and_solve(ctx);
}

/// Whether the force of a joint has grown within the step beyond what it was solved with: that of a
/// completed one that swings too fast now, which is refused, or of another whose stiffness was that
/// of a much smaller force. @param k  Its place among the joints.
bool has_outgrown(Model& model, std::int32_t k) noexcept {
    Completion& c = model.completion;
    const model::Interactions& in = model.interactions;
    const std::int32_t id = c.joints[at(k)];
    // The force of what repeats others is not known before the filter.
    if (in.repeats[at(id)]) return false;
    if (in.completed[at(id)]) {
        if (squared_swing(model, k, in.lambda.data()) <= kTooFast * kTooFast) return false;
        c.refused[at(k)] = 1;
        return true;
    }
    constexpr double kGrown = 1.5;
    const JointPlace& joint = c.places[at(k)];
    return !(squared_impulse(joint, in.lambda.data()) <=
                 kGrown * kGrown * squared_impulse(joint, c.lambda_with.data()) ||
             squared_swing(model, k, in.lambda.data()) <= kResolvedSwing * kResolvedSwing);
}

/// @return whether there are such joints.
bool outgrown(StepContext& ctx) noexcept {
    std::atomic<bool> found{false};  // no order: it is only ever set
    const auto count = static_cast<std::int32_t>(ctx.model.completion.joints.size());
    over(ctx.pool, count, [&](std::int32_t a, std::int32_t b) {
        bool any = false;
        for (std::int32_t k = a; k < b; ++k) any |= has_outgrown(ctx.model, k);
        if (any) found.store(true, std::memory_order_relaxed);
    });
    return found.load(std::memory_order_relaxed);
}

/// Solve the step again with the stiffness of the forces that have been found, where they are
/// larger.
Status solve_with_new_forces(StepContext& ctx) noexcept {
    model::Interactions& in = ctx.model.interactions;
    Completion& c = ctx.model.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        const std::int32_t id = c.joints[k];
        const bool larger =
            in.swing[at(id)] > 0.0 && squared_impulse(c.places[k], in.lambda.data()) >
                                          squared_impulse(c.places[k], c.lambda_with.data());
        const auto row = in.row_begin[at(id)];
        if (larger) std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &c.lambda_with[at(row)]);
    }
    recall(ctx);
    ++ctx.work.stats.restiffened;
    for (const std::int32_t id : c.joints)
        std::copy_n(&c.lambda_with[at(in.row_begin[at(id)])], in.rows[at(id)],
                    &in.lambda[at(in.row_begin[at(id)])]);
    return assemble_and_solve(ctx);
}

/// Refinement, and rows at their bounds that rounds have moved across.
Status settle_free(StepContext& ctx) noexcept {
    constexpr int kMost = 4;
    Status status = Status::ok;
    for (int i = 0; i < kMost && status == Status::ok; ++i) {
        status = settle_rounds(ctx, ctx.work.stats.completion_rounds == 0);
        const std::int32_t before = ctx.work.stats.factorisations;
        if (status == Status::ok) status = settle_bounds(ctx);
        if (ctx.work.stats.factorisations == before || status != Status::ok) break;
        (void)make_rounds(ctx);
    }
    return status;
}

/// The same where something touches.
Status settle_touching(StepContext& ctx) noexcept {
    constexpr int kMost = 4;
    Status status = settle_newton(ctx);
    for (int i = 0; i < kMost && status == Status::ok && rows_ask(ctx); ++i) {
        status = settle_rows(ctx);
        if (status != Status::ok) break;
        (void)make_rounds(ctx);
        status = settle_newton(ctx);
    }
    return status;
}

/// What follows the rounds: laws of contacts, rows at their bounds, refinement. What another round
/// would change is measured again where that took substitutions.
Status settle(StepContext& ctx) noexcept {
    const std::int32_t before = ctx.work.stats.substitutions;
    const bool contacts = ctx.model.system.contacts.count() > 0;
    const Status status = contacts ? settle_touching(ctx) : settle_free(ctx);
    if (status == Status::ok && ctx.work.stats.substitutions != before)
        ctx.work.stats.completion_change = renew_completed(ctx).change;
    return status;
}

}  // namespace

Status complete(StepContext& ctx) noexcept {
    Status status = Status::ok;
    constexpr int kMostGrowths = 2;  // times that a step is solved again for them
    if (ctx.state.started)
        for (int i = 0; i < kMostGrowths && status == Status::ok && outgrown(ctx); ++i)
            status = solve_with_new_forces(ctx);
    if (ctx.model.completion.any && status == Status::ok) {
        const Turning t = make_rounds(ctx);
        status = t.gap <= kGap ? settle(ctx) : solve_linearised(ctx);
    }
    if (status == Status::ok) take_self_stress(ctx);
    return status;
}

Status solve_assembled(StepContext& ctx) noexcept {
    const Status status = solve_linear(ctx);
    return status == Status::ok ? complete(ctx) : status;
}

}  // namespace hawser::stepper
