// SPDX-License-Identifier: Apache-2.0
// Shapes, materials and collision groups of scenes.
#include "good_scenes.h"
#include "support.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace hawser::scene::test {
namespace {

const ShapeDef& shape(const Description& d, const std::string& name) {
    for (const ShapeDef& s : d.shapes) {
        if (s.name == name) {
            return s;
        }
    }
    ADD_FAILURE() << "no shape " << name;
    return d.shapes.front();
}

TEST(SceneShapes, become_definitions) {
    const Description d = flat(kTouching);
    EXPECT_EQ(d.settings.contact_margin, 0.03);
    ASSERT_EQ(d.materials.size(), 2U);  // in the order of their names
    EXPECT_EQ(d.materials[0].name, "mud");
    EXPECT_EQ(d.materials[1].friction, 0.2);
    EXPECT_EQ(d.materials[1].rolling, 1e-3);
    EXPECT_TRUE(std::isnan(d.materials[0].damping_time));
    ASSERT_EQ(d.material_pairs.size(), 2U);
    EXPECT_EQ(d.material_pairs[0].a.index, 2);
    EXPECT_EQ(d.material_pairs[0].b.index, 1);
    EXPECT_EQ(d.material_pairs[0].values.stiffness, 5e5);
    EXPECT_EQ(d.material_pairs[1].b.index, 0);
    const ShapeDef& deck = shape(d, "ship/deck");
    EXPECT_EQ(deck.kind, ShapeKind::box);
    EXPECT_EQ(deck.material.index, 2);
    EXPECT_EQ(deck.half_size, Vec3(40, 9, 0.5));
    EXPECT_EQ(deck.touches, ~0U);
    const ShapeDef& roller = shape(d, "ship/roller");
    EXPECT_EQ(roller.half_length, 3.0);
    EXPECT_NEAR((roller.orientation * Vec3::UnitZ() - Vec3::UnitY()).norm(), 0.0, 1e-15);
    EXPECT_EQ(roller.group, deck.group);
    EXPECT_EQ(std::popcount(deck.group), 2);
    EXPECT_EQ(shape(d, "two/b/s").half_size.x(), 2.5);
    EXPECT_EQ(shape(d, "two/b/s").material.index, 1);
    EXPECT_EQ(shape(d, "one/b/s").material.index, 2);
}

/// A cylinder of 0.2 m against the faces +x and −z of a box of 12 by 8 by 4 m.
TEST(SceneShapes, posts_lie_in_the_edges_of_boxes) {
    const Description d = flat(R"({
      "version": 1, "name": "quay", "settings": {"step": 0.01, "duration": 1},
      "bodies": [{"name": "quay", "kind": "fixed", "box": [6, 4, 2]},
                 {"name": "load", "mass": 1, "box": [1, 1, 1]}],
      "posts": [{"name": "rim", "on": "quay", "edge": [1, 0, -1], "radius": 0.2}]})");
    const ShapeDef& rim = shape(d, "rim");
    EXPECT_EQ(rim.kind, ShapeKind::cylinder);
    EXPECT_NEAR((rim.position - Vec3(5.8, 0.0, -1.8)).norm(), 0.0, 1e-15);
    EXPECT_EQ(rim.half_length, 4.0);
    EXPECT_NEAR(std::abs((rim.orientation * Vec3::UnitZ()).y()), 1.0, 1e-15);
}

/// A wedge and a box on one body: an edge by two points near it, and all sharp edges.
const std::string kWedge = R"({
  "version": 1, "name": "quay", "settings": {"step": 0.01, "duration": 1},
  "bodies": [
    {"name": "quay", "kind": "fixed", "position": [0, 0, 0], "shapes": [
      {"name": "bow", "kind": "hull", "vertices": [[-1, -2, 0], [1, -2, 0], [0, -2, 1], [-1, 2, 0], [1, 2, 0], [0, 2, 1]]},
      {"name": "house", "kind": "box", "half_size": [1, 1, 1], "position": [5, 0, 0]},
      {"name": "ball", "kind": "sphere", "radius": 1, "position": [-5, 0, 0]}]},
    {"name": "load", "mass": 1, "box": [1, 1, 1]}],
  "posts": [{"name": "ridge", "on": "quay", "radius": 0.1, "slides": true,
             "edge_of": {"shape": "bow", "near": [[0.05, -1, 1], [0, 1.5, 1.1]]}},
            {"name": "sharp", "on": "quay", "radius": 0.05,
             "edge_of": {"shape": "bow", "sharper_than": 2}}]})";

