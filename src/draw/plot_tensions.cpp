// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "draw/commands_note.h"
#include "draw/curves.h"
#include "draw/plots.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::draw {

namespace {

// Largest ratio of tensions in a panel. Beyond it smaller tensions look like zero.
constexpr double kPanelRatio = 6.0;
constexpr std::size_t kMaxPanels = 3;
constexpr double kLegendRow = 36.0;  // Height of a legend entry with its note [points].

using Curves = std::vector<std::size_t>;  // Indices into Series::cables.

std::vector<Curves> curves_by_size(const record::Series& series) {
    Curves order(series.cables.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return series.cables[a].peak > series.cables[b].peak;
    });
    std::vector<Curves> panels;
    double top = 0.0;
    for (const std::size_t i : order) {
        const double peak = series.cables[i].peak;
        if (panels.empty() || (peak * kPanelRatio < top && panels.size() < kMaxPanels)) {
            panels.emplace_back();
            top = peak;
        }
        panels.back().push_back(i);
    }
    for (Curves& curves : panels) std::sort(curves.begin(), curves.end());
    return panels;
}

Range tension_range(const record::Series& series, const Curves& curves, double factor) {
    std::vector<double> values;
    for (const std::size_t i : curves) {
        const record::CableSeries& s = series.cables[i];
        for (const auto* list : {&s.lowest, &s.highest}) {
            const Range r = range_of(*list);
            values.insert(values.end(), {factor * r.low, factor * r.high});
        }
    }
    Range r = range_of(values);
    // Start the axis at zero if it comes close to zero, so that heights are proportional to
    // tensions.
    if (r.low > 0.0 && r.low < 0.6 * r.high) r.low = 0.0;
    const bool at_zero = r.low == 0.0;
    r = widened(r, 0.06, std::max(1e-9, 0.002 * std::abs(r.high)));
    if (at_zero) r.low = 0.0;
    return r;
}

std::vector<double> dash_pattern(std::size_t index) {
    return index < 9 ? std::vector<double>{} : std::vector<double>{7.0, 6.0};
}

void draw_curves(Drawing& drawing, const Axes& axes, const record::Series& series,
                 const Curves& curves, double factor) {
    for (const std::size_t i : curves) {
        const record::CableSeries& s = series.cables[i];
        std::vector<std::vector<Point>> bands = curve_parts(axes, series, s.highest, factor);
        const std::vector<std::vector<Point>> lower = curve_parts(axes, series, s.lowest, factor);
        for (std::size_t p = 0; p < bands.size(); ++p) {
            bands[p].insert(bands[p].end(), lower[p].rbegin(), lower[p].rend());
            drawing.add(Path{.points = std::move(bands[p]),
                             .width = 0.0,
                             .fill = curve_color(i).with_alpha(36),
                             .closed = true});
        }
    }
    for (const std::size_t i : curves)
        for (std::vector<Point>& part : curve_parts(axes, series, series.cables[i].first, factor))
            drawing.add(Path{.points = std::move(part),
                             .stroke = curve_color(i),
                             .width = 1.8,
                             .dash = dash_pattern(i)});
}

std::vector<LegendEntry> legend(const record::Recording& recording, const record::Series& series,
                                const Curves& curves) {
    std::vector<LegendEntry> entries;
    for (const std::size_t i : curves) {
        const record::CableSeries& s = series.cables[i];
        const record::RecordedCable& cable = recording.cables[static_cast<std::size_t>(s.cable)];
        std::string note = "max " + record::with_unit(s.peak, "N");
        if (cable.breaking_load > 0.0)
            note += fmt::format(", {:.3g} % of breaking", 100.0 * s.peak / cable.breaking_load);
        entries.push_back({s.name, note, curve_color(i), dash_pattern(i)});
    }
    return entries;
}

void mark_events(Drawing& drawing, const record::Recording& recording, const Axes& axes) {
    int shown = 0;
    for (const record::RecordedEvent& event : recording.events) {
        if (event.kind != EventKind::line_break || event.time < axes.x.low ||
            event.time > axes.x.high || ++shown > 8)
            continue;
        const double x = axes.at(event.time, axes.y.low).x;
        drawing.line({x, axes.frame.y}, {x, axes.frame.bottom()}, Color{190, 30, 30, 255}, 1.2,
                     {5.0, 5.0});
        drawing.add(Text{.at = {x + 4, axes.frame.y + 14.0 * shown},
                         .text = event.where + " parts",
                         .size = 11.0,
                         .color = Color{190, 30, 30, 255},
                         .halo = true});
    }
}

void draw_panel(Drawing& drawing, const record::Recording& recording, const record::Series& series,
                const Curves& curves, const std::vector<Command>& commands, Axes axes) {
    double peak = 0.0;
    for (const std::size_t i : curves) peak = std::max(peak, series.cables[i].peak);
    const record::Unit unit = record::readable_unit(peak, "N");
    axes.x = range_of(series.time);
    axes.x.high = std::max(axes.x.high, axes.x.low + recording.settings.step);
    axes.y = tension_range(series, curves, unit.factor);
    axes.y_label = fmt::format("tension [{}]", unit.name);
    axes.x_ticks = 10;
    axes.y_ticks = std::max(3, static_cast<int>(axes.frame.height / 60));
    axes.draw(drawing);
    mark_commands(drawing, axes, commands);
    draw_curves(drawing, axes, series, curves, unit.factor);
    mark_events(drawing, recording, axes);
    draw_legend(drawing, {axes.frame.right() + 24, axes.frame.y + 14},
                legend(recording, series, curves));
}

}  // namespace

std::optional<Drawing> plot_tensions(const record::Recording& recording,
                                     const record::Series& series) {
    if (series.cables.empty() || series.time.empty()) return std::nullopt;
    const std::vector<Curves> panels = curves_by_size(series);
    const std::vector<Command> commands = list_commands_by_time(recording);
    const double listed = kCommandLine * static_cast<double>(commands.size());
    const double top = 108, bottom = 96 + listed, gap = 40;
    const double least = panels.size() == 1 ? 520 : panels.size() == 2 ? 270 : 190;
    std::vector<double> heights;
    double total = top + bottom - gap;
    for (const Curves& curves : panels) {
        const auto rows = static_cast<double>(curves.size());
        heights.push_back(std::max(least, rows * kLegendRow));
        total += heights.back() + gap;
    }
    Drawing drawing{.width = 1280, .height = total};
    draw_heading(drawing, recording.scene_name + ": tension of the cables over time",
                 record::parameter_line(recording));
    double y = top;
    for (std::size_t g = 0; g < panels.size(); ++g) {
        draw_panel(drawing, recording, series, panels[g], commands,
                   {.frame = {110, y, 880, heights[g]},
                    .x_label = g + 1 == panels.size() ? "time [s]" : "",
                    .x_numbers = g + 1 == panels.size()});
        y += heights[g] + gap;
    }
    list_commands(drawing, {110, drawing.height - 22 - listed + kCommandLine}, commands);
    drawing.text({110, drawing.height - 22 - listed},
                 "Line: first element of the cable. Band: lowest to highest element it has then.",
                 12.0, Anchor::start, kSoft);
    return drawing;
}

}  // namespace hawser::draw
