// SPDX-License-Identifier: Apache-2.0
/// Add labels to a view in space: heights, names, colours, broken cables.
#include "draw/parted.h"
#include "draw/space.h"
#include "draw/wire_lines.h"
#include "record/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::draw {

/// Draw a scale of heights at the leftmost corner of the box.
void Space::draw_heights() {
    Vec3 foot = box_.low;
    for (const Vec3& corner : corners())
        if (corner.z() == box_.low.z() && at(corner).x < at(foot).x) foot = corner;
    Vec3 top = foot;
    top.z() = box_.high.z();
    const double length = std::abs(at(top).y - at(foot).y);
    if (length < 40.0) return;
    const std::vector<double> heights =
        ticks({foot.z(), top.z()}, std::max(2, static_cast<int>(length / 45.0)));
    const double every = heights.size() > 1 ? heights[1] - heights[0] : top.z() - foot.z();
    drawing_.line(at(foot), at(top), kSoft, 1.0);
    for (const double z : heights) {
        const Point p = at({foot.x(), foot.y(), z});
        drawing_.line({p.x - 5, p.y}, p, kSoft, 1.0);
        drawing_.text({p.x - 9, p.y + 4}, tick_label(z, every), 11.0, Anchor::end, kSoft);
    }
    drawing_.text({at(top).x, at(top).y - 8}, "z", 11.0, Anchor::middle, kSoft);
}

void Space::draw_names() {
    std::vector<Box> occupied;
    const auto put = [&](const Vec3& where, const std::string& name, double size, bool bold) {
        const Point p = at(where);
        const double w = text_width(name, size, bold);
        for (const double up : {10.0, 26.0, -22.0, 42.0, -38.0})
            for (const double side : {0.0, -0.6, 0.6}) {
                const Box box{p.x - 0.5 * w + side * w, p.y - up - size, w, size + 4};
                const bool free = box.x > 4 && box.right() < drawing_.width - kScaleRoom + 20 &&
                                  box.y > kSpaceTop - 20 && box.bottom() < drawing_.height - 20 &&
                                  std::none_of(
                                      occupied.begin(), occupied.end(),
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
                occupied.push_back(box);
                return;
            }
    };
    for (const std::int32_t index : recording_.plot_bodies) {
        const auto b = static_cast<std::size_t>(index);
        const record::RecordedBody& body = recording_.bodies[b];
        if (body.kind == BodyKind::scalar || !frame_.there[b] || !inside(frame_.poses[b].position))
            continue;
        const Mat3 turn = frame_.poses[b].orientation.normalized().toRotationMatrix();
        const double up = turn.row(2).cwiseAbs().dot(body.half_size);
        put(frame_.poses[b].position + up * Vec3::UnitZ(), body.name, 12.5, true);
    }
    const WireReader reader(recording_);
    std::vector<WireLine> lines;
    reader.read(frame_, lines);
    for (const std::int32_t index : recording_.plot_cables)
        if (const auto& l = lines[static_cast<std::size_t>(index)];
            l.segments.size() > 2 && inside(l.segments[l.segments.size() / 2].from))
            put(l.segments[l.segments.size() / 2].from, std::string(l.name), 11.0, false);
}

void Space::draw_frame() {
    if (recording_.element_count > 0) {
        const record::Unit unit = record::readable_unit(tension_.high, "N");
        const double height = std::min(360.0, drawing_.height - kSpaceTop - kSpaceBelow - 40);
        // Hulls extend beyond axes that the user set.
        drawing_.box({drawing_.width - kScaleRoom, kSpaceTop, kScaleRoom, height + 50}, kWhite);
        draw_color_bar(drawing_, {drawing_.width - kScaleRoom + 14, kSpaceTop + 30, 20, height},
                       {tension_.low * unit.factor, tension_.high * unit.factor},
                       fmt::format("tension [{}]", unit.name));
    }
    std::string note = "Grid in m.";
    if (water_.level) note += fmt::format(" Blue: still water, z = {:.4g} m.", *water_.level);
    if (water_.seabed) note += fmt::format(" Sand: seabed, z = {:.4g} m.", *water_.seabed);
    note += " Dashed: paths of the plotted bodies.";
    drawing_.text({28, drawing_.height - 16}, note, 12.0, Anchor::start, kSoft);
    const std::vector<BrokenElement> parted = broken_elements(recording_, frame_.time);
    if (parted.empty()) return;
    std::string text = "Crosses: ";
    for (std::size_t i = 0; i < std::min<std::size_t>(4, parted.size()); ++i)
        text += (i > 0 ? "; " : "") + parted[i].text;
    if (parted.size() > 4) text += fmt::format(" and {} more", parted.size() - 4);
    drawing_.text({28, drawing_.height - 34}, text + ".", 12.0, Anchor::start, kBrokenColor);
}

}  // namespace hawser::draw