TEST(SceneShapes, posts_lie_in_edges_of_hulls) {
    const Description d = flat(kWedge);
    ASSERT_EQ(d.posts.size(), 3U);
    EXPECT_TRUE(d.posts[0].def.slides);
    EXPECT_FALSE(d.posts[1].def.slides);
    EXPECT_EQ(d.posts[2].def.name, "sharp/2");
    // Slopes of 45 degrees: the axis is below the ridge by the radius and the corner's additional
    // distance.
    const ShapeDef& ridge = shape(d, "ridge");
    EXPECT_NEAR((ridge.position - Vec3(0, 0, 1.0 - 0.1 * std::sqrt(2.0))).norm(), 0.0, 1e-12);
    EXPECT_NEAR(ridge.half_length, 2.0, 1e-12);
    const ShapeDef& eave = shape(d, "sharp/1");
    EXPECT_NEAR(std::abs(eave.position.x()), 1.0 - 0.05 / std::tan(0.125 * 3.14159265358979), 1e-9);
    EXPECT_NEAR(eave.position.z(), 0.05, 1e-9);
}

TEST(SceneShapes, edges_that_are_not_there_are_refused) {
    const auto refusal = [](const std::string& value) -> std::string {
        try {
            (void)flat(patched(
                kWedge, R"([{"op":"replace","path":"/posts/0/edge_of","value":)" + value + "}]"));
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    struct Row {
        const char *value, *path, *says;
    };
    for (const Row& row :
         {Row{R"({"shape": "bew", "sharper_than": 1})", "/posts/0/edge_of/shape", "\"bow\"?"},
          {R"({"shape": "ball", "sharper_than": 1})", "/posts/0/edge_of/shape", "no edges"},
          {R"({"sharper_than": 1})", "/posts/0/edge_of", "several shapes"},
          {R"({"shape": "bow"})", "/posts/0/edge_of", "either two points"},
          {R"({"shape": "bow", "near": [[0, 0, 1], [0, 1, 1]], "sharper_than": 1})",
           "/posts/0/edge_of", "either two points"},
          {R"({"shape": "bow", "sharper_than": 3})", "/posts/0/edge_of/sharper_than", "so sharp"},
          {R"({"shape": "bow", "near": [[0, 0, 1], [0, 0, 1]]})", "/posts/0/edge_of/near",
           "two different points"},
          {R"({"shape": "bow", "near": [[0, -1, 3], [0, 1, 3]]})", "/posts/0/edge_of/near",
           "goes from"},
          {R"({"shape": "house", "near": [[4, -1, 3], [4, 1, 3]]})", "/posts/0/edge_of/near",
           "goes from"}}) {
        const std::string said = refusal(row.value);
        EXPECT_NE(said.find(row.path), std::string::npos) << said;
        EXPECT_NE(said.find(row.says), std::string::npos) << said;
    }
    EXPECT_EQ(refusal(R"({"shape": "house", "near": [[4, -1, 1], [4, 1, 1]]})"), "");
}

TEST(SceneShapes, cables_get_segments_between_lumps) {
    const Description d = flat(kTouching);
    // The element at the ship ends on a rigid body and has none; the last one ends on a fixed body.
    int segments = 0, links = 0;
    for (const ShapeDef& s : d.shapes) {
        segments += s.name.starts_with("tow/c") ? 1 : 0;
        links += s.name.starts_with("links/c") ? 1 : 0;
    }
    EXPECT_EQ(segments, 7);
    EXPECT_EQ(links, 4);
    const ShapeDef& first = shape(d, "tow/c1");
    EXPECT_EQ(d.body(first.body).name, "tow/1");
    EXPECT_EQ(d.body(first.body_b).name, "tow/2");
    EXPECT_EQ(first.radius, 0.04);
    EXPECT_EQ(std::popcount(first.touches), 3);
    EXPECT_NE(first.touches & first.group, 0U);
    EXPECT_NE(first.touches & shape(d, "ship/deck").group, 0U);
    EXPECT_EQ(first.touches & 1U, 0U);
    const ShapeDef& link = shape(d, "links/c2");
    EXPECT_FALSE(link.body_b.valid());
    EXPECT_EQ(link.half_length, 5.0);
    EXPECT_NEAR((link.orientation * Vec3::UnitZ() - Vec3::UnitX()).norm(), 0.0, 1e-15);
}

TEST(SceneShapes, segments_between_lumps_of_ones_own) {
    const Description d = flat(kTouching);
    const ShapeDef& stay = shape(d, "buoy/stay");
    EXPECT_EQ(stay.kind, ShapeKind::capsule);
    EXPECT_EQ(d.body(stay.body).name, "buoy");
    EXPECT_EQ(d.body(stay.body_b).name, "weight");  // defined after the buoy
    EXPECT_EQ(stay.radius, 0.03);
    EXPECT_EQ(stay.group, shape(d, "tow/c1").group);
    const ShapeDef& copy = shape(d, "1:buoy/stay");
    EXPECT_EQ(d.body(copy.body).name, "1:buoy");
    EXPECT_EQ(d.body(copy.body_b).name, "1:weight");
    // Nodes of cables, bodies of instances, and the world are bodies too.
    for (const char* other : {"tow/3", "quay", "world"}) {
        const Description more =
            flat(patched(kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/to","value":")" +
                                        std::string(other) + R"("}])"));
        EXPECT_EQ(more.body(shape(more, "buoy/stay").body_b).name, other);
    }
}

