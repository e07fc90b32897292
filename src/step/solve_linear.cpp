// SPDX-License-Identifier: Apache-2.0
#include "step/solve_linear.h"

#include "context/timer.h"
#include "methods/nonsmooth.h"
#include "solve/active_set.h"
#include "solve/solve.h"

namespace hawser::step {

Status solve_linear(context::StepContext& ctx) noexcept {
    if (ctx.model.def.nonsmooth == Nonsmooth::pgs)
        return context::timed(ctx, Stage::nonsmooth, methods::solve_pgs);
    if (ctx.model.system.contacts.count() > 0)
        return context::timed(ctx, Stage::nonsmooth, methods::solve_contacts);
    const Status status = solve::factor_and_solve(ctx);
    return status == Status::ok ? context::timed(ctx, Stage::nonsmooth, solve::settle_bounds)
                                : status;
}

}  // namespace hawser::step
