// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_stiffness.h
/// How stiff cuts may be before a split step is unstable.

#include <hawser/world.h>

#include <cmath>
#include <vector>

namespace hawser::bench::split {

inline constexpr double kGrowth = 1.02;  ///< Spectral radius from which a step counts as unstable.

/// Largest factor, 1e-8 to 1e2, of the stiffness of the cuts at which the step is stable.
struct Stiffness {
    double stable = 0.0;                ///< Largest factor known to be stable [1].
    double unstable = 0.0;              ///< Smallest factor known to be unstable; 0: none is [1].
    [[nodiscard]] bool found() const {  ///< Within a tenth of a decade.
        return unstable <= 0.0 || stable <= 0.0 || unstable <= stable * std::pow(10.0, 0.11);
    }
};

/// By bisection, until a tenth of a decade is left or the processor time [s] is up.
[[nodiscard]] Stiffness largest_stable(const World& world, const std::vector<InteractionId>& cuts,
                                       double seconds);

}  // namespace hawser::bench::split