TEST(SceneShapes, a_segment_of_ones_own_carries) {
    // A ball dropped on a strut between two fixed ends, with a point mass in the middle, stays on
    // it. Without the segments it would fall past the point mass.
    Scene scene = load_text(R"({"version": 1, "name": "s", "settings": {"step": 0.005},
      "bodies": [
        {"name": "left", "kind": "fixed", "position": [-1, 0, 0],
         "shapes": [{"kind": "segment", "to": "node", "radius": 0.1}]},
        {"name": "node", "kind": "lump", "position": [0, 0, 0], "mass": 10, "gravity": false},
        {"name": "ball", "position": [-0.5, 0, 0.31], "mass": 1, "sphere": 0.2,
         "shapes": [{"kind": "sphere", "radius": 0.2}]}],
      "interactions": [{"kind": "distance", "bodies": ["world", "node"], "points": [[5, 0, 0], [0, 0, 0]]},
        {"kind": "distance", "bodies": ["world", "node"], "points": [[0, 5, 0], [0, 0, 0]]},
        {"kind": "distance", "bodies": ["world", "node"], "points": [[0, 0, 5], [0, 0, 0]]}]})",
                            "strut.json");
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
    }
    const Vec3 ball = scene.world.pose(scene.world.find_body("ball")).position;
    // On top of it, less the deformation of the contact (9.81 N on 1e8 N/m) and of the rods.
    EXPECT_NEAR(ball.z(), 0.3, 1e-4);
    ASSERT_EQ(scene.world.contacts().size(), 1U);
    EXPECT_NEAR(scene.world.contacts().front().force.norm(), 9.81, 1e-3);
}

