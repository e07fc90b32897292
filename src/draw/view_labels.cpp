// SPDX-License-Identifier: Apache-2.0
#include "draw/view_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace hawser::draw {

namespace {

constexpr double kBodySize = 12.0, kCableSize = 11.0;
constexpr double kNamedSize = 16.0;  // Smallest size of a body with a name [points].
constexpr std::size_t kMaxNames = 400;

bool overlaps(const Box& a, const Box& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

// True if a part of a segment is inside a box (Liang and Barsky, 1984).
bool segment_crosses(const Point& a, const Point& b, const Box& box) {
    double enter = 0.0, leave = 1.0;
    const double d[2] = {b.x - a.x, b.y - a.y};
    const double low[2] = {box.x - a.x, box.y - a.y};
    const double high[2] = {box.right() - a.x, box.bottom() - a.y};
    for (int k = 0; k < 2; ++k) {
        if (d[k] == 0.0) {
            if (low[k] > 0.0 || high[k] < 0.0) return false;
            continue;
        }
        const double p = low[k] / d[k], q = high[k] / d[k];
        enter = std::max(enter, std::min(p, q));
        leave = std::min(leave, std::max(p, q));
    }
    return enter <= leave;
}

// Placement of names such that they hide as little as possible.
class Placer {
  public:
    Placer(Drawing& drawing, const Axes& axes, const View& view, const record::Recording& recording,
           const record::Frame& frame)
        : drawing_(drawing), axes_(axes), view_(view), frame_(frame) {
        for (const record::RecordedCable& cable : recording.cables)
            for (std::size_t i = 0; i + 1 < cable.nodes.size(); ++i)
                lines_.emplace_back(node(cable, i), node(cable, i + 1));
    }

    [[nodiscard]] Point node(const record::RecordedCable& cable, std::size_t i) const {
        const auto body = static_cast<std::size_t>(cable.nodes[i]);
        return project(axes_, view_, frame_.poses[body].position);
    }

    void body(const Box& at, const std::string& name) {
        const double w = text_width(name, kBodySize, true), x = at.x + 0.5 * at.width;
        std::optional<Choice> best;
        for (const double off : {7.0, 26.0, 45.0, 64.0, 83.0}) {
            for (const double side : {0.0, -0.7, 0.7, -1.3, 1.3}) {
                const double left = x - 0.5 * w + side * w;
                consider_position(best, {left, at.y - off}, w, kBodySize,
                                  off + 12.0 * std::abs(side));
                consider_position(best, {left, at.bottom() + off + kBodySize - 4}, w, kBodySize,
                                  off + 2.0 + 12.0 * std::abs(side));
            }
            const double middle = at.y + 0.5 * at.height + 4;
            consider_position(best, {at.right() + off, middle}, w, kBodySize, off + 4.0);
            consider_position(best, {at.x - w - off, middle}, w, kBodySize, off + 4.0);
        }
        if (!best) return;
        const Box& box = best->box;
        // Draw the line from the label's point nearest to the body to the body's point nearest to
        // the label.
        const double middle = at.y + 0.5 * at.height;
        const Point from{std::clamp(x, box.x, box.right()),
                         std::clamp(middle, box.y, box.bottom())};
        const Point to{std::clamp(from.x, at.x, at.right()), std::clamp(from.y, at.y, at.bottom())};
        if (std::hypot(to.x - from.x, to.y - from.y) > 16.0) drawing_.line(from, to, kSoft, 0.8);
        drawing_.add(
            Text{.at = best->at, .text = name, .size = kBodySize, .bold = true, .halo = true});
        occupied_.push_back(box);
    }

    void cable(const record::RecordedCable& cable) {
        const double w = text_width(cable.name, kCableSize);
        const Point a = node(cable, 0), b = node(cable, cable.nodes.size() - 1);
        if (std::hypot(b.x - a.x, b.y - a.y) < w + 20.0) return;  // The name would hide the cable.
        std::optional<Choice> best;
        for (const double fraction : {0.5, 0.42, 0.58, 0.33, 0.67, 0.25, 0.75, 0.15, 0.85}) {
            const Point p = node(
                cable,
                static_cast<std::size_t>(fraction * static_cast<double>(cable.nodes.size() - 1)));
            const double off = 20.0 * std::abs(fraction - 0.5);
            consider_position(best, {p.x - 0.5 * w, p.y - 6}, w, kCableSize, off);
            consider_position(best, {p.x - 0.5 * w, p.y + kCableSize + 5}, w, kCableSize,
                              off + 1.0);
            consider_position(best, {p.x + 7, p.y + 4}, w, kCableSize, off + 2.0);
            consider_position(best, {p.x - w - 7, p.y + 4}, w, kCableSize, off + 2.0);
        }
        if (!best) return;
        drawing_.add(Text{
            .at = best->at, .text = cable.name, .size = kCableSize, .color = kSoft, .halo = true});
        occupied_.push_back(best->box);
    }

    void reserve_box(const Box& box) { bodies_.push_back(box); }

  private:
    struct Choice {
        Point at;
        Box box;
        double cost = 0.0;
    };

    // Rate a position for a text of width w with its base point at p, and keep it if it is better
    // than `best`. @param off  Cost of its distance from the object.
    void consider_position(std::optional<Choice>& best, Point p, double w, double size,
                           double off) const {
        const Box box{p.x, p.y - size, w, size + 3};
        const Box& frame = axes_.frame;
        if (box.x < frame.x + 2 || box.right() > frame.right() - 2 || box.y < frame.y + 2 ||
            box.bottom() > frame.bottom() - 2)
            return;
        for (const Box& other : occupied_)
            if (overlaps(box, other)) return;
        double cost = off;
        for (const Box& other : bodies_) cost += overlaps(box, other) ? 25.0 : 0.0;
        for (const auto& [from, to] : lines_) {
            if (best && cost >= best->cost) return;
            if (segment_crosses(from, to, box)) cost += 12.0;
        }
        if (!best || cost < best->cost) best = {p, box, cost};
    }

    Drawing& drawing_;
    const Axes& axes_;
    const View& view_;
    const record::Frame& frame_;
    std::vector<std::pair<Point, Point>> lines_;
    std::vector<Box> bodies_, occupied_;
};

// Return the plotted bodies, then the others that are not part of a cable.
std::vector<std::int32_t> bodies_to_name(const record::Recording& recording,
                                         const std::vector<bool>& visible) {
    std::vector<std::int32_t> bodies = recording.plot_bodies;
    const std::vector<bool> interior = record::cable_interior(recording);
    for (std::size_t i = 0; i < visible.size() && bodies.size() < kMaxNames; ++i)
        if (visible[i] && !interior[i] && recording.bodies[i].kind == BodyKind::rigid &&
            std::find(bodies.begin(), bodies.end(), static_cast<std::int32_t>(i)) == bodies.end())
            bodies.push_back(static_cast<std::int32_t>(i));
    return bodies;
}

}  // namespace

void draw_names(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Frame& frame,
                const std::string& assembly) {
    Placer placer(drawing, axes, view, recording, frame);
    const std::vector<bool> visible = visible_bodies(recording);
    std::vector<std::pair<Box, std::string>> names;
    const std::size_t plotted = recording.plot_bodies.size();
    const auto bodies = bodies_to_name(recording, visible);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const auto i = static_cast<std::size_t>(bodies[k]);
        const std::string& name = recording.bodies[i].name;
        if (name.empty() || !visible[i]) continue;
        const Box at = body_extent(axes, view, recording.bodies[i], frame.poses[i]);
        if (at.right() < axes.frame.x || at.x > axes.frame.right() || at.bottom() < axes.frame.y ||
            at.y > axes.frame.bottom())
            continue;
        // Names may cover a hull but not a boom.
        if (at.width < 120.0 || at.height < 30.0) placer.reserve_box(at);
        if (k >= plotted && std::max(at.width, at.height) < kNamedSize) continue;
        const bool own = !assembly.empty() && name.size() > assembly.size() &&
                         name.compare(0, assembly.size(), assembly) == 0;
        names.emplace_back(at, own ? name.substr(assembly.size()) : name);
    }
    for (const auto& [at, name] : names) placer.body(at, name);
    for (const std::int32_t index : recording.plot_cables) {
        const record::RecordedCable& cable = recording.cables[static_cast<std::size_t>(index)];
        if (cable.nodes.size() >= 3) placer.cable(cable);
    }
}

Range tension_range(const record::Frame& frame) {
    const std::vector<float>& of = frame.wires != nullptr ? frame.pulls : frame.tensions;
    std::vector<double> values(of.begin(), of.end());
    values.insert(values.end(), frame.line_pulls.begin(), frame.line_pulls.end());
    for (double& value : values) value = std::max(0.0, value);  // −1 for broken elements
    Range r = range_of(values);
    if (r.low > 0.0 && r.low < 0.6 * r.high) r.low = 0.0;
    // A range below a hundredth of the value would show noise in colour.
    return widened(r, 0.0, std::max(1.0, 1e-2 * std::abs(r.high)));
}

}  // namespace hawser::draw
