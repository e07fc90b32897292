// SPDX-License-Identifier: Apache-2.0
#include "debrief/curve_plots.h"

#include "draw/axes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hawser::debrief {
namespace {

using draw::Point;

constexpr std::size_t kMostPanels = 12;
constexpr double kLeftMargin = 110, kPictureWidth = 1120, kRightMargin = 40, kTopMargin = 40,
                 kPanelHeight = 130, kPanelSeparation = 38, kBottom = 60;
constexpr draw::Color kLimitColor{150, 157, 166, 255};

/// Return the limits that the exercise compares an output with.
std::set<double> limits_of_output(const exercise::Exercise& e, const std::string& output) {
    std::set<double> out;
    const auto take = [&](const auto& list) {
        for (const auto& one : list)
            for (const exercise::Condition& c : one.when.conditions)
                for (const double limit : {c.above, c.below})
                    if (c.output == output && std::isfinite(limit)) out.insert(limit);
    };
    take(e.alarms);
    take(e.goals);
    take(e.penalties);
    take(e.ends);
    return out;
}

/// Mark events on the lower edge of a panel: goals in green; alarms, penalties and faults in red.
void mark_entries(draw::Drawing& drawing, const draw::Axes& axes, const exercise::Result& result) {
    for (const exercise::Entry& e : result.entries) {
        const bool good = e.kind == exercise::EntryKind::goal;
        const bool bad = e.kind == exercise::EntryKind::alarm ||
                         e.kind == exercise::EntryKind::penalty ||
                         e.kind == exercise::EntryKind::fault;
        if ((!good && !bad) || e.time < axes.x.low || e.time > axes.x.high) continue;
        const double x = axes.at(e.time, axes.y.low).x, y = axes.frame.bottom();
        drawing.add(
            draw::Path{.points = {{x, y - 9}, {x - 5, y}, {x + 5, y}},
                       .width = 0.0,
                       .fill = good ? draw::Color{10, 107, 78, 255} : draw::Color{163, 32, 32, 255},
                       .closed = true});
    }
}

}  // namespace

std::optional<draw::Drawing> plot_curves(const exercise::Exercise& exercise,
                                         const exercise::Result& result,
                                         const exercise::Curves& curves) {
    const std::size_t panels = std::min(kMostPanels, curves.values.size());
    if (panels == 0 || curves.time.size() < 2) return std::nullopt;
    draw::Drawing drawing{
        .width = kPictureWidth,
        .height = kTopMargin + static_cast<double>(panels) * (kPanelHeight + kPanelSeparation) -
                  kPanelSeparation + kBottom,
        .title = exercise.name + ": displays over time"};
    for (std::size_t k = 0; k < panels; ++k) {
        const std::string& output = exercise.displays[k];
        std::vector<double> all = curves.values[k];
        const draw::Range own = draw::range_of(all);
        const std::set<double> limits = limits_of_output(exercise, output);
        // Limits far from the curve would flatten it.
        const double near = 0.6 * std::max(own.span(), 1e-9);
        for (const double limit : limits)
            if (limit > own.low - near && limit < own.high + near) all.push_back(limit);
        const draw::Range range = draw::range_of(all);
        const draw::Range y =
            draw::widened(range, 0.06, std::max(1e-9, 1e-3 * std::abs(range.high)));
        const bool last = k + 1 == panels;
        const draw::Axes axes{
            .frame = {kLeftMargin,
                      kTopMargin + static_cast<double>(k) * (kPanelHeight + kPanelSeparation),
                      kPictureWidth - kLeftMargin - kRightMargin, kPanelHeight},
            .x = {curves.time.front(), curves.time.back()},
            .y = y,
            .x_label = last ? "time [s]" : "",
            .title = output,
            .x_numbers = last,
            .x_ticks = 10,
            .y_ticks = 4};
        axes.draw(drawing);
        drawing.add(draw::Clip{axes.frame});
        for (const double limit : limits)
            drawing.line(axes.at(axes.x.low, limit), axes.at(axes.x.high, limit), kLimitColor, 1.2,
                         {6, 4});
        drawing.add(draw::Path{.points = draw::thinned(axes, curves.time, curves.values[k]),
                               .stroke = draw::curve_color(k),
                               .width = 1.8});
        mark_entries(drawing, axes, result);
        drawing.add(draw::Clip{});
    }
    return drawing;
}

}  // namespace hawser::debrief
