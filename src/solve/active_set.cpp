// SPDX-License-Identifier: Apache-2.0
#include "solve/active_set.h"

#include "context/view.h"
#include "solve/bounds.h"
#include "solve/solve.h"

#include <cstdint>

namespace hawser::solve {
namespace {

constexpr int kMaxPasses = 20;

/// Switch the rows whose status does not match the current λ and v₊. In the first passes all such
/// rows switch. Because two rows could alternate forever, later only the first one switches (K. G.
/// Murty's least index rule, which terminates).
/// @return the number of such rows; from pass kMaxPasses on none is switched.
std::int32_t switch_solved(context::Model& model, context::Work& work, int pass) noexcept {
    constexpr int kSimultaneousPasses = 6;
    take_bounds(model, work.newton);
    keep_bounds(work.newton, 1.0);
    const std::int32_t rows =
        switch_bounds(model, work, 0.0, pass < kSimultaneousPasses ? kAnyRows : pass < kMaxPasses);
    work.stats.flips_left = pass < kMaxPasses ? 0 : rows;
    if (rows > 0) work.solve.rhs_ready = false;
    return rows;
}

}  // namespace

Status settle_bounds(context::StepContext& ctx) noexcept {
    constexpr int kMaxSolves = 100;  // for moving bounds
    const double tolerance = ctx.model.def.contact_tolerance;
    for (int pass = 0, solves = 0; pass <= kMaxPasses; ++solves) {
        ctx.work.stats.natural_map = bounds_map(ctx.model, ctx.work.newton);
        // At the end nothing is moved, so that λ is the solution.
        if (solves >= kMaxSolves) pass = kMaxPasses;
        Status status = Status::ok;
        const bool moved = ctx.work.stats.natural_map > tolerance;
        if (!moved && pass < kMaxPasses &&
            !any_row_requests_switch(ctx.model, ctx.work.newton, context::row_view(ctx.model))) {
            ctx.work.stats.flips_left = 0;
            break;
        }
        const std::int32_t rows = switch_solved(ctx.model, ctx.work, pass);
        if (pass == kMaxPasses || (rows == 0 && !moved)) break;
        if (rows > 0) {
            ++pass;
            status = factor_and_solve(ctx);
        } else {
            continue_with_factor(ctx);
            status = refine(ctx);
        }
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

Status follow_loads(context::StepContext& ctx) noexcept {
    constexpr int kMaxLoadIterations = 8;
    Status status = Status::ok;
    ctx.work.newton.follow.restart();
    for (int i = 0; i < kMaxLoadIterations && status == Status::ok; ++i) {
        if (!(bounds_map(ctx.model, ctx.work.newton) > ctx.model.def.contact_tolerance)) break;
        if (asking_rows(ctx.model, ctx.work, ctx.model.contact_floor) > 0) break;
        (void)switch_bounds(ctx.model, ctx.work, ctx.model.contact_floor, kAnyRows);
        continue_with_factor(ctx);
        status = refine(ctx);
    }
    return status;
}

bool update_active_set(context::Model& model, context::Work& work, int pass) noexcept {
    const bool moved = bounds_map(model, work.newton) > model.def.contact_tolerance;
    const std::int32_t rows = switch_solved(model, work, pass);
    return pass < kMaxPasses && (rows > 0 || moved);
}

}  // namespace hawser::solve
