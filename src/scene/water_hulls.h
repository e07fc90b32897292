// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water_hulls.h
/// Hulls of a scene's sea, and their coefficients (hawser/water_hull.h).

#include <hawser/water_hull.h>

#include "scene/document.h"

namespace hawser::scene {

/// Read an entry of "hulls", except its body and areas. @throws SceneError
[[nodiscard]] WaterHull hull_of(const Json& json, const SourceLocation& location);
/// True if a file of the hull was rejected, so that its contents are missing.
[[nodiscard]] bool hull_is_omitted(const Json& json);
/// Return the treatment of damping for a word.
[[nodiscard]] NegativeDamping negative_damping_from(const std::string& word) noexcept;
/// Return coefficients in the form of a scene.
[[nodiscard]] Json coefficients_json(const WaveCoefficients& c);

}  // namespace hawser::scene
