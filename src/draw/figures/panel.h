// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file panel.h
/// Panels of a figure: each a picture of its own, and all on one page.

#include "draw/drawing.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// Sides of a square panel, and of its square for contents [points].
inline constexpr double kFigureWidth = 640, kFigureHeight = 744, kFigureSquare = 584;

/// An empty panel with a title, lines below it (the first in ink, others grey) and metadata.
[[nodiscard]] Drawing make_panel(double width, double height, const std::string& title,
                                 const std::vector<std::string>& notes);

/// The square of a square panel.
[[nodiscard]] Box panel_square();

struct Swatch {
    std::string name;
    Color color;
    bool line = false;  ///< A stroke instead of a box.
    std::vector<double> dash{};
};
/// Colours with names in rows from `at` on, no wider than `width`.
void draw_swatches(Drawing& drawing, Point at, double width, const std::vector<Swatch>& swatches);

/// Copy a picture into another, scaled evenly to a width.
void place(Drawing& page, const Drawing& panel, Point at, double width);

/// Panels row by row on one page, each row stretched to the width of the page.
[[nodiscard]] Drawing make_page(const std::string& title, const std::string& parameters,
                                const std::vector<std::vector<const Drawing*>>& rows);

}  // namespace hawser::draw
