// SPDX-License-Identifier: Apache-2.0
#include "live/frame_plan.h"

#include "base/index.h"
#include "record/commands.h"
#include "record/scene_info.h"

#include <algorithm>
#include <map>
#include <span>

namespace hawser::live {

namespace {

template <class Id>
bool equal(std::span<const Id> a, const std::vector<Id>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}
template <class Id>
std::vector<Id> copy(std::span<const Id> from) {
    return {from.begin(), from.end()};
}

HeldPoint held_point(const World& world, const InteractionDef& def, std::size_t k) {
    const BodyKind kind = world.body_def(def.body[k]).kind;
    const bool turns = kind != BodyKind::lump && !def.point[k].isZero(0.0);
    return {def.body[k].index, turns, turns ? def.point[k] : Vec3::Zero()};
}

PieceSource make_piece_source(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    PieceSource out{.element = id};
    out.routed = kind_info(def.kind).is(kRouted);
    for (std::size_t k = 0; k < 2; ++k) out.end[k] = held_point(world, def, k);
    return out;
}

WireSource make_wire_source(const World& world, WireId id) {
    WireSource out{.kind = WireKind::wire, .wire = id, .name = world.wires().name(id)};
    const auto nodes = world.wires().nodes(id);
    const auto elements = world.wires().elements(id);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (!world.alive(elements[e])) continue;
        PieceSource one = make_piece_source(world, elements[e]);
        one.backwards = e < nodes.size() && one.end[0].body != nodes[e].index &&
                        one.end[1].body == nodes[e].index;
        out.pieces.push_back(one);
    }
    return out;
}

/// Return a row of rigid links, whose joints are points of a frame.
WireSource links_of(const World& world, const scene::Cable& cable) {
    WireSource out{.kind = WireKind::links, .name = cable.name};
    for (std::size_t j = 0; j + 1 < cable.stretch.size(); ++j) {
        if (!world.alive(cable.stretch[j]) || !world.alive(cable.stretch[j + 1])) continue;
        PieceSource one{.element = cable.stretch[j + 1]};
        one.joint = true;
        one.end[0] = held_point(world, world.interaction_def(cable.stretch[j]), 0);
        one.end[1] = held_point(world, world.interaction_def(cable.stretch[j + 1]), 0);
        out.pieces.push_back(one);
    }
    return out;
}

/// Return the nodes of wires: nodes to which elements of a wire connect, including free ends.
std::vector<bool> nodes_of_wires(const World& world) {
    std::vector<bool> node(at(world.body_count()), false);
    for (const WireId wire : world.wires().ids())
        for (const BodyId id : world.wires().nodes(wire))
            if (world.alive(id) && world.body_def(id).kind == BodyKind::lump)
                node[at(id.index)] = true;
    return node;
}

void add_bodies(const World& world, FramePlan& plan) {
    const std::vector<bool> node = nodes_of_wires(world);
    for (const BodyId id : world.bodies()) {
        if (node[at(id.index)]) continue;
        switch (world.body_def(id).kind) {
            case BodyKind::rigid:
            case BodyKind::kinematic:
                plan.rigid.push_back(id);
                break;
            case BodyKind::lump:
                plan.lumps.push_back(id);
                break;
            case BodyKind::scalar:
                plan.scalars.push_back(id);
                break;
            case BodyKind::fixed:
                plan.fixed.push_back(id);
                break;
        }
    }
}

void add_wires(const scene::Scene& scene, FramePlan& plan) {
    const World& world = scene.world;
    for (const WireId id : world.wires().ids()) plan.wires.push_back(make_wire_source(world, id));
    std::vector<bool> in_cable(at(world.interaction_count()), false);
    for (const scene::Cable& cable : scene.cables) {
        if (!cable.links) continue;
        plan.wires.push_back(links_of(world, cable));
        for (const InteractionId id : cable.stretch) in_cable[at(id.index)] = true;
    }
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        const KindInfo& kind = kind_info(def.kind);
        if (kind.is(kPulls) && kind.uses_points && !world.wires().of(id).valid()) {
            const bool rigid = !kind.is(kElastic);
            plan.wires.push_back({.kind = rigid ? WireKind::rod : WireKind::line,
                                  .wire = {},
                                  .name = record::interaction_label(world, id),
                                  .cable = -1,
                                  .pieces = {make_piece_source(world, id)}});
        }
        if (kind.is(kForceOnSecond) && !in_cable[at(id.index)])
            plan.joints.push_back({id, {def.body[0].index, def.body[1].index}, def.point[1]});
    }
    for (WireSource& wire : plan.wires)
        for (std::size_t c = 0; c < scene.cables.size(); ++c)
            if (scene.cables[c].name == wire.name) wire.cable = static_cast<std::int32_t>(c);
}

std::string unit_of(const World& world, const InputDef& def) {
    if (!def.unit.empty()) return def.unit;
    if (!def.interaction.valid()) return def.component < 3 ? "N" : "N m";
    if (!world.alive(def.interaction)) return {};
    for (const ParamInfo& param : kind_info(world.interaction_def(def.interaction).kind).params)
        if (def.param == param.name) return param.unit;
    return {};
}

