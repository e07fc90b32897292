// SPDX-License-Identifier: Apache-2.0
// Templates, copies, includes, stored states and overrides.
#include "good_scenes.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::scene::test {
namespace {

TEST(Templates, stand_on_a_moving_body) {
    const Description d = flat(kSite);
    // The ship is rotated by 90° about z, and the template by 90° more, at (0, 5, 4) on it.
    const BodyDef& ship = body(d, "ship");
    const BodyDef& boom = body(d, "port/boom");
    const Vec3 origin = ship.position + ship.orientation * Vec3(0, 5, 4);
    const Quat turned(Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitZ()));
    EXPECT_TRUE(boom.position.isApprox(origin + turned * Vec3(12, 0, 5), 1e-12));
    EXPECT_LT(boom.orientation.angularDistance(turned), 1e-7);
    // It moves with the ship, including its rotation.
    EXPECT_TRUE(boom.velocity.isApprox(
        ship.velocity + ship.angular_velocity.cross(boom.position - ship.position), 1e-12));
    EXPECT_EQ(boom.angular_velocity, ship.angular_velocity);
    EXPECT_EQ(boom.mass, 15000.0);
    const InteractionDef& pivot = interaction(d, "port/pivot");
    EXPECT_EQ(pivot.body[0], d.find_body("ship"));
    EXPECT_TRUE(d.world_point(pivot.body[0], pivot.point[0])
                    .isApprox(origin + turned * Vec3(0, 0, 5), 1e-12));
    // The template in the template.
    EXPECT_EQ(body(d, "port/w/block").mass, 15000.0);
    EXPECT_EQ(interaction(d, "port/w/rod").body[0], d.find_body("port/tip"));
    EXPECT_TRUE(d.has_cable("port/hoist"));
}

TEST(Templates, texts_with_parameters) {
    const Json parameters = Json::parse(R"({"n": 3, "x": 0.5, "s": "ab", "v": [1, 2]})");
    const SourceLocation place{"f", ""};
    EXPECT_EQ(substitute("${n}", parameters, place), 3);
    EXPECT_EQ(substitute("${v}", parameters, place), Json::parse("[1, 2]"));
    EXPECT_EQ(substitute("a${n}b${s}", parameters, place), "a3bab");
    EXPECT_EQ(substitute(Json::parse(R"([{"k": "${x}"}])"), parameters, place),
              Json::parse(R"([{"k": 0.5}])"));
    EXPECT_EQ(substitute("$n {n}", parameters, place), "$n {n}");
}

TEST(Copies, repeat_everything_and_join) {
    Options options;
    const auto bodies = [&](int scale) {
        options.scale = scale;
        return flat(kSite, options).bodies.size();
    };
    // Each copy adds the same number; a join of 5 elements adds 4 nodes. The world exists once.
    const std::size_t step = bodies(4) - bodies(3);
    EXPECT_EQ(bodies(5) - bodies(4), step);
    options.scale = 3;
    const Description d = flat(kSite, options);
    EXPECT_TRUE(body(d, "2:rig").position.isApprox(Vec3(0, 3000, 0), 1e-12));
    EXPECT_EQ(body(d, "2:drum").position.x(), 0.5);  // a coordinate, not a position
    EXPECT_TRUE(body(d, "1:moor/0").position.isApprox(Vec3(-400, 1500, -100), 1e-12));
    EXPECT_TRUE(d.find_body("neighbour/1").valid());
    EXPECT_TRUE(d.find_body("1:neighbour/1").valid());
    EXPECT_FALSE(d.find_body("2:neighbour/1").valid());
    const InteractionDef& last = interaction(d, "1:neighbour/s4");
    EXPECT_EQ(last.body[1], d.find_body("2:rig"));
    EXPECT_TRUE(d.has_cable("1:port/hoist"));
    // A world point of a copy moves with it: the fixed end of its links, attached to the world.
    const InteractionDef& joint = interaction(d, "2:links/j4");
    EXPECT_EQ(joint.body[1], d.find_body("world"));
    EXPECT_TRUE(joint.point[1].isApprox(Vec3(0, 3135, 0), 1e-12));
    EXPECT_EQ(std::count_if(d.bodies.begin(), d.bodies.end(),
                            [](const BodyDef& b) { return b.name.ends_with("world"); }),
              1);
    // The largest number of copies.
    options.scale = 1000;
    EXPECT_EQ(flat(kSite, options).bodies.size(), d.bodies.size() + 997 * step);
    options.scale = 3;
    // The text contains the scale.
    const Document document = document_of(kSite, options);
    EXPECT_EQ(document.root["repeat"]["copies"], 3);
}

