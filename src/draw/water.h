// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water.h
/// Where a recorded scene has water and a seabed, for pictures.

#include <hawser/recording.h>

#include <optional>

namespace hawser::draw {

struct Water {
    std::optional<double> level;   ///< Still water, z [m]: of a sea, or where something floats.
    std::optional<double> seabed;  ///< z [m]: of a level plane or of the sea; highest of several.
};

/// From the scene's document and its shapes, with the level of the frame: tide and what was set.
/// Waves are left out: recordings do not hold them.
[[nodiscard]] Water water_of(const record::Recording& recording, const record::Frame& frame);

}  // namespace hawser::draw
