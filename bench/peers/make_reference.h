// SPDX-License-Identifier: Apache-2.0
/// @file
/// References made by our own engine at small steps, for scenes that no other engine can follow.
#pragma once

#include "scenes.h"

#include <string>

namespace hawser::bench {

/// Substeps of the two finest runs: both are stored.
inline constexpr int kCoarse = 16, kFine = 32;

/// Simulate `scene` for `duration` with 1, 2, 4, … kFine substeps. Print the difference between the
/// tow tension of each and that of the finest, rms after the first second. Write
/// `folder`/<scene>.csv: `t`, `tension_…` of the finest run and `coarse_…` of the second.
/// @throws std::runtime_error if the file cannot be written or a step fails; std::invalid_argument
///        if the scene has no towed ship.
void make_reference(const Scene& scene, double duration, const std::string& folder);

}  // namespace hawser::bench
