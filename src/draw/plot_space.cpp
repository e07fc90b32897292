// SPDX-License-Identifier: Apache-2.0
#include "draw/parted.h"
#include "draw/plots.h"
#include "draw/projection.h"
#include "draw/shapes.h"
#include "draw/solids_view.h"
#include "draw/view_labels.h"
#include "draw/water.h"
#include "draw/wire_lines.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::draw {
namespace {

constexpr double kSpaceWidth = 1280, kSpaceHeight = 860, kSpaceTop = 92, kSpaceBelow = 64,
                 kSpaceLeft = 54, kScaleRoom = 130;
constexpr Color kHullColor{104, 126, 150, 255}, kStructureColor{218, 158, 72, 255},
    kPlainColor{158, 164, 172, 255}, kWaterColor{96, 160, 206, 70}, kWaterLine{70, 130, 180, 255},
    kSandColor{226, 214, 194, 255}, kSandLine{168, 148, 116, 255}, kEdge{38, 46, 56, 255};

Color shaded(Color c, double light) {
    const auto one = [&](std::uint8_t v) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(v * light), 0L, 255L));
    };
    return {one(c.r), one(c.g), one(c.b), c.a};
}

/// One picture.
class Space {
  public:
    Space(const record::Recording& recording, const record::Frame& frame,
          const ViewOptions& options, const Bounds& bounds)
        : recording_(recording),
          frame_(frame),
          camera_(Camera::at(options.azimuth, std::clamp(options.elevation, 5.0, 85.0))),
          water_(water_of(recording)),
          box_(bounds),
          tension_(tension_range(frame)) {
        drawing_.width = options.width > 0.0 ? options.width : kSpaceWidth;
        drawing_.height = options.height > 0.0 ? options.height : kSpaceHeight;
        widen_box();
        fit();
        gather();
    }

    Drawing draw(const record::Series& series) {
        draw_heading(drawing_,
                     fmt::format("{}: the scene at {:.6g} s", recording_.scene_name, frame_.time),
                     record::parameter_line(recording_));
        if (water_.seabed) draw_level(*water_.seabed, kSandColor, kSandLine, false);
        draw_grounds_lines();
        const double level = water_.level.value_or(-1e300);
        if (water_.level) {
            draw_layer(level, false);
            draw_level(level, kWaterColor, kWaterLine.with_alpha(110), true);
        }
        draw_paths(series);
        draw_layer(level, true);
        draw_names();
        draw_frame();
        return std::move(drawing_);
    }

  private:
    /// Level ground and water reach a little beyond what there is.
    void widen_box() {
        const Vec3 size = box_.high - box_.low;
        const double margin = 0.06 * std::max(size.x(), size.y()) + 1e-3;
        for (int k = 0; k < 2; ++k) {
            // Not thinner than a fifth of its length: a tow is no line on a map.
            const double least = 0.2 * std::max(size.x(), size.y());
            const double more = std::max(margin, 0.5 * (least - size[k]));
            box_.low[k] -= more;
            box_.high[k] += more;
        }
        if (water_.level) {
            box_.low.z() = std::min(box_.low.z(), *water_.level);
            box_.high.z() = std::max(box_.high.z(), *water_.level);
        }
        if (water_.seabed) box_.low.z() = std::min(box_.low.z(), *water_.seabed);
    }

    [[nodiscard]] std::vector<Vec3> corners() const {
        std::vector<Vec3> out;
        for (int i = 0; i < 8; ++i)
            out.emplace_back((i & 1) != 0 ? box_.high.x() : box_.low.x(),
                             (i & 2) != 0 ? box_.high.y() : box_.low.y(),
                             (i & 4) != 0 ? box_.high.z() : box_.low.z());
        return out;
    }

