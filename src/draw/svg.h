// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file svg.h
/// Writes a drawing as SVG 1.1.

#include "draw/drawing.h"

#include <string>

namespace hawser::draw {

/// The whole document, XML declaration included. Text stays text, so it can be searched.
[[nodiscard]] std::string to_svg(const Drawing& drawing);

/// Text with the five characters special to XML replaced and control characters removed.
[[nodiscard]] std::string escape_xml(const std::string& text);

}  // namespace hawser::draw
