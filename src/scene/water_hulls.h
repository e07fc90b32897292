// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_hulls.h
/// Hulls of a scene's sea, and their coefficients (hawser/water_hull.h).

#include <hawser/water_hull.h>

#include "scene/document.h"

namespace hawser::scene {

/// An entry of "hulls", but for its body and areas. @throws SceneError
[[nodiscard]] WaterHull hull_of(const Json& json, const Place& place);
/// A file of it was refused, and what it should have become is not there.
[[nodiscard]] bool hull_left_out(const Json& json);
/// Treatment of damping by its word.
[[nodiscard]] NegativeDamping negative_damping_of(const std::string& word) noexcept;
/// Coefficients as a scene has them.
[[nodiscard]] Json coefficients_json(const WaveCoefficients& c);

}  // namespace hawser::scene
