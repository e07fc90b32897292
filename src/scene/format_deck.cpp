// SPDX-License-Identifier: Apache-2.0
/// Deck gear: shark jaws, chain stoppers, guide pins, hooks, chasers.
#include "scene/deck_fields.h"
#include "scene/field_shapes.h"
#include "scene/format.h"

#include <utility>
#include <vector>

namespace hawser::scene {

using namespace make;

namespace {

/// Return the schema fields of deck gear: name and body, the fields `more`, the rows of its table,
/// and remarks.
template <class Rows>
std::vector<Field> fields_of_gear(const char* names, const char* on, const Rows& rows,
                                  std::vector<Field> more = {}) {
    std::vector<Field> fields{{"name", name("a name"), true, "", "", names},
                              {"on", body_ref(), true, "", "", on}};
    for (Field& field : more) fields.push_back(std::move(field));
    add_fields(fields, rows);
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return fields;
}

}  // namespace

ShapePtr stopper_shape() {
    return object(
        "stopper", "a stopper",
        "A shark jaw or chain stopper. It engages a cable within its reach, holds it and releases "
        "it: the signal NAME.close, 1 or 0. The holding joint is the interaction NAME/hold.",
        fields_of_gear("Unique among stoppers; of its signals, name.load.",
                       "Body on which it is mounted.", kStopperFields));
}

ShapePtr pin_shape() {
    std::vector<Field> fields = fields_of_gear("Unique among pins; of its signals, name.up.",
                                               "Body that it is on.", kPinFields);
    const auto surface = surface_fields();
    fields.insert(fields.end(), surface.begin(), surface.end());
    return object("pin", "a pin",
                  "A guide pin that goes up and down through a deck, by the signal NAME.up, 1 up "
                  "to 0 down. It is a body on a slide with the post NAME/post.",
                  std::move(fields));
}

ShapePtr hook_shape() {
    return object(
        "hook", "a hook",
        "A hook at the end of a cable or on a body. It attaches loads by slings and releases them: "
        "the signal NAME.take is the number of a load, or its name in a timeline; 0: none. Its "
        "legs are the interactions NAME/leg1, NAME/leg2, ….",
        fields_of_gear("Unique among hooks; of its signals, name.load.",
                       "Body that acts as the hook, or the last node of a cable (CABLE/number).",
                       kHookFields,
                       {{"loads", list("a list of loads", crane_load_shape(), 1, 1000), true, "",
                         "", "Loads that it can attach."},
                        {"take", body_ref(), false, "none", "",
                         "Body of the load that hangs from the start."}}));
}

ShapePtr chaser_shape() {
    return object(
        "chaser", "a chaser",
        "A ring that is put round the cable within its reach, runs along it with friction, and is "
        "taken off again: the signal NAME.close, 1 or 0. Cables that are made fast to the ring are "
        "left out; others need \"consistent_mass\".",
        fields_of_gear("Unique among chasers; of its signals, name.arrived.",
                       "The rigid body that is the ring.", kChaserFields));
}

}  // namespace hawser::scene