void add_inputs(const scene::Scene& scene, FramePlan& plan) {
    const World& world = scene.world;
    for (const scene::SignalInput& input : scene.signal_inputs)
        for (const SystemSignal& s : world.system_signals())
            if (s.system + "." + s.name == input.signal && s.input)
                plan.inputs.push_back({.name = input.name,
                                       .unit = input.unit.empty() ? s.unit : input.unit,
                                       .group = input.group,
                                       .kind = "lever",
                                       .min = input.min,
                                       .max = input.max,
                                       .nominal = input.nominal,
                                       .factor = input.factor,
                                       .spring = input.spring,
                                       .words = input.factor == 1.0 ? record::signal_words(world, s)
                                                                    : std::vector<std::string>{},
                                       .drives = input.signal,
                                       .id = {},
                                       .signal = s.value});
    for (const InputId id : world.inputs()) {
        const InputDef& def = world.input_def(id);
        plan.inputs.push_back({.name = def.name,
                               .unit = unit_of(world, def),
                               .group = def.group,
                               // The winch or crane drives its own parts; users do not.
                               .kind = record::is_inner_input(world, def.name) ? "inner" : "lever",
                               .min = def.min,
                               .max = def.max,
                               .nominal = def.nominal,
                               .spring = def.spring,
                               .id = id});
    }
    const auto has_control = [&](const std::string& signal) {
        return std::any_of(scene.signal_inputs.begin(), scene.signal_inputs.end(),
                           [&](const scene::SignalInput& i) { return i.signal == signal; });
    };
    for (const SystemSignal& s : world.system_signals())
        if (s.input)
            plan.inputs.push_back(
                {.name = s.system + "." + s.name,
                 .unit = s.unit,
                 .group = s.system,
                 // One control each: an input of the scene replaces the signal's.
                 .kind = has_control(s.system + "." + s.name) ? "inner" : "signal",
                 .min = s.min,
                 .max = s.max,
                 .words = record::signal_words(world, s),
                 .id = {},
                 .signal = s.value});
    // The group of an input without group is the first part of its name.
    for (InputSource& input : plan.inputs)
        if (const auto slash = input.name.rfind('/');
            input.group.empty() && slash != std::string::npos)
            input.group = input.name.substr(0, slash);
}

}  // namespace

const char* to_string(WireKind kind) noexcept {
    switch (kind) {
        case WireKind::wire:
            return "wire";
        case WireKind::links:
            return "links";
        case WireKind::line:
            return "line";
        case WireKind::rod:
            return "rod";
    }
    return "";
}

FramePlan FramePlan::of(const scene::Scene& scene) {
    const World& world = scene.world;
    FramePlan plan;
    add_bodies(world, plan);
    add_wires(scene, plan);
    add_inputs(scene, plan);
    plan.outputs = copy(world.output_ids());
    for (const ShapeId id : world.shapes())
        if (!world.shape_def(id).body_b.valid()) plan.shapes.push_back(id);
    plan.all_bodies = copy(world.bodies());
    plan.all_interactions = copy(world.interactions());
    plan.all_shapes = copy(world.shapes());
    plan.all_wires = copy(world.wires().ids());
    plan.all_inputs = copy(world.inputs());
    plan.all_outputs = copy(world.output_ids());
    plan.all_signals = world.system_signals().size();
    return plan;
}

bool FramePlan::current(const World& world) const {
    return equal(world.bodies(), all_bodies) && equal(world.interactions(), all_interactions) &&
           equal(world.shapes(), all_shapes) && equal(world.wires().ids(), all_wires) &&
           equal(world.inputs(), all_inputs) && equal(world.output_ids(), all_outputs) &&
           world.system_signals().size() == all_signals;
}

bool FramePlan::is_same_scene(const FramePlan& other) const {
    const auto same_joint = [](const JointSource& a, const JointSource& b) { return a.id == b.id; };
    // A line has one piece, which identifies it. The pieces of a wire may differ.
    const auto same_wire = [](const WireSource& a, const WireSource& b) {
        return a.kind == b.kind && a.wire == b.wire && a.name == b.name;
    };
    const auto same_input = [](const InputSource& a, const InputSource& b) {
        return a.name == b.name && a.kind == b.kind;
    };
    return rigid == other.rigid && lumps == other.lumps && scalars == other.scalars &&
           fixed == other.fixed && shapes == other.shapes && outputs == other.outputs &&
           std::equal(joints.begin(), joints.end(), other.joints.begin(), other.joints.end(),
                      same_joint) &&
           std::equal(wires.begin(), wires.end(), other.wires.begin(), other.wires.end(),
                      same_wire) &&
           std::equal(inputs.begin(), inputs.end(), other.inputs.begin(), other.inputs.end(),
                      same_input);
}

}  // namespace hawser::live
