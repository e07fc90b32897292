// SPDX-License-Identifier: Apache-2.0
#include <hawser/stopper.h>
#include <hawser/world.h>

#include "base/number.h"
#include "wire/stopper_system.h"

#include <cmath>
#include <memory>
#include <string>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const StopperDef& def, const std::string& why) {
    throw DefError("stopper '" + def.name + "': " + why);
}

void check(World& world, const StopperDef& def) {
    if (def.name.empty()) throw DefError("a stopper needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    if (world.find_interaction(def.name + "/hold").valid())
        throw_def_error(
            def, "the interaction '" + def.name + "/hold' exists, but is reserved for its joint");
    if (!world.alive(def.body)) throw_def_error(def, "its body is missing; give one");
    const BodyKind kind = world.body_def(def.body).kind;
    if (kind == BodyKind::lump || kind == BodyKind::scalar)
        throw_def_error(def,
                        "it is on a point mass or a scalar body; give a body with an orientation");
    if (!def.point.allFinite() || !(def.point.norm() <= 1e7))
        throw_def_error(def, "point is not finite, or beyond 1e7 m");
    if (!def.outboard.allFinite() || !(def.outboard.norm() > 1e-9))
        throw_def_error(
            def,
            "outboard has no direction; give one that points the way in which wire pays "
            "out, such as [-1, 0, 0]");
    if (!(def.reach > 0.0 && def.reach <= 1e3))
        throw_def_error(def,
                        "reach = " + number(def.reach) + " m; give a length above 0 up to 1000");
    if (!(def.rated_load > 0.0 && def.rated_load <= 1e12))
        throw_def_error(
            def, "rated_load = " + number(def.rated_load) + " N; give a force above 0 up to 1e12");
    if (!(def.pitch == 0.0 || (def.pitch >= 0.05 && def.pitch <= 10.0)))
        throw_def_error(def, "pitch = " + number(def.pitch) +
                                 " m; give 0 for a jaw, 0.05 to 10 for a chain stopper");
}

/// Check that no other closed stopper holds the same node. Each would carry its full load.
void check_node_is_free(World& world, const StopperDef& def) {
    if (!def.closed) return;
    const auto node_to_hold = wire::StopperSystem(def).node_to_hold(world);
    if (!node_to_hold) return;
    for (int i = 0; i < world.system_count(); ++i) {
        const auto* other = dynamic_cast<const wire::StopperSystem*>(&world.system(i));
        if (other == nullptr || !other->def().closed) continue;
        const auto theirs = other->node_to_hold(world);
        if (!theirs || theirs->wire != node_to_hold->wire) continue;
        const double separation = std::abs(theirs->at - node_to_hold->at);
        if (separation > wire::kStopperAtNode) continue;
        throw_def_error(def,
                        "point: if closed at the start, it would hold the node that stopper '" +
                            other->def().name + "' holds, " + number(separation) +
                            " m away along the wire; give points whose nearest positions on the "
                            "wire are more than " +
                            number(wire::kStopperAtNode) + " m apart, or start one of them open");
    }
}

}  // namespace

void define(World& world, const StopperDef& def) {
    check(world, def);
    check_node_is_free(world, def);
    world.add_system(std::make_unique<wire::StopperSystem>(def));
}

}  // namespace hawser
