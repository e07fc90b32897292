// SPDX-License-Identifier: Apache-2.0
#include "live/recorded_scene.h"

#include "base/index.h"
#include "live/scene_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace hawser::live {
namespace {

using Rec = record::Recording;

/// Return the outlines of a recording as shapes.
Json outlines_json(const Rec& recording) {
    Json out = Json::array();
    for (const record::RecordedOutline& outline : recording.outlines) {
        if (outline.points.size() < 2) continue;
        Json shape{{"body", outline.body}, {"name", ""}};
        shape["position"] = lengths(Vec3::Zero());
        shape["orientation"] = turn(Quat::Identity());
        if (outline.kind == record::OutlineKind::plane) {
            shape["kind"] = "plane";
            shape["position"] = lengths(outline.points[0]);
            shape["orientation"] = turn(turn_between(Vec3::UnitZ(), outline.points[1]));
        } else if (outline.kind == record::OutlineKind::lines) {
            shape["kind"] = "lines";
            shape["row"] = outline.row;
            shape["vertices"] = vertices_of(outline.points);
        } else {
            shape["kind"] = "points";
            shape["radius"] = outline.radius;
            shape["vertices"] = vertices_of(outline.points);
        }
        out.push_back(std::move(shape));
    }
    return out;
}

Vec3 middle(const Rec& recording) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const record::RecordedBody& body : recording.bodies) {
        if (body.kind != BodyKind::rigid && body.kind != BodyKind::lump) continue;
        sum += body.start.position;
        ++count;
    }
    if (count == 0) return sum;
    sum /= count;
    return {10.0 * std::round(sum.x() / 10.0), 10.0 * std::round(sum.y() / 10.0), 0.0};
}

}  // namespace

RecordedScene::RecordedScene(const Rec& recording) : recording_(recording) {
    if (recording.frame_count() == 0)
        throw record::RecordingError(recording.file + ": there is no frame to show");
    build_world();
    find_wires();
    follow_inputs();
    origin_ = middle(recording);
}

void RecordedScene::build_world() {
    if (!recording_.scene_text.empty()) {
        try {
            scene_ = scene::load_text(recording_.scene_text, recording_.file + " (its scene)");
            if (at(scene_.world.body_count()) == recording_.start_bodies) {
                plan_ = FramePlan::of(scene_);
                return;
            }
            fault_ = "its scene has other bodies than its frames";
        } catch (const std::exception& error) {
            fault_ = error.what();
        }
    }
    build_from_list();
}

void RecordedScene::build_from_list() {
    uses_recorded_list_ = true;
    scene::Scene fresh;
    scene_ = std::move(fresh);
    scene_.name = recording_.scene_name;
    scene_.world = World(WorldDef{.step = recording_.settings.step});
    std::set<std::string> names;
    for (std::size_t b = 0; b < recording_.start_bodies; ++b) {
        const record::RecordedBody& body = recording_.bodies[b];
        BodyDef def{.kind = body.kind,
                    .position = body.start.position,
                    .orientation = body.start.orientation,
                    .mass = 1.0,  // recordings do not contain masses
                    .inertia = Mat3::Identity(),
                    .half_size = body.half_size};
        if (names.insert(body.name).second) def.name = body.name;
        (void)scene_.world.add_body(def);
    }
    plan_ = FramePlan::of(scene_);
    const std::vector<bool> inside = record::cable_interior(recording_);
    const auto is_node = [&](BodyId id) { return inside[at(id.index)]; };
    std::erase_if(plan_.lumps, is_node);
    std::erase_if(plan_.rigid, is_node);
}

/// Find the wires of the recorded scene, the pieces into which they were cut, and the lines that
/// were added during the run.
void RecordedScene::find_wires() {
    std::set<std::string> known;
    for (const WireSource& wire : plan_.wires) known.insert(wire.name);
    const auto add = [&](const std::string& name, WireKind kind) {
        if (!known.insert(name).second) return;
        WireSource wire{.kind = kind};
        wire.name = name;
        plan_.wires.push_back(std::move(wire));
    };
    for (const record::RecordedCable& cable : recording_.cables) add(cable.name, WireKind::wire);
    const std::vector<record::RecordedWire>*last = nullptr, *last_lines = nullptr;
    for (std::size_t f = 0; f < recording_.frame_count(); ++f) {
        const record::Frame frame = recording_.frame(f);
        if (frame.wires != nullptr && frame.wires != last)
            for (const record::RecordedWire& wire : *frame.wires) add(wire.name, WireKind::wire);
        if (frame.lines != nullptr && frame.lines != last_lines)
            for (const record::RecordedWire& line : *frame.lines) add(line.name, WireKind::line);
        last = frame.wires;
        last_lines = frame.lines;
    }
    sources_.resize(plan_.wires.size());
    for (std::size_t w = 0; w < plan_.wires.size(); ++w) {
        sources_[w].joint = joint_of(plan_.wires[w]);
        for (std::size_t c = 0; c < recording_.cables.size(); ++c)
            if (recording_.cables[c].name == plan_.wires[w].name)
                sources_[w].cable = static_cast<std::int32_t>(c);
    }
}

std::int32_t RecordedScene::joint_of(const WireSource& wire) const {
    const bool alone = wire.kind == WireKind::line || wire.kind == WireKind::rod;
    if (!alone || wire.pieces.size() != 1) return -1;
    const HeldPoint(&end)[2] = wire.pieces.front().end;
    for (std::size_t j = 0; j < recording_.joints.size(); ++j) {
        const record::RecordedJoint& joint = recording_.joints[j];
        if (joint.body[0] == end[0].body && joint.body[1] == end[1].body &&
            joint.point[0] == end[0].point && joint.point[1] == end[1].point)
            return static_cast<std::int32_t>(j);
    }
    return -1;
}

void RecordedScene::follow_inputs() {
    for (const std::string& name : recording_.input_names) {
        const auto at_plan =
            std::find_if(plan_.inputs.begin(), plan_.inputs.end(),
                         [&](const InputSource& i) { return i.id.valid() && i.name == name; });
        input_of_.push_back(at_plan == plan_.inputs.end()
                                ? -1
                                : static_cast<std::int32_t>(at_plan - plan_.inputs.begin()));
    }
}

nlohmann::json RecordedScene::json() const {
    Json out = scene_json(scene_, plan_, {.epoch = 1, .origin = origin_, .recording = true});
    if (uses_recorded_list_) out["shapes"] = outlines_json(recording_);
    for (std::size_t w = 0; w < sources_.size(); ++w) {
        if (sources_[w].cable < 0) continue;
        const record::RecordedCable& cable = recording_.cables[at(sources_[w].cable)];
        out["wires"][w]["breaking_load"] = cable.breaking_load;
        out["wires"][w]["length"] = shorter(cable.length, 1e-4);
    }
    return out;
}

}  // namespace hawser::live
