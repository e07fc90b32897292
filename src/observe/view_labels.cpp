// SPDX-License-Identifier: Apache-2.0
#include "observe/view_labels.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::observe {

namespace {

bool overlaps(const Box& a, const Box& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace

void draw_names(Drawing& drawing, const Axes& axes, const View& view, const Recording& recording,
                const Frame& frame) {
    constexpr double kSize = 12.0;
    constexpr std::size_t kMostNames = 400;
    constexpr double kNamedSize = 16.0;  // Smaller bodies go unnamed.
    std::vector<std::int32_t> bodies = recording.plot_bodies;
    const std::vector<bool> visible = visible_bodies(recording);
    const std::vector<bool> interior = cable_interior(recording);
    for (std::size_t i = 0; i < visible.size() && bodies.size() < kMostNames; ++i)
        if (visible[i] && !interior[i] && recording.bodies[i].kind == BodyKind::rigid &&
            std::find(bodies.begin(), bodies.end(), static_cast<std::int32_t>(i)) == bodies.end())
            bodies.push_back(static_cast<std::int32_t>(i));
    std::vector<Box> taken;
    for (const std::int32_t index : bodies) {
        const auto i = static_cast<std::size_t>(index);
        const std::string& name = recording.bodies[i].name;
        if (name.empty() || !visible[i]) continue;
        const Box at = body_extent(axes, view, recording.bodies[i], frame.poses[i]);
        const bool plotted = std::find(recording.plot_bodies.begin(), recording.plot_bodies.end(),
                                       index) != recording.plot_bodies.end();
        if (!plotted && std::max(at.width, at.height) < kNamedSize) continue;
        const double w = text_width(name, kSize, true);
        const Point tries[4] = {{at.x + 0.5 * (at.width - w), at.y - 7},
                                {at.x + 0.5 * (at.width - w), at.bottom() + kSize + 3},
                                {at.right() + 6, at.y + 0.5 * at.height + 4},
                                {at.x - w - 6, at.y + 0.5 * at.height + 4}};
        for (const Point p : tries) {
            const Box box{p.x, p.y - kSize, w, kSize + 2};
            if (box.x < axes.frame.x || box.right() > axes.frame.right() || box.y < axes.frame.y ||
                box.bottom() > axes.frame.bottom() ||
                std::any_of(taken.begin(), taken.end(),
                            [&](const Box& other) { return overlaps(box, other); }))
                continue;
            taken.push_back(box);
            drawing.add(Text{.at = p, .text = name, .size = kSize, .bold = true, .halo = true});
            break;
        }
    }
}

void draw_cable_names(Drawing& drawing, const Axes& axes, const View& view,
                      const Recording& recording, const Frame& frame) {
    for (const std::int32_t index : recording.plot_cables) {
        const RecordedCable& cable = recording.cables[static_cast<std::size_t>(index)];
        if (cable.nodes.size() < 3) continue;
        const auto node = static_cast<std::size_t>(cable.nodes[cable.nodes.size() / 2]);
        const Point at = project(axes, view, frame.poses[node].position);
        const Point from = project(
            axes, view, frame.poses[static_cast<std::size_t>(cable.nodes.front())].position);
        const Point to =
            project(axes, view, frame.poses[static_cast<std::size_t>(cable.nodes.back())].position);
        if (std::hypot(to.x - from.x, to.y - from.y) < text_width(cable.name, 11.0) + 20.0)
            continue;  // The name would hide the cable.
        drawing.add(Text{.at = {at.x, at.y - 6},
                         .text = cable.name,
                         .size = 11.0,
                         .anchor = Anchor::middle,
                         .color = kSoft,
                         .halo = true});
    }
}

Range tension_range(const Frame& frame) {
    const std::vector<double> values(frame.tensions.begin(), frame.tensions.end());
    Range r = range_of(values);
    if (r.low > 0.0 && r.low < 0.6 * r.high) r.low = 0.0;
    return widened(r, 0.0, std::max(1.0, 1e-3 * std::abs(r.high)));
}

}  // namespace hawser::observe
