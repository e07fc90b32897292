// SPDX-License-Identifier: Apache-2.0
#include "failure.h"

namespace hawser::cli {

std::string failure(const StepStats& stats) {
    if (stats.status == Status::over_bound) return to_string(stats.bound_met);
    return to_string(stats.status);
}

}  // namespace hawser::cli
