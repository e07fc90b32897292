// SPDX-License-Identifier: Apache-2.0
/// Drag-embedment anchors and stability gauges (hawser/anchor.h, hawser/stability.h).
#include "scene/anchors.h"
#include "scene/field_shapes.h"
#include "scene/format.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

template <class T>
void add_anchor_fields(std::vector<Field>& fields) {
    add_fields(fields, VesselTable<T>::kNumbers);
}

/// Return the words of an enumeration without its first word, which means "none".
std::vector<std::string> words_after_first(std::span<const char* const> names) {
    return {names.begin() + 1, names.end()};
}

}  // namespace

ShapePtr anchor_shape() {
    std::vector<Field> clay;
    add_anchor_fields<AnchorClay>(clay);
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among systems; of its signals, NAME.drag."},
        {"body", body_ref(), true, "", "", "A rigid body, with the line at its shackle."},
        {"point", vector3("a point"), false, "[0, 0, 0]", "m",
         "Point at which the soil acts, in the frame of the body."},
        {"cable", text("a cable name"), false, "all that end on it", "",
         "The anchor line, if other cables end on the anchor, too."},
        {"soil", word("a soil", words_after_first(anchor_soils())), true, "", "",
         "Soil of the seabed."},
        {"type", word("a type", words_after_first(anchor_types())), false, "none: uhc", "",
         "Published capacity by mass and soil."},
        {"law", word("a law", {"exponential", "trajectory"}), false, "exponential", "",
         "Capacity by drag; trajectory: of an anchor that dives in the clay."},
        {"set", boolean("true or false"), false, "false", "", "Whether it is set at the start."},
        {"clay",
         object("anchor_clay", "a clay", "Clay around an anchor and its line.", std::move(clay)),
         false, "none", "", "For the trajectory and the friction of the line in the soil."}};
    add_anchor_fields<AnchorDef>(fields);
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return object("anchor", "an anchor",
                  "A drag-embedment anchor. Its holding capacity depends on the drag distance and "
                  "the line angle; above it the anchor drags or breaks out.",
                  std::move(fields));
}

ShapePtr stability_shape() {
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "",
         "Unique among systems; of its signals, NAME.permissible."},
        {"body", body_ref(), true, "", "", "The ship, with a hull in the sea or \"gm\"."},
        {"cable", text("a cable name"), true, "", "", "The towline; it ends on the ship."},
        {"other_cables", list("a list of cable names", text("a cable name"), 0, 100), false, "none",
         "",
         "Further cables that may pass the stern: a pennant on a hook, a chain in a shark jaw."},
        {"pin", vector3("a point"), true, "", "m",
         "Inner side of the towing pin at the highest support of the cable, in the body's frame."},
        {"stern", vector3("a point"), false, "none", "m",
         "Deck at the stern on the centreline, for the freeboard."}};
    add_anchor_fields<StabilityDef>(fields);
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return object("stability", "a stability gauge",
                  "Permissible tension of a towline by the ship's stability, with alarms.",
                  std::move(fields));
}

}  // namespace hawser::scene
