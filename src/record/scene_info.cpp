// SPDX-License-Identifier: Apache-2.0
#include "record/scene_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::record {

SceneInfo make_scene_info(const scene::Scene& scene) {
    SceneInfo info{.name = scene.name,
                   .path = scene.path,
                   .text = scene.text,
                   .hash = scene.hash,
                   .cables = {},
                   .plot_cables = {},
                   .plot_bodies = {},
                   .shape_places = scene.shape_places};
    for (const scene::Cable& cable : scene.cables)
        info.cables.push_back({cable.name, cable.line_type, cable.nodes, cable.stretch, cable.EA,
                               cable.breaking_load, cable.length, cable.diameter, cable.laid_from,
                               cable.laid_to, cable.drum_element == 0.0});
    for (const std::string& name : scene.plot_tensions)
        for (std::size_t i = 0; i < scene.cables.size(); ++i)
            if (scene.cables[i].name == name)
                info.plot_cables.push_back(static_cast<std::int32_t>(i));
    for (const std::string& name : scene.plot_motions)
        if (const BodyId body = scene.world.find_body(name); body.valid())
            info.plot_bodies.push_back(body);
    return info;
}

double element_tension(const World& world, InteractionId element) {
    const std::span<const double> force = world.force(element);
    if (force.empty()) return 0.0;
    if (kind_info(world.interaction_def(element).kind).is(kPulls)) return -force[0];
    double sum = 0.0;
    for (const double f : force.first(std::min<std::size_t>(3, force.size()))) sum += f * f;
    return std::sqrt(sum);
}

std::vector<BodyId> watched_bodies(const SceneInfo& scene, const World& world) {
    if (!scene.plot_bodies.empty()) return scene.plot_bodies;
    std::vector<bool> inside(static_cast<std::size_t>(world.body_count()), false);
    for (const CableInfo& cable : scene.cables)
        for (std::size_t i = 1; i + 1 < cable.nodes.size(); ++i)
            inside[static_cast<std::size_t>(cable.nodes[i].index)] = true;
    std::vector<BodyId> out;
    for (const BodyId id : world.bodies())
        if (world.body_def(id).kind == BodyKind::rigid &&
            !inside[static_cast<std::size_t>(id.index)])
            out.push_back(id);
    return out;
}

namespace {

/// Return the wire to which a node belongs; invalid if the body is no node of a wire.
WireId wire_at(const World& world, BodyId body) {
    if (world.body_def(body).kind != BodyKind::lump) return {};
    for (const WireId wire : world.wires().ids()) {
        const auto nodes = world.wires().nodes(wire);
        if (std::find(nodes.begin(), nodes.end(), body) != nodes.end()) return wire;
    }
    return {};
}

}  // namespace

std::string body_label(const World& world, BodyId body) {
    if (!body.valid()) return "-";
    if (!world.alive(body)) return fmt::format("body {}, which has been removed", body.index);
    const std::string& name = world.body_def(body).name;
    if (!name.empty()) return name;
    const WireId wire = wire_at(world, body);
    return wire.valid() ? fmt::format("{} node {}", world.wires().name(wire), body.index)
                        : fmt::format("body {}", body.index);
}

std::string interaction_label(const World& world, InteractionId interaction) {
    if (!interaction.valid()) return "-";
    if (!world.alive(interaction))
        return fmt::format("interaction {}, which has been removed", interaction.index);
    const InteractionDef& def = world.interaction_def(interaction);
    if (!def.name.empty()) return def.name;
    const KindInfo& kind = kind_info(def.kind);
    const WireId wire =
        kind.is(kBendsWire) ? wire_at(world, def.body[1]) : world.wires().of(interaction);
    const std::string number = fmt::format("{} {}", kind.name, interaction.index);
    return wire.valid() ? world.wires().name(wire) + " " + number : number;
}

std::string name_in_quotes(const std::string& name) { return "\"" + name + "\""; }

std::string names_in_words(const std::vector<std::string>& names) {
    constexpr std::size_t kMaxNames = 8;
    const std::size_t shown = std::min(kMaxNames, names.size());
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        const bool last = i + 1 == names.size();
        text += i == 0 ? "" : last ? " and " : ", ";
        text += names[i];
    }
    if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
    return text;
}

std::string position_label(const World& world, InteractionId interaction, BodyId body) {
    if (interaction.valid()) return interaction_label(world, interaction);
    return body.valid() ? body_label(world, body) : "-";
}

std::string origin(const World& world, std::string_view name) {
    for (auto slash = name.rfind('/'); slash != name.npos && slash > 0;
         slash = name.rfind('/', slash - 1))
        if (const std::string_view maker = name.substr(0, slash);
            world.find_system(maker) != nullptr ||
            world.find_interaction(std::string(maker) + "/part1").valid())
            return fmt::format(" (made by \"{}\")", maker);
    return "";
}

std::string interaction_in_words(const World& world, InteractionId interaction) {
    if (!interaction.valid()) return "the whole world";
    if (!world.alive(interaction)) return interaction_label(world, interaction);
    const InteractionDef& def = world.interaction_def(interaction);
    const KindInfo& kind = kind_info(def.kind);
    std::string words = kind.name;
    std::replace(words.begin(), words.end(), '_', ' ');
    words = "the " + words + " " + name_in_quotes(interaction_label(world, interaction));
    std::vector<std::string> bodies;
    for (std::size_t b = 0; b < static_cast<std::size_t>(kind.bodies); ++b)
        bodies.push_back(name_in_quotes(body_label(world, def.body[b])));
    return words + (bodies.size() > 1 ? " between " : " of ") + names_in_words(bodies) +
           origin(world, interaction_label(world, interaction));
}

}  // namespace hawser::record