TEST(Includes, bring_line_types_and_templates) {
    const TempFolder folder;
    folder.write("parts/lines.json", R"({"version": 1, "include": ["more.json"],
        "line_types": {"rope": {"mass_per_length": 2, "EA": 1e6}}})");
    folder.write("parts/more.json", R"({"version": 1, "templates": {"ball": {
        "bodies": [{"name": "b", "mass": 1, "sphere": 1}]}}})");
    const auto file = folder.write("scene.json", R"({"version": 1, "name": "scene",
        "include": ["parts/lines.json", "parts/more.json"],
        "instances": [{"template": "ball", "name": "one"}],
        "cables": [{"name": "c", "line_type": "rope", "from": {"at": [0, 0, 9]},
                    "to": {"body": "one/b"}, "elements": 3}]})");
    const Scene scene = load_file(file);
    EXPECT_EQ(scene.world.body_count(), 4);  // the ball, two nodes, the fixed end
    // The text needs no other file.
    EXPECT_EQ(load_text(scene.text, "elsewhere.json").hash, scene.hash);

    const auto error_message = [&](const std::string& name) {
        try {
            (void)load_file(folder.path / name);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto scene_with = [&](const std::string& includes) {
        folder.write("s.json", R"({"version": 1, "name": "s", "include": [)" + includes + "]}");
        return error_message("s.json");
    };
    folder.write("cycle.json", R"({"version": 1, "include": ["cycle.json"]})");
    EXPECT_NE(scene_with("\"cycle.json\"").find("cycle.json: /include/0: the file"),
              std::string::npos);
    folder.write("bad.json", R"({"version": 1, "line_types": {"x": {"mass_per_length": -1}}})");
    EXPECT_NE(scene_with("\"bad.json\"").find("bad.json: /line_types/x/mass_per_length"),
              std::string::npos);
    folder.write("body.json", R"({"version": 1, "bodies": []})");
    EXPECT_NE(scene_with("\"body.json\"").find("no key \"bodies\""), std::string::npos);
    folder.write("twice.json", R"({"version": 1,
        "line_types": {"rope": {"mass_per_length": 2}}})");
    EXPECT_NE(scene_with(R"("parts/lines.json", "twice.json")").find("already defined"),
              std::string::npos);
    for (int i = 0; i < 9; ++i) {
        folder.write("deep" + std::to_string(i) + ".json",
                     R"({"version": 1, "include": ["deep)" + std::to_string(i + 1) + R"(.json"]})");
    }
    EXPECT_NE(scene_with("\"deep0.json\"").find("more than 8 deep"), std::string::npos);
    // A link to a file outside the folder is followed and rejected.
    std::filesystem::create_symlink("/etc/hostname", folder.path / "link.json");
    EXPECT_NE(scene_with("\"link.json\"").find("outside"), std::string::npos);
    // A part may refer to parent folders within the folder of the scene.
    folder.write("parts/up.json", R"({"version": 1, "include": ["../twice.json"]})");
    EXPECT_EQ(scene_with("\"parts/up.json\"").find("outside"), std::string::npos);
    // A mistake in a template of another file is reported there.
    folder.write("heavy.json", R"({"version": 1, "templates": {"heavy": {
        "parameters": {"m": 1}, "bodies": [{"name": "b", "mass": "${m}", "sphere": 1}]}}})");
    folder.write("use.json", R"({"version": 1, "name": "s", "include": ["heavy.json"],
        "instances": [{"template": "heavy", "name": "one", "parameters": {"m": -1}}]})");
    EXPECT_NE(error_message("use.json").find("heavy.json: /templates/heavy/bodies/0/mass"),
              std::string::npos);
}

