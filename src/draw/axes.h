// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file axes.h
/// Draw axes with round ticks, curves, legends and colour bars.

#include "draw/drawing.h"

#include <span>
#include <string>
#include <vector>

namespace hawser::draw {

/// Range of values on an axis; low > high if the axis is reversed.
struct Range {
    double low = 0.0, high = 1.0;
    [[nodiscard]] double span() const noexcept { return high - low; }
};

/// Return the smallest range that contains all finite values; {0, 1} if there are none.
[[nodiscard]] Range range_of(std::span<const double> values);
/// Return a range widened at both ends by the fraction `fraction` of its span, and to a span of at
/// least `least`.
[[nodiscard]] Range widened(Range range, double fraction, double least);

/// Return ticks at 1, 2 or 5 times a power of ten inside the range, ascending, about `count` of
/// them.
[[nodiscard]] std::vector<double> ticks(Range range, int count);
/// Return the number of a tick with the decimals that the distance of ticks requires.
[[nodiscard]] std::string tick_label(double value, double distance);

/// One panel: its box in the picture and the ranges of its axes.
struct Axes {
    Box frame;
    Range x{}, y{};
    std::string x_label{}, y_label{}, title{};
    bool x_numbers = true;  ///< False if a panel below shows the numbers.
    int x_ticks = 8, y_ticks = 6;

    [[nodiscard]] Point at(double px, double py) const noexcept {
        return {frame.x + (px - x.low) / x.span() * frame.width,
                frame.bottom() - (py - y.low) / y.span() * frame.height};
    }
    /// Draw grid, frame, tick numbers and labels. Draw curves afterwards.
    void draw(Drawing& drawing) const;
};

/// Return the points of a curve, thinned so that each pixel column keeps its extremes.
[[nodiscard]] std::vector<Point> thinned(const Axes& axes, std::span<const double> x,
                                         std::span<const double> y);

/// Return a distinct colour for a curve, also for readers with a colour-vision deficiency. Source:
/// Okabe and Ito, "Color universal design", 2008; without yellow, with two more shades.
[[nodiscard]] Color curve_color(std::size_t index);

/// Return a sequential colour from dark blue over violet to orange, dark enough on white; t in 0-1.
[[nodiscard]] Color scale_color(double t);

struct LegendEntry {
    std::string name{}, note{};
    Color color{};
    std::vector<double> dash{};
};
/// Draw a column of entries with a grey note below each name. @return height of the column
/// [points].
double draw_legend(Drawing& drawing, Point at, std::span<const LegendEntry> entries);

/// Draw a vertical bar of scale_color with ticks.
void draw_color_bar(Drawing& drawing, const Box& box, Range range, const std::string& label);

/// Draw the title and the parameter line at the top of a picture, and store them in its metadata.
void draw_heading(Drawing& drawing, const std::string& title, const std::string& parameters);

}  // namespace hawser::draw
