// SPDX-License-Identifier: Apache-2.0
/// Write frames of recordings in the form for clients.
#include "live/recorded_scene.h"

#include "base/index.h"
#include "live/hub.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace hawser::live {
namespace {

constexpr double kCoincidenceDistance = 1e-3;  // [m] ends closer than this coincide
constexpr float kUnknownTension = std::numeric_limits<float>::quiet_NaN();

void append_point(std::vector<float>& to, const Vec3& v) {
    for (int k = 0; k < 3; ++k) to.push_back(static_cast<float>(v[k]));
}

Vec3 on_body(const Pose& pose, const Vec3& point) {
    return pose.position + pose.orientation * point;
}

}  // namespace

/// Add the points and tensions of the wire called `name` to a frame, if `wires` contains it.
/// @return true if it was added.
bool RecordedScene::add_recorded(const record::Frame& frame, std::string_view name,
                                 const std::vector<record::RecordedWire>* wires,
                                 const std::vector<float>& pulls, std::vector<float>& points,
                                 std::vector<float>& tensions) const {
    if (wires == nullptr) return false;
    for (const record::RecordedWire& recorded : *wires) {
        if (recorded.name != name) continue;
        Vec3 last = Vec3::Zero();
        for (std::size_t p = 0; p < recorded.pieces.size(); ++p) {
            const record::RecordedPiece& piece = recorded.pieces[p];
            const auto end = [&](std::size_t k) -> Vec3 {
                return on_body(frame.poses[at(piece.body[k])], piece.point[k]) - origin_;
            };
            const float pull = pulls[recorded.first_piece + p];
            const Vec3 begin = end(0);
            if (p == 0) {
                append_point(points, begin);
            } else if ((begin - last).squaredNorm() > kCoincidenceDistance * kCoincidenceDistance) {
                append_point(points, begin);  // it lies on a wheel between them
                tensions.push_back(std::max(pull, tensions.back()));
            }
            last = end(1);
            append_point(points, last);
            tensions.push_back(pull);
        }
        return true;
    }
    return false;
}

/// Add the points and tensions of a wire: from the frame if nodes of the wire were added or
/// removed, else from the cable of the scene.
void RecordedScene::add_wire(const record::Frame& frame, std::size_t wire,
                             std::vector<float>& points, std::vector<float>& tensions) const {
    const WireSource& source = plan_.wires[wire];
    if (add_recorded(frame, source.name, frame.wires, frame.pulls, points, tensions) ||
        add_recorded(frame, source.name, frame.lines, frame.line_pulls, points, tensions))
        return;
    const auto* gone = frame.gone_joints;
    if (gone != nullptr && std::count(gone->begin(), gone->end(), sources_[wire].joint) > 0) return;
    if (sources_[wire].cable >= 0) {
        const record::RecordedCable& cable = recording_.cables[at(sources_[wire].cable)];
        const std::size_t n = cable.nodes.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Pose& pose = frame.poses[at(cable.nodes[k])];
            const bool first = k == 0, last = k + 1 == n;
            append_point(points,
                         (first || last ? on_body(pose, cable.end[first ? 0 : 1]) : pose.position) -
                             origin_);
            const std::size_t e = std::min<std::size_t>(k, at(std::max(1, cable.elements)) - 1);
            if (!last) tensions.push_back(frame.tensions[at(cable.first_element) + e]);
        }
        return;
    }
    // Ropes over sheaves and rods: straight between their points; tension is not recorded.
    for (const PieceSource& piece : source.pieces) {
        for (const HeldPoint& held : piece.end)
            append_point(points, on_body(frame.poses[at(held.body)], held.point) - origin_);
        tensions.push_back(kUnknownTension);
    }
}

