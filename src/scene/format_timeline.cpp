// SPDX-License-Identifier: Apache-2.0
/// Operations at times.
#include "scene/format.h"
#include "scene/timeline.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

Field end_field(const char* key, const char* doc) {
    return {key, word("an end", {"first", "last"}), false, "last", "", doc};
}

/// Add the fields for the gear that connects an end.
void add_gear(std::vector<Field>& fields, bool plate) {
    std::vector<std::string> words{gear_words().begin(), gear_words().end()};
    if (!plate) std::erase(words, "triplate");
    fields.push_back({"gear", word("gear", words), false, "splice", "",
                      plate ? "splice: the two become one wire; shackle, swivel, pelican_hook: a "
                              "link; triplate: a plate with a link for each."
                            : "splice: held rigidly where it is; shackle, swivel, pelican_hook: a "
                              "link."});
    fields.push_back({"name", name("a name"), false, "of the wire and /gear", "",
                      "Of the gear, unique among interactions; \"release\" finds it by it."});
    fields.push_back({"mass", number("a mass", 0.0, 1e12), false, "0", "kg",
                      "Mass of the gear; required for a triplate."});
    fields.push_back(
        {"length", positive("a length", kMostLength), false, "0.3", "m", "Length of a link."});
    fields.push_back({"EA", positive("a stiffness", kMaxForce), false, "of the wire", "N",
                      "Axial stiffness EA of a link."});
    fields.push_back({"breaking_load", positive("a force", kMaxForce), false, "never", "N",
                      "A link breaks above this tension."});
    if (plate)
        fields.push_back({"radius", positive("a length", kMostLength), false, "0.3", "m",
                          "Radius of the circle on which a triplate's holes lie."});
    fields.push_back(
        {"reach", number("a length", 0.0, kMostLength), false, "0.1", "m",
         "Distance of the ends that is allowed in addition to the length of the gear."});
}

}  // namespace

ShapePtr operation_shape() {
    const ShapePtr wire = text("a wire name");
    const char* const which = "A cable of lumps, or a piece of one: name/2, name/3, … as cut.";
    std::vector<Field> detach{{"wire", wire, true, "", "", which}, end_field("end", "Which end.")};
    std::vector<Field> attach = detach;
    attach.push_back({"body", body_ref(), true, "", "", "Body that is to hold it."});
    attach.push_back(
        {"point", vector3("a point"), false, "[0, 0, 0]", "m", "Origin of its frame."});
    add_gear(attach, false);
    std::vector<Field> join = detach;
    join.push_back(
        {"to", wire, true, "", "", "The other wire, which a splice merges into this one."});
    join.push_back(
        {"to_end", word("an end", {"first", "last"}), false, "first", "", "Which end of it."});
    add_gear(join, true);
    const ShapePtr value = choice("a number, a winch's mode, or a load of a crane",
                                  {number("a number", -1e30, 1e30), text("a mode or a load")});
    return object(
        "operation", "an operation",
        "Something that is done before the first step that begins at its time or later.",
        {{"at", number("a time", 0.0, 1e12), true, "", "s", "Time of the operation."},
         {"set", map("values by input", value), false, "", "",
          "Inputs and signals of winches (name.mode, name.speed) and cranes (name.hoist, "
          "name.take) "
          "with their values; or …"},
         {"cut", wire, false, "", "", "… wire that is cut in two …"},
         {"s", positive("a length", kMostLength), false, "", "m",
          "… at this unstretched length from its first end; or …"},
         {"detach",
          object("operation_detach", "an end", "End of a wire to release.", std::move(detach)),
          false, "", "", "… end to release; or …"},
         {"attach",
          object("operation_attach", "an end and a body",
                 "Free end of a wire that is attached to a body.", std::move(attach)),
          false, "", "", "… free end to attach to a body within reach; or …"},
         {"join",
          object("operation_join", "two ends", "Free ends of wires that come together.",
                 std::move(join)),
          false, "", "", "… free ends that come together, within reach; or …"},
         {"release", text("a name"), false, "", "", "… pelican hook that opens."},
         {"description", text("a text"), false, "", "",
          "Purpose of the operation. Reports and summaries state it at its time."}},
        {{"set", "cut", "detach", "attach", "join", "release"},
         {"s", "set"},
         {"s", "detach"},
         {"s", "attach"},
         {"s", "join"},
         {"s", "release"}});
}

}  // namespace hawser::scene
