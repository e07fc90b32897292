// SPDX-License-Identifier: Apache-2.0
#include "scene/format.h"

#include <string>

namespace hawser::scene {
namespace {

using namespace make;

// Limits that catch a wrong unit or a damaged digit; far beyond anything marine.
constexpr double kMostMass = 1e15;
constexpr double kMostLength = 1e6;
constexpr double kMostForce = 1e15;
constexpr double kMostDamping = 1e18;
constexpr std::size_t kMostEntries = kMaxElements;

ShapePtr body_ref() { return text("a body name"); }
ShapePtr list_of(const char* what, const ShapePtr& item) {
    return list(what, item, 0, kMostEntries);
}
ShapePtr quaternion() {
    return list("an orientation [w, x, y, z]", number("a number", -1e6, 1e6), 4, 4);
}
ShapePtr angles() {
    return list("three angles [roll, pitch, yaw] in degrees", number("an angle", -36000, 36000), 3,
                3);
}
ShapePtr damping() {
    const ShapePtr one = number("a damping coefficient", 0.0, kMostDamping);
    return choice("a damping coefficient, or [x, y, z] of them",
                  {one, list("three damping coefficients [x, y, z]", one, 3, 3)});
}
ShapePtr half_sizes() {
    return list("three half sizes [x, y, z]", positive("a length", kMostLength), 3, 3);
}
ShapePtr inertia() {
    const ShapePtr entry = number("a moment of inertia", -1e30, 1e30);
    const ShapePtr row = list("three numbers", entry, 3, 3);
    return choice("an inertia: [Ixx, Iyy, Izz] or three rows of three numbers",
                  {list("three moments [Ixx, Iyy, Izz]", entry, 3, 3),
                   list("three rows of three numbers", row, 3, 3)});
}
ShapePtr cylinder() {
    return object("cylinder", "a cylinder", "A solid cylinder.",
                  {{"radius", positive("a length", kMostLength), true, "", "m", "Radius."},
                   {"length", positive("a length", kMostLength), true, "", "m", "Length."},
                   {"axis", word("an axis", {"x", "y", "z"}), false, "x", "",
                    "Axis of the body's frame along which it lies."}});
}

ShapePtr line_type() {
    return object(
        "line_type", "a line type", "Properties of a chain, wire or rope.",
        {{"mass_per_length", positive("a mass per length", 1e9), true, "", "kg/m", "In air."},
         {"EA", positive("a stiffness", kMostForce), false, "", "N",
          "Axial stiffness; needed by cables of lumps."},
         {"EI", number("a stiffness", 0.0, kMostForce), false, "0", "N m^2",
          "Bending stiffness; 0: perfectly flexible. Cables of links bend freely."},
         {"diameter", positive("a length", 1e3), false, "", "m", "For pictures."},
         {"breaking_load", positive("a force", kMostForce), false, "never", "N",
          "An element parts above this tension."},
         {"axial_damping", number("a fraction", 0.0, 10.0), false, "two steps of damping time", "1",
          "Fraction of critical of the highest axial mode of an element."},
         {"drag", number("a damping per length", 0.0, kMostDamping), false, "0", "N s/m^2",
          "Linear drag per length."},
         {"submerged_factor", number("a factor", -1.0, 1.0), false, "1", "1",
          "Weight in water divided by weight in air."},
         {"color", text("a colour"), false, "", "", "For pictures, such as \"#445566\"."},
         {"description", text("a text"), false, "", "", "Source and remarks."}});
}

/// A group of bodies, for settings.coupling.
ShapePtr group() {
    return choice("a group: a name or a number", {text("a name"), integer("a number", 0, 1e6)});
}

ShapePtr body() {
    return object(
        "body", "a body", "One body.",
        {{"name", name("a name"), true, "", "", "Unique among bodies."},
         {"kind", word("a kind of body", {"rigid", "lump", "scalar", "fixed", "kinematic"}), false,
          "rigid", "",
          "rigid: 6 degrees of freedom; lump: a point mass, 3; scalar: a drum, 1; fixed: part of "
          "the world; kinematic: moves with its velocity whatever pulls at it."},
         {"group", group(), false, "\"\"", "",
          "Group that it belongs to: settings.coupling says how groups couple."},
         {"position", vector3("a position"), false, "[0, 0, 0]", "m",
          "Centre of mass; of a scalar body the coordinate is x (m or rad)."},
         {"orientation", quaternion(), false, "[1, 0, 0, 0]", "1",
          "Quaternion [w, x, y, z] from the body's frame to the world."},
         {"euler_deg", angles(), false, "", "deg",
          "[roll, pitch, yaw]: about x, then y, then z of the world."},
         {"velocity", vector3("a velocity"), false, "[0, 0, 0]", "m/s",
          "Of the centre of mass at time 0; of a scalar body x."},
         {"angular_velocity", vector3("an angular velocity"), false, "[0, 0, 0]", "rad/s",
          "At time 0, world frame."},
         {"mass", positive("a mass", kMostMass), false, "", "kg",
          "Needed by rigid, lump and scalar bodies; of a drum kg or kg m^2."},
         {"inertia", inertia(), false, "", "kg m^2",
          "About the centre of mass in the body's frame, symmetric and positive definite. A rigid "
          "body needs this or box, cylinder or sphere."},
         {"box", half_sizes(), false, "", "m", "Half sizes of a solid box: inertia and picture."},
         {"cylinder", cylinder(), false, "", "", "Solid cylinder: inertia and picture."},
         {"sphere", positive("a radius", kMostLength), false, "", "m",
          "Radius of a solid sphere: inertia and picture."},
         {"half_size", half_sizes(), false, "of the box", "m", "Box drawn in pictures."},
         {"force", vector3("a force"), false, "[0, 0, 0]", "N", "Constant force, world frame."},
         {"torque", vector3("a torque"), false, "[0, 0, 0]", "N m",
          "Constant torque, world frame."},
         {"linear_damping", damping(), false, "0", "N s/m",
          "Drag along the axes of the body; one number for all three."},
         {"angular_damping", damping(), false, "0", "N m s",
          "Drag about the axes of the body; one number for all three."},
         {"gravity", boolean("true or false"), false, "true (scalar: false)", "",
          "False: weightless, such as a ship afloat."},
         {"shapes", list_of("a list of shapes", shape_of_body()), false, "none", "",
          "What of it touches other things. A lump takes spheres and segments."},
         {"description", text("a text"), false, "", "", "Remarks."}},
        {{"orientation", "euler_deg"}, {"inertia", "box", "cylinder", "sphere"}});
}

ShapePtr cable_end() {
    return object(
        "cable_end", "a cable end", "Where a cable ends: on a body, in the world, or free.",
        {{"body", body_ref(), false, "", "", "Body to which the end is attached …"},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m", "… at this point of its frame."},
         {"at", vector3("a point"), false, "", "m", "World point to which it is fixed."},
         {"free", vector3("a point"), false, "", "m", "World point at which a free end starts."}},
        {{"body", "at", "free"}, {"point", "at", "free"}});
}

ShapePtr cable() {
    const ShapePtr winch =
        object("winch", "a winch", "A drum at the \"from\" end that pays the cable out.",
               {{"drum", body_ref(), true, "", "", "Scalar body."},
                {"radius", number("a radius", -1e3, 1e3), true, "", "m",
                 "Cable paid out per unit of drum coordinate."},
                {"fairlead", cable_end(), false, "\"from\"", "",
                 "Where the cable leaves, if \"from\" names the drum or is not given."}});
    return object(
        "cable", "a cable", "A chain, wire or rope between two ends, cut into equal elements.",
        {{"name", name("a name"), true, "", "", "Unique among cables."},
         {"line_type", choice("a line type by name or in place", {text("a name"), line_type()}),
          true, "", "", "What it is made of."},
         {"from", cable_end(), false, "", "", "First end; needed unless a fairlead is given."},
         {"to", cable_end(), true, "", "", "Last end."},
         {"length", positive("a length", kMostLength), false, "along its shape", "m",
          "Unstretched length."},
         {"elements", integer("a number of elements", 1, static_cast<double>(kMaxElements)), false,
          "one more than the points", "", "Number of elements."},
         {"as", word("a way to model a cable", {"lumps", "links"}), false, "lumps", "",
          "lumps: point masses, stretch and bend; links: rigid cylinders and ball joints."},
         {"radius", positive("a length", 1e3), false, "half the diameter", "m", "Of links."},
         {"shape",
          choice("\"straight\", \"catenary\" or a list of points",
                 {word("a shape", {"straight", "catenary"}),
                  list("a list of points", vector3("a point"), 1, kMostEntries)}),
          false, "straight", "m",
          "Initial shape: straight, catenary (hanging at rest without stretch), or the positions "
          "of the interior nodes, one fewer than the elements."},
         {"offsets", list("a list of offsets", vector3("an offset"), 0, kMostEntries), false, "",
          "m", "Added to the interior nodes."},
         {"tension_only", boolean("true or false"), false, "true", "", "False: it also pushes."},
         {"groups", list("a list of groups", group(), 1, 100), false, "[\"\"]", "",
          "Groups of its nodes or links, which are shared out evenly from the first end on."},
         {"winch", winch, false, "", "", "Drum that pays it out."},
         {"contact", cable_contact(), false, "it touches nothing", "",
          "Its elements touch what they meet; an element that ends on a body does not."},
         {"compliance", number("a compliance", 0.0, 1e12), false, "of a ball joint", "m/N",
          "Of the ball joints of links."},
         {"damping_time", number("a time", 0.0, 1e12), false, "of a ball joint", "s",
          "Of the ball joints of links."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

/// Value of a template's parameter.
ShapePtr parameter() {
    const ShapePtr any_number = number("a number", -1e30, 1e30);
    return choice("a number, a string, true, false or a list of numbers",
                  {any_number, text("a string"), boolean("true or false"),
                   list("a list of numbers", any_number, 0, 16)});
}

ShapePtr instance() {
    return object(
        "instance", "an instance", "One use of a template.",
        {{"template", text("a template name"), true, "", "", "Template to use."},
         {"name", name("a name"), true, "", "",
          "Prefix of the names that it makes: name/body, name/interaction."},
         {"on", body_ref(), false, "the world", "",
          "Body whose frame the template's frame starts from, velocity included."},
         {"position", vector3("a position"), false, "[0, 0, 0]", "m", "Of the template's frame."},
         {"orientation", quaternion(), false, "[1, 0, 0, 0]", "1", "Of the template's frame."},
         {"euler_deg", angles(), false, "", "deg", "Of the template's frame: [roll, pitch, yaw]."},
         {"parameters", map("parameters by name", parameter()), false, "of the template", "",
          "Values in place of the defaults."},
         {"bind", map("body names by local name", body_ref()), false, "", "",
          "Local names that stand for bodies outside."}},
        {{"orientation", "euler_deg"}});
}

ShapePtr scene_template(const Format& format) {
    return object(
        "template", "a template", "A reusable group of bodies, such as a crane.",
        {{"description", text("a text"), false, "", "", "Remarks."},
         {"parameters", map("parameters by name", parameter()), false, "", "",
          "Names and defaults of what \"${name}\" stands for."},
         {"bodies", with_placeholders(format.bodies), false, "", "", "Bodies."},
         {"interactions", with_placeholders(format.interactions), false, "", "", "Interactions."},
         {"cables", with_placeholders(format.cables), false, "", "", "Cables."},
         {"inputs", with_placeholders(format.inputs), false, "", "", "Inputs."},
         {"outputs", with_placeholders(format.outputs), false, "", "", "Outputs."},
         {"instances", with_placeholders(format.instances), false, "", "",
          "Templates used inside."}});
}

std::vector<Field> state_fields() {
    const ShapePtr pose = object(
        "state_body", "the state of a body", "Pose and velocity of one body.",
        {{"p", vector3("a position"), true, "", "m", "Position."},
         {"q", quaternion(), false, "[1, 0, 0, 0]", "1", "Orientation [w, x, y, z]."},
         {"v", vector3("a velocity"), false, "[0, 0, 0]", "m/s", "Velocity."},
         {"w", vector3("an angular velocity"), false, "[0, 0, 0]", "rad/s", "Angular velocity."}});
    return {{"bodies", map("body states by name", pose), false, "", "", "Every moving body."},
            {"time", number("a time", 0.0, 1e12), false, "", "s", "When it was taken."},
            {"scene", text("a name"), false, "", "", "Scene it belongs to."},
            {"description", text("a text"), false, "", "", "Remarks."}};
}

/// What a scene and an included file share.
std::vector<Field> common_fields(const ShapePtr& line, const ShapePtr& group) {
    return {{"$schema", text("a text"), false, "", "", "For editors."},
            {"version", integer("the version 1", kFormatVersion, kFormatVersion), true, "", "",
             "Version of the format: 1."},
            {"description", text("a text"), false, "", "", "Remarks."},
            {"include", list("a list of file names", text("a file name"), 0, 64), false, "", "",
             "Files with line types, materials and templates, relative to this one."},
            {"line_types", map("line types by name", line), false, "", "", "Line types."},
            {"materials", map("materials by name", material()), false, "", "",
             "What shapes are made of. \"default\" has all the defaults and is always there."},
            {"templates", map("templates by name", group), false, "", "", "Templates."}};
}

ShapePtr scene_file(const Format& f, std::vector<Field> fields) {
    const ShapePtr number_or_rows = number("a number", 0.0, 1e12);
    const std::vector<Field> more{
        {"name", name("a name"), true, "", "", "Name of the scene."},
        {"settings", settings_shape(), false, "", "", "Settings."},
        {"defaults",
         object("defaults", "defaults", "For constraint interactions that give none.",
                {{"compliance", number_or_rows, false, "1e-12", "m/N or rad/(N m)", "Compliance."},
                 {"damping_time", number_or_rows, false, "two steps", "s", "Damping time."}}),
         false, "", "", "Defaults of constraints."},
        {"material_pairs", list_of("a list of material pairs", material_pair()), false, "", "",
         "How two given materials touch, in place of the mixing rules."},
        {"bodies", f.bodies, false, "", "", "Bodies."},
        {"interactions", f.interactions, false, "", "", "Interactions."},
        {"cables", f.cables, false, "", "", "Cables."},
        {"instances", f.instances, false, "", "", "Uses of templates."},
        {"inputs", f.inputs, false, "", "", "Inputs."},
        {"outputs", f.outputs, false, "", "", "Outputs: columns of --csv."},
        {"repeat",
         object("repeat", "a repetition", "How copies of the scene stand side by side.",
                {{"offset", vector3("an offset"), true, "", "m", "From one copy to the next."},
                 {"joins", f.cables, false, "", "",
                  "Cables between neighbours: \"from\" in one copy, \"to\" in the next."},
                 {"copies", integer("a number of copies", 1, kMaxCopies), false, "1", "",
                  "Copies in all; the option --scale sets it."}}),
         false, "", "", "Copies."},
        {"state",
         object("state", "a state", "Pose and velocity in which the scene starts.",
                [] {
                    auto all = state_fields();
                    all.push_back({"file", text("a file name"), false, "", "",
                                   "State file, relative to this one."});
                    return all;
                }(),
                {{"file", "bodies"}}),
         false, "", "", "Start from a stored state."},
        {"plot",
         object("plot", "a plot", "What pictures of the scene show.",
                {{"tensions", list_of("a list of cables", text("a cable name")), false, "", "",
                  "Cables with a curve of tension."},
                 {"motions", list_of("a list of bodies", body_ref()), false, "", "",
                  "Bodies with a curve of motion."},
                 {"view_box",
                  list("six numbers [x, y, z, x, y, z]", number("a number", -1e9, 1e9), 6, 6),
                  false, "", "m", "Lower and upper corner of what is shown."}}),
         false, "", "", "Pictures."}};
    fields.insert(fields.end(), more.begin(), more.end());
    return object("scene", "a scene", "A scene file.", std::move(fields));
}

Format make_format() {
    Format f;
    f.line_type = line_type();
    f.bodies = list_of("a list of bodies", body());
    f.interactions = list_of("a list of interactions", interaction_shape());
    f.cables = list_of("a list of cables", cable());
    f.instances = list_of("a list of instances", instance());
    f.inputs = list_of("a list of inputs", input_shape());
    f.outputs = list_of("a list of outputs", output_shape());
    const auto common = common_fields(f.line_type, scene_template(f));
    f.scene = scene_file(f, common);
    auto part = common;
    part.push_back({"name", name("a name"), false, "", "", "Name of the part."});
    f.part = object("part", "an included file", "A file with line types and templates.", part);
    auto stored = state_fields();
    stored.front().required = true;
    stored.push_back({"version", integer("the version 1", 1, 1), true, "", "", "1."});
    f.state = object("state_file", "a state file", "What a settled scene is stored as.", stored);
    return f;
}

}  // namespace

const Format& format() {
    static const Format instance = make_format();
    return instance;
}

}  // namespace hawser::scene
