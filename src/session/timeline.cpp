// SPDX-License-Identifier: Apache-2.0
#include "session/timeline.h"

#include <hawser/hawser.h>

#include <fmt/format.h>

namespace hawser::session {
namespace {

constexpr double kSlack = 1e-6;  ///< Times are multiples of the step up to rounding.

}  // namespace

void Timeline::skip(std::span<const scene::Operation> all, const World& world) noexcept {
    const double last = world.time() - (1.0 - kSlack) * world.settings().step;
    next_ = 0;
    while (world.step_count() > 0 && next_ < all.size() && all[next_].at <= last) ++next_;
    begun_ = next_;
}

void Timeline::take(std::span<const scene::Operation> all, World& world) {
    const double now = world.time() + kSlack * world.settings().step;
    begun_ = next_;
    for (; next_ < all.size() && all[next_].at <= now; ++next_) {
        const scene::Operation& operation = all[next_];
        try {
            scene::perform(operation, world);
        } catch (const DefError& error) {
            throw DefError(fmt::format("timeline, {:.6g} s, {}: {}", operation.at,
                                       scene::to_string(operation), error.what()));
        }
    }
}

}  // namespace hawser::session
