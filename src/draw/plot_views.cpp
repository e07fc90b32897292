// SPDX-License-Identifier: Apache-2.0
#include "draw/parted.h"
#include "draw/plots.h"
#include "draw/projection.h"
#include "draw/shapes.h"
#include "draw/view_labels.h"
#include "draw/water.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::draw {

namespace {

// Margins in the picture [points].
constexpr double kViewsLeft = 100, kRight = 170, kViewsTop = 118, kBottom = 74, kViewsBetween = 84;
constexpr double kWidth = 1280, kMaxHeight = 1180, kMinHeight = 640;

struct Layout {
    View view[2];
    Axes axes[2];
    double width = kWidth, height = 0.0;  // Size of the picture [points].
    int panels = 2;
    double bar_x = 0.0;  // Left edge of the colour bar.
};

Axes panel(const View& view, const Bounds& b, Box frame) {
    static constexpr std::array<const char*, 3> kAxis{"x [m]", "y [m]", "z [m]"};
    Range up{b.low[view.up], b.high[view.up]};
    if (view.up_sign < 0.0) std::swap(up.low, up.high);
    return {.frame = frame,
            .x = {b.low[view.right], b.high[view.right]},
            .y = up,
            .x_label = kAxis[static_cast<std::size_t>(view.right)],
            .y_label = kAxis[static_cast<std::size_t>(view.up)],
            .title = view.title,
            .x_numbers = true,
            .x_ticks = std::max(2, static_cast<int>(frame.width / 90)),
            .y_ticks = std::max(2, static_cast<int>(frame.height / 60))};
}

// Arrange two panels with equal scales. They are stacked or side by side, in the arrangement that
// shows the scene larger.
Layout arrange_two_panels(Bounds b) {
    const Vec3 extent = b.high - b.low;
    const int across = extent.x() >= extent.y() ? 0 : 1;
    Layout out;
    out.view[0] = {across, 2, 1.0, across == 0 ? "Side view (along y)" : "Side view (along −x)"};
    out.view[1] = {across, 1 - across, across == 0 ? 1.0 : -1.0, "Top view"};
    // Add margins; no panel is thinner than a seventh of its length.
    const double least = std::max(1e-3, extent.maxCoeff() / 7.0);
    for (int k = 0; k < 3; ++k) {
        const double required_span = std::max(extent[k] * 1.12, least);
        const double middle = 0.5 * (b.low[k] + b.high[k]);
        b.low[k] = middle - 0.5 * required_span;
        b.high[k] = middle + 0.5 * required_span;
    }
    const Vec3 size = b.high - b.low;
    const double wide = size[across], deep = size[1 - across], high = size.z();
    const double available_width = kWidth - kViewsLeft - kRight,
                 available_height = kMaxHeight - kViewsTop - kBottom;
    const double stacked =
        std::min(available_width / wide, (available_height - kViewsBetween) / (high + deep));
    const double side_by_side = std::min((available_width - kViewsBetween) / (2.0 * wide),
                                         available_height / std::max(high, deep));
    const bool above = stacked >= 0.9 * side_by_side;
    const double scale = above ? stacked : side_by_side;
    const double w = wide * scale, h0 = high * scale, h1 = deep * scale;
    if (above) {
        const double x = kViewsLeft + 0.5 * (available_width - w);
        out.axes[0] = panel(out.view[0], b, {x, kViewsTop, w, h0});
        out.axes[1] = panel(out.view[1], b, {x, kViewsTop + h0 + kViewsBetween, w, h1});
        out.height = kViewsTop + h0 + kViewsBetween + h1 + kBottom;
    } else {
        out.axes[0] = panel(out.view[0], b, {kViewsLeft, kViewsTop, w, h0});
        out.axes[1] = panel(out.view[1], b, {kViewsLeft + w + kViewsBetween, kViewsTop, w, h1});
        out.height = kViewsTop + std::max(h0, h1) + kBottom;
    }
    out.height = std::max(out.height, kMinHeight);
    out.bar_x = std::max(out.axes[0].frame.right(), out.axes[1].frame.right()) + 40;
    return out;
}

// Draw the paths of the plotted bodies.
void draw_paths(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Series& series) {
    for (std::size_t i = 0; i < series.bodies.size(); ++i) {
        const record::BodySeries& s = series.bodies[i];
        const record::RecordedBody& body = recording.bodies[static_cast<std::size_t>(s.body)];
        if (body.kind == BodyKind::scalar) continue;
        for (const auto& [begin, end] : record::continuous_intervals(series, s.value[0])) {
            std::vector<Point> path;
            for (std::size_t t = begin; t < end; ++t) {
                const Point p = project(
                    axes, view,
                    body.start.position + Vec3(s.value[0][t], s.value[1][t], s.value[2][t]));
                if (path.empty() || std::hypot(p.x - path.back().x, p.y - path.back().y) > 0.5)
                    path.push_back(p);
            }
            drawing.add(Path{
                .points = std::move(path), .stroke = curve_color(i).with_alpha(150), .width = 1.2});
        }
    }
}

void widen_by_paths(const record::Recording& recording, const record::Series& series,
                    Bounds& bounds) {
    for (const record::BodySeries& s : series.bodies) {
        const record::RecordedBody& body = recording.bodies[static_cast<std::size_t>(s.body)];
        if (body.kind == BodyKind::scalar) continue;
        for (std::size_t t = 0; t < s.value[0].size(); ++t)
            bounds.add(body.start.position + Vec3(s.value[0][t], s.value[1][t], s.value[2][t]));
    }
}

// List the broken cables on one line.
void mark_broken_elements(Drawing& drawing, Point at, const record::Recording& recording,
                          double time) {
    const std::vector<BrokenElement> parted = broken_elements(recording, time);
    constexpr std::size_t kMaxNamedWires = 4;
    if (parted.empty()) return;
    std::string text = "Crosses: ";
    for (std::size_t i = 0; i < std::min(kMaxNamedWires, parted.size()); ++i)
        text += (i > 0 ? "; " : "") + parted[i].text;
    if (parted.size() > kMaxNamedWires)
        text += fmt::format(" and {} more", parted.size() - kMaxNamedWires);
    drawing.text(at, text + ".", 12.0, Anchor::start, kBrokenColor);
}

/// Arrange one panel of the largest size that fits the picture, with equal scales on both axes.
Layout arrange_one_panel(const Bounds& b, const ViewOptions& options, double margin) {
    const Vec3 extent = b.high - b.low;
    const int across = extent.x() >= extent.y() ? 0 : 1;
    Layout out;
    out.panels = 1;
    out.view[0] =
        options.shown == Shown::side
            ? View{across, 2, 1.0, across == 0 ? "Side view (along y)" : "Side view (along −x)"}
            : View{across, 1 - across, across == 0 ? 1.0 : -1.0, "Top view"};
    const View& view = out.view[0];
    out.width = options.width > 0.0 ? options.width : kWidth;
    const double available_width = out.width - kViewsLeft - kRight;
    const double wide = std::max(1e-3, extent[view.right] * margin);
    double high = std::max(extent[view.up] * margin, wide / 7.0);
    double scale = available_width / wide;
    out.height = options.height > 0.0
                     ? options.height
                     : std::clamp(scale * high + kViewsTop + kBottom, kMinHeight, kMaxHeight);
    const double available_height = out.height - kViewsTop - kBottom;
    scale = std::min(scale, available_height / high);
    // Extend the axes to fill the remaining space.
    Bounds shown = b;
    const double half[2] = {0.5 * available_width / scale, 0.5 * available_height / scale};
    for (int k = 0; k < 2; ++k) {
        const int axis = k == 0 ? view.right : view.up;
        const double middle = 0.5 * (b.low[axis] + b.high[axis]);
        shown.low[axis] = middle - half[k];
        shown.high[axis] = middle + half[k];
    }
    out.axes[0] = panel(view, shown, {kViewsLeft, kViewsTop, available_width, available_height});
    out.bar_x = out.axes[0].frame.right() + 40;
    return out;
}

/// Draw still water and seabed in a side view, behind all other shapes.
void draw_water(Drawing& drawing, const Axes& axes, const View& view, const Water& water) {
    if (view.up != 2) return;
    const auto below = [&](double z, Color fill, Color line) {
        const double left = axes.frame.x, right = axes.frame.right();
        const double y = std::max(axes.at(0.0, z).y, axes.frame.y);
        if (y > axes.frame.bottom()) return;
        drawing.box({left, y, right - left, axes.frame.bottom() - y}, fill);
        if (axes.at(0.0, z).y >= axes.frame.y) drawing.line({left, y}, {right, y}, line, 1.4);
    };
    if (water.level) below(*water.level, {120, 175, 215, 40}, {70, 130, 180, 255});
    if (water.seabed) below(*water.seabed, {226, 214, 194, 255}, {150, 128, 96, 255});
}

}  // namespace

