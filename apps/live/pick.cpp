// SPDX-License-Identifier: Apache-2.0
#include "live/pick.h"

#include "live/scene_text.h"
#include "record/names.h"
#include "record/scene_info.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::live {
namespace {

Json figure(const char* name, const char* unit, double value) {
    return {name, unit, std::isfinite(value) ? Json(value) : Json(nullptr)};
}

Json of_body(const World& world, BodyId id) {
    const BodyDef& def = world.body_def(id);
    const Pose pose = world.pose(id);
    const Twist twist = world.velocity(id);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    Json numbers = Json::array();
    if (def.kind == BodyKind::scalar) {
        numbers.push_back(figure("coordinate", "m or rad", pose.position.x()));
        numbers.push_back(figure("speed", "m/s or rad/s", twist.linear.x()));
    } else {
        for (int k = 0; k < 3; ++k)
            numbers.push_back(figure(k == 0 ? "x" : k == 1 ? "y" : "z", "m", pose.position[k]));
        numbers.push_back(figure("speed", "m/s", twist.linear.norm()));
    }
    if (def.kind == BodyKind::rigid || def.kind == BodyKind::kinematic) {
        const Mat3 r = pose.orientation.toRotationMatrix();
        numbers.push_back(figure("heading", "deg", kDegrees * std::atan2(r(1, 0), r(0, 0))));
        numbers.push_back(
            figure("tilt", "deg", kDegrees * std::acos(std::clamp(r(2, 2), -1.0, 1.0))));
        numbers.push_back(figure("turning", "rad/s", twist.angular.norm()));
    }
    if (def.kind != BodyKind::fixed) numbers.push_back(figure("mass", "kg", def.mass));
    return {{"of", {{"body", id.index}}},
            {"name", record::body_label(world, id)},
            {"numbers", numbers},
            {"text", {{"kind", to_string(def.kind)}}}};
}

Json of_wire(const World& world, const WireSource& wire, double share, int number) {
    Json numbers = Json::array();
    double most = 0.0;
    int parted = 0;
    for (const PieceSource& piece : wire.pieces) {
        most = std::max(most, record::element_tension(world, piece.element));
        parted += piece.joint || world.intact(piece.element) ? 0 : 1;
    }
    if (wire.wire.valid()) {
        const double length = world.wires().length(wire.wire);
        numbers.push_back(
            figure("tension here", "N", world.wires().tension(wire.wire, share * length)));
        numbers.push_back(figure("from its first end", "m", share * length));
        numbers.push_back(figure("length", "m", length));
    }
    numbers.push_back(figure("largest tension", "N", most));
    numbers.push_back(figure("elements", "", static_cast<double>(wire.pieces.size())));
    numbers.push_back(figure("parted elements", "", parted));
    return {{"of", {{"wire", number}}},
            {"name", wire.name},
            {"numbers", numbers},
            {"text", {{"kind", to_string(wire.kind)}}}};
}

Json of_joint(const World& world, const JointSource& joint) {
    const auto force = world.force(joint.id);
    const InteractionDef& def = world.interaction_def(joint.id);
    Json numbers = Json::array();
    numbers.push_back(figure("force", "N", record::element_tension(world, joint.id)));
    for (std::size_t k = 0; k < std::min<std::size_t>(3, force.size()); ++k)
        numbers.push_back(figure(k == 0   ? "force x"
                                 : k == 1 ? "force y"
                                          : "force z",
                                 "N", force[k]));
    if (kind_info(def.kind).coordinate != KindCoordinate::none)
        numbers.push_back(figure("coordinate", "m or rad", world.coordinate(joint.id)));
    return {{"of", {{"joint", joint.id.index}}},
            {"name", record::interaction_label(world, joint.id)},
            {"numbers", numbers},
            {"text", {{"kind", kind_info(def.kind).name}}}};
}

}  // namespace

BodyId body_of(const World& world, std::int32_t number) {
    const auto bodies = world.bodies();
    const auto at = std::lower_bound(bodies.begin(), bodies.end(), number,
                                     [](BodyId id, std::int32_t n) { return id.index < n; });
    if (at == bodies.end() || at->index != number)
        throw DefError("there is no body " + std::to_string(number));
    return *at;
}

const WireSource& find_wire_source(const FramePlan& plan, const Command& command) {
    if (!command.by_name) {
        const auto number = static_cast<std::size_t>(command.target_id);
        if (command.target_id < 0 || number >= plan.wires.size())
            throw DefError("there is no wire " + std::to_string(command.target_id));
        return plan.wires[number];
    }
    std::vector<std::string> names;
    for (const WireSource& wire : plan.wires) {
        if (wire.name == command.name.view()) return wire;
        names.push_back(wire.name);
    }
    throw DefError("there is no wire \"" + std::string(command.name.view()) + "\"; nearest: \"" +
                   record::nearest_name(command.name.view(), names) + "\"");
}

nlohmann::json picked_object_json(const World& world, const FramePlan& plan,
                                  const Command& command) {
    Json out;
    if (command.by_wire) {
        const WireSource& wire = find_wire_source(plan, command);
        out = of_wire(world, wire, command.value, static_cast<int>(&wire - plan.wires.data()));
    } else if (command.by_joint) {
        const auto at =
            std::find_if(plan.joints.begin(), plan.joints.end(),
                         [&](const JointSource& j) { return j.id.index == command.target_id; });
        if (at == plan.joints.end())
            throw DefError("there is no joint " + std::to_string(command.target_id));
        out = of_joint(world, *at);
    } else {
        out = of_body(world, body_of(world, command.target_id));
    }
    out["type"] = "picked";
    out["time"] = world.time();
    if (command.id != kNoId) out["id"] = command.id;
    return out;
}

}  // namespace hawser::live
