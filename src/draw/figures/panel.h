// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file panel.h
/// Build the panels of a figure, each as a separate picture and all on one page.

#include "draw/drawing.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// Side lengths of a square panel and of its content [points].
inline constexpr double kFigureWidth = 640, kFigureHeight = 744, kFigureSquare = 584;

/// Return an empty panel with a title, lines below it (the first in ink, others grey) and metadata.
[[nodiscard]] Drawing make_panel(double width, double height, const std::string& title,
                                 const std::vector<std::string>& notes);

/// Return the content square of a square panel.
[[nodiscard]] Box panel_square();

struct Swatch {
    std::string name;
    Color color;
    bool line = false;  ///< Draw a stroke instead of a box.
    std::vector<double> dash{};
};
/// Draw colours with names in rows that start at `at` and are at most `width` wide.
void draw_swatches(Drawing& drawing, Point at, double width, const std::vector<Swatch>& swatches);

/// Copy a drawing into another one, scaled equally in both directions to a width.
void place(Drawing& page, const Drawing& panel, Point at, double width);

/// Arrange panels row by row on one page; each row is stretched to the width of the page.
[[nodiscard]] Drawing make_page(const std::string& title, const std::string& parameters,
                                const std::vector<std::vector<const Drawing*>>& rows);

}  // namespace hawser::draw
