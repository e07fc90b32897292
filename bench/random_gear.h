// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_gear.h
/// Run random scenes with winches, guides and hulls (random_gear_cases.h). Each run that ends ok is
/// checked by the full verifier, and by the scene at a quarter of the step.

#include "random_gear_cases.h"

#include <cstdint>
#include <string>

namespace hawser::bench {

struct GearOptions {
    GearFamily family = GearFamily::winches;
    std::uint64_t seed = 1;
    int count = 2000, shown = 20;
    std::int64_t only = -1;  ///< Run only this case and print its comparison.
    std::string json;
};

/// Run. @return exit code: 0 if no run ended ok with an error, and enough ended ok.
int run_gear(const GearOptions& options);

}  // namespace hawser::bench
