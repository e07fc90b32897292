// SPDX-License-Identifier: Apache-2.0
#include "failure.h"

#include <hawser/system.h>

namespace hawser::cli {

std::string failure(const World& world) {
    const StepStats& stats = world.stats();
    if (stats.status == Status::over_bound) return to_string(stats.bound_met);
    const std::string why = to_string(world.bad_load(), world);
    if (why.empty()) return to_string(stats.status);
    return to_string(stats.status) + (": " + why);
}

}  // namespace hawser::cli
