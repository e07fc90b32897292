// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_accuracy.h
/// Measured error of the kinematics of waves (docs/theory/waves.md).

#include <hawser/id.h>

#include <cstdint>

namespace hawser {

class World;

/// Velocities of the last step against sums in double precision of all components.
struct SeaAccuracy {
    double significant = 0.0;  ///< Significant orbital velocity at still water [m/s].
    double error = 0.0;        ///< Largest error of a velocity, over the significant one [1].
    double tolerance = 0.0;    ///< Bound of it; 0: the sea is summed in double precision [1].
    std::int64_t points = 0;   ///< Nodes of lines and cells of hulls that were compared.
};

/// Compare the water at all nodes of lines and cells of hulls at the last step. Takes as long as
/// some steps. Without a sea, waves or a step `points` is 0.
[[nodiscard]] SeaAccuracy sea_accuracy(const World& world);

}  // namespace hawser
