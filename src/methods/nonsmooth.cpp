// SPDX-License-Identifier: Apache-2.0
#include "methods/nonsmooth.h"

#include "contact/newton.h"

namespace hawser::methods {

void begin_contacts(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept {
    switch (model.def.nonsmooth) {
        case Nonsmooth::newton:
            return contact::begin_newton(model, work, pool);
        case Nonsmooth::pivoting:
            return begin_pivoting(model, work.newton, pool);
        case Nonsmooth::split:
            return begin_split(model, work.newton, pool);
        case Nonsmooth::convex:
            return begin_convex(model, work.newton, pool);
        case Nonsmooth::pgs:
            return begin_pgs(model);
    }
}

Status solve_contacts(context::StepContext& ctx) noexcept {
    switch (ctx.model.def.nonsmooth) {
        case Nonsmooth::pivoting:
            return solve_pivoting(ctx);
        case Nonsmooth::split:
            return solve_split(ctx);
        case Nonsmooth::convex:
            return solve_convex(ctx);
        default:
            return contact::solve_newton(ctx, ctx.model.completion.any);
    }
}

}  // namespace hawser::methods