TEST(SceneShapes, copies_have_shapes_but_one_seabed) {
    const Description d = flat(kTouching);
    EXPECT_EQ(d.body(shape(d, "1:ship/deck").body).name, "1:ship");
    EXPECT_EQ(d.body(shape(d, "1:tow/c1").body_b).name, "1:tow/2");
    EXPECT_EQ(shape(d, "1:ship/deck").material.index, 2);
    (void)shape(d, "join/c1");
    int planes = 0;
    for (const ShapeDef& s : d.shapes) {
        planes += s.kind == ShapeKind::plane ? 1 : 0;
    }
    EXPECT_EQ(planes, 1);
    // If tilted, each copy is a plane of its own.
    const Description tilted = flat(patched(
        kTouching, R"([{"op":"replace","path":"/bodies/0/shapes/0/normal","value":[0, 0.1, 1]}])"));
    EXPECT_EQ(tilted.shapes.size(), d.shapes.size() + 1);
}

TEST(SceneShapes, become_a_world) {
    Scene scene = load_text(kTouching, "test.json");
    const Description d = flat(kTouching);
    EXPECT_EQ(scene.world.shape_count(), static_cast<int>(d.shapes.size()));
    EXPECT_EQ(scene.world.settings().contact_margin, 0.03);
    const ShapeId deck = scene.world.find_shape("1:ship/deck");
    ASSERT_TRUE(deck.valid());
    const ShapeDef& def = scene.world.shape_def(deck);
    EXPECT_EQ(scene.world.material_def(def.material).name, "steel");
    EXPECT_EQ(scene.world.body_def(def.body).name, "1:ship");
    ASSERT_EQ(scene.world.step(), Status::ok);
    EXPECT_GT(scene.world.contacts().size(), 0U);
    const Scene again = load_text(scene.text, "again.json");
    EXPECT_EQ(again.world.shape_count(), scene.world.shape_count());
}

TEST(SceneShapes, options_reach_them) {
    Options options;
    options.set = {"bodies.ship.shapes.roller.radius=1.5", "materials.mud.friction=0.9"};
    const Description d = flat(kTouching, options);
    EXPECT_EQ(shape(d, "ship/roller").radius, 1.5);
    EXPECT_EQ(d.materials[0].friction, 0.9);
}

TEST(SceneShapes, materials_may_come_from_included_files) {
    const TempFolder folder;
    folder.write("parts/stuff.json", R"({"version": 1, "materials": {"ice": {"friction": 0.02}}})");
    const auto file = folder.write("s.json", R"({
      "version": 1, "name": "s", "include": ["parts/stuff.json"],
      "bodies": [{"name": "b", "mass": 1, "sphere": 1,
                  "shapes": [{"kind": "sphere", "radius": 1, "material": "ice"}]}]})");
    const Scene scene = load_file(file);
    EXPECT_EQ(scene.world.material_def(scene.world.find_material("ice")).friction, 0.02);
}

constexpr std::string_view kGround = R"({"version": 1, "name": "g", "bodies": [
  {"name": "m", "kind": "lump", "mass": 1},
  {"name": "g", "kind": "fixed", "shapes": [
    {"kind": "heightfield", "name": "h", "rows": 3, "columns": 4, "cell": [2, 1],
     "heights": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]},
    {"kind": "heightfield", "name": "f", "rows": 3, "columns": 5, "cell": [1, 0.5],
     "ground": {"slope": [0.1, -0.2], "height": 2, "length": [4, 2]}},
    {"kind": "heightfield", "name": "flat", "rows": 2, "columns": 2, "cell": [1, 1]},
    {"kind": "hull", "name": "t",
     "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]},
    {"kind": "mesh", "name": "m", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
     "triangles": [[0, 1, 2]]}]}]})";

TEST(SceneShapes, ground_by_heights_or_by_a_function) {
    const Description d = flat(kGround);
    const ShapeDef& h = shape(d, "g/h");
    EXPECT_EQ(h.rows, 3);
    EXPECT_EQ(h.columns, 4);
    EXPECT_EQ(h.heights[4], 4.0);
    const ShapeDef& f = shape(d, "g/f");
    ASSERT_EQ(f.heights.size(), 15U);
    // Row 2, column 3: x = 1, y = 0.5; a quarter of both wave lengths.
    EXPECT_NEAR(f.heights[13],
                0.1 - 0.1 + 2.0 * std::cos(std::numbers::pi / 2) * std::cos(std::numbers::pi / 2),
                1e-15);
    EXPECT_NEAR(f.heights[7], 2.0, 1e-15);
    for (const double z : shape(d, "g/flat").heights) {
        EXPECT_EQ(z, 0.0);
    }
    EXPECT_EQ(shape(d, "g/t").vertices.size(), 4U);
    EXPECT_EQ(shape(d, "g/m").triangles[0][2], 2);
}

