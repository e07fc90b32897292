// SPDX-License-Identifier: Apache-2.0
/// Inputs and outputs of a scene. The table of kinds defines the outputs (hawser/outputs.h).
#include "scene/format.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

/// Add the display fields of an input or output for clients.
void add_display(std::vector<Field>& fields, const char* unit_fallback) {
    fields.push_back(
        {"unit", text("a unit"), false, unit_fallback, "",
         "Text that is shown with the value. The value itself is always in SI units."});
    fields.push_back({"group", text("a text"), false, "", "", "Heading under which it is shown."});
    fields.push_back({"nominal", number("a size", 0.0, 1e30), false, "0", "",
                      "Usual size, for axes and levers; 0: not known."});
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
}

/// Add the schema fields that name the body, interaction or signal of an output.
void add_target(std::vector<Field>& fields, std::vector<std::vector<std::string>>& alternatives,
                const OutputKindInfo& kind) {
    const bool drum = kind.kind == OutputKind::drum;
    switch (kind.target) {
        case OutputTarget::body:
            fields.push_back({"body", text("a body name"), true, "", "", "Of which body."});
            fields.push_back({"point", vector3("a point"), false, "[0, 0, 0]", "m",
                              "Point of its frame, from the centre of mass."});
            break;
        case OutputTarget::two_bodies:
            fields.push_back({"bodies", list("2 body names", text("a body name"), 2, 2), true, "",
                              "", "From and to."});
            fields.push_back({"points", list("2 points, one a body", vector3("a point"), 2, 2),
                              false, "the centres of mass", "m",
                              "Points, one on each body, in its frame."});
            break;
        case OutputTarget::interaction:
            fields.push_back({"interaction", text("an interaction name"), !drum, "", "",
                              drum ? "A winch_stretch; or …" : "Of which interaction."});
            break;
        case OutputTarget::line:
            fields.push_back(
                {"interactions",
                 list("a list of interactions", text("an interaction name"), 1, kMaxElements),
                 false, "", "", "Elements of a line, in order; or …"});
            break;
        case OutputTarget::world:
        case OutputTarget::system:
            break;
    }
    if (drum || kind.target == OutputTarget::line) {
        fields.push_back({"cable", text("a cable name"), false, "", "",
                          drum ? "… a cable with a winch." : "… a cable."});
        alternatives.push_back({drum ? "interaction" : "interactions", "cable"});
    }
}

std::string article_of(const std::string& noun) {
    return (std::string("aeiou").find(noun.front()) != std::string::npos ? "an " : "a ") + noun;
}

ShapePtr kind_of_output(const OutputKindInfo& kind) {
    std::vector<Field> fields{
        {"kind", literal(word("the kind", {kind.name})), true, "", "", "The kind."},
        {"name", name("a name"), true, "", "", "Unique among outputs."}};
    std::vector<std::vector<std::string>> alternatives;
    add_target(fields, alternatives, kind);
    const bool several = kind.components.size() > 1;
    std::vector<std::string> words;
    std::string doc = "Which number of it:";
    for (const OutputComponent& c : kind.components) {
        words.emplace_back(c.name);
        doc += fmt::format(" {} [{}], {}", c.name, c.unit, c.doc);
    }
    fields.push_back({"component", word("a component", words), several,
                      several ? "" : kind.components[0].name, "", several ? doc : "The only one."});
    if (kind.kind == OutputKind::velocity) {
        fields.push_back({"local", boolean("true or false"), false, "false", "",
                          "Along and about the body's own axes instead of the world's."});
    }
    add_display(fields, "of the component");
    return object(fmt::format("output_{}", kind.name),
                  article_of(std::string(kind.name)) + " output", kind.doc, std::move(fields),
                  std::move(alternatives));
}

}  // namespace

ShapePtr input_shape() {
    const ShapePtr bound = number("a number", -1e30, 1e30);
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among inputs."},
        {"interaction", text("an interaction name"), false, "", "",
         "Interaction with the parameter to set …"},
        {"param", text("a parameter"), false, "", "", "… and the parameter; or …"},
        {"signal", text("a signal"), false, "", "",
         "… signal of a winch, by its full name, \"NAME.speed\" …"},
        {"factor", number("a factor", -1e12, 1e12), false, "1", "1",
         "… which gets the value times this; or …"},
        {"body", text("a body name"), false, "", "",
         "… body on which its force acts, in addition to other forces …"},
        {"component",
         word("a component", {"force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z"}),
         false, "", "", "… and which component of it, world frame."},
        {"local", boolean("true or false"), false, "false", "",
         "The component is in the frame of the rigid body and rotates with it. It adds to other "
         "loads of the body."},
        {"min", bound, false, "-1e30", "", "Smallest value."},
        {"max", bound, false, "1e30", "", "Largest value."},
        {"spring", bound, false, "none", "",
         "Value to which the control returns when it is released; without it the control stays."}};
    add_display(fields, "of what it sets");
    return object("input", "an input", "A number that may be changed while the scene runs.",
                  std::move(fields),
                  {{"interaction", "body"},
                   {"interaction", "component"},
                   {"interaction", "local"},
                   {"param", "body"},
                   {"param", "component"},
                   {"signal", "interaction"},
                   {"signal", "param"},
                   {"signal", "body"},
                   {"signal", "component"},
                   {"signal", "local"},
                   {"factor", "interaction"},
                   {"factor", "body"}});
}

ShapePtr output_shape() {
    auto shape = std::make_shared<Shape>();
    shape->type = Shape::Type::switched;
    shape->id = "output";
    shape->what = "an output";
    shape->doc = "A number that may be read while the scene runs; \"kind\" selects which.";
    shape->key = "kind";
    for (const OutputKindInfo& kind : output_kinds()) {
        if (kind.target == OutputTarget::system) continue;  // No scene has systems.
        shape->cases.emplace_back(kind.name, kind_of_output(kind));
    }
    return shape;
}

}  // namespace hawser::scene
