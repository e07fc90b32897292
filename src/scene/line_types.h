// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_types.h
/// Of which line types a cable is.

#include "scene/cable_parts.h"

namespace hawser::scene {

/// "line_type" or "sections": what there is of each piece but its elements' length. @throws
/// SceneError.
void read_line_types(CableLayout& c, const Json& cable, const Document& document,
                     const Place& place);

/// What water does by a line type's, or a rod's, coefficients, where they are given; all but the
/// diameter.
void read_line_water(const Json& json, LineWater& water);

/// Lengths of all elements, once the length of the cable is known.
void measure_elements(CableLayout& c) noexcept;

/// Whether a length is a whole number of links, but for the digits of a file.
[[nodiscard]] bool of_whole_links(double length, double link) noexcept;

/// Chain is of whole links: elements of lumps have a whole number of them each. @throws SceneError.
void check_links(const CableLayout& c, const Json& cable, const Place& place);

}  // namespace hawser::scene
