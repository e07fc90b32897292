// SPDX-License-Identifier: Apache-2.0
#include "access/asleep.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::stepper {

void reserve_sleep(StepContext& ctx) {
    ctx.work.sleep.island.resize(at(ctx.model.bodies.count()));
    ctx.work.sleep.mark.resize(at(ctx.model.bodies.count()));
}

void wake_all(StepContext& ctx) noexcept {
    std::fill(ctx.model.bodies.asleep.begin(), ctx.model.bodies.asleep.end(), std::uint8_t{0});
    std::fill(ctx.model.bodies.quiet.begin(), ctx.model.bodies.quiet.end(), 0);
    ctx.work.stats.asleep = 0;
}

void check_asleep(StepContext& ctx) noexcept {
    for (std::int32_t b = 0; b < ctx.model.bodies.count(); ++b) {
        std::uint8_t& flag = ctx.model.bodies.asleep[at(b)];
        flag = flag != 0 && moves(ctx.model.bodies, b) ? 1 : 0;
        std::int32_t& quiet = ctx.model.bodies.quiet[at(b)];
        quiet = std::clamp(quiet, 0, kMostQuiet);
    }
    ctx.work.stats.asleep = static_cast<std::int32_t>(std::count(
        ctx.model.bodies.asleep.begin(), ctx.model.bodies.asleep.end(), std::uint8_t{1}));
}

void disturb_all(StepContext& ctx) noexcept {
    std::fill(ctx.model.bodies.quiet.begin(), ctx.model.bodies.quiet.end(), 0);
}

void disturb(StepContext& ctx, std::int32_t body) noexcept {
    if (moves(ctx.model.bodies, body)) ctx.model.bodies.quiet[at(body)] = 0;
}

}  // namespace hawser::stepper
