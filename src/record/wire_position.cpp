// SPDX-License-Identifier: Apache-2.0
#include "record/wire_position.h"

#include "record/scene_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

namespace hawser::record {

double rest_length(const World& world, InteractionId element) {
    const InteractionDef& def = world.interaction_def(element);
    if (!kind_info(def.kind).is(kWoundUp)) return def.params[0];
    if (kind_info(def.kind).is(kRouted))
        return def.params[0] +
               def.get("radius") * (world.pose(def.body[2]).position.x() - def.get("drum_zero"));
    // The drum changes the rest length. It equals the distance of the ends minus the violation.
    const double separation = (world.world_point(def.body[1], def.point[1]) -
                               world.world_point(def.body[0], def.point[0]))
                                  .norm();
    return separation - world.violation(element)[0];
}

std::optional<WirePosition> wire_position(const World& world, InteractionId element) {
    for (const WireId wire : world.wires().ids()) {
        double s = 0.0;
        for (const InteractionId one : world.wires().elements(wire)) {
            if (!world.alive(one)) continue;
            const double rest = rest_length(world, one);
            if (one == element)
                return {{world.wires().name(wire), s + 0.5 * rest, world.wires().length(wire)}};
            s += rest;
        }
    }
    return std::nullopt;
}

std::string broken_label(const World& world, InteractionId element) {
    const std::string name = interaction_label(world, element);
    const std::optional<WirePosition> at = wire_position(world, element);
    return at ? fmt::format("{} ({} at {:.4g} m)", name, at->wire, at->s) : name;
}

std::string describe_breaking(const World& world, const Event& event) {
    if (event.kind != EventKind::line_break || !event.interaction.valid() ||
        !world.alive(event.interaction))
        return {};
    const InteractionDef& def = world.interaction_def(event.interaction);
    const std::span<const ParamInfo> params = kind_info(def.kind).params;
    const auto breaking = std::find_if(params.begin(), params.end(), [](const ParamInfo& p) {
        return std::string_view(p.name) == "breaking_load";
    });
    if (breaking == params.end()) return {};
    const double load = def.get("breaking_load");
    if (!(load > 0.0 && load < breaking->max)) return {};
    return fmt::format(" ({:.0f} % of its breaking load)", 100.0 * std::abs(event.value) / load);
}

}  // namespace hawser::record
