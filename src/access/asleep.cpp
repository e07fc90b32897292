// SPDX-License-Identifier: Apache-2.0
#include "access/asleep.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::stepper {

void reserve_sleep(StepContext& ctx) {
    ctx.sleep.island.resize(at(ctx.bodies.count()));
    ctx.sleep.mark.resize(at(ctx.bodies.count()));
}

void wake_all(StepContext& ctx) noexcept {
    std::fill(ctx.bodies.asleep.begin(), ctx.bodies.asleep.end(), std::uint8_t{0});
    std::fill(ctx.bodies.quiet.begin(), ctx.bodies.quiet.end(), 0);
    ctx.stats.asleep = 0;
}

void check_asleep(StepContext& ctx) noexcept {
    for (std::int32_t b = 0; b < ctx.bodies.count(); ++b) {
        std::uint8_t& flag = ctx.bodies.asleep[at(b)];
        flag = flag != 0 && moves(ctx.bodies, b) ? 1 : 0;
        std::int32_t& quiet = ctx.bodies.quiet[at(b)];
        quiet = std::clamp(quiet, 0, kMostQuiet);
    }
    ctx.stats.asleep = static_cast<std::int32_t>(
        std::count(ctx.bodies.asleep.begin(), ctx.bodies.asleep.end(), std::uint8_t{1}));
}

void disturb_all(StepContext& ctx) noexcept {
    std::fill(ctx.bodies.quiet.begin(), ctx.bodies.quiet.end(), 0);
}

void disturb(StepContext& ctx, std::int32_t body) noexcept {
    if (moves(ctx.bodies, body)) ctx.bodies.quiet[at(body)] = 0;
}

}  // namespace hawser::stepper
