// SPDX-License-Identifier: Apache-2.0
#include "wire/define_gypsy.h"

#include <hawser/world.h>

#include "wire/winch_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser {
namespace {

/// Return the pitch of a link [m].
double link_pitch(const WinchDef& def) noexcept {
    return std::isnan(def.gypsy.pitch) ? 4.0 * def.wire_diameter : def.gypsy.pitch;
}

/// Return the length of chain that moves with the wheel [m].
double moving_chain(const WinchDef& def) noexcept {
    return def.gypsy.wrap * gypsy_radius(def) + def.gypsy.locker_fall;
}

}  // namespace

double gypsy_radius(const WinchDef& def) noexcept {
    return def.gypsy.pockets * link_pitch(def) / std::numbers::pi;
}

double gypsy_chain_inertia(const WinchDef& def) noexcept {
    const double r = gypsy_radius(def);
    return def.mass_per_length * moving_chain(def) * r * r;
}

ChainProperties chain_properties(double diameter, bool studs) noexcept {
    const double square = diameter * diameter;
    return {.mass_per_length = (studs ? 21.9e3 : 19.9e3) * square,
            .EA = (studs ? 1.01e11 : 0.854e11) * square,
            .link = 4.0 * diameter};
}

namespace wire {

GypsyWheel complete_gypsy(const WinchDef& def) {
    const GypsyDef& g = def.gypsy;
    if (g.pockets < 3 || g.pockets > 100)
        throw_def_error(def, "gypsy.pockets = " + std::to_string(g.pockets) + "; give 3 to 100");
    if (def.core_radius != 0.0 || def.width != 0.0 || !std::isnan(def.flange_radius) ||
        !std::isnan(def.layer_pitch))
        throw_def_error(
            def,
            "a gypsy has no core_radius, width, flange_radius or layer_pitch: pockets and "
            "pitch give its radius; leave them out");
    check_number(def, "wire_diameter", def.wire_diameter, 0.0, true);
    check_number(def, "mass_per_length", def.mass_per_length, 0.0, true);
    const double pitch = link_pitch(def);
    check_number(def, "gypsy.pitch", pitch, 0.0, true);
    if (pitch < 2.0 * def.wire_diameter)
        throw_def_error(def,
                        "gypsy.pitch = " + number(pitch) + " m is below 2 bar diameters, " +
                            number(2.0 * def.wire_diameter) +
                            " m: links of this proportion do not fit into each other; 4 is usual");
    check_number(def, "gypsy.jump_load", g.jump_load, 0.0, true);
    const double friction = std::isnan(g.jump_friction) ? 0.5 * g.jump_load : g.jump_friction;
    check_number(def, "gypsy.jump_friction", friction, 0.0, false);
    if (friction > g.jump_load)
        throw_def_error(
            def, "gypsy.jump_friction is above jump_load: chain that jumps is held by no more");
    check_number(def, "gypsy.locker_fall", g.locker_fall, 0.0, false);
    check_number(def, "gypsy.locker", g.locker, 0.0, true);
    if (def.stored > g.locker)
        throw_def_error(def, "stored = " + number(def.stored) + " m, but its locker holds " +
                                 number(g.locker) + " m");
    check_number(def, "gypsy.wrap", g.wrap, 0.0, true);
    if (g.wrap > 7.0) throw_def_error(def, "gypsy.wrap = " + number(g.wrap) + " rad; give up to 7");
    return {.radius = gypsy_radius(def),
            .pocket = 2.0 * pitch,
            .jump_load = g.jump_load,
            .jump_friction = friction,
            .fall = g.locker_fall,
            .locker = g.locker};
}

void add_gypsy_parts(World& world, const WinchDef& def, const GypsyWheel& wheel, WinchIds& ids) {
    const double most = std::min(wheel.jump_load * wheel.radius, 1e30);
    InteractionDef grip{.name = def.name + "/grip", .kind = InteractionKind::ScalarClutch};
    grip.body = {ids.drum, ids.chain, {}};
    grip.set("force_min", -most).set("force_max", most);
    ids.grip = world.add_interaction(grip);
    InteractionDef end{.name = def.name + "/bitter_end", .kind = InteractionKind::ScalarFriction};
    end.body[0] = ids.chain;
    end.set("force", 0.0).set("back", 0.0);
    // Held by the chain between it and the wheel.
    const auto elements = world.wires().elements(def.wire);
    const double EA =
        world.interaction_def(def.end == 0 ? elements.front() : elements.back()).get("EA");
    end.compliance[0] = moving_chain(def) / (EA * wheel.radius * wheel.radius);
    ids.bitter_end = world.add_interaction(end);
}

}  // namespace wire
}  // namespace hawser
