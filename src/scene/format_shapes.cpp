// SPDX-License-Identifier: Apache-2.0
#include <hawser/material_fields.h>

#include "scene/field_shapes.h"
#include "scene/format.h"

#include <utility>

namespace hawser::scene {
namespace {

using namespace make;

constexpr double kMaxShapeLength = 1e6;
constexpr std::size_t kMostHull = 4096;  ///< Vertices of a hull.
constexpr std::size_t kMostPoints =
    1'000'000;  ///< Largest number of points of a mesh or heightfield.

ShapePtr group_names(const char* what) {
    const ShapePtr one = name("a group name");
    return choice(what, {one, list("a list of group names", one, 1, kMaxGroups)});
}

}  // namespace

std::vector<Field> surface_fields() {
    return {{"material", text("a material name"), false, "default", "", "Material, by name."},
            {"groups", group_names("a group name or a list of them"), false, "default", "",
             "Collision groups that it is in; 32 in all."},
            {"touches", group_names("a group name or a list of them"), false, "every group", "",
             "Groups that it touches. Two shapes touch when each touches a group of the other."}};
}

namespace {

std::vector<Field> values_of_material() {
    std::vector<Field> fields;
    add_fields(fields, kMaterialFields);
    fields.push_back({"description", text("a text"), false, "", "", "Source and remarks."});
    return fields;
}

ShapePtr length(const char* what) { return positive(what, kMaxShapeLength); }
ShapePtr axis() { return word("an axis", {"x", "y", "z"}); }

/// Return the schema of one kind of collision shape. `fields` are added to the common fields.
std::pair<std::string, ShapePtr> shape_kind(const std::string& kind, const std::string& what,
                                            const std::string& doc, std::vector<Field> fields,
                                            bool turns = true, bool placed = true) {
    std::vector<std::vector<std::string>> alternatives;
    std::vector<Field> all{
        {"kind", literal(word("the kind", {kind})), true, "", "", "The kind."},
        {"name", name("a name"), false, "", "",
         "Unique among the shapes of its body; NAME of body B is the shape B/NAME."}};
    if (placed) {
        all.push_back({"position", vector3("a position"), false, "[0, 0, 0]", "m",
                       "Position of the shape's frame in the body's frame."});
    }
    if (turns) {
        all.push_back({"orientation",
                       list("an orientation [w, x, y, z]", number("a number", -1e6, 1e6), 4, 4),
                       false, "[1, 0, 0, 0]", "1",
                       "Orientation of the shape's frame in the body's frame."});
        all.push_back({"euler_deg",
                       list("three angles [roll, pitch, yaw] in degrees",
                            number("an angle", -36000, 36000), 3, 3),
                       false, "", "deg", "The same as angles about x, then y, then z."});
        alternatives.push_back({"orientation", "euler_deg"});
        if (kind == "plane") alternatives.back().emplace_back("normal");
    }
    all.insert(all.end(), fields.begin(), fields.end());
    const auto surface = surface_fields();
    all.insert(all.end(), surface.begin(), surface.end());
    all.push_back({"description", text("a text"), false, "", "", "Remarks."});
    return {kind, object("shape_" + kind, what, doc, std::move(all), std::move(alternatives))};
}

std::vector<Field> along_axis(const char* what) {
    return {{"radius", length("a length"), true, "", "m", "Radius."},
            {"length", length("a length"), true, "", "m", what},
            {"axis", axis(), false, "x", "", "Axis of the shape's frame along its length."}};
}

ShapePtr ground() {
    return object(
        "ground", "a ground", "Heights as a function of x and y in the shape's frame.",
        {{"slope", list("two slopes", number("a slope", -100.0, 100.0), 2, 2), false, "[0, 0]", "1",
          "Rise along x and along y."},
         {"height", number("a height", -1e5, 1e5), false, "0", "m", "Height of the waves …"},
         {"length", list("two wave lengths", length("a length"), 2, 2), false, "", "m",
          "… of these lengths along x and y: height cos(2 pi x/Lx) cos(2 pi y/Ly) is added."}});
}

std::vector<Field> heightfield() {
    return {{"rows", integer("a number of rows", 2, 65536), true, "", "", "Nodes along y."},
            {"columns", integer("a number of columns", 2, 65536), true, "", "", "Nodes along x."},
            {"cell", list("two lengths", length("a length"), 2, 2), true, "", "m",
             "Distance of nodes along x and along y. The field is centred on the shape's frame."},
            {"heights", list("a list of heights", number("a height", -1e5, 1e5), 4, kMostPoints),
             false, "", "m", "Row by row, each along x; the solid is below."},
            {"ground", ground(), false, "flat", "", "Alternative to heights."}};
}

std::vector<Field> vertices(const char* what, std::size_t least, std::size_t most) {
    return {{"vertices", list(what, vector3("a point"), least, most), true, "", "m",
             "Vertices in the shape's frame."}};
}

std::vector<Field> mesh() {
    auto fields = vertices("a list of points", 3, kMostPoints);
    const ShapePtr corner = integer("an index of a vertex", 0, static_cast<double>(kMostPoints));
    fields.push_back(
        {"triangles",
         list("a list of triangles", list("three indices", corner, 3, 3), 1, kMostPoints), true, "",
         "", "Three indices of vertices each, from 0."});
    return fields;
}

}  // namespace

ShapePtr material() {
    return object("material", "a material",
                  "Surface properties of shapes. If two materials have no pair, these rules apply: "
                  "geometric means of friction, rolling and torsional resistance; the larger "
                  "restitution and damping time; both stiffnesses in series.",
                  values_of_material());
}

ShapePtr material_pair() {
    std::vector<Field> fields{{"between", list("two material names", text("a material name"), 2, 2),
                               true, "", "", "The two bodies; they may be the same one."}};
    const auto values = values_of_material();
    fields.insert(fields.end(), values.begin(), values.end());
    return object("material_pair", "a material pair",
                  "Properties of the contact of two materials. Omitted values are the defaults of "
                  "a material.",
                  std::move(fields));
}

ShapePtr cable_contact() {
    std::vector<Field> fields{
        {"radius", positive("a length", 1e3), false, "half the diameter; of links their radius",
         "m", "Radius of the capsules along its elements."},
        {"to_ends", boolean("true or false"), false, "false", "",
         "Also of elements that end on a body: up to its point, drum or "
         "fairlead, and up to guides and posts. Not of links."}};
    const auto surface = surface_fields();
    fields.insert(fields.end(), surface.begin(), surface.end());
    return object("contact", "a contact", "How a cable touches.", std::move(fields));
}

ShapePtr shape_of_body() {
    auto shape = std::make_shared<Shape>();
    shape->type = Shape::Type::switched;
    shape->id = "shape";
    shape->what = "a shape";
    shape->doc = "Shape of a body for contacts; \"kind\" selects its geometry.";
    shape->key = "kind";
    shape->cases = {
        shape_kind("sphere", "a sphere", "A ball.",
                   {{"radius", length("a length"), true, "", "m", "Radius."}}, false),
        shape_kind("capsule", "a capsule", "A cylinder with half balls at its ends.",
                   along_axis("Between the centres of the half balls.")),
        shape_kind("segment", "a segment",
                   "A capsule from this node to another one, such as an element of a line. One of "
                   "the two may be a fixed body, whose centre is then the end.",
                   {{"to", text("a body name"), true, "", "", "The other body."},
                    {"radius", length("a length"), true, "", "m", "Radius."}},
                   false, false),
        shape_kind(
            "box", "a box", "A box.",
            {{"half_size",
              list("three half sizes [x, y, z]", positive("a length", kMaxShapeLength), 3, 3), true,
              "", "m", "Half sizes."}}),
        shape_kind("cylinder", "a cylinder", "A cylinder with flat ends.",
                   along_axis("Between its ends.")),
        shape_kind("plane", "a plane", "A half-space: solid below the shape's x-y plane.",
                   {{"normal", vector3("a direction"), false, "[0, 0, 1]", "1",
                     "Direction out of the solid, in the body's frame."}}),
        shape_kind("heightfield", "a heightfield",
                   "Ground given by heights over the shape's x-y plane.", heightfield()),
        shape_kind("hull", "a hull", "The convex hull of points.",
                   vertices("a list of 4 to 4096 points", 4, kMostHull)),
        shape_kind("mesh", "a mesh",
                   "Triangles, both sides of which touch; only on a fixed or kinematic body.",
                   mesh())};
    return shape;
}

namespace {

ShapePtr edge_of_shape() {
    return object(
        "edge_of", "edges of a shape", "Convex edges of a shape. One of `near`, `sharper_than`.",
        {{"shape", text("a shape name"), false, "the only one with edges", "",
          "Name of a shape of the body: a box, hull or mesh."},
         {"near", list("two points", vector3("a point"), 2, 2), false, "", "m",
          "In the frame of the body: that edge which both lie at, to a tenth of the way between "
          "them."},
         {"sharper_than", number("an angle", 0.0, 3.14159), false, "", "rad",
          "All edges at which the normals of the faces turn by more: posts NAME/1, NAME/2, …, 64 "
          "at most."}});
}

}  // namespace

ShapePtr post_shape() {
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among posts; of its signals, name.held."},
        {"on", body_ref(), true, "", "", "Body that it belongs to."},
        {"from", vector3("a point"), false, "", "m",
         "Start of its axis, in the frame of the body; required without `edge` and `edge_of`."},
        {"to", vector3("a point"), false, "", "m",
         "End of its axis, in that frame; required without `edge` and `edge_of`."},
        {"edge", vector3("an edge"), false, "", "1",
         "Edge of the body's box, given by its two faces: [1, 0, 1] is the edge of +x and +z. The "
         "cylinder touches both faces from inside, as if the edge were rounded."},
        {"edge_of", edge_of_shape(), false, "", "",
         "Of a box, hull or mesh among the body's shapes: an edge, or all that are sharp."},
        {"slides", boolean("true or false"), false, "false", "",
         "True: cables slide along the axis if their pull exceeds friction. False: they keep their "
         "position along it."},
        {"radius", positive("a radius", 1e3), true, "", "m", "Radius of the cylinder."},
        {"friction", number("a coefficient", 0.0, 10.0), false, "0", "1",
         "Of cables that lie on it; while they only touch it, that of its material."},
        {"efficiency", number("an efficiency", 0.0, 1.0), false, "1", "1",
         "Efficiency of a roller: lesser tension over greater; above 0."},
        {"inertia", number("an inertia", 0.0, 1e12), false, "0", "kg m^2",
         "Moment of inertia of a roller that turns with the cable."},
        {"wires", integer("a number", 1, 16), false, "2", "1", "Cables that lie on it at once."},
        {"element", number("a length", 0.0, 1e6), false, "that of the cable", "m",
         "Of elements that come behind it; 0: no node runs through."},
        {"margin", number("a length", 0.0, 1e3), false, "1", "m",
         "Distance within which cables are checked in each step, so that no cable passes through "
         "it within a step."},
        {"description", text("a text"), false, "", "", "Remarks."}};
    const auto surface = surface_fields();
    fields.insert(fields.end(), surface.begin(), surface.end());
    return object(
        "post", "a post",
        "Turning point that cables engage and leave during the run: a pin, a bollard, a rail, the "
        "edge of a deck. It is a cylinder, which cables with \"contact\" detect.",
        std::move(fields));
}

}  // namespace hawser::scene