struct Wrong {
    std::string_view scene, patch, path, words;
};

// clang-format off
constexpr Wrong kWrong[] = {
{kTouching, R"([{"op":"replace","path":"/bodies/1/shapes/0/material","value":"stel"}])", "/bodies/1/shapes/0/material", "did you mean \"steel\""},
{kTouching, R"([{"op":"replace","path":"/cables/0/contact/material","value":"x"}])", "/cables/0/contact/material", "no material"},
{kTouching, R"([{"op":"replace","path":"/material_pairs/0/between/1","value":"md"}])", "/material_pairs/0/between/1", "did you mean \"mud\""},
{kTouching, R"([{"op":"replace","path":"/material_pairs/1/between","value":["mud","steel"]}])", "/material_pairs/1", "already"},
{kTouching, R"([{"op":"add","path":"/materials/default","value":{}}])", "/materials/default", "always there"},
{kTouching, R"([{"op":"add","path":"/materials/a b","value":{}}])", "/materials/a b", "letters"},
{kTouching, R"([{"op":"replace","path":"/materials/mud/friction","value":-1}])", "/materials/mud/friction", "at least 0"},
{kTouching, R"([{"op":"add","path":"/materials/mud/frction","value":1}])", "/materials/mud/frction", "did you mean \"friction\""},
{kTouching, R"([{"op":"replace","path":"/cables/0/contact/touches","value":["dck"]}])", "/cables/0/contact/touches/0", "did you mean \"deck\""},
{kTouching, R"([{"op":"replace","path":"/cables/0/contact/groups","value":"two words"}])", "/cables/0/contact/groups", "group name"},
{kTouching, R"([{"op":"replace","path":"/bodies/1/shapes/1/kind","value":"cilinder"}])", "/bodies/1/shapes/1/kind", "did you mean \"cylinder\""},
{kTouching, R"([{"op":"remove","path":"/bodies/1/shapes/1/radius"}])", "/bodies/1/shapes/1", "radius"},
{kTouching, R"([{"op":"replace","path":"/bodies/1/shapes/1/name","value":"deck"}])", "/bodies/1/shapes/1/name", "already"},
{kTouching, R"([{"op":"add","path":"/bodies/1/shapes/1/half_size","value":[1,1,1]}])", "/bodies/1/shapes/1/half_size", "has no key"},
{kTouching, R"([{"op":"replace","path":"/bodies/0/shapes/0/normal","value":[0,0,0]}])", "/bodies/0/shapes/0/normal", "zero"},
{kTouching, R"([{"op":"add","path":"/bodies/0/shapes/0/euler_deg","value":[0,0,1]}])", "/bodies/0/shapes/0", "normal"},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/0","value":{"kind":"box","half_size":[1,1,1]}}])", "/bodies/3/shapes/0", "orientation"},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/to","value":"wieght"}])", "/bodies/3/shapes/1/to", "did you mean \"weight\""},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/to","value":"buoy"}])", "/bodies/3/shapes/1/to", "two different"},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/to","value":"ship"}])", "/bodies/3/shapes/1/to", "neither a lump nor fixed"},
{kTouching, R"([{"op":"add","path":"/bodies/1/shapes/-","value":{"kind":"segment","to":"buoy","radius":1}}])", "/bodies/1/shapes/4/kind", "neither a lump nor fixed"},
{kTouching, R"([{"op":"add","path":"/bodies/0/shapes/-","value":{"kind":"segment","to":"quay","radius":1}}])", "/bodies/0/shapes/1/to", "must be a lump"},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/to","value":["buoy"]}])", "/bodies/3/shapes/1/to", "a body name"},
{kTouching, R"([{"op":"remove","path":"/bodies/3/shapes/1/to"}])", "/bodies/3/shapes/1", "\"to\""},
{kTouching, R"([{"op":"remove","path":"/bodies/3/shapes/2/radius"}])", "/bodies/3/shapes/2", "radius"},
{kTouching, R"([{"op":"add","path":"/bodies/3/shapes/1/length","value":1}])", "/bodies/3/shapes/1/length", "has no key"},
{kTouching, R"([{"op":"add","path":"/bodies/3/shapes/1/position","value":[0,0,0]}])", "/bodies/3/shapes/1/position", "has no key"},
{kTouching, R"([{"op":"add","path":"/bodies/3/shapes/2/name","value":"stay"}])", "/bodies/3/shapes/2/name", "already"},
{kTouching, R"([{"op":"replace","path":"/bodies/3/shapes/1/groups","value":"a b"}])", "/bodies/3/shapes/1/groups", "group name"},
{kTouching, R"([{"op":"replace","path":"/settings/contact_margin","value":0}])", "/settings/contact_margin", "at least"},
{kTouching, R"([{"op":"remove","path":"/line_types/wire/diameter"},{"op":"add","path":"/cables/1/radius","value":0.1}])", "/cables/0/contact", "radius"},
{kGround, R"([{"op":"replace","path":"/bodies/1/shapes/0/rows","value":4}])", "/bodies/1/shapes/0/heights", "expected 16 heights"},
{kGround, R"([{"op":"replace","path":"/bodies/1/shapes/0/rows","value":1}])", "/bodies/1/shapes/0/rows", "at least 2"},
{kGround, R"([{"op":"replace","path":"/bodies/1/shapes/2/rows","value":60000},{"op":"replace","path":"/bodies/1/shapes/2/columns","value":60000}])", "/bodies/1/shapes/2", "more than"},
{kGround, R"([{"op":"remove","path":"/bodies/1/shapes/1/ground/length"}])", "/bodies/1/shapes/1/ground", "length"},
{kGround, R"([{"op":"replace","path":"/bodies/1/shapes/4/triangles/0/1","value":3}])", "/bodies/1/shapes/4/triangles/0/1", "no vertex 3"},
{kGround, R"([{"op":"remove","path":"/bodies/1/shapes/3/vertices/0"}])", "/bodies/1/shapes/3/vertices", "4 to 4096"},
};
// clang-format on

