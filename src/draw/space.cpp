// SPDX-License-Identifier: Apache-2.0
#include "draw/space.h"

#include "draw/shapes.h"
#include "draw/view_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::draw {
namespace {

constexpr Color kHullColor{104, 126, 150, 255}, kStructureColor{218, 158, 72, 255},
    kPlainColor{158, 164, 172, 255}, kWaterColor{96, 160, 206, 70}, kWaterLine{70, 130, 180, 255},
    kSandColor{226, 214, 194, 255}, kSandLine{168, 148, 116, 255}, kEdge{38, 46, 56, 255},
    kFloorColor{246, 248, 250, 255}, kFloorLine{150, 157, 166, 255};

Color shaded(Color c, double light) {
    const auto one = [&](std::uint8_t v) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(v * light), 0L, 255L));
    };
    return {one(c.r), one(c.g), one(c.b), c.a};
}

}  // namespace

Space::Space(const record::Recording& recording, const record::Frame& frame,
             const ViewOptions& options, const Bounds& bounds)
    : recording_(recording),
      frame_(frame),
      camera_(Camera::at(options.azimuth, std::clamp(options.elevation, 5.0, 85.0))),
      water_(water_of(recording, frame)),
      box_(bounds),
      tension_(tension_range(frame)) {
    drawing_.width = options.width > 0.0 ? options.width : kSpaceWidth;
    // Corners from the user may exclude water and seabed.
    const auto shown = [&](const std::optional<double>& z) {
        return z && (!options.box || options.around ||
                     (*z >= box_.low.z() - 1e-6 && *z <= box_.high.z() + 1e-6));
    };
    if (!shown(water_.level)) water_.level.reset();
    if (!shown(water_.seabed)) water_.seabed.reset();
    gather();
    widen_box(options.box && !options.around);
    fit(options);
}

Drawing Space::draw(const record::Series& series) {
    draw_heading(drawing_,
                 fmt::format("{}: the scene at {:.6g} s", recording_.scene_name, frame_.time),
                 record::parameter_line(recording_));
    drawing_.add(Clip{Box{0, kSpaceTop - 24, drawing_.width, drawing_.height - kSpaceTop - 20}});
    if (water_.seabed) draw_level(*water_.seabed, kSandColor, kSandLine, false);
    if (!water_.seabed && !water_.level) draw_level(box_.low.z(), kFloorColor, kFloorLine, true);
    draw_grounds_lines();
    draw_paths(series);
    const double level = water_.level.value_or(-1e300);
    if (water_.level) {
        draw_layer(level, false);
        draw_level(level, kWaterColor, kWaterLine.with_alpha(110), true);
    }
    draw_layer(level, true);
    draw_heights();
    draw_names();
    drawing_.add(Clip{});
    draw_frame();
    return std::move(drawing_);
}

/// Widen the visible box, so that level ground and water extend slightly beyond the scene. A box
/// that the user has set stays unchanged.
void Space::widen_box(bool given) {
    if (given) return;
    const Vec3 size = box_.high - box_.low;
    const double length = std::max(size.x(), size.y());
    // Extend the water around a ship, relative to the size of the ship.
    double margin = 0.04 * length + 1e-3;
    for (const Solid& s : solids_) margin = std::max(margin, 0.2 * (s.x1 - s.x0));
    for (int k = 0; k < 2; ++k) {
        // Keep the width of the box at least a fifth of its length, also for a long tow.
        const double more = std::max(margin, 0.5 * (0.2 * length - size[k]));
        box_.low[k] -= more;
        box_.high[k] += more;
    }
    if (water_.level) {
        box_.low.z() = std::min(box_.low.z(), *water_.level);
        box_.high.z() = std::max(box_.high.z(), *water_.level);
    }
    if (water_.seabed) box_.low.z() = std::min(box_.low.z(), *water_.seabed);
}

std::vector<Vec3> Space::corners() const {
    std::vector<Vec3> out;
    for (int i = 0; i < 8; ++i)
        out.emplace_back((i & 1) != 0 ? box_.high.x() : box_.low.x(),
                         (i & 2) != 0 ? box_.high.y() : box_.low.y(),
                         (i & 4) != 0 ? box_.high.z() : box_.low.z());
    return out;
}

