// SPDX-License-Identifier: Apache-2.0
#include "context/asleep.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::context {

void reserve_sleep(const Model& model, Sleep& sleep) {
    sleep.island.resize(at(model.bodies.count()));
    sleep.mark.resize(at(model.bodies.count()));
}

void wake_all(Model& model, StepStats& stats) noexcept {
    std::fill(model.bodies.asleep.begin(), model.bodies.asleep.end(), std::uint8_t{0});
    std::fill(model.bodies.quiet.begin(), model.bodies.quiet.end(), 0);
    stats.asleep = 0;
}

void check_asleep(Model& model, StepStats& stats) noexcept {
    for (std::int32_t b = 0; b < model.bodies.count(); ++b) {
        std::uint8_t& flag = model.bodies.asleep[at(b)];
        flag = flag != 0 && moves(model.bodies, b) ? 1 : 0;
        std::int32_t& quiet = model.bodies.quiet[at(b)];
        quiet = std::clamp(quiet, 0, kMaxQuiet);
    }
    stats.asleep = static_cast<std::int32_t>(
        std::count(model.bodies.asleep.begin(), model.bodies.asleep.end(), std::uint8_t{1}));
}

void wake_islands_of(Model& model) noexcept {
    std::fill(model.bodies.quiet.begin(), model.bodies.quiet.end(), 0);
}

void wake_island(Model& model, std::int32_t body) noexcept {
    if (moves(model.bodies, body)) model.bodies.quiet[at(body)] = 0;
}

}  // namespace hawser::context
