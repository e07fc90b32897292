// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "draw/commands_note.h"
#include "draw/curves.h"
#include "draw/plots.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::draw {

namespace {

constexpr std::array<const char*, 6> kNames{"Δx", "Δy", "Δz", "Δroll", "Δpitch", "Δyaw"};

// Smallest span of an axis: 0.1 mm and 0.001 degrees. Smaller motions are not visible in a picture.
constexpr double kMinMetres = 1e-4, kMinDegrees = 1e-3;

std::string label(const record::Recording& recording, const record::BodySeries& s) {
    const std::string& name = recording.bodies[static_cast<std::size_t>(s.body)].name;
    return name.empty() ? fmt::format("body {}", s.body) : name;
}

Range value_range(const record::Series& series, int k, double factor) {
    std::vector<double> values;
    for (const record::BodySeries& s : series.bodies) {
        if (s.value[std::size_t(k)].empty()) continue;
        const Range r = range_of(s.value[std::size_t(k)]);
        values.insert(values.end(), {factor * r.low, factor * r.high});
    }
    return widened(range_of(values), 0.08, factor * (k < 3 ? kMinMetres : kMinDegrees));
}

// Use millimetres if no motion exceeds a centimetre.
record::Unit length_unit(const record::Series& series, int k) {
    double largest = 0.0;
    for (const record::BodySeries& s : series.bodies)
        for (const double v : s.value[std::size_t(k)]) largest = std::max(largest, std::abs(v));
    return largest < 0.01 ? record::Unit{"mm", 1e3} : record::Unit{"m", 1.0};
}

void draw_panel(Drawing& drawing, const record::Series& series,
                const std::vector<Command>& commands, const Axes& axes, int k, double factor) {
    axes.draw(drawing);
    mark_commands(drawing, axes, commands);
    for (std::size_t i = 0; i < series.bodies.size(); ++i) {
        const std::vector<double>& values = series.bodies[i].value[std::size_t(k)];
        for (std::vector<Point>& part : curve_parts(axes, series, values, factor))
            drawing.add(
                Path{.points = std::move(part),
                     .stroke = curve_color(i),
                     .width = 1.6,
                     .dash = i < 9 ? std::vector<double>{} : std::vector<double>{7.0, 6.0}});
    }
}

std::string extremes(const record::BodySeries& s) {
    double moved = 0.0, turned = 0.0;
    for (std::size_t t = 0; t < s.value[0].size(); ++t)
        moved = std::max(moved, std::hypot(s.value[0][t], s.value[1][t], s.value[2][t]));
    std::string note = fmt::format("at most {}", record::with_unit(moved, "m"));
    if (s.turns) {
        for (int k = 3; k < 6; ++k)
            for (const double angle : s.value[std::size_t(k)])
                turned = std::max(turned, std::abs(angle - s.value[std::size_t(k)].front()));
        note += fmt::format(", {:.3g}°", turned);
    }
    return note;
}

}  // namespace

std::optional<Drawing> plot_motions(const record::Recording& recording,
                                    const record::Series& series) {
    if (series.bodies.empty() || series.time.empty()) return std::nullopt;
    const bool turns = std::any_of(series.bodies.begin(), series.bodies.end(),
                                   [](const record::BodySeries& s) { return s.turns; });
    const std::vector<Command> commands = list_commands_by_time(recording);
    const double listed = kCommandLine * static_cast<double>(commands.size());
    Drawing drawing{.width = 1280, .height = 860 + listed};
    draw_heading(drawing, recording.scene_name + ": motion of the bodies over time",
                 record::parameter_line(recording));
    const int columns = turns ? 2 : 1;
    const double left = 110, right = 250, between = 100, top = 118, bottom = 92 + listed, gap = 52;
    const double width = (drawing.width - left - right - between * (columns - 1)) / columns;
    const double height = (drawing.height - top - bottom - 2 * gap) / 3;
    Range time = range_of(series.time);
    time.high = std::max(time.high, time.low + recording.settings.step);
    for (int k = 0; k < 3 * columns; ++k) {
        const record::Unit unit = k < 3 ? length_unit(series, k) : record::Unit{"deg", 1.0};
        const int column = k / 3, row = k % 3;
        const Axes axes{
            .frame = {left + column * (width + between), top + row * (height + gap), width, height},
            .x = time,
            .y = value_range(series, k, unit.factor),
            .x_label = row == 2 ? "time [s]" : "",
            .y_label = fmt::format("{} [{}]", kNames[static_cast<std::size_t>(k)], unit.name),
            .title = "",
            .x_numbers = row == 2,
            .x_ticks = turns ? 5 : 10,
            .y_ticks = 4};
        draw_panel(drawing, series, commands, axes, k, unit.factor);
    }
    list_commands(drawing, {left, drawing.height - 18 - listed + kCommandLine}, commands);
    drawing.text({left, top - 20}, "Displacement of the centre of mass from the start", 13.0,
                 Anchor::start, kInk, true);
    if (turns)
        drawing.text({left + width + between, top - 20}, "Roll, pitch and yaw from the start", 13.0,
                     Anchor::start, kInk, true);
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < series.bodies.size(); ++i)
        entries.push_back(
            {label(recording, series.bodies[i]), extremes(series.bodies[i]), curve_color(i), {}});
    draw_legend(drawing, {drawing.width - right + 22, top + 14}, entries);
    return drawing;
}

}  // namespace hawser::draw