void Space::fit(const ViewOptions& options) {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
    for (const Vec3& c : corners()) {
        const Point p = camera_.flat(c);
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    const double wide = drawing_.width - 2 * kSpaceLeft - kScaleRoom;
    // Limit the height to that of the contents.
    const double needed = wide * (y1 - y0) / std::max(1e-9, x1 - x0) + kSpaceTop + kSpaceBelow + 20;
    drawing_.height =
        options.height > 0.0 ? options.height : std::clamp(needed, 480.0, kSpaceHeight);
    const double high = drawing_.height - kSpaceTop - kSpaceBelow;
    scale_ = std::min(wide / std::max(1e-9, x1 - x0), high / std::max(1e-9, y1 - y0));
    shift_ = {kSpaceLeft + 0.5 * wide - scale_ * 0.5 * (x0 + x1),
              kSpaceTop + 0.5 * high + scale_ * 0.5 * (y0 + y1)};
}

Point Space::at(const Vec3& p) const {
    const Point flat = camera_.flat(p);
    return {shift_.x + scale_ * flat.x, shift_.y - scale_ * flat.y};
}

bool Space::inside(const Vec3& p) const {
    constexpr double kBoxTolerance = 1e-6;
    return p.x() >= box_.low.x() - kBoxTolerance && p.x() <= box_.high.x() + kBoxTolerance &&
           p.y() >= box_.low.y() - kBoxTolerance && p.y() <= box_.high.y() + kBoxTolerance &&
           p.z() >= box_.low.z() - kBoxTolerance && p.z() <= box_.high.z() + kBoxTolerance;
}

void Space::gather() {
    const std::vector<bool> visible = visible_bodies(recording_);
    for (std::size_t i = 0; i < recording_.bodies.size(); ++i) {
        if (!frame_.there[i] || !inside(frame_.poses[i].position)) continue;
        const record::RecordedBody& body = recording_.bodies[i];
        const Mat3 turn = frame_.poses[i].orientation.normalized().toRotationMatrix();
        const double reach = body.half_size.maxCoeff();
        // A hull is long and not thin, unlike a boom or a crate.
        const bool hull = reach > 8.0 && body.half_size.sum() - reach > 5.0;
        for (record::Triangles& t : record::body_surfaces(recording_, i)) {
            for (Vec3& p : t.points) p = frame_.poses[i].position + turn * p;
            solids_.push_back(make_solid(std::move(t),
                                         hull                           ? kHullColor
                                         : body.kind == BodyKind::fixed ? kPlainColor
                                                                        : kStructureColor,
                                         camera_));
        }
        if (visible[i] && reach <= 0.0 && body.kind != BodyKind::fixed)
            dots_.push_back(frame_.poses[i].position);
    }
}

void Space::draw_layer(double level, bool above) {
    const Vec3 light =
        (0.35 * camera_.to_viewer - 0.45 * camera_.right + 0.82 * camera_.up).normalized();
    for (const std::size_t i : painting_order(solids_, camera_)) {
        const Solid& s = solids_[i];
        for (std::size_t f = 0; f < s.normals.size(); ++f) {
            if (s.normals[f].dot(camera_.to_viewer) <= 1e-9) continue;
            const auto& c = s.surface.corners[f];
            const std::vector<Vec3> part =
                clipped({s.surface.points[c[0]], s.surface.points[c[1]], s.surface.points[c[2]]},
                        level, above);
            if (part.empty()) continue;
            const double strength = 0.62 + 0.5 * std::max(0.0, s.normals[f].dot(light)) +
                                    0.06 * s.normals[f].dot(camera_.right);
            const Color fill = shaded(s.color, strength);
            polygon(part, fill, fill, 0.6);  // stroke covers the seams between triangles
        }
        for (Crease crease : visible_creases(s, camera_))
            if (clip(crease.from, crease.to, level, above))
                drawing_.line(at(crease.from), at(crease.to), kEdge, 1.0);
    }
    draw_wires(level, above);
    draw_joints(level, above);
    for (const Vec3& dot : dots_)
        if ((dot.z() >= level) == above && !is_hidden(dot, solids_, camera_)) draw_dot(dot);
}

void Space::draw_dot(const Vec3& p) {
    const Point c = at(p);
    Path path{.points = {}, .stroke = kEdge, .width = 1.0, .fill = kStructureColor, .closed = true};
    for (int i = 0; i < 16; ++i)
        path.points.push_back(
            {c.x + 4.5 * std::cos(i * 0.392699), c.y + 4.5 * std::sin(i * 0.392699)});
    drawing_.add(std::move(path));
}

std::optional<std::pair<Vec3, Vec3>> shown_box(const record::Recording& recording,
                                               const std::vector<std::size_t>& frames) {
    Bounds bounds;
    for (const std::size_t index : frames) {
        const record::Frame frame = recording.frame(index);
        add_to_bounds(recording, frame, bounds);
        add_outlines_to_bounds(recording, frame, bounds);
    }
    if (bounds.empty()) return std::nullopt;
    return std::pair(bounds.low, bounds.high);
}

std::optional<Drawing> plot_space(const record::Recording& recording, const record::Series& series,
                                  std::size_t frame_index, const ViewOptions& options) {
    if (frame_index >= recording.frame_count()) return std::nullopt;
    const auto box = options.box ? options.box : shown_box(recording, {frame_index});
    if (!box) return std::nullopt;
    Bounds bounds;
    bounds.add(box->first);
    bounds.add(box->second);
    const record::Frame frame = recording.frame(frame_index);
    return Space(recording, frame, options, bounds).draw(series);
}

}  // namespace hawser::draw
