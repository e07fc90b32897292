// SPDX-License-Identifier: Apache-2.0
#include <hawser/body_fields.h>

#include "scene/field_shapes.h"
#include "scene/format.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

ShapePtr quaternion() {
    return list("an orientation [w, x, y, z]", number("a number", -1e6, 1e6), 4, 4);
}
ShapePtr angles() {
    return list("three angles [roll, pitch, yaw] in degrees", number("an angle", -36000, 36000), 3,
                3);
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

/// Return the schema of a key of bodies that has a special reader.
ShapePtr shape_with_special_reader(const FieldInfo<BodyDef>& row) {
    const std::string_view key = row.key;
    if (key == "orientation") return quaternion();
    if (key == "inertia") return inertia();
    if (key == "half_size") return half_sizes();
    if (key == "group") return group();
    return vector3(row.what);
}

/// Return the keys that set the member of a row in another form.
std::vector<Field> keys_of_other_form(std::string_view key) {
    if (key == "orientation")
        return {{"euler_deg", angles(), false, "", "deg",
                 "[roll, pitch, yaw]: about x, then y, then z of the world."}};
    if (key != "inertia") return {};
    return {
        {"box", half_sizes(), false, "", "m", "Half sizes of a solid box: inertia and picture."},
        {"cylinder", cylinder(), false, "", "", "Solid cylinder: inertia and picture."},
        {"sphere", positive("a radius", kMostLength), false, "", "m",
         "Radius of a solid sphere: inertia and picture."}};
}

}  // namespace

ShapePtr body_shape() {
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among bodies."},
        {"kind", word("a kind of body", {"rigid", "lump", "scalar", "fixed", "kinematic"}), false,
         "rigid", "",
         "rigid: 6 degrees of freedom; lump: a point mass, 3; scalar: a drum, 1; fixed: part of "
         "the world; kinematic: moves with its velocity whatever pulls at it."}};
    for (const FieldInfo<BodyDef>& row : kBodyFields) {
        fields.push_back(field_from_row(
            row, row.is(kOwnReader) ? shape_with_special_reader(row) : shape_of_field(row)));
        for (Field& other : keys_of_other_form(row.key)) fields.push_back(std::move(other));
    }
    fields.push_back({"shapes", list_of("a list of shapes", shape_of_body()), false, "none", "",
                      "What of it touches other things. A lump takes spheres and segments."});
    fields.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return object("body", "a body", "One body.", std::move(fields),
                  {{"orientation", "euler_deg"}, {"inertia", "box", "cylinder", "sphere"}});
}

namespace {

/// Return the schema of the value of a template parameter.
ShapePtr parameter() {
    const ShapePtr any_number = number("a number", -1e30, 1e30);
    return choice("a number, a string, true, false or a list of numbers",
                  {any_number, text("a string"), boolean("true or false"),
                   list("a list of numbers", any_number, 0, 16)});
}

}  // namespace

ShapePtr instance_shape() {
    return object("instance", "an instance", "One use of a template.",
                  {{"template", text("a template name"), true, "", "", "Template to use."},
                   {"name", name("a name"), true, "", "",
                    "Prefix of the names that it makes: name/body, name/interaction."},
                   {"on", body_ref(), false, "the world", "",
                    "Body whose frame the template's frame starts from, velocity included."},
                   {"position", vector3("a position"), false, "[0, 0, 0]", "m",
                    "Position of the template's frame."},
                   {"orientation", quaternion(), false, "[1, 0, 0, 0]", "1",
                    "Orientation of the template's frame."},
                   {"euler_deg", angles(), false, "", "deg",
                    "Angles of the template's frame: [roll, pitch, yaw]."},
                   {"parameters", map("parameters by name", parameter()), false, "of the template",
                    "", "Values in place of the defaults."},
                   {"bind", map("body names by local name", body_ref()), false, "", "",
                    "Local names that stand for bodies outside."}},
                  {{"orientation", "euler_deg"}});
}

