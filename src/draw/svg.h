// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file svg.h
/// Write a drawing as SVG 1.1.

#include "draw/drawing.h"

#include <string>

namespace hawser::draw {

/// Return the whole document, including the XML declaration. Text stays text, so that it can be
/// searched.
[[nodiscard]] std::string to_svg(const Drawing& drawing);

/// Replace the five special characters of XML, and remove control characters.
[[nodiscard]] std::string escape_xml(const std::string& text);

}  // namespace hawser::draw
