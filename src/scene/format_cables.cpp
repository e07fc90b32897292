// SPDX-License-Identifier: Apache-2.0
#include "scene/field_shapes.h"
#include "scene/format.h"
#include "scene/line_types.h"
#include "scene/resolutions.h"
#include "scene/winches.h"

#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

ShapePtr cable_end() {
    return object(
        "cable_end", "a cable end", "Where a cable ends: on a body, in the world, or free.",
        {{"body", body_ref(), false, "", "", "Body to which the end is attached …"},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m", "… at this point of its frame."},
         {"at", vector3("a point"), false, "", "m", "World point to which it is fixed."},
         {"free", vector3("a point"), false, "", "m", "World point at which a free end starts."}},
        {{"body", "at", "free"}, {"point", "at", "free"}});
}

ShapePtr drum_of_cable() {
    return object("winch", "a winch", "A drum at the \"from\" end that pays the cable out.",
                  {{"drum", body_ref(), true, "", "", "Scalar body."},
                   {"radius", number("a radius", -1e3, 1e3), true, "", "m",
                    "Cable paid out per unit of drum coordinate."},
                   {"fairlead", cable_end(), false, "\"from\"", "",
                    "Where the cable leaves, if \"from\" names the drum or is not given."}});
}

ShapePtr seabed_of_cable() {
    return object(
        "cable_seabed", "a seabed of a cable",
        "Seabed on which a cable lies at the start. It causes no contact during the run.",
        {{"height", number("a height", -kMostLength, kMostLength), true, "", "m",
          "Of the bottom; nodes lie the radius of \"contact\" over it."},
         {"friction", number("a friction coefficient", 0.0, 100.0), false, "0", "1",
          "Friction coefficient: the tension decreases along the part that lies on the seabed."}});
}

ShapePtr weak_of_cable() {
    return object("cable_weak", "a weak point of a cable",
                  "The element at this point breaks at a lower tension.",
                  {{"at", number("a length", 0.0, kMostLength), true, "", "m",
                    "Unstretched length from the first end."},
                   {"breaking_load", positive("a force", kMaxForce), true, "", "N",
                    "The element at this point breaks above this tension."}});
}

ShapePtr section_of_cable(const ShapePtr& line) {
    return object(
        "cable_section", "a section of a cable", "A piece of a cable of one line type.",
        {{"line_type", line, true, "", "", "Line type, by name or as an object."},
         {"length", positive("a length", kMostLength), true, "", "m", "Unstretched length."},
         {"elements", integer("a number of elements", 1, static_cast<double>(kMaxElements)), true,
          "", "", "Number of its elements, which are equal."}});
}

ShapePtr resolution_shape() {
    std::vector<Field> fields;
    add_fields(fields, resolution_fields());
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return object("cable_resolution", "a resolution",
                  "Inserts and removes nodes of a cable by tension, curvature and contact. Its "
                  "signals are CABLE/resolution.nodes and so on.",
                  std::move(fields));
}

}  // namespace

ShapePtr line_type_shape() {
    std::vector<Field> fields;
    add_fields(fields, kSectionFields);
    add_fields(fields, kLayoutFields);
    fields.push_back(
        {"color", text("a colour"), false, "", "", "Colour in pictures, such as \"#445566\"."});
    fields.push_back({"description", text("a text"), false, "", "", "Source and remarks."});
    for (Field& field : line_water_fields()) fields.push_back(std::move(field));
    return object("line_type", "a line type", "Properties of a chain, wire or rope.",
                  std::move(fields));
}