    void fit() {
        double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
        for (const Vec3& c : corners()) {
            const Point p = camera_.flat(c);
            x0 = std::min(x0, p.x);
            x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y);
            y1 = std::max(y1, p.y);
        }
        const double wide = drawing_.width - 2 * kSpaceLeft - kScaleRoom,
                     high = drawing_.height - kSpaceTop - kSpaceBelow;
        scale_ = std::min(wide / std::max(1e-9, x1 - x0), high / std::max(1e-9, y1 - y0));
        shift_ = {kSpaceLeft + 0.5 * wide - scale_ * 0.5 * (x0 + x1),
                  kSpaceTop + 0.5 * high + scale_ * 0.5 * (y0 + y1)};
    }

    [[nodiscard]] Point at(const Vec3& p) const {
        const Point flat = camera_.flat(p);
        return {shift_.x + scale_ * flat.x, shift_.y - scale_ * flat.y};
    }

    void gather() {
        const double size = (box_.high - box_.low).norm();
        const std::vector<bool> visible = visible_bodies(recording_);
        for (std::size_t i = 0; i < recording_.bodies.size(); ++i) {
            if (!frame_.there[i]) continue;
            const record::RecordedBody& body = recording_.bodies[i];
            const Mat3 turn = frame_.poses[i].orientation.normalized().toRotationMatrix();
            const double reach = body.half_size.maxCoeff();
            for (record::Triangles& t : record::body_surfaces(recording_, i)) {
                for (Vec3& p : t.points) p = frame_.poses[i].position + turn * p;
                const bool hull = reach > 0.02 * size && reach > 8.0;
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

    void polygon(const std::vector<Vec3>& points, Color fill, Color stroke, double width) {
        Path path{.points = {}, .stroke = stroke, .width = width, .fill = fill, .closed = true};
        for (const Vec3& p : points) path.points.push_back(at(p));
        drawing_.add(std::move(path));
    }

    /// Rectangle of the box at a level, with lines at round numbers; on the water with the numbers.
    void draw_level(double z, Color fill, Color line, bool numbers) {
        const Vec3 &a = box_.low, &b = box_.high;
        polygon({{a.x(), a.y(), z}, {b.x(), a.y(), z}, {b.x(), b.y(), z}, {a.x(), b.y(), z}}, fill,
                line, 1.0);
        const double size = std::max(b.x() - a.x(), b.y() - a.y());
        const std::vector<double> round = ticks({0.0, size}, 8);
        const double every = round.size() > 1 ? round[1] - round[0] : size;
        numbered_ = numbered_ || numbers;
        for (int k = 0; k < 2; ++k)
            for (double t = std::ceil(a[k] / every) * every; t <= b[k]; t += every) {
                Vec3 from = a, to = b;
                from[k] = to[k] = t;
                from.z() = to.z() = z;
                broken_line(from, to, line.with_alpha(numbers ? 70 : 110), 0.8, {});
                if (numbers || !water_.level) put_number(k, t, every, z);
            }
    }

    /// Beside the edge that is nearer to the viewer.
    void put_number(int k, double value, double every, double z) {
        const int other = 1 - k;
        const bool high_side = camera_.to_viewer[other] > 0.0;
        Vec3 end = high_side ? box_.high : box_.low;
        end[k] = value;
        end.z() = z;
        Vec3 out = Vec3::Zero();
        out[other] = high_side ? 1.0 : -1.0;
        const Point on = at(end), beyond = at(end + out);
        const double length = std::hypot(beyond.x - on.x, beyond.y - on.y);
        if (length <= 0.0) return;
        const Point d{(beyond.x - on.x) / length, (beyond.y - on.y) / length};
        drawing_.line(on, {on.x + 5 * d.x, on.y + 5 * d.y}, kSoft, 1.0);
        drawing_.text({on.x + 15 * d.x, on.y + 15 * d.y + 4},
                      tick_label(value, every) + (value == 0.0 ? (k == 0 ? " x" : " y") : ""), 11.0,
                      Anchor::middle, kSoft);
    }

    /// Where no solid stands before it, in pieces.
    void broken_line(const Vec3& from, const Vec3& to, Color color, double width,
                     const std::vector<double>& dash) {
        const Point a = at(from), b = at(to);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const int pieces = std::clamp(static_cast<int>(length / 4.0), 1, 400);
        std::vector<Point> run;
        const auto flush = [&] {
            if (run.size() > 1)
                drawing_.add(Path{.points = run, .stroke = color, .width = width, .dash = dash});
            run.clear();
        };
        for (int i = 0; i < pieces; ++i) {
            const double s = static_cast<double>(i) / pieces, e = (i + 1.0) / pieces;
            if (is_hidden(from + 0.5 * (s + e) * (to - from), solids_, camera_)) {
                flush();
                continue;
            }
            if (run.empty()) run.push_back(at(from + s * (to - from)));
            run.push_back(at(from + e * (to - from)));
        }
        // Straight: its ends are enough.
        if (run.size() > 2) run = {run.front(), run.back()};
        flush();
    }

    void draw_grounds_lines() {
        for (const record::RecordedOutline& o : recording_.outlines) {
            if (o.kind != record::OutlineKind::lines) continue;
            const Pose& pose = frame_.poses[static_cast<std::size_t>(o.body)];
            const auto row = static_cast<std::size_t>(o.row);
            for (std::size_t i = 0; i + row <= o.points.size(); i += row) {
                Path path{.points = {}, .stroke = kSandLine.with_alpha(150), .width = 0.6};
                for (std::size_t k = i; k < i + row; ++k)
                    path.points.push_back(at(pose.position + pose.orientation * o.points[k]));
                drawing_.add(std::move(path));
            }
        }
    }

    /// What lies above the water, or below.
    void draw_layer(double level, bool above) {
        const Vec3 light =
            (0.35 * camera_.to_viewer - 0.45 * camera_.right + 0.82 * camera_.up).normalized();
        for (const std::size_t i : painting_order(solids_, camera_)) {
            const Solid& s = solids_[i];
            for (std::size_t f = 0; f < s.normals.size(); ++f) {
                if (s.normals[f].dot(camera_.to_viewer) <= 1e-9) continue;
                const auto& c = s.surface.corners[f];
                const std::vector<Vec3> part = clipped(
                    {s.surface.points[c[0]], s.surface.points[c[1]], s.surface.points[c[2]]}, level,
                    above);
                if (part.empty()) continue;
                const double strength = 0.62 + 0.5 * std::max(0.0, s.normals[f].dot(light)) +
                                        0.06 * s.normals[f].dot(camera_.right);
                const Color fill = shaded(s.color, strength);
                polygon(part, fill, fill, 0.6);  // over the seams between triangles
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

    static bool clip(Vec3& from, Vec3& to, double level, bool above) {
        const double sign = above ? 1.0 : -1.0;
        const double a = sign * (from.z() - level), b = sign * (to.z() - level);
        if (a < 0.0 && b < 0.0) return false;
        const Vec3 cut = a == b ? from : Vec3(from + a / (a - b) * (to - from));
        if (a < 0.0) from = cut;
        if (b < 0.0) to = cut;
        return true;
    }

    void draw_dot(const Vec3& p) {
        const Point c = at(p);
        Path path{
            .points = {}, .stroke = kEdge, .width = 1.0, .fill = kStructureColor, .closed = true};
        for (int i = 0; i < 16; ++i)
            path.points.push_back(
                {c.x + 4.5 * std::cos(i * 0.392699), c.y + 4.5 * std::sin(i * 0.392699)});
        drawing_.add(std::move(path));
    }

    void draw_wires(double level, bool above) {
        const WireReader reader(recording_);
        std::vector<WireLine> lines;
        reader.read(frame_, lines);
        for (const WireLine& line : lines)
            for (const WirePiece& s : line.segments) {
                Vec3 from = s.from, to = s.to;
                if (s.parted) {
                    for (const Vec3& end : {from, to})
                        if ((end.z() >= level) == above) draw_cross(end);
                    continue;
                }
                if (!clip(from, to, level, above)) continue;
                broken_line(from, to, scale_color((s.tension - tension_.low) / tension_.span()),
                            2.2, {});
            }
    }

    void draw_cross(const Vec3& end) {
        if (is_hidden(end, solids_, camera_)) return;
        const Point p = at(end);
        for (const double side : {-5.0, 5.0})
            drawing_.line({p.x - 5, p.y - side}, {p.x + 5, p.y + side}, kPartedColor, 2.2);
    }

    /// Rods, and lines from bodies to joints outside their box.
    void draw_joints(double level, bool above) {
        for (const record::RecordedJoint& joint : recording_.joints) {
            Vec3 where[2];
            bool drawn = true;
            for (int k = 0; k < 2; ++k) {
                const auto body = static_cast<std::size_t>(joint.body[k]);
                drawn =
                    drawn && frame_.there[body] && recording_.bodies[body].kind != BodyKind::scalar;
                where[k] = frame_.poses[body].position +
                           frame_.poses[body].orientation.normalized() * joint.point[k];
            }
            if (!drawn) continue;
            const auto line = [&](Vec3 from, Vec3 to) {
                if (clip(from, to, level, above)) broken_line(from, to, kEdge, 1.6, {});
            };
            line(where[0], where[1]);
            for (int k = 0; k < 2; ++k) {
                const auto body = static_cast<std::size_t>(joint.body[k]);
                const record::RecordedBody& b = recording_.bodies[body];
                if ((joint.point[k].cwiseAbs().array() > 1.05 * b.half_size.array()).any() &&
                    b.kind != BodyKind::fixed)
                    line(frame_.poses[body].position, where[k]);
            }
        }
    }

    void draw_paths(const record::Series& series) {
        for (std::size_t i = 0; i < series.bodies.size(); ++i) {
            const record::BodySeries& s = series.bodies[i];
            const record::RecordedBody& body = recording_.bodies[static_cast<std::size_t>(s.body)];
            if (body.kind == BodyKind::scalar) continue;
            std::vector<Point> path;
            for (std::size_t t = 0; t < s.value[0].size(); ++t) {
                const Point p =
                    at(body.start.position + Vec3(s.value[0][t], s.value[1][t], s.value[2][t]));
                if (path.empty() || std::hypot(p.x - path.back().x, p.y - path.back().y) > 0.7)
                    path.push_back(p);
            }
            drawing_.add(Path{.points = std::move(path),
                              .stroke = curve_color(i).with_alpha(130),
                              .width = 1.1,
                              .dash = {5, 4}});
        }
    }

    /// The plotted bodies and cables, where they find room.
    void draw_names() {
        std::vector<Box> taken;
        const auto put = [&](const Vec3& where, const std::string& name, double size, bool bold) {
            const Point p = at(where);
            const double w = text_width(name, size, bold);
            for (const double up : {10.0, 26.0, -22.0, 42.0, -38.0})
                for (const double side : {0.0, -0.6, 0.6}) {
                    const Box box{p.x - 0.5 * w + side * w, p.y - up - size, w, size + 4};
                    const bool free = box.x > 4 && box.right() < drawing_.width - kScaleRoom + 20 &&
                                      box.y > kSpaceTop - 20 &&
                                      box.bottom() < drawing_.height - 20 &&
                                      std::none_of(
                                          taken.begin(), taken.end(),
                                          [&](const Box& t) {
                                              return box.x < t.right() && t.x < box.right() &&
                                                     box.y < t.bottom() && t.y < box.bottom();
                                          });
                    if (!free) continue;
                    drawing_.add(Text{.at = {box.x, p.y - up},
                                      .text = name,
                                      .size = size,
                                      .bold = bold,
                                      .color = bold ? kInk : kSoft,
                                      .halo = true});
                    taken.push_back(box);
                    return;
                }
        };
        for (const std::int32_t index : recording_.plot_bodies) {
            const auto b = static_cast<std::size_t>(index);
            const record::RecordedBody& body = recording_.bodies[b];
            if (body.kind == BodyKind::scalar || !frame_.there[b]) continue;
            const Mat3 turn = frame_.poses[b].orientation.normalized().toRotationMatrix();
            const double up = turn.row(2).cwiseAbs().dot(body.half_size);
            put(frame_.poses[b].position + up * Vec3::UnitZ(), body.name, 12.5, true);
        }
        const WireReader reader(recording_);
        std::vector<WireLine> lines;
        reader.read(frame_, lines);
        for (const std::int32_t index : recording_.plot_cables)
            if (const auto& l = lines[static_cast<std::size_t>(index)]; l.segments.size() > 2)
                put(l.segments[l.segments.size() / 2].from, std::string(l.name), 11.0, false);
    }

    /// Colour bar, what has parted, what is shown.
    void draw_frame() {
        if (recording_.element_count > 0) {
            const record::Unit unit = record::readable_unit(tension_.high, "N");
            draw_color_bar(drawing_,
                           {drawing_.width - kScaleRoom + 14, kSpaceTop + 30, 20,
                            std::min(360.0, drawing_.height - kSpaceTop - kSpaceBelow - 40)},
                           {tension_.low * unit.factor, tension_.high * unit.factor},
                           fmt::format("tension [{}]", unit.name));
        }
        std::string note = "Grid in m.";
        if (water_.level) note += fmt::format(" Blue: still water, z = {:.4g} m.", *water_.level);
        if (water_.seabed) note += fmt::format(" Sand: seabed, z = {:.4g} m.", *water_.seabed);
        note += " Dashed: paths of the plotted bodies.";
        drawing_.text({28, drawing_.height - 16}, note, 12.0, Anchor::start, kSoft);
        const std::vector<PartedElement> parted = parted_elements(recording_, frame_.time);
        if (parted.empty()) return;
        std::string text = "Crosses: ";
        for (std::size_t i = 0; i < std::min<std::size_t>(4, parted.size()); ++i)
            text += (i > 0 ? "; " : "") + parted[i].text;
        if (parted.size() > 4) text += fmt::format(" and {} more", parted.size() - 4);
        drawing_.text({28, drawing_.height - 34}, text + ".", 12.0, Anchor::start, kPartedColor);
    }

    const record::Recording& recording_;
    const record::Frame& frame_;
    Camera camera_;
    Water water_;
    Bounds box_;
    Range tension_;
    Drawing drawing_;
    double scale_ = 1.0;
    Point shift_;
    bool numbered_ = false;
    std::vector<Solid> solids_;
    std::vector<Vec3> dots_;
};

}  // namespace

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
