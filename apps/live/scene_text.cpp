// SPDX-License-Identifier: Apache-2.0
#include "live/scene_text.h"

#include "live/protocol.h"
#include "record/scene_info.h"

#include <nlohmann/json.hpp>

#include <map>
#include <numbers>

namespace hawser::live {
namespace {

Json body_json(const World& world, BodyId id, int slot) {
    const BodyDef& def = world.body_def(id);
    const Pose pose = world.pose(id);
    return {{"id", id.index},
            {"name", def.name},
            {"kind", to_string(def.kind)},
            {"slot", slot},
            {"mass", def.mass},
            {"half_size", lengths(def.half_size)},
            {"position", lengths(pose.position)},
            {"orientation", turn(pose.orientation)}};
}

Json bodies_of(const World& world, const FramePlan& plan) {
    Json out = Json::array();
    for (const auto* kind : {&plan.rigid, &plan.lumps, &plan.scalars}) {
        int slot = 0;
        for (const BodyId id : *kind) out.push_back(body_json(world, id, slot++));
    }
    for (const BodyId id : plan.fixed) out.push_back(body_json(world, id, -1));
    return out;
}

/// Return the indices of the bodies at both ends of a wire; −1 for a free end, which is a node.
Json ends_of(const World& world, const WireSource& wire) {
    if (wire.pieces.empty()) return {-1, -1};
    const PieceSource &first = wire.pieces.front(), &last = wire.pieces.back();
    Json out = Json::array();
    for (const std::int32_t body :
         {first.end[first.backwards ? 1 : 0].body, last.end[last.backwards ? 0 : 1].body}) {
        bool node = false;
        for (const BodyId id : world.bodies())
            if (id.index == body)
                node = wire.kind == WireKind::wire && world.body_def(id).kind == BodyKind::lump;
        out.push_back(node ? -1 : body);
    }
    return out;
}

double parameter(const InteractionDef& def, std::string_view name) {
    for (std::size_t k = 0; k < kind_info(def.kind).params.size(); ++k)
        if (name == kind_info(def.kind).params[k].name) return def.params[k];
    return 0.0;
}

/// Return the diameter of the contact shapes along a wire, for a wire without a cable in the scene.
double touching_diameter(const World& world, const WireSource& wire) {
    if (wire.pieces.empty()) return 0.0;
    const HeldPoint& held = wire.pieces[wire.pieces.size() / 2].end[0];
    for (const ShapeId id : world.shapes()) {
        const ShapeDef& def = world.shape_def(id);
        if (def.body_b.valid() && (def.body.index == held.body || def.body_b.index == held.body))
            return 2.0 * def.radius;
    }
    return 0.0;
}

Json wire_json(const scene::Scene& scene, const WireSource& wire, int id) {
    const World& world = scene.world;
    Json out{{"id", id},
             {"name", wire.name},
             {"kind", to_string(wire.kind)},
             {"ends", ends_of(world, wire)},
             {"line_type", ""},
             {"color", ""}};
    double breaking = 0.0, diameter = 0.0, length = 0.0;
    if (wire.cable >= 0) {
        const scene::Cable& cable = scene.cables[static_cast<std::size_t>(wire.cable)];
        breaking = cable.breaking_load;
        diameter = cable.diameter;
        length = cable.length;
        out["line_type"] = cable.line_type;
        out["color"] = cable.color;
    }
    if (!wire.pieces.empty()) {
        const InteractionDef& def = world.interaction_def(wire.pieces.front().element);
        if (wire.wire.valid()) length = world.wires().length(wire.wire);
        if (length == 0.0) length = parameter(def, "length");
        const double least = parameter(def, "breaking_load");
        if (breaking == 0.0 && least < 1e29) breaking = least;
        if (diameter == 0.0) diameter = touching_diameter(world, wire);
    }
    out["breaking_load"] = breaking;
    out["diameter"] = diameter;
    out["length"] = shorter(length, 1e-4);
    return out;
}

/// Add the drum that pays out an element to the JSON entry of the element.
void add_drum(const World& world, const PieceSource& piece, int wire, Json& out) {
    const InteractionDef& def = world.interaction_def(piece.element);
    if (!kind_info(def.kind).is(kWoundUp) || kind_info(def.kind).is(kRouted)) return;
    // The end that is not a node is at the fairlead.
    const std::size_t k = world.body_def(def.body[0]).kind == BodyKind::lump ? 1 : 0;
    out.push_back({{"name", record::interaction_label(world, piece.element)},
                   {"wire", wire},
                   {"body", def.body[k].index},
                   {"point", lengths(def.point[k])},
                   {"drum", def.body[2].index},
                   {"radius", parameter(def, "radius")}});
}

/// Add the sheaves, rollers and bollards of a line to its JSON entry.
void add_wheels(const World& world, const PieceSource& piece, Json& out) {
    const InteractionDef& def = world.interaction_def(piece.element);
    const KindInfo& kind = kind_info(def.kind);
    if (!kind.is(kRouted) || !kind.uses_points) return;
    for (std::size_t k = 0; k < 2; ++k) {
        double radius = 0.0;
        std::size_t slide = 2;
        if (kind.is(kWoundUp)) {  // one of its ends is a fixed point
            const bool first = parameter(def, "radius") > 0.0;
            if (first == (k == 0)) radius = parameter(def, "wheel");
        } else {
            radius = parameter(def, k == 0 ? "wheel_0" : "wheel_1");
            slide = 2 + k;
        }
        if (radius == 0.0) continue;
        out.push_back({{"name", record::interaction_label(world, piece.element)},
                       {"body", def.body[k].index},
                       {"point", lengths(def.point[k])},
                       {"axis", lengths(def.frame[k] * Vec3::UnitZ())},
                       {"radius", radius},
                       {"slide", def.body[slide].index}});
    }
}

void add_lines(const scene::Scene& scene, const FramePlan& plan, Json& out) {
    const World& world = scene.world;
    Json wires = Json::array(), drums = Json::array(), wheels = Json::array();
    for (std::size_t w = 0; w < plan.wires.size(); ++w) {
        const int id = static_cast<int>(w);
        wires.push_back(wire_json(scene, plan.wires[w], id));
        for (const PieceSource& piece : plan.wires[w].pieces) {
            if (piece.joint) continue;
            add_drum(world, piece, id, drums);
            add_wheels(world, piece, wheels);
        }
    }
    out["wires"] = std::move(wires);
    out["drums"] = std::move(drums);
    out["wheels"] = std::move(wheels);
}

Json joints_of(const World& world, const FramePlan& plan) {
    Json out = Json::array();
    for (const JointSource& joint : plan.joints)
        out.push_back({{"id", joint.id.index},
                       {"name", record::interaction_label(world, joint.id)},
                       {"kind", kind_info(world.interaction_def(joint.id).kind).name},
                       {"bodies", {joint.body[0], joint.body[1]}},
                       {"point", lengths(joint.point)}});
    return out;
}

Json inputs_of(const World& world, const FramePlan& plan) {
    Json out = Json::array();
    for (const InputSource& input : plan.inputs)
        out.push_back(
            {{"name", input.name},
             {"unit", input.unit},
             {"group", input.group},
             {"min", limit(input.min)},
             {"max", limit(input.max)},
             {"value", input.signal ? *input.signal / input.factor : world.input(input.id)},
             {"nominal", input.nominal},
             {"spring", input.spring ? Json(*input.spring) : Json(nullptr)},
             {"words", input.words},
             {"drives", input.drives},
             {"kind", input.kind}});
    return out;
}

Json outputs_of(const World& world, const FramePlan& plan) {
    Json out = Json::array();
    for (const OutputId id : plan.outputs) {
        const OutputDef& def = world.output_def(id);
        out.push_back({{"name", def.name},
                       {"unit", def.unit},
                       {"group", def.group},
                       {"nominal", def.nominal}});
    }
    return out;
}

Json systems_of(const World& world) {
    std::map<std::string, std::pair<Json, Json>> systems;
    for (const SystemSignal& s : world.system_signals()) {
        auto& [inputs, outputs] = systems[s.system];
        (s.input ? inputs : outputs).push_back(s.system + "." + s.name);
    }
    Json out = Json::array();
    for (const auto& [name, signals] : systems)
        out.push_back({{"name", name},
                       {"inputs", signals.first.is_null() ? Json::array() : signals.first},
                       {"outputs", signals.second.is_null() ? Json::array() : signals.second}});
    return out;
}

}  // namespace

const char* to_string(BodyKind kind) noexcept {
    switch (kind) {
        case BodyKind::rigid:
            return "rigid";
        case BodyKind::lump:
            return "lump";
        case BodyKind::scalar:
            return "scalar";
        case BodyKind::fixed:
            return "fixed";
        case BodyKind::kinematic:
            return "kinematic";
    }
    return "";
}

/// Return the light of the pictures from the key "plot" of the scene's document, with angles in
/// rad.
Json light_json(const scene::Scene& scene) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    Json out{{"light", "day"},
             {"visibility", nullptr},
             {"sun_azimuth", nullptr},
             {"sun_elevation", nullptr}};
    const Json document = Json::parse(scene.text, nullptr, false);
    if (!document.is_object() || !document.contains("plot")) return out;
    const Json& plot = document["plot"];
    out["light"] = plot.value("light", "day");
    if (plot.contains("visibility")) out["visibility"] = plot["visibility"];
    if (plot.contains("sun_azimuth_deg"))
        out["sun_azimuth"] = kDegree * plot["sun_azimuth_deg"].get<double>();
    if (plot.contains("sun_elevation_deg"))
        out["sun_elevation"] = kDegree * plot["sun_elevation_deg"].get<double>();
    return out;
}

