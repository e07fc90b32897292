// SPDX-License-Identifier: Apache-2.0
#include "access/remember.h"

#include <algorithm>

namespace hawser::stepper {

void remember(StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.interactions;
    std::copy(in.lambda.begin(), in.lambda.end(), ctx.lambda_before.begin());
    std::copy(in.repeats.begin(), in.repeats.end(), ctx.repeats_before.begin());
    ctx.remembered = true;
    ctx.refine_unasked_before = ctx.refine_unasked;
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i)
        ctx.active_before[i] = in.active[static_cast<std::size_t>(ctx.system.bounded[i])];
}

void recall(StepContext& ctx) noexcept {
    model::Interactions& in = ctx.interactions;
    std::copy(ctx.lambda_before.begin(), ctx.lambda_before.end(), in.lambda.begin());
    std::copy(ctx.repeats_before.begin(), ctx.repeats_before.end(), in.repeats.begin());
    ctx.refine_unasked = ctx.refine_unasked_before;
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i)
        in.active[static_cast<std::size_t>(ctx.system.bounded[i])] = ctx.active_before[i];
}

}  // namespace hawser::stepper
