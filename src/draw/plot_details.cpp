// SPDX-License-Identifier: Apache-2.0
#include "draw/plots.h"
#include "draw/projection.h"
#include "draw/shapes.h"
#include "draw/view_labels.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace hawser::draw {

namespace {

constexpr std::size_t kMostPanels = 4;
constexpr double kLeft = 90, kTop = 112, kPanelWidth = 540, kBetween = 90, kBarRoom = 150;
// Margin around the body, as a fraction of its size.
constexpr double kBodyMargin = 0.35;

// Choose plotted bodies with a size that is small compared with the whole scene.
std::vector<std::int32_t> plotted_bodies(const record::Recording& recording, double scene_size) {
    std::vector<std::int32_t> out;
    for (const std::int32_t index : recording.plot_bodies) {
        const record::RecordedBody& body = recording.bodies[static_cast<std::size_t>(index)];
        const double size = 2.0 * body.half_size.norm();
        if (size > 0.0 && size < 0.25 * scene_size && out.size() < kMostPanels)
            out.push_back(index);
    }
    return out;
}

Bounds body_bounds(const record::RecordedBody& body, const Pose& pose) {
    Bounds bounds;
    const Mat3 r = pose.orientation.normalized().toRotationMatrix();
    const Vec3 reach = r.cwiseAbs() * body.half_size;
    bounds.add(pose.position - reach);
    bounds.add(pose.position + reach);
    return bounds;
}

// Return the axes of a side view along the body's longer horizontal extent, with equal scales.
Axes panel(const View& view, const Bounds& body, Point at, double height) {
    const double wide = body.high[view.right] - body.low[view.right];
    const double high = body.high[2] - body.low[2];
    const double scale = std::min(kPanelWidth / (wide * (1.0 + 2.0 * kBodyMargin)),
                                  height / std::max(high * (1.0 + 2.0 * kBodyMargin), 0.5 * wide));
    const double x = 0.5 * (body.low[view.right] + body.high[view.right]);
    // Structures on a body are usually higher than parts below it, so the margin above is larger.
    const double z = 0.5 * (body.low[2] + body.high[2]) + 0.12 * height / scale;
    return {.frame = {at.x, at.y, kPanelWidth, height},
            .x = {x - 0.5 * kPanelWidth / scale, x + 0.5 * kPanelWidth / scale},
            .y = {z - 0.5 * height / scale, z + 0.5 * height / scale},
            .x_label = view.right == 0 ? "x [m]" : "y [m]",
            .y_label = "z [m]",
            .title = view.title,
            .x_numbers = true,
            .x_ticks = 6,
            .y_ticks = 5};
}

}  // namespace

std::optional<Drawing> plot_details(const record::Recording& recording, std::size_t frame_index) {
    if (frame_index >= recording.frame_count()) return std::nullopt;
    const record::Frame first = recording.frame(0), frame = recording.frame(frame_index);
    Bounds bounds;
    add_to_bounds(recording, frame, bounds);
    if (bounds.empty()) return std::nullopt;
    const auto bodies = plotted_bodies(recording, (bounds.high - bounds.low).norm());
    if (bodies.empty()) return std::nullopt;
    const std::size_t columns = std::min<std::size_t>(2, bodies.size());
    const std::size_t rows = (bodies.size() + columns - 1) / columns;
    const double height = rows == 1 ? 460 : 340;
    Drawing drawing{
        .width = kLeft + static_cast<double>(columns) * (kPanelWidth + kBetween) + kBarRoom - 40,
        .height = kTop + static_cast<double>(rows) * (height + 84) + 16};
    draw_heading(drawing,
                 fmt::format("{}: close to the plotted bodies at {:.6g} s", recording.scene_name,
                             frame.time),
                 record::parameter_line(recording));
    const Range tension = tension_range(frame);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const std::size_t row = k / columns, column = k % columns;
        const auto i = static_cast<std::size_t>(bodies[k]);
        const Bounds body = body_bounds(recording.bodies[i], frame.poses[i]);
        const Vec3 size = body.high - body.low;
        View view{size.x() >= size.y() ? 0 : 1, 2, 1.0, ""};
        view.title = fmt::format("{}, side view (along {})", recording.bodies[i].name,
                                 view.right == 0 ? "y" : "−x");
        const Axes axes = panel(view, body,
                                {kLeft + static_cast<double>(column) * (kPanelWidth + kBetween),
                                 kTop + static_cast<double>(row) * (height + 84)},
                                height);
        axes.draw(drawing);
        draw_grounds(drawing, axes, view, recording, frame);
        drawing.add(Clip{axes.frame});
        draw_frame(drawing, axes, view, recording, first, {true, tension});
        draw_solids(drawing, axes, view, recording, frame, false);
        draw_frame(drawing, axes, view, recording, frame, {false, tension});
        const std::string& name = recording.bodies[i].name;
        draw_names(drawing, axes, view, recording, frame, name.substr(0, name.rfind('/') + 1));
        drawing.add(Clip{});
    }
    if (recording.element_count > 0) {
        const record::Unit unit = record::readable_unit(tension.high, "N");
        draw_color_bar(drawing, {drawing.width - 112, kTop + 20, 20, 300},
                       {tension.low * unit.factor, tension.high * unit.factor},
                       fmt::format("tension [{}]", unit.name));
    }
    return drawing;
}

}  // namespace hawser::draw
