// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_layout.h"

#include "draw/projection.h"

#include <algorithm>
#include <map>

namespace hawser::exporting {
namespace {

constexpr double kMaxEndDistance =
    1e-6;  ///< Largest distance of segment ends that count as joined [m].

void add_bodies(const record::Recording& recording, Layout& out) {
    const std::vector<bool> visible = draw::visible_bodies(recording);
    for (std::size_t i = 0; i < recording.bodies.size(); ++i) {
        if (!visible[i]) continue;
        const BodyKind kind = recording.bodies[i].kind;
        BodyNode node;
        node.body = static_cast<std::int32_t>(i);
        node.surfaces = record::body_surfaces(recording, i);
        node.moves = kind != BodyKind::fixed;
        node.has_rotation = kind == BodyKind::rigid || kind == BodyKind::kinematic;
        out.bodies.push_back(std::move(node));
    }
}

/// Add rods, and lines from bodies to joints outside their box.
void add_rods(const record::Recording& recording, Layout& out) {
    constexpr double kNoLength = 1e-3;
    std::map<std::int32_t, std::size_t> place;
    for (std::size_t i = 0; i < out.bodies.size(); ++i) place[out.bodies[i].body] = i;
    for (const record::RecordedJoint& joint : recording.joints) {
        const auto a = place.find(joint.body[0]), b = place.find(joint.body[1]);
        if (a == place.end() || b == place.end()) continue;
        const std::size_t at[2] = {a->second, b->second};
        Vec3 where[2];
        for (int k = 0; k < 2; ++k) {
            const auto& body = recording.bodies[static_cast<std::size_t>(joint.body[k])];
            where[k] = body.start.position + body.start.orientation * joint.point[k];
            const bool outside =
                (joint.point[k].cwiseAbs().array() > 1.05 * body.half_size.array()).any();
            if (outside && body.kind != BodyKind::fixed && joint.point[k].norm() > kNoLength)
                out.rods.push_back({{at[k], at[k]}, {Vec3::Zero(), joint.point[k]}});
        }
        if ((where[1] - where[0]).norm() > kNoLength)
            out.rods.push_back({{at[0], at[1]}, {joint.point[0], joint.point[1]}});
    }
}

void follow_wires(const std::vector<WireLine>& lines, Layout& out) {
    for (const WireLine& line : lines) {
        auto wire = std::find_if(out.wires.begin(), out.wires.end(),
                                 [&](const WireNodes& w) { return w.name == line.name; });
        if (wire == out.wires.end()) {
            out.wires.push_back({.name = std::string(line.name), .peak = {}});
            wire = std::prev(out.wires.end());
        }
        wire->segments = std::max(wire->segments, line.segments.size());
        wire->peak.resize(wire->segments, 0.0F);
        for (std::size_t i = 0; i < line.segments.size(); ++i) {
            const WirePiece& s = line.segments[i];
            wire->peak[i] = std::max(wire->peak[i], s.tension);
            if (s.parted || (i > 0 && (line.segments[i - 1].to - s.from).norm() > kMaxEndDistance))
                wire->joined = false;
        }
    }
}

}  // namespace

Layout compute_layout(const record::Recording& recording, const Frames& frames) {
    Layout out;
    add_bodies(recording, out);
    add_rods(recording, out);
    const WireReader reader(recording);
    std::vector<WireLine> lines;
    draw::Bounds bounds;
    for (const std::size_t index : frames) {
        const record::Frame frame = recording.frame(index);
        for (BodyNode& node : out.bodies) {
            const auto body = static_cast<std::size_t>(node.body);
            if (!frame.there[body]) node.comes = true;
            bounds.add(frame.poses[body].position);
        }
        reader.read(frame, lines);
        follow_wires(lines, out);
    }
    for (const WireLine& line : lines)
        for (const WirePiece& s : line.segments) bounds.add(s.from);
    if (!bounds.empty()) out.size = std::max(1e-3, (bounds.high - bounds.low).norm());
    for (const WireNodes& wire : out.wires)
        for (const float t : wire.peak) out.max_tension = std::max(out.max_tension, t);
    return out;
}

void joint_positions(const WireNodes& wire, const WireLine& line, std::vector<Vec3>& out) {
    out.assign(wire.joints(), Vec3::Zero());
    Vec3 last = line.segments.empty() ? Vec3(Vec3::Zero()) : line.segments.front().from;
    for (std::size_t i = 0; i < wire.segments; ++i) {
        Vec3 from = last, to = last;
        if (i < line.segments.size()) {
            const WirePiece& s = line.segments[i];
            from = s.from;
            last = s.to;
            to = s.parted ? s.from : s.to;
        }
        out[wire.joint(i, 0)] = from;
        out[wire.joint(i, 1)] = to;
    }
}

}  // namespace hawser::exporting