TEST(State, is_stored_and_read_again) {
    const TempFolder folder;
    const Scene first = load_text(kSite, "site.json");
    Scene moved = load_text(kSite, "site.json");
    const BodyId rig = moved.world.find_body("rig");
    moved.world.set_pose(rig, {Vec3(1, 2, 3), Quat(0.8, 0, 0, 0.6)});
    folder.write("site.settled.json", state_text(moved));
    const auto file = folder.write(
        "site.json",
        patched(kSite, R"([{"op":"add","path":"/state","value":{"file":"site.settled.json"}}])"));
    const Scene settled = load_file(file);
    const BodyDef& def = settled.world.body_def(settled.world.find_body("rig"));
    EXPECT_EQ(def.position, Vec3(1, 2, 3));
    EXPECT_TRUE(def.orientation.isApprox(Quat(0.8, 0, 0, 0.6)));
    const BodyDef& same = settled.world.body_def(settled.world.find_body("moor/3"));
    EXPECT_EQ(same.position, first.world.body_def(first.world.find_body("moor/3")).position);
    // Joints keep the attachment points of the scene as written.
    const InteractionId moor = settled.world.find_interaction("moor/s11");
    EXPECT_EQ(settled.world.interaction_def(moor).point[1], Vec3(-35, 0, -5));
    EXPECT_EQ(load_text(settled.text, "x.json").world.state().hash(), settled.world.state().hash());

    // Stored with one copy, loaded with three: the others are shifted.
    Options options;
    options.scale = 3;
    const Scene three = load_file(file, options);
    EXPECT_TRUE(three.world.body_def(three.world.find_body("2:rig"))
                    .position.isApprox(Vec3(1, 3002, 3), 1e-12));
}

TEST(State, of_a_changed_scene_is_refused) {
    const TempFolder folder;
    folder.write("old.json", state_text(load_text(kPendulum, "p.json")));
    const auto file = folder.write(
        "p.json", patched(kPendulum, R"([{"op":"add","path":"/state","value":{"file":"old.json"}},
            {"op":"add","path":"/bodies/1","value":{"name":"new","mass":1,"sphere":1}}])"));
    try {
        (void)load_file(file);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.file, (folder.path / "old.json").string());
        EXPECT_NE(error.message.find("\"new\""), std::string::npos);
    }
}

TEST(Copies, have_rods_of_their_own) {
    const Description d = flat(kSea);
    ASSERT_TRUE(d.sea.has_value());
    const std::vector<WaterRod>& rods = d.sea->rods;
    ASSERT_EQ(rods.size(), 4U);             // two entries, two copies
    for (const std::size_t i : {0U, 1U}) {  // defaults
        EXPECT_EQ(rods[i].body, d.find_body(i == 0 ? "wedge" : "1:wedge"));
        EXPECT_EQ(rods[i].from, Vec3(0, 0, -4));
        EXPECT_EQ(rods[i].to, Vec3(0, 0, 6));
        EXPECT_EQ(rods[i].water.diameter, 0.5);
        EXPECT_TRUE(std::isnan(rods[i].water.volume));
        EXPECT_EQ(rods[i].water.cd_normal, LineWater{}.cd_normal);
        EXPECT_EQ(rods[i].segments, WaterRod{}.segments);
    }
    const LineWater& w = rods[2].water;
    EXPECT_EQ(rods[2].body, d.find_body("box"));
    EXPECT_EQ(w.volume, 0.0);
    EXPECT_EQ(w.cd_normal, 1.0);
    EXPECT_EQ(w.cd_tangential, 0.1);
    EXPECT_EQ(w.ca_normal, 0.9);
    EXPECT_EQ(w.ca_tangential, 0.2);
    EXPECT_EQ(rods[2].segments, 4);
}

TEST(Overrides, reach_every_value) {
    const auto value = [](const std::string& option, const char* pointer) {
        Json root = Json::parse(kSite);
        apply_override(root, option, {"f", ""});
        return root[Json::json_pointer(pointer)];
    };
    EXPECT_EQ(value("settings.step=0.01", "/settings/step"), 0.01);
    EXPECT_EQ(value("settings.form=saddle", "/settings/form"), "saddle");
    EXPECT_EQ(value("bodies.rig.mass=3e7", "/bodies/0/mass"), 3e7);
    EXPECT_EQ(value("bodies.0.mass=3e7", "/bodies/0/mass"), 3e7);
    EXPECT_EQ(value("bodies.ship.force=[0,1,2]", "/bodies/1/force"), Json::parse("[0,1,2]"));
    EXPECT_EQ(value("bodies.ship.force.1=5", "/bodies/1/force/1"), 5);
    EXPECT_EQ(value("interactions.fall.length=21", "/interactions/4/length"), 21);
    EXPECT_EQ(value("line_types.wire.EA=1e8", "/line_types/wire/EA"), 1e8);
    EXPECT_EQ(value("instances.port.parameters.reach=15", "/instances/0/parameters/reach"), 15);
    // A name with a dot in it.
    EXPECT_EQ(value("inputs.roller.speed.max=2", "/inputs/0/max"), 2);
    Json plain = Json::parse(kPendulum);
    apply_override(plain, "settings.step=0.02", {"f", ""});
    EXPECT_EQ(plain["settings"]["step"], 0.02);
}

}  // namespace
}  // namespace hawser::scene::test
