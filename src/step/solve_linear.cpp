// SPDX-License-Identifier: Apache-2.0
#include "step/solve_linear.h"

#include "context/timer.h"
#include "methods/nonsmooth.h"
#include "solve/active_set.h"
#include "solve/solve.h"

namespace hawser::stepper {

Status solve_linear(StepContext& ctx) noexcept {
    if (ctx.model.def.nonsmooth == Nonsmooth::pgs) return timed(ctx, Stage::nonsmooth, solve_pgs);
    if (ctx.model.system.contacts.count() > 0) return timed(ctx, Stage::nonsmooth, solve_contacts);
    const Status status = factor_and_solve(ctx);
    return status == Status::ok ? timed(ctx, Stage::nonsmooth, settle_bounds) : status;
}

}  // namespace hawser::stepper
