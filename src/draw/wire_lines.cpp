// SPDX-License-Identifier: Apache-2.0
#include "draw/wire_lines.h"

#include <algorithm>
#include <limits>

namespace hawser::draw {
namespace {

Vec3 position_in_frame(const record::Frame& frame, std::int32_t body, const Vec3& point) {
    const Pose& pose = frame.poses[static_cast<std::size_t>(body)];
    return pose.position + pose.orientation.normalized() * point;
}

}  // namespace

WireReader::WireReader(const record::Recording& recording)
    : recording_(recording),
      broken_(broken_elements(recording, std::numeric_limits<double>::infinity())) {
    for (std::size_t c = 0; c < recording.cables.size(); ++c)
        cables_.emplace(recording.cables[c].name, c);
}

/// Read a cable in its initial form. A drum has no position, so a cable from a drum has one element
/// more than drawn segments: segments correspond to elements from the last one backwards.
void WireReader::read_cable(std::size_t index, const record::Frame& frame, WireLine& out) const {
    const record::RecordedCable& cable = recording_.cables[index];
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < cable.nodes.size(); ++i) {
        const std::int32_t node = cable.nodes[i];
        if (recording_.bodies[static_cast<std::size_t>(node)].kind == BodyKind::scalar) continue;
        const Vec3 local = i == 0                        ? cable.end[0]
                           : i + 1 == cable.nodes.size() ? cable.end[1]
                                                         : Vec3(Vec3::Zero());
        points.push_back(position_in_frame(frame, node, local));
    }
    const auto pieces = static_cast<std::int32_t>(points.size()) - 1;
    for (std::int32_t i = 0; i < pieces; ++i) {
        const auto at = static_cast<std::size_t>(i);
        WirePiece segment{points[at], points[at + 1]};
        if (cable.elements > 0) {
            const std::int32_t element =
                std::min(cable.elements - 1, std::max(0, cable.elements - pieces + i));
            segment.tension = frame.tensions[static_cast<std::size_t>(cable.first_element) +
                                             static_cast<std::size_t>(element)];
            segment.parted =
                std::any_of(broken_.begin(), broken_.end(), [&](const BrokenElement& p) {
                    return p.cable == index && p.element == element && p.time <= frame.time;
                });
        }
        out.segments.push_back(segment);
    }
}

/// Read a wire whose nodes have changed since the start of the recording. If a wheel lies between
/// two pieces of the wire, a chord with the tension of the first piece joins them.
void WireReader::read_wire(const record::RecordedWire& wire, const record::Frame& frame,
                           const std::vector<float>& pulls, WireLine& out) {
    for (std::size_t i = 0; i < wire.pieces.size(); ++i) {
        const record::RecordedPiece& piece = wire.pieces[i];
        const float pull = pulls[wire.first_piece + i];
        const WirePiece segment{position_in_frame(frame, piece.body[0], piece.point[0]),
                                position_in_frame(frame, piece.body[1], piece.point[1]),
                                std::max(0.0F, pull), pull < 0.0F};
        const bool chord = i > 0 && !segment.parted && !out.segments.back().parted &&
                           wire.pieces[i - 1].body[1] == piece.body[0] &&
                           wire.pieces[i - 1].point[1] != piece.point[0];
        if (chord)
            out.segments.push_back(
                {out.segments.back().to, segment.from, out.segments.back().tension, false});
        out.segments.push_back(segment);
    }
}

void WireReader::read(const record::Frame& frame, std::vector<WireLine>& out) const {
    out.clear();
    for (const record::RecordedCable& cable : recording_.cables)
        out.push_back({cable.name, cable.EA, cable.breaking_load, {}});
    std::vector<bool> changed(out.size(), false);
    if (frame.wires != nullptr)
        for (const record::RecordedWire& wire : *frame.wires) {
            auto own = cables_.find(wire.name);
            if (own != cables_.end()) {
                changed[own->second] = true;
                read_wire(wire, frame, frame.pulls, out[own->second]);
                continue;
            }
            // A piece "tow/2" belongs to the cable "tow".
            own = cables_.find(std::string_view(wire.name).substr(0, wire.name.rfind('/')));
            WireLine line{wire.name, 0.0, 0.0, {}};
            if (own != cables_.end()) {
                line.EA = recording_.cables[own->second].EA;
                line.breaking_load = recording_.cables[own->second].breaking_load;
            }
            read_wire(wire, frame, frame.pulls, line);
            out.push_back(std::move(line));
        }
    for (std::size_t c = 0; c < recording_.cables.size(); ++c)
        if (!changed[c]) read_cable(c, frame, out[c]);
    if (frame.lines == nullptr) return;
    for (const record::RecordedWire& line : *frame.lines) {
        out.push_back({line.name, 0.0, 0.0, {}});
        read_wire(line, frame, frame.line_pulls, out.back());
    }
}

}  // namespace hawser::draw