/// Return the values of inputs before a step of the branch of frame `index`. An input that this
/// branch has not set yet has the value of the earlier branches at the state from which it started.
std::vector<float> RecordedScene::inputs_at(std::size_t index, std::int64_t step) const {
    std::vector<float> out;
    for (const InputSource& input : plan_.inputs)
        out.push_back(input.id.valid() ? static_cast<float>(scene_.world.input(input.id))
                                       : kUnknownTension);
    const auto& takes = recording_.takes;
    const std::size_t take = recording_.take_of(index);
    const std::size_t begin = take == 0 ? 0 : takes[take - 1].inputs;
    const std::size_t end = take < takes.size() ? takes[take].inputs : recording_.inputs.size();
    for (std::size_t i = 0; i < end; ++i) {
        const record::RecordedInput& set = recording_.inputs[i];
        const std::int64_t until = i >= begin ? step : takes[take - 1].to;
        if (set.step >= until || at(set.input) >= input_of_.size()) continue;
        if (const std::int32_t of = input_of_[at(set.input)]; of >= 0)
            out[at(of)] = static_cast<float>(set.value);
    }
    return out;
}

void RecordedScene::write(std::size_t index, std::uint16_t flags, std::uint32_t number,
                          Bytes& out) const {
    const record::Frame frame = recording_.frame(index);
    const auto count = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    std::vector<float> floats, points, tensions;
    const auto put_pose = [&](BodyId id, bool turns) {
        const Pose& pose = frame.poses[at(id.index)];
        const bool exists = frame.there[at(id.index)];
        for (int k = 0; k < 3; ++k)
            floats.push_back(exists ? static_cast<float>(pose.position[k] - origin_[k])
                                    : kUnknownTension);
        if (!turns) return;
        for (const double q : {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                               pose.orientation.z()})
            floats.push_back(static_cast<float>(q));
    };
    for (const BodyId id : plan_.rigid) put_pose(id, true);
    for (const BodyId id : plan_.lumps) put_pose(id, false);
    for (const BodyId id : plan_.scalars)
        floats.push_back(static_cast<float>(frame.poses[at(id.index)].position.x()));
    FrameHeader head;
    for (std::size_t w = 0; w < plan_.wires.size(); ++w) {
        const std::size_t before = points.size() / 3;
        add_wire(frame, w, points, tensions);
        const std::uint32_t n = count(points.size() / 3 - before);
        float bits = 0.0F;
        std::memcpy(&bits, &n, sizeof bits);
        floats.push_back(bits);
    }
    floats.insert(floats.end(), points.begin(), points.end());
    floats.insert(floats.end(), tensions.begin(), tensions.end());
    floats.insert(floats.end(), 3 * plan_.joints.size() + plan_.outputs.size(), kUnknownTension);
    const std::vector<float> inputs = inputs_at(index, frame.step);
    floats.insert(floats.end(), inputs.begin(), inputs.end());
    std::vector<float> stats(kStatCount, kUnknownTension);
    stats[10] = static_cast<float>(1e3 * recording_.settings.step);
    stats[11] = static_cast<float>(frame.momentum_residual);
    stats[13] = static_cast<float>(frame.violation_max);
    stats[19] = static_cast<float>(frame.energy);
    floats.insert(floats.end(), stats.begin(), stats.end());

    head.flags = static_cast<std::uint16_t>(flags | kOfRecording);
    head.epoch = 1;
    head.number = number;
    head.step = frame.step;
    head.time = frame.time;
    head.rigid = count(plan_.rigid.size());
    head.lumps = count(plan_.lumps.size());
    head.scalars = count(plan_.scalars.size());
    head.wires = count(plan_.wires.size());
    head.points = count(points.size() / 3);
    head.pieces = count(tensions.size());
    head.joints = count(plan_.joints.size());
    head.outputs = count(plan_.outputs.size());
    head.inputs = count(plan_.inputs.size());
    head.stats = count(kStatCount);
    head.length = count(kFrameHeader + 4 * floats.size());
    head.clock = clock_now();
    out.resize(head.length);
    std::memcpy(out.data(), &head, sizeof head);
    std::memcpy(out.data() + kFrameHeader, floats.data(), 4 * floats.size());
}

}  // namespace hawser::live
