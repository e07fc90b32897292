// SPDX-License-Identifier: Apache-2.0
// Draw the tension along cables: least, mean and greatest over the recording, and that of one
// frame.
#include "draw/along.h"
#include "draw/axes.h"
#include "draw/parted.h"
#include "draw/plots.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::draw {

namespace {

constexpr std::size_t kMaxAlong = 6;  // Largest number of panels.
constexpr double kAlongTop = 112, kAlongLeft = 110, kAlongWidth = 900, kAlongBetween = 64;
constexpr double kNowWidth = 1.4;

void draw_along(Drawing& drawing, const Axes& axes, const Along& a, double factor, Color color) {
    const auto at = [&](const std::vector<double>& s, const std::vector<double>& values) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < values.size(); ++i)
            points.push_back(axes.at(s[i], factor * values[i]));
        return points;
    };
    std::vector<Point> band = at(a.s, a.greatest);
    const std::vector<Point> low = at(a.s, a.least);
    band.insert(band.end(), low.rbegin(), low.rend());
    drawing.add(Path{
        .points = std::move(band), .width = 0.0, .fill = color.with_alpha(40), .closed = true});
    drawing.add(Path{.points = at(a.s, a.greatest), .stroke = color, .width = 1.0});
    drawing.add(Path{.points = low, .stroke = color, .width = 1.0});
    drawing.add(Path{.points = at(a.s, a.mean), .stroke = color, .width = 2.0});
    if (!a.tensions.empty())
        drawing.add(Path{.points = at(a.elements, a.tensions), .stroke = kInk, .width = kNowWidth});
}

void mark_broken(Drawing& drawing, const Axes& axes, double s, const std::string& text) {
    const double x = axes.at(s, axes.y.low).x;
    drawing.line({x, axes.frame.y}, {x, axes.frame.bottom()}, kBrokenColor, 1.2, {5.0, 5.0});
    drawing.add(Text{.at = {x + 5, axes.frame.y + 16},
                     .text = text,
                     .size = 11.0,
                     .color = kBrokenColor,
                     .halo = true});
}

Axes along_axes(const Along& a, const record::Unit& unit, double top, double height) {
    Range y{unit.factor * range_of(a.least).low, unit.factor * range_of(a.greatest).high};
    if (y.low < 0.6 * y.high) y.low = std::min(0.0, y.low);
    return {.frame = {kAlongLeft, top, kAlongWidth, height},
            .x = {0.0, a.length},
            .y = widened(y, 0.04, 1e-9),
            .x_label = a.changes ? "length along the wire from the first end [m]"
                                 : "unstretched length from the first end [m]",
            .y_label = fmt::format("tension [{}]", unit.name),
            .title = a.name,
            .x_numbers = true,
            .x_ticks = 10,
            .y_ticks = std::max(3, static_cast<int>(height / 60))};
}

}  // namespace

std::optional<Drawing> plot_wires(const record::Recording& recording, const record::Series& series,
                                  std::size_t frame_index) {
    const std::vector<Along> along = tensions_along(recording, series, kMaxAlong, frame_index);
    if (along.empty()) return std::nullopt;
    const double height = along.size() == 1 ? 480 : along.size() == 2 ? 300 : 190;
    Drawing drawing{
        .width = 1280,
        .height = kAlongTop + 40 + static_cast<double>(along.size()) * (height + kAlongBetween)};
    draw_heading(drawing, recording.scene_name + ": tension along the cables",
                 record::parameter_line(recording));
    const std::vector<BrokenElement> parted = broken_elements(recording, HUGE_VAL);
    for (std::size_t w = 0; w < along.size(); ++w) {
        const Along& a = along[w];
        const double peak = *std::max_element(a.greatest.begin(), a.greatest.end());
        const record::Unit unit = record::readable_unit(std::max(peak, 1e-9), "N");
        const Axes axes = along_axes(
            a, unit, kAlongTop + static_cast<double>(w) * (height + kAlongBetween), height);
        axes.draw(drawing);
        draw_along(drawing, axes, a, unit.factor, curve_color(w));
        for (const double s : a.parted) mark_broken(drawing, axes, s, "parted");
        for (const BrokenElement& p : parted)
            if (p.cable == a.cable && !a.changes)
                mark_broken(drawing, axes, a.s[static_cast<std::size_t>(p.element)], p.text);
    }
    const bool lies = std::any_of(along.begin(), along.end(), [](auto& a) { return a.changes; });
    drawing.text(
        {kAlongLeft, drawing.height - 14},
        fmt::format(
            "Band: least to greatest in the frames. Thick line: mean. Black: at {:.6g} s. {}",
            recording.frame_head(frame_index).time,
            lies ? "Lengths as the wires lie, where nodes come and go."
                 : "Elements of equal length, as at the start."),
        12.0, Anchor::start, kSoft);
    return drawing;
}

}  // namespace hawser::draw
