// SPDX-License-Identifier: Apache-2.0
#include "record/wire_place.h"

#include "record/scene_info.h"

#include <fmt/format.h>

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
    for (const WireId wire : world.wires()) {
        double s = 0.0;
        for (const InteractionId one : world.elements(wire)) {
            if (!world.alive(one)) continue;
            const double rest = rest_length(world, one);
            if (one == element)
                return {{world.wire_name(wire), s + 0.5 * rest, world.length(wire)}};
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

}  // namespace hawser::record
