// SPDX-License-Identifier: Apache-2.0
/// @file
/// References made by Hawser at small steps, for scenes that no other engine can simulate.
#pragma once

#include "scenes.h"

#include <string>

namespace hawser::bench {

/// Substeps of the two finest runs, which are stored.
inline constexpr int kCoarse = 16, kFine = 32;

/// Simulate `scene` for `duration` with 1, 2, 4, … kFine substeps. Prints the rms difference of
/// each tow tension to that of the finest run, after the first second. Writes `folder`/<scene>.csv:
/// `t`, `tension_…` of the finest run and `coarse_…` of the second one. @throws std::runtime_error
/// if the file cannot be written or a step fails; std::invalid_argument if the scene has no tow.
void make_reference(const Scene& scene, double duration, const std::string& folder);

}  // namespace hawser::bench
