// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_accuracy.h
/// Measured error of wave velocities. In waves of more than 16 components, loads on lines, rods and
/// hulls use sums in single precision. sea_accuracy() compares them with sums in double precision
/// (docs/theory/waves.md).

#include <hawser/id.h>

#include <cstdint>

namespace hawser {

class World;

/// Error of the water velocities of the last step.
struct SeaAccuracy {
    double significant = 0.0;  ///< Significant orbital velocity at still water [m/s].
    double error = 0.0;        ///< Largest error of a velocity over `significant` [1].
    double tolerance =
        0.0;  ///< Upper bound of `error` [1]; 0: the sea is summed in double precision.
    std::int64_t points = 0;  ///< Number of compared points: nodes of lines and cells of hulls.
};

/// Compute the error of the velocities of the last step at all nodes of lines and cells of hulls.
/// This takes as long as some steps. If there is no sea, no wave or no step, `points` is 0.
[[nodiscard]] SeaAccuracy sea_accuracy(const World& world);

}  // namespace hawser
