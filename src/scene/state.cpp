// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <algorithm>
#include <set>

namespace hawser::scene {
namespace {

bool is_moving(BodyKind kind) {
    return kind == BodyKind::rigid || kind == BodyKind::lump || kind == BodyKind::scalar;
}

void set_state(BodyDef& def, const Json& state, const SourceLocation& location) {
    def.position = vector_of(state["p"]);
    def.velocity = vector_or(state, "v", Vec3::Zero());
    if (def.kind == BodyKind::rigid || def.kind == BodyKind::kinematic) {
        def.orientation =
            state.contains("q") ? quaternion_of(state["q"], location / "q") : Quat::Identity();
        def.angular_velocity = vector_or(state, "w", Vec3::Zero());
    }
}

/// True if a name of a state exists only in scenes of several copies: "3:rig", or the nodes of a
/// cable between copies.
bool belongs_to_copies(const std::string& name, const Json& root) {
    const auto repeat = root.find("repeat");
    if (repeat == root.end()) {
        return false;
    }
    if (name.find(':') != std::string::npos) {
        return true;
    }
    const auto joins = repeat->find("joins");
    if (joins == repeat->end()) {
        return false;
    }
    for (const Json& join : *joins) {
        if (name.starts_with(join["name"].get<std::string>() + "/")) {
            return true;
        }
    }
    return false;
}

/// True if the body is a pin. Its scene defines its position on a body that the state moves, so the
/// state does not contain it.
bool is_pin(const std::string& name, const Description& out) {
    return std::any_of(out.deck.pins.begin(), out.deck.pins.end(),
                       [&](const auto& pin) { return pin.def.name == name; });
}

}  // namespace

void apply_state(Description& out, const Document& document) {
    const auto state = document.root.find("state");
    if (state == document.root.end()) {
        return;
    }
    const Json& stored = (*state)["bodies"];
    for (const auto& [name, value] : stored.items()) {
        const SourceLocation location = document.state / name;
        const BodyId id = out.find_body(name);
        if (id.valid()) {
            if (out.body(id).kind != BodyKind::fixed) {
                set_state(out.bodies[static_cast<std::size_t>(id.index)], value, location);
            }
        } else if (!belongs_to_copies(name, document.root) && !is_pin(name, out)) {
            std::vector<std::string> known;
            for (const BodyDef& body : out.bodies) {
                known.push_back(body.name);
            }
            throw_error(location,
                        "the scene has no body " + in_quotes(name) + suggestion(name, known) +
                            (known.size() > 24 ? "; settle the scene again if it changed" : ""));
        }
    }
    for (const BodyDef& body : out.bodies) {
        if (is_moving(body.kind) && !stored.contains(body.name)) {
            throw_error(document.state, "the state lacks the body " + in_quotes(body.name) +
                                            "; settle the scene again");
        }
    }
}

std::string state_text(const Scene& scene) {
    const auto list = [](const Vec3& v) { return Json{v.x(), v.y(), v.z()}; };
    Json bodies = Json::object();
    for (int i = 0; i < scene.world.body_count(); ++i) {
        const BodyDef& def = scene.world.body_def(BodyId{i});
        if (!is_moving(def.kind) || def.name.empty()) {
            continue;
        }
        const Pose pose = scene.world.pose(BodyId{i});
        const Twist twist = scene.world.velocity(BodyId{i});
        Json entry{{"p", list(pose.position)}, {"v", list(twist.linear)}};
        if (def.kind == BodyKind::rigid) {
            const Quat& q = pose.orientation;
            entry["q"] = {q.w(), q.x(), q.y(), q.z()};
            entry["w"] = list(twist.angular);
        }
        bodies[def.name] = std::move(entry);
    }
    constexpr int kStateVersion = 1;
    const Json state{{"version", kStateVersion},
                     {"scene", scene.name},
                     {"time", scene.world.time()},
                     {"bodies", std::move(bodies)}};
    return state.dump(1) + "\n";
}

}  // namespace hawser::scene
