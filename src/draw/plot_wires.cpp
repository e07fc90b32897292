// SPDX-License-Identifier: Apache-2.0
// Tension along cables: least, mean and greatest of the recording over the material coordinate.
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

constexpr std::size_t kMostAlong = 6;  // Panels.
constexpr double kAlongTop = 112, kAlongLeft = 110, kAlongWidth = 900, kAlongBetween = 64;

// Tensions of a cable's elements over the frames [N], and where their middles are [m].
struct Along {
    std::vector<double> s, least, mean, greatest;
};

// Tension in the elements of several cables, frame by frame. Before the first step none is known.
std::vector<Along> tensions_along(const record::Recording& recording,
                                  const std::vector<std::int32_t>& cables) {
    std::vector<Along> out(cables.size());
    std::size_t frames = 0;
    for (std::size_t c = 0; c < cables.size(); ++c) {
        const record::RecordedCable& cable = recording.cables[static_cast<std::size_t>(cables[c])];
        const auto n = static_cast<std::size_t>(cable.elements);
        for (std::size_t i = 0; i < n; ++i)
            out[c].s.push_back(cable.length * (static_cast<double>(i) + 0.5) /
                               static_cast<double>(n));
        out[c].least.assign(n, HUGE_VAL);
        out[c].mean.assign(n, 0.0);
        out[c].greatest.assign(n, -HUGE_VAL);
    }
    for (std::size_t f = 0; f < recording.frame_count(); ++f) {
        const record::Frame frame = recording.frame(f);
        if (frame.step == 0 && recording.frame_count() > 1) continue;
        ++frames;
        for (std::size_t c = 0; c < cables.size(); ++c) {
            const record::RecordedCable& cable =
                recording.cables[static_cast<std::size_t>(cables[c])];
            for (std::size_t i = 0; i < out[c].s.size(); ++i) {
                const double tension =
                    frame.tensions[static_cast<std::size_t>(cable.first_element) + i];
                out[c].least[i] = std::min(out[c].least[i], tension);
                out[c].greatest[i] = std::max(out[c].greatest[i], tension);
                out[c].mean[i] += tension;
            }
        }
    }
    for (Along& a : out)
        for (double& mean : a.mean) mean /= static_cast<double>(std::max<std::size_t>(1, frames));
    return out;
}

void scale(std::vector<double>& values, double factor) {
    for (double& v : values) v *= factor;
}

void draw_along(Drawing& drawing, const Axes& axes, const Along& a, Color color) {
    const auto at = [&](const std::vector<double>& values) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < values.size(); ++i)
            points.push_back(axes.at(a.s[i], values[i]));
        return points;
    };
    std::vector<Point> band = at(a.greatest);
    const std::vector<Point> low = at(a.least);
    band.insert(band.end(), low.rbegin(), low.rend());
    drawing.add(Path{
        .points = std::move(band), .width = 0.0, .fill = color.with_alpha(40), .closed = true});
    drawing.add(Path{.points = at(a.greatest), .stroke = color, .width = 1.0});
    drawing.add(Path{.points = low, .stroke = color, .width = 1.0});
    drawing.add(Path{.points = at(a.mean), .stroke = color, .width = 2.0});
}

}  // namespace

std::optional<Drawing> plot_wires(const record::Recording& recording,
                                  const record::Series& series) {
    std::vector<std::int32_t> cables;
    for (const record::CableSeries& s : series.cables)
        if (cables.size() < kMostAlong) cables.push_back(s.cable);
    if (cables.empty() || recording.frame_count() == 0) return std::nullopt;
    std::vector<Along> along = tensions_along(recording, cables);
    const double height = cables.size() == 1 ? 480 : cables.size() == 2 ? 300 : 190;
    Drawing drawing{
        .width = 1280,
        .height = kAlongTop + 40 + static_cast<double>(cables.size()) * (height + kAlongBetween)};
    draw_heading(drawing, recording.scene_name + ": tension along the cables",
                 record::parameter_line(recording));
    const std::vector<PartedElement> parted = parted_elements(recording, HUGE_VAL);
    for (std::size_t c = 0; c < cables.size(); ++c) {
        const auto index = static_cast<std::size_t>(cables[c]);
        const record::RecordedCable& cable = recording.cables[index];
        Along& a = along[c];
        const double peak = *std::max_element(a.greatest.begin(), a.greatest.end());
        const record::Unit unit = record::readable_unit(std::max(peak, 1e-9), "N");
        for (auto* values : {&a.least, &a.mean, &a.greatest}) scale(*values, unit.factor);
        Range y{range_of(a.least).low, range_of(a.greatest).high};
        if (y.low < 0.6 * y.high) y.low = std::min(0.0, y.low);
        const Axes axes{
            .frame = {kAlongLeft, kAlongTop + static_cast<double>(c) * (height + kAlongBetween),
                      kAlongWidth, height},
            .x = {0.0, cable.length > 0.0 ? cable.length : 1.0},
            .y = widened(y, 0.04, 1e-9),
            .x_label = c + 1 == cables.size() ? "unstretched length from the first end "
                                                "[m]"
                                              : "",
            .y_label = fmt::format("tension [{}]", unit.name),
            .title = cable.name,
            .x_numbers = true,
            .x_ticks = 10,
            .y_ticks = std::max(3, static_cast<int>(height / 60))};
        axes.draw(drawing);
        draw_along(drawing, axes, a, curve_color(c));
        for (const PartedElement& p : parted) {
            if (p.cable != index) continue;
            const double x = axes.at(a.s[static_cast<std::size_t>(p.element)], y.low).x;
            drawing.line({x, axes.frame.y}, {x, axes.frame.bottom()}, kPartedColor, 1.2,
                         {5.0, 5.0});
            drawing.add(Text{.at = {x + 5, axes.frame.y + 16},
                             .text = p.text,
                             .size = 11.0,
                             .color = kPartedColor,
                             .halo = true});
        }
    }
    drawing.text({kAlongLeft, drawing.height - 14},
                 "Band: least to greatest in the frames. Thick line: mean. Elements of equal "
                 "length, as at the start.",
                 12.0, Anchor::start, kSoft);
    return drawing;
}

}  // namespace hawser::draw
