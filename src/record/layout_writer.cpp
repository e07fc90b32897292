// SPDX-License-Identifier: Apache-2.0
#include "record/layout_writer.h"

#include "record/commands.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::record {
namespace {

void put_joints(ByteWriter& out, const SceneInfo& scene, const World& world) {
    const std::vector<InteractionId> joints = drawn_joints(scene, world);
    out.put(static_cast<std::uint32_t>(joints.size()));
    for (const InteractionId joint : joints) {
        const InteractionDef& def = world.interaction_def(joint);
        for (std::size_t k = 0; k < 2; ++k) {
            out.put(def.body[k].index);
            for (int d = 0; d < 3; ++d) out.put(def.point[k][d]);
        }
    }
}

// Return the attachment point of a cable at its first or last body, in the frame of this body.
Vec3 end_point(const CableInfo& cable, const World& world, bool last) {
    if (cable.elements.empty() || cable.nodes.empty()) return Vec3::Zero();
    const BodyId body = last ? cable.nodes.back() : cable.nodes.front();
    const InteractionId element = last ? cable.elements.back() : cable.elements.front();
    if (!world.alive(element)) return Vec3::Zero();
    const InteractionDef& def = world.interaction_def(element);
    for (std::size_t k = 0; k < def.body.size(); ++k)
        if (def.body[k] == body) return def.point[k];
    return Vec3::Zero();
}

}  // namespace

std::vector<InteractionId> drawn_joints(const SceneInfo& scene, const World& world) {
    std::vector<bool> in_cable(static_cast<std::size_t>(world.interaction_count()), false);
    for (const CableInfo& cable : scene.cables)
        for (const InteractionId element : cable.elements)
            in_cable[static_cast<std::size_t>(element.index)] = true;
    std::vector<InteractionId> joints;
    for (const InteractionId id : world.interactions()) {
        const KindInfo& kind = kind_info(world.interaction_def(id).kind);
        // Lines of drums and parts of routes have two bodies, followed by their drum or slide.
        const bool two = kind.bodies == 2 || kind.scalar_slot == 2;
        if (two && kind.uses_points && !in_cable[static_cast<std::size_t>(id.index)])
            joints.push_back(id);
    }
    return joints;
}

void write_body(ByteWriter& out, const BodyDef& def, const Pose& pose) {
    out.put_text(def.name);
    out.put(static_cast<std::uint8_t>(def.kind));
    for (int k = 0; k < 3; ++k) out.put(def.half_size[k]);
    for (int k = 0; k < 3; ++k) out.put(pose.position[k]);
    for (const double q :
         {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(), pose.orientation.z()})
        out.put(q);
}

void write_layout(ByteWriter& out, const SceneInfo& scene, const World& world) {
    out.put(static_cast<std::uint32_t>(world.body_count()));
    // Write bodies by index. Empty slots are written too, because all other entries refer to bodies
    // by index.
    std::int32_t place = 0;
    for (const BodyId id : world.bodies()) {
        for (; place < id.index; ++place) write_body(out, BodyDef{}, Pose{});
        write_body(out, world.body_def(id), world.pose(id));
        ++place;
    }
    for (; place < world.body_count(); ++place) write_body(out, BodyDef{}, Pose{});
    out.put(static_cast<std::uint32_t>(scene.cables.size()));
    for (const CableInfo& cable : scene.cables) {
        out.put_text(cable.name);
        out.put_text(cable.line_type);
        for (const double v : {cable.EA, cable.breaking_load, cable.length}) out.put(v);
        out.put(static_cast<std::uint32_t>(cable.nodes.size()));
        for (const BodyId node : cable.nodes) out.put(node.index);
        for (const bool last : {false, true}) {
            const Vec3 point = end_point(cable, world, last);
            for (int k = 0; k < 3; ++k) out.put(point[k]);
        }
        out.put(static_cast<std::uint32_t>(cable.elements.size()));
    }
    out.put(static_cast<std::uint32_t>(scene.plot_cables.size()));
    for (const std::int32_t cable : scene.plot_cables) out.put(cable);
    out.put(static_cast<std::uint32_t>(scene.plot_bodies.size()));
    for (const BodyId body : scene.plot_bodies) out.put(body.index);
    put_joints(out, scene, world);
}

void write_input_names(ByteWriter& out, const World& world) {
    std::vector<std::string> names(static_cast<std::size_t>(world.input_count()));
    for (const InputId id : world.inputs())
        names[static_cast<std::size_t>(id.index)] = world.input_def(id).name;
    out.put(static_cast<std::uint32_t>(names.size()));
    for (const std::string& name : names) out.put_text(name);
    const auto inner = [&](const std::string& name) { return is_inner_input(world, name); };
    if (std::none_of(names.begin(), names.end(), inner)) return;
    for (const std::string& name : names) out.put(static_cast<std::uint8_t>(inner(name) ? 1 : 0));
}

}  // namespace hawser::record
