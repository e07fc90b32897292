// SPDX-License-Identifier: Apache-2.0
#include <hawser/drum_feed.h>
#include <hawser/world.h>

#include "base/number.h"
#include "wire/drum_feed_system.h"

#include <cmath>
#include <memory>
#include <string>

namespace hawser {
namespace {

[[noreturn]] void throw_feed_error(const DrumFeedDef& def, const std::string& why) {
    throw DefError("drum feed '" + def.name + "': " + why);
}

/// Return the element of the wire's end that lies on a drum.
/// @throws DefError
InteractionId element_on_drum(const World& world, const DrumFeedDef& def) {
    if (!world.alive(def.wire)) throw_feed_error(def, "the wire does not exist");
    if (def.end != 0 && def.end != 1) throw_feed_error(def, "end must be 0, the first one, or 1");
    const auto elements = world.wires().elements(def.wire);
    const InteractionId id = def.end == 0 ? elements.front() : elements.back();
    if (!world.alive(id) || world.interaction_def(id).kind != InteractionKind::WinchStretch)
        throw_feed_error(def,
                         "this end of its wire does not lie on a drum; call WorldWires::spool()");
    return id;
}

/// Check that nodes can be made. @throws DefError
void check_nodes(const World& world, const DrumFeedDef& def, InteractionId line) {
    if (!(def.element > 0.0 && std::isfinite(def.element)))
        throw_feed_error(def,
                         "element = " + number(def.element) + " m; give a length of at least 0");
    if (!(def.mass_per_length > 0.0 && std::isfinite(def.mass_per_length)))
        throw_feed_error(def, "mass_per_length = " + number(def.mass_per_length) +
                                  " kg/m; give a number above 0");
    const InteractionDef& at_drum = world.interaction_def(line);
    const BodyId fairlead = at_drum.body[def.end == 0 ? 0 : 1];
    if (world.body_def(fairlead).kind == BodyKind::lump)
        throw_feed_error(def, "the fairlead must not be on a point mass");
    for (const InteractionId id : world.wires().elements(def.wire))
        if (id != line && world.alive(id) && !(world.interaction_def(id).get("mass") > 0.0))
            throw_feed_error(
                def, "the elements of its wire have no mass for new nodes (consistent_mass)");
}

}  // namespace

void define(World& world, const DrumFeedDef& given) {
    DrumFeedDef def = given;
    if (def.name.empty()) throw DefError("a drum feed needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_feed_error(def, "the name is in use; names must be unique");
    const InteractionId line = element_on_drum(world, def);
    const double length = world.interaction_def(line).get("length");
    if (std::isnan(def.element)) def.element = length;
    if (def.element != 0.0) check_nodes(world, def, line);
    const double angle = world.pose(world.interaction_def(line).body[2]).position.x();
    world.add_system(std::make_unique<wire::DrumFeedSystem>(def, line, length, angle));
}

}  // namespace hawser