Json scene_json(const scene::Scene& scene, const FramePlan& plan, const SceneNotes& notes) {
    const World& world = scene.world;
    Json out{{"type", "scene"},
             {"version", kProtocolVersion},
             {"epoch", notes.epoch},
             {"mode", notes.recording ? "recording" : "live"},
             {"name", scene.name},
             {"description", scene.description},
             {"step", world.settings().step},
             {"duration", scene.duration},
             {"gravity", lengths(world.settings().gravity)},
             {"units", "SI"},
             {"origin", lengths(notes.origin)},
             {"view_box", Json::array()},
             {"stats", kStatNames}};
    for (const Vec3& corner : scene.plot_view_box) out["view_box"].push_back(lengths(corner));
    out["light"] = light_json(scene);
    Json stages = Json::array();
    for (int s = 0; s < kStageCount; ++s) stages.push_back(to_string(static_cast<Stage>(s)));
    out["stages"] = std::move(stages);
    out["bodies"] = bodies_of(world, plan);
    Json shapes = Json::array();
    for (const ShapeId id : plan.shapes) shapes.push_back(shape_json(world, id));
    out["shapes"] = std::move(shapes);
    add_lines(scene, plan, out);
    out["joints"] = joints_of(world, plan);
    out["systems"] = systems_of(world);
    out["vessels"] = vessels_json(world);
    out["gauges"] = gauges_json(world);
    out["inputs"] = inputs_of(world, plan);
    out["outputs"] = outputs_of(world, plan);
    add_sea(world, out);
    return out;
}

}  // namespace hawser::live
