// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file axes.h
/// Axes with round ticks, curves, legends and colour bars.

#include "draw/drawing.h"

#include <span>
#include <string>
#include <vector>

namespace hawser::draw {

/// A range of values that an axis shows; low > high on an axis that runs backwards.
struct Range {
    double low = 0.0, high = 1.0;
    [[nodiscard]] double span() const noexcept { return high - low; }
};

/// Smallest range that holds all finite values; {0, 1} for none.
[[nodiscard]] Range range_of(std::span<const double> values);
/// Widened by `share` of its span at both ends, and to at least `least` in all.
[[nodiscard]] Range widened(Range range, double share, double least);

/// Ticks at 1, 2 or 5 times a power of ten, about `count` of them, inside the range, ascending.
[[nodiscard]] std::vector<double> ticks(Range range, int count);
/// A tick's number with as many decimals as the distance of the ticks needs.
[[nodiscard]] std::string tick_label(double value, double distance);

/// One panel: its place in the picture and the ranges it shows.
struct Axes {
    Box frame;
    Range x{}, y{};
    std::string x_label{}, y_label{}, title{};
    bool x_numbers = true;  ///< False where a panel below shows them.
    int x_ticks = 8, y_ticks = 6;

    [[nodiscard]] Point at(double px, double py) const noexcept {
        return {frame.x + (px - x.low) / x.span() * frame.width,
                frame.bottom() - (py - y.low) / y.span() * frame.height};
    }
    /// Grid, frame, tick numbers, labels. Paint curves afterwards.
    void draw(Drawing& drawing) const;
};

/// Points of a curve, thinned so that each pixel column keeps its extremes.
[[nodiscard]] std::vector<Point> thinned(const Axes& axes, std::span<const double> x,
                                         std::span<const double> y);

/// Distinct colours for curves, also for readers with a colour-vision deficiency (Okabe and
/// Ito, "Color universal design", 2008, yellow left out and two shades added).
[[nodiscard]] Color curve_color(std::size_t index);

/// Sequential colours from dark blue over violet to orange, dark enough on white; t in 0-1.
[[nodiscard]] Color scale_color(double t);

struct LegendEntry {
    std::string name{}, note{};
    Color color{};
    std::vector<double> dash{};
};
/// A column of entries, the note in grey below its name. @return the height it took.
double draw_legend(Drawing& drawing, Point at, std::span<const LegendEntry> entries);

/// Vertical bar of scale_color with ticks.
void draw_color_bar(Drawing& drawing, const Box& box, Range range, const std::string& label);

/// Title and parameter line at the top of a picture, also into its metadata.
void draw_heading(Drawing& drawing, const std::string& title, const std::string& parameters);

}  // namespace hawser::draw
