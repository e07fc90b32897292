// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_gear.h
/// Random scenes with winches, guides and hulls (random_gear_cases.h). Each run that ends ok is
/// checked by the full verifier, and compared with the same scene at a quarter of the step.

#include "random_gear_cases.h"

#include <cstdint>
#include <string>

namespace hawser::bench {

struct GearOptions {
    GearFamily family = GearFamily::winches;
    std::uint64_t seed = 1;
    int count = 2000, shown = 20;
    std::int64_t only = -1;  ///< Run this case alone and print its comparison.
    std::string json;
};

/// Run the cases. @return exit code: 0 if enough runs ended ok and none of these was wrong.
int run_gear(const GearOptions& options);

}  // namespace hawser::bench
