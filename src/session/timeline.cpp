// SPDX-License-Identifier: Apache-2.0
#include "session/timeline.h"

#include <hawser/hawser.h>

#include <fmt/format.h>

#include <algorithm>

namespace hawser::session {
namespace {

constexpr double kSlack = 1e-6;  ///< Times are multiples of the step up to rounding.

}  // namespace

double operations_done_until(const World& world) noexcept {
    return world.time() - (1.0 - kSlack) * world.settings().step;
}

bool Timeline::sets(std::span<const scene::Operation> all, const std::string& name,
                    double after) const {
    const auto named = [&](const auto& entry) { return entry.first == name; };
    return std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(next_),
                       [&](const scene::Operation& operation) {
                           return operation.at > after &&
                                  std::any_of(operation.set.begin(), operation.set.end(), named);
                       });
}

void Timeline::skip(std::span<const scene::Operation> all, const World& world) noexcept {
    const double last = operations_done_until(world);
    next_ = 0;
    while (world.step_count() > 0 && next_ < all.size() && all[next_].at <= last) ++next_;
    begun_ = next_;
}

void Timeline::perform_due(std::span<const scene::Operation> all, World& world) {
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