ShapePtr cable_shape() {
    const ShapePtr line =
        choice("a line type, by name or as an object", {text("a name"), line_type_shape()});
    return object(
        "cable", "a cable", "A chain, wire or rope between two ends, cut into equal elements.",
        {{"name", name("a name"), true, "", "", "Unique among cables."},
         {"line_type", line, false, "", "",
          "Line type, by name or as an object; required without \"sections\"."},
         {"sections", list("a list of sections", section_of_cable(line), 1, 1000), false, "", "",
          "From the first end on, where it is of several line types, instead of \"line_type\", "
          "\"length\" and \"elements\"."},
         {"from", cable_end(), false, "", "", "First end; needed unless a fairlead is given."},
         {"to", cable_end(), true, "", "", "Last end."},
         {"length", positive("a length", kMostLength), false, "along its shape", "m",
          "Unstretched length."},
         {"elements", integer("a number of elements", 1, static_cast<double>(kMaxElements)), false,
          "one more than the points", "", "Number of elements."},
         {"as", word("a way to model a cable", {"lumps", "links"}), false, "lumps", "",
          "lumps: point masses, stretch and bend; links: rigid cylinders and ball joints."},
         {"radius", positive("a length", 1e3), false, "half the diameter", "m", "Radius of links."},
         {"shape",
          choice("the name of a shape or a list of points",
                 {word("a shape", {"straight", "catenary", "hanging", "laid", "path"}),
                  list("a list of points", vector3("a point"), 1, kMaxElements)}),
          false, "straight", "m",
          "Initial shape: straight; catenary, at rest without stretch; hanging, at rest with its "
          "stretch, between any ends; laid, along the seabed and straight up to its ends; path, "
          "evenly along \"path\"; or the positions of the interior nodes, one fewer than the "
          "elements."},
         {"seabed", seabed_of_cable(), false, "", "",
          "Horizontal seabed for cables that start with the shape catenary, hanging or laid."},
         {"path", list("a list of points", vector3("a point"), 1, kMaxElements), false, "", "m",
          "Corners between the ends of a cable of the shape path."},
         {"offsets", list("a list of offsets", vector3("an offset"), 0, kMaxElements), false, "",
          "m", "Offsets added to the positions of the interior nodes."},
         {"weak", weak_of_cable(), false, "", "",
          "Point at which the cable breaks at a lower tension than elsewhere."},
         {"tension_only", boolean("true or false"), false, "true", "", "False: it also pushes."},
         {"consistent_mass", boolean("true or false"), false, "false", "",
          "True: an element between two lumps moves as a straight piece, with its mass along it."},
         {"resolution", resolution_shape(), false, "its elements stay as they are", "",
          "Limits within which its elements become longer and shorter; it needs "
          "\"consistent_mass\"."},
         {"groups", list("a list of groups", group(), 1, 100), false, "[\"\"]", "",
          "Groups of its nodes or links, which are shared out evenly from the first end on."},
         {"winch", drum_of_cable(), false, "", "", "Drum that pays it out."},
         {"contact", cable_contact(), false, "it touches nothing", "",
          "Contacts of its elements with shapes. Elements that end on a body have contacts only "
          "with \"to_ends\"."},
         {"compliance", number("a compliance", 0.0, 1e12), false, "of a ball joint", "m/N",
          "Compliance of the ball joints of links."},
         {"damping_time", number("a time", 0.0, 1e12), false, "of a ball joint", "s",
          "Damping time of the ball joints of links."},
         {"description", text("a text"), false, "", "", "Remarks."}},
        {{"line_type", "sections"}, {"length", "sections"}, {"elements", "sections"}});
}

namespace {

ShapePtr gypsy_shape() {
    std::vector<Field> fields{{"pockets", integer("a number of pockets", kMinPockets, kMaxPockets),
                               true, "", "1", "Each holds a link that lies flat; 5 are usual."}};
    add_fields(fields, gypsy_fields());
    return object("gypsy", "a gypsy", "A wheel with pockets for the links of a chain.",
                  std::move(fields));
}

}  // namespace

ShapePtr winch_shape() {
    const std::span<const char* const> modes = winch_modes();
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among winches; of its signals, name.mode."},
        {"cable", text("a cable name"), true, "", "", "Cable of lumps that it winds up."},
        {"end", word("an end", {"from", "to"}), false, "from", "",
         "End of the cable that is on the drum."},
        {"mode", word("a mode", {modes.begin(), modes.end()}), false, "brake", "",
         "Mode at the start."}};
    add_fields(fields, winch_fields());
    fields.push_back(
        {"heave_point",
         object("heave_point", "a point of a body", "A point that moves with the ship.",
                {{"body", body_ref(), true, "", "", "Body of the point."},
                 {"point", vector3("a point"), true, "", "m", "Point in the frame of the body."}}),
         false, "the fairlead", "", "Point whose upward motion mode heave compensates."});
    fields.push_back({"gypsy", gypsy_shape(), false, "it is a drum", "",
                      "A wheel with pockets for chain, instead of a drum."});
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return object("winch_on_deck", "a winch on deck",
                  "A winch at the end of a cable: a drum with layers or a gypsy, motor, brake and "
                  "modes.",
                  std::move(fields),
                  {{"core_radius", "gypsy"},
                   {"width", "gypsy"},
                   {"flange_radius", "gypsy"},
                   {"layer_pitch", "gypsy"}});
}

}  // namespace hawser::scene
