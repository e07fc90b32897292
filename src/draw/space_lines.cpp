// SPDX-License-Identifier: Apache-2.0
/// Draw the lines of a view in space: grids of levels, wires, rods, paths.
#include "draw/parted.h"
#include "draw/space.h"
#include "draw/wire_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::draw {
namespace {

/// Largest number of lines of a grid. Far from the origin the rounding of numbers could make the
/// loop endless.
constexpr int kMaxLines = 64;
constexpr Color kGroundLine{168, 148, 116, 150}, kRodLine{38, 46, 56, 255};

}  // namespace

void Space::polygon(const std::vector<Vec3>& points, Color fill, Color stroke, double width) {
    Path path{.points = {}, .stroke = stroke, .width = width, .fill = fill, .closed = true};
    for (const Vec3& p : points) path.points.push_back(at(p));
    drawing_.add(std::move(path));
}

/// Draw the visible parts of a line inside the box, in pieces that no solid hides.
void Space::broken_line(const Vec3& from, const Vec3& to, Color color, double width) {
    const Point a = at(from), b = at(to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int pieces = std::clamp(static_cast<int>(length / 4.0), 1, 400);
    double begin = -1.0, end = 0.0;
    const auto flush = [&] {
        if (begin >= 0.0)
            drawing_.line(at(from + begin * (to - from)), at(from + end * (to - from)), color,
                          width);
        begin = -1.0;
    };
    for (int i = 0; i < pieces; ++i) {
        const double s = static_cast<double>(i) / pieces, e = (i + 1.0) / pieces;
        const Vec3 middle = from + 0.5 * (s + e) * (to - from);
        if (!inside(middle) || is_hidden(middle, solids_, camera_)) {
            flush();
            continue;
        }
        if (begin < 0.0) begin = s;
        end = e;
    }
    flush();
}

void Space::draw_level(double z, Color fill, Color line, bool numbers) {
    const Vec3 &a = box_.low, &b = box_.high;
    polygon({{a.x(), a.y(), z}, {b.x(), a.y(), z}, {b.x(), b.y(), z}, {a.x(), b.y(), z}}, fill,
            line, 1.0);
    const double size = std::max(b.x() - a.x(), b.y() - a.y());
    const std::vector<double> round = ticks({0.0, size}, 8);
    const double every = round.size() > 1 ? round[1] - round[0] : size;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < kMaxLines; ++i) {
            const double n = std::ceil(a[k] / every) + i;
            if (!(n * every <= b[k])) break;
            const double t = n * every + 0.0;  // avoids −0
            Vec3 from = a, to = b;
            from[k] = to[k] = t;
            from.z() = to.z() = z;
            broken_line(from, to, line.with_alpha(numbers ? 70 : 110), 0.8);
            if (numbers || !water_.level) draw_number(k, t, every, z);
        }
}

void Space::draw_number(int k, double value, double every, double z) {
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

void Space::draw_grounds_lines() {
    for (const record::RecordedOutline& o : recording_.outlines) {
        if (o.kind != record::OutlineKind::lines) continue;
        const Pose& pose = frame_.poses[static_cast<std::size_t>(o.body)];
        const auto row = static_cast<std::size_t>(o.row);
        for (std::size_t i = 0; i + row <= o.points.size(); i += row) {
            Path path{.points = {}, .stroke = kGroundLine, .width = 0.6};
            for (std::size_t k = i; k < i + row; ++k)
                path.points.push_back(at(pose.position + pose.orientation * o.points[k]));
            drawing_.add(std::move(path));
        }
    }
}

bool Space::clip(Vec3& from, Vec3& to, double level, bool above) {
    const double sign = above ? 1.0 : -1.0;
    const double a = sign * (from.z() - level), b = sign * (to.z() - level);
    if (a < 0.0 && b < 0.0) return false;
    const Vec3 cut = a == b ? from : Vec3(from + a / (a - b) * (to - from));
    if (a < 0.0) from = cut;
    if (b < 0.0) to = cut;
    return true;
}

void Space::draw_wires(double level, bool above) {
    const WireReader reader(recording_);
    std::vector<WireLine> lines;
    reader.read(frame_, lines);
    for (const WireLine& line : lines)
        for (const WirePiece& s : line.segments) {
            Vec3 from = s.from, to = s.to;
            if (s.parted) {
                for (const Vec3& end : {from, to})
                    if ((end.z() >= level) == above && inside(end)) draw_cross(end);
                continue;
            }
            if (!clip(from, to, level, above)) continue;
            broken_line(from, to, scale_color((s.tension - tension_.low) / tension_.span()), 2.2);
        }
}

void Space::draw_cross(const Vec3& end) {
    if (is_hidden(end, solids_, camera_)) return;
    const Point p = at(end);
    for (const double side : {-5.0, 5.0})
        drawing_.line({p.x - 5, p.y - side}, {p.x + 5, p.y + side}, kBrokenColor, 2.2);
}

void Space::draw_joints(double level, bool above) {
    for (std::size_t j = 0; j < recording_.joints.size(); ++j) {
        const record::RecordedJoint& joint = recording_.joints[j];
        Vec3 where[2];
        bool drawn = !is_removed(frame_, j);
        for (int k = 0; k < 2; ++k) {
            const auto body = static_cast<std::size_t>(joint.body[k]);
            drawn = drawn && frame_.there[body] && recording_.bodies[body].kind != BodyKind::scalar;
            where[k] = frame_.poses[body].position +
                       frame_.poses[body].orientation.normalized() * joint.point[k];
        }
        if (!drawn) continue;
        const auto line = [&](Vec3 from, Vec3 to) {
            if (clip(from, to, level, above)) broken_line(from, to, kRodLine, 1.6);
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

void Space::draw_paths(const record::Series& series) {
    for (std::size_t i = 0; i < series.bodies.size(); ++i) {
        const record::BodySeries& s = series.bodies[i];
        const record::RecordedBody& body = recording_.bodies[static_cast<std::size_t>(s.body)];
        if (body.kind == BodyKind::scalar) continue;
        Path path{
            .points = {}, .stroke = curve_color(i).with_alpha(130), .width = 1.1, .dash = {5, 4}};
        const auto put = [&] {
            if (path.points.size() > 1) drawing_.add(path);
            path.points.clear();
        };
        for (const auto& [begin, end] : record::continuous_intervals(series, s.value[0])) {
            for (std::size_t t = begin; t < end; ++t) {
                const Vec3 where =
                    body.start.position + Vec3(s.value[0][t], s.value[1][t], s.value[2][t]);
                if (!inside(where)) {
                    put();
                    continue;
                }
                const Point p = at(where);
                if (path.points.empty() ||
                    std::hypot(p.x - path.points.back().x, p.y - path.points.back().y) > 0.7)
                    path.points.push_back(p);
            }
            put();
        }
    }
}

}  // namespace hawser::draw
