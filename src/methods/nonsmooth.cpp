// SPDX-License-Identifier: Apache-2.0
#include "methods/nonsmooth.h"

#include "contact/newton.h"

namespace hawser::stepper {

void begin_contacts(StepContext& ctx) noexcept {
    switch (ctx.model.def.nonsmooth) {
        case Nonsmooth::newton:
            return begin_newton(ctx);
        case Nonsmooth::pivoting:
            return begin_pivoting(ctx);
        case Nonsmooth::split:
            return begin_split(ctx);
        case Nonsmooth::convex:
            return begin_convex(ctx);
        case Nonsmooth::pgs:
            return begin_pgs(ctx);
    }
}

Status solve_contacts(StepContext& ctx) noexcept {
    switch (ctx.model.def.nonsmooth) {
        case Nonsmooth::pivoting:
            return solve_pivoting(ctx);
        case Nonsmooth::split:
            return solve_split(ctx);
        case Nonsmooth::convex:
            return solve_convex(ctx);
        default:
            return solve_newton(ctx, ctx.model.completion.any);
    }
}

}  // namespace hawser::stepper
