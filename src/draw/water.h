// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file water.h
/// Find the water level and the seabed of a recorded scene, for pictures.

#include <hawser/recording.h>

#include <optional>

namespace hawser::draw {

struct Water {
    std::optional<double> level;  ///< Height z of still water [m]: of a sea, or if a body floats.
    /// Height z of the seabed [m]: of a level plane or of the sea; the highest of several.
    std::optional<double> seabed;
};

/// Return the water of a frame, from the scene's document and its shapes. The level is that of the
/// frame, with tide and user settings. Waves are omitted, because recordings do not contain them.
[[nodiscard]] Water water_of(const record::Recording& recording, const record::Frame& frame);

}  // namespace hawser::draw