std::optional<Drawing> plot_views(const record::Recording& recording, const record::Series& series,
                                  std::size_t frame_index, const ViewOptions& options) {
    if (frame_index >= recording.frame_count()) return std::nullopt;
    if (options.shown == Shown::space) return plot_space(recording, series, frame_index, options);
    const record::Frame first = recording.frame(0), frame = recording.frame(frame_index);
    Bounds bounds;
    add_to_bounds(recording, first, bounds);
    add_to_bounds(recording, frame, bounds);
    add_outlines_to_bounds(recording, first, bounds);
    add_outlines_to_bounds(recording, frame, bounds);
    widen_by_paths(recording, series, bounds);
    if (bounds.empty()) return std::nullopt;
    if (options.box) {
        bounds.low = options.box->first;
        bounds.high = options.box->second;
    }
    const bool both = options.shown == Shown::side_and_top;
    const Water water = water_of(recording, frame);
    Layout layout =
        both ? arrange_two_panels(bounds)
             : arrange_one_panel(bounds, options, options.box && !options.around ? 1.0 : 1.12);
    if (both && options.height > 0.0) layout.height = std::max(layout.height, options.height);
    Drawing drawing{.width = layout.width, .height = layout.height};
    draw_heading(drawing,
                 fmt::format("{}: the scene at {:.6g} s", recording.scene_name, frame.time),
                 record::parameter_line(recording));
    const Range tension = tension_range(frame);
    double low = 0.0;
    for (int k = 0; k < layout.panels; ++k) {
        const Axes& axes = layout.axes[k];
        const View& view = layout.view[k];
        draw_water(drawing, axes, view, water);
        axes.draw(drawing);
        draw_grounds(drawing, axes, view, recording, frame);
        if (options.box) drawing.add(Clip{axes.frame});
        draw_solids(drawing, axes, view, recording, first, true);
        draw_frame(drawing, axes, view, recording, first, {true, tension});
        draw_paths(drawing, axes, view, recording, series);
        draw_solids(drawing, axes, view, recording, frame, false);
        draw_frame(drawing, axes, view, recording, frame, {false, tension});
        draw_names(drawing, axes, view, recording, frame);
        if (options.box) drawing.add(Clip{});
        low = std::max(low, axes.frame.bottom());
    }
    if (recording.element_count > 0) {
        const record::Unit unit = record::readable_unit(tension.high, "N");
        draw_color_bar(drawing,
                       {layout.bar_x, kViewsTop + 20, 22, std::min(420.0, low - kViewsTop - 20)},
                       {tension.low * unit.factor, tension.high * unit.factor},
                       fmt::format("tension [{}]", unit.name));
    }
    mark_broken_elements(drawing, {28, layout.height - 34}, recording, frame.time);
    drawing.text({28, layout.height - 16},
                 fmt::format("Grey: at {:.6g} s. Coloured thin lines: paths of the plotted "
                             "bodies.{}",
                             first.time, water.level ? " Blue: still water." : ""),
                 12.0, Anchor::start, kSoft);
    return drawing;
}

}  // namespace hawser::draw