TEST(SceneShapes, mistakes_are_refused_where_they_are) {
    for (const Wrong& wrong : kWrong) {
        try {
            (void)load_text(patched(wrong.scene, wrong.patch), "test.json");
            ADD_FAILURE() << "accepted: " << wrong.patch;
        } catch (const SceneError& error) {
            EXPECT_EQ(error.path, wrong.path) << wrong.patch << "\n" << error.what();
            EXPECT_NE(error.message.find(wrong.words), std::string::npos) << wrong.patch << "\n"
                                                                          << error.what();
        }
    }
}

TEST(SceneShapes, no_more_than_32_groups) {
    std::string groups;
    for (int i = 0; i < 31; ++i) {
        groups += (i == 0 ? "\"g" : ", \"g") + std::to_string(i) + "\"";
    }
    const auto scene = [&](const std::string& more) {
        return R"({"version": 1, "name": "s", "bodies": [{"name": "b", "kind": "lump", "mass": 1,
          "shapes": [{"kind": "sphere", "radius": 1, "groups": [)" +
               groups + R"(]}]}, {"name": "c", "kind": "lump", "mass": 1, "shapes":
          [{"kind": "sphere", "radius": 1, "groups": ")" +
               more + R"("}]}]})";
    };
    EXPECT_EQ(refusal(scene("g30")), "");
    EXPECT_NE(refusal(scene("one_more")).find("32 groups"), std::string::npos);
}

}  // namespace
}  // namespace hawser::scene::test
