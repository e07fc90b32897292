// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_types.h
/// Read the line types of a cable.

#include "scene/cable_parts.h"

namespace hawser::scene {

/// Read "line_type" or "sections": all properties of the sections except the lengths of elements.
/// @throws SceneError.
void read_line_types(CableLayout& c, const Json& cable, const Document& document,
                     const Place& place);

/// Read the water coefficients of a line type or a rod, except the diameter. Missing keys keep the
/// defaults.
void read_line_water(const Json& json, LineWater& water);

/// Compute the lengths of all elements from the length of the cable.
void measure_elements(CableLayout& c) noexcept;

/// True if a length is a whole number of links, up to the decimals of a file.
[[nodiscard]] bool of_whole_links(double length, double link) noexcept;

/// Check that each element between nodes of a chain has a whole number of links. @throws
/// SceneError.
void check_links(const CableLayout& c, const Json& cable, const Place& place);

}  // namespace hawser::scene
