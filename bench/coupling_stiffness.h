// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_stiffness.h
/// Largest stiffness of cuts for which a split step is stable.

#include <hawser/world.h>

#include <cmath>
#include <vector>

namespace hawser::bench::split {

inline constexpr double kGrowth = 1.02;  ///< Spectral radius from which a step counts as unstable.

/// Largest stable factor of the stiffness of the cuts, 1e-8 to 1e2.
struct Stiffness {
    double stable = 0.0;                      ///< Largest factor found stable [1].
    double unstable = 0.0;                    ///< Smallest factor found unstable; 0: none [1].
    [[nodiscard]] bool is_accurate() const {  ///< True if within a tenth of a decade.
        return unstable <= 0.0 || stable <= 0.0 || unstable <= stable * std::pow(10.0, 0.11);
    }
};

/// Find it by bisection, to a tenth of a decade or until the processor time [s] is used.
[[nodiscard]] Stiffness largest_stable(const World& world, const std::vector<InteractionId>& cuts,
                                       double seconds);

}  // namespace hawser::bench::split
