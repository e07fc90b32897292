// SPDX-License-Identifier: Apache-2.0
#include "state/remember.h"

#include <algorithm>

namespace hawser::state {

void save_solved_state(context::StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    std::copy(in.lambda.begin(), in.lambda.end(), ctx.work.before.lambda.begin());
    std::copy(in.repeats.begin(), in.repeats.end(), ctx.work.before.repeats.begin());
    ctx.work.before.remembered = true;
    ctx.work.before.refine_unasked = ctx.state.refine_unasked;
    for (std::size_t i = 0; i < ctx.work.before.active.size(); ++i)
        ctx.work.before.active[i] =
            in.active[static_cast<std::size_t>(ctx.model.system.bounded[i])];
}

void restore_solved_state(context::StepContext& ctx) noexcept {
    model::Interactions& in = ctx.model.interactions;
    std::copy(ctx.work.before.lambda.begin(), ctx.work.before.lambda.end(), in.lambda.begin());
    std::copy(ctx.work.before.repeats.begin(), ctx.work.before.repeats.end(), in.repeats.begin());
    ctx.state.refine_unasked = ctx.work.before.refine_unasked;
    for (std::size_t i = 0; i < ctx.work.before.active.size(); ++i)
        in.active[static_cast<std::size_t>(ctx.model.system.bounded[i])] =
            ctx.work.before.active[i];
}

}  // namespace hawser::state