namespace {

/// Add the lists that scenes and templates have in common.
void add_lists(std::vector<Field>& fields, const Format& format, bool placeholders) {
    const std::span<const ListFormat> lists = list_formats();
    for (std::size_t i = 0; i < lists.size(); ++i)
        fields.push_back({lists[i].key,
                          placeholders ? with_placeholders(format.lists[i]) : format.lists[i],
                          false, "", "", lists[i].doc});
}

ShapePtr scene_template(const Format& format) {
    std::vector<Field> fields{{"description", text("a text"), false, "", "", "Remarks."},
                              {"parameters", map("parameters by name", parameter()), false, "", "",
                               "Names and defaults of what \"${name}\" stands for."}};
    add_lists(fields, format, true);
    return object("template", "a template", "A reusable group of bodies, such as a crane.",
                  std::move(fields));
}

std::vector<Field> state_fields() {
    const ShapePtr pose = object(
        "state_body", "the state of a body", "Pose and velocity of one body.",
        {{"p", vector3("a position"), true, "", "m", "Position."},
         {"q", quaternion(), false, "[1, 0, 0, 0]", "1", "Orientation [w, x, y, z]."},
         {"v", vector3("a velocity"), false, "[0, 0, 0]", "m/s", "Velocity."},
         {"w", vector3("an angular velocity"), false, "[0, 0, 0]", "rad/s", "Angular velocity."}});
    return {
        {"bodies", map("body states by name", pose), false, "", "", "Every moving body."},
        {"time", number("a time", 0.0, 1e12), false, "", "s", "Time at which the state was taken."},
        {"scene", text("a name"), false, "", "", "Scene it belongs to."},
        {"description", text("a text"), false, "", "", "Remarks."}};
}

/// Return the fields that scenes and included files have in common.
std::vector<Field> common_fields(const ShapePtr& line, const ShapePtr& group) {
    return {{"$schema", text("a text"), false, "", "", "For editors."},
            {"version", integer("the version 1 or 2", 1, kFormatVersion), true, "", "",
             "Version of the format. 2: the key \"winch\" of a cable feeds elements; 1: it keeps "
             "one element, down to 2 % of its length."},
            {"description", text("a text"), false, "", "", "Remarks."},
            {"include", list("a list of file names", text("a file name"), 0, 64), false, "", "",
             "Files with line types, materials and templates, relative to this one."},
            {"line_types", map("line types by name", line), false, "", "", "Line types."},
            {"materials", map("materials by name", material()), false, "", "",
             "Materials of shapes. \"default\" has all the defaults and is always there."},
            {"templates", map("templates by name", group), false, "", "", "Templates."}};
}

ShapePtr plot_shape() {
    return object(
        "plot", "a plot", "Settings of pictures of the scene.",
        {{"tensions", list_of("a list of cables", text("a cable name")), false, "", "",
          "Cables with a curve of tension."},
         {"motions", list_of("a list of bodies", body_ref()), false, "", "",
          "Bodies with a curve of motion."},
         {"view_box", list("six numbers [x, y, z, x, y, z]", number("a number", -1e9, 1e9), 6, 6),
          false, "", "m", "Lower and upper corner of what is shown."},
         {"light", word("a light", {"day", "dusk", "night"}), false, "day", "",
          "Light of the page's pictures; at night ships show their lights."},
         {"visibility", number("a distance", 50.0, 1e5), false, "clear air", "m",
          "Distance at which objects vanish in haze or fog, in the page."},
         {"sun_azimuth_deg", number("an angle", -360.0, 360.0), false, "-42 (south-east)", "deg",
          "Direction to the sun, from x (east) towards y (north), in the page."},
         {"sun_elevation_deg", number("an angle", 0.0, 90.0), false, "by the light", "deg",
          "Height of the sun, or of the moon at night, in the page."}});
}

/// Return the parts of a scene that no template has.
std::vector<Field> parts_of_scene(const Format& f) {
    return {{"sea", sea_shape(), false, "air", "", "Water and wind."},
            {"timeline", f.operations, false, "", "", "Operations on the scene at given times."},
            {"repeat",
             object("repeat", "a repetition", "How copies of the scene stand side by side.",
                    {{"offset", vector3("an offset"), true, "", "m",
                      "Offset from one copy to the next."},
                     {"joins", f.list("cables"), false, "", "",
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
            {"plot", plot_shape(), false, "", "", "Pictures."}};
}

ShapePtr scene_file(const Format& f, std::vector<Field> fields) {
    const ShapePtr number_or_rows = number("a number", 0.0, 1e12);
    const std::vector<Field> more{
        {"name", name("a name"), true, "", "", "Name of the scene."},
        {"settings", settings_shape(), false, "", "", "Settings."},
        {"defaults",
         object("defaults", "defaults", "For constraint interactions that give none.",
                {{"compliance", number_or_rows, false, "of the kind", "m/N or rad/(N m)",
                  "Compliance of all rows. Joints and `distance` have 0, ranges and `hold` 1e-12."},
                 {"damping_time", number_or_rows, false, "two steps", "s",
                  "Damping time of all rows."}}),
         false, "", "", "Defaults of constraints."},
        {"material_pairs", list_of("a list of material pairs", material_pair()), false, "", "",
         "How two given materials touch, in place of the mixing rules."}};
    fields.insert(fields.end(), more.begin(), more.end());
    add_lists(fields, f, false);
    for (Field& part : parts_of_scene(f)) fields.push_back(std::move(part));
    return object("scene", "a scene", "A scene file.", std::move(fields));
}

Format make_format() {
    Format f;
    f.line_type = line_type_shape();
    f.operations = list_of("a list of operations", operation_shape());
    for (const ListFormat& each : list_formats())
        f.lists.push_back(list_of(std::string("a list of ") + each.entries, each.shape()));
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

std::span<const ListFormat> list_formats() {
    static constexpr ListFormat kFormats[] = {
#define HAWSER_LIST_FORMAT(key, item, entries, doc) {#key, entries, doc, item##_shape},
        HAWSER_SCENE_LISTS(HAWSER_LIST_FORMAT) HAWSER_SCENE_SECTIONS(HAWSER_LIST_FORMAT)
#undef HAWSER_LIST_FORMAT
    };
    return kFormats;
}

const ShapePtr& Format::list(std::string_view key) const {
    const std::span<const ListFormat> all = list_formats();
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const ListFormat& each) { return key == each.key; });
    return lists.at(static_cast<std::size_t>(at - all.begin()));
}

const Format& format() {
    static const Format instance = make_format();
    return instance;
}

const std::set<std::string>& outermost_keys() {
    static const std::set<std::string> keys = [] {
        std::set<std::string> out;
        for (const ShapePtr& shape : {format().scene, format().part, format().state})
            for (const Field& field : shape->fields) out.insert(field.name);
        return out;
    }();
    return keys;
}

}  // namespace hawser::scene
