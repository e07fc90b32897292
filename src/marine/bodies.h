// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bodies.h
/// Sizes of small bodies and of slender ones in the water (hawser/sea.h).

#include <hawser/sea.h>

#include <cmath>
#include <numbers>

namespace hawser::marine {

/// From its lowest to its highest point; by default that of a ball of its volume [m].
[[nodiscard]] inline double height_of(const WaterBody& body) noexcept {
    return body.height > 0.0 ? body.height : std::cbrt(6.0 * body.volume / std::numbers::pi);
}

/// With the volume that it has by default.
[[nodiscard]] inline LineWater with_volume(LineWater water) noexcept {
    water.volume = water.area();
    return water;
}

}  // namespace hawser::marine
