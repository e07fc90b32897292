// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bodies.h
/// Sizes of small bodies and of slender ones in the water (hawser/sea.h).

#include <hawser/sea.h>

#include <cmath>
#include <numbers>

namespace hawser::marine {

/// Return the height of a body from its lowest to its highest point [m]; by default the diameter of
/// a ball of its volume.
[[nodiscard]] inline double height_of(const WaterBody& body) noexcept {
    return body.height > 0.0 ? body.height : std::cbrt(6.0 * body.volume / std::numbers::pi);
}

/// Return the coefficients of a line with its displaced volume set. If it is not defined, it is the
/// area of the cross-section.
[[nodiscard]] inline LineWater with_volume(LineWater water) noexcept {
    water.volume = water.area();
    return water;
}

}  // namespace hawser::marine
