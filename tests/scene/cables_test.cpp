// SPDX-License-Identifier: Apache-2.0
#include "support.h"

#include <cmath>
#include <string>

namespace hawser::scene::test {
namespace {

std::string with_cable(const std::string& cable, const std::string& more = "") {
    return R"({"version": 1, "name": "t",
      "line_types": {"wire": {"mass_per_length": 20, "EA": 1e8, "EI": 4000, "drag": 6,
                              "axial_damping": 0.5, "submerged_factor": 0.75,
                              "breaking_load": 2e6, "diameter": 0.1, "color": "#123456"},
                     "chain": {"mass_per_length": 50}},
      "bodies": [{"name": "a", "position": [0, 0, 10], "euler_deg": [0, 0, 90],
                  "velocity": [1, 0, 0], "mass": 1e5, "box": [5, 2, 1]},
                 {"name": "drum", "kind": "scalar", "mass": 10}],
      "cables": [)" +
           cable + "]" + more + "}";
}

TEST(Cables, lumps_between_a_body_and_the_world) {
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"body": "a", "point": [5, 0, 0]},
            "to": {"at": [0, 45, 10]}, "length": 44, "elements": 4})"));
    // a, drum, c/1..c/3 and the fixed end c/4.
    ASSERT_EQ(d.bodies.size(), 6U);
    EXPECT_FALSE(d.find_body("c/0").valid());
    EXPECT_EQ(body(d, "c/4").kind, BodyKind::fixed);
    // Point (5, 0, 0) of a body rotated by 90° about z is at y = 5.
    EXPECT_TRUE(body(d, "c/1").position.isApprox(Vec3(0, 15, 10), 1e-12));
    const BodyDef& node = body(d, "c/2");
    EXPECT_EQ(node.kind, BodyKind::lump);
    EXPECT_DOUBLE_EQ(node.mass, 20.0 * 11.0);
    EXPECT_EQ(node.linear_damping, Vec3::Constant(6.0 * 11.0));
    // Weight in water is 0.75 of the weight in air: the rest is an upward force.
    EXPECT_TRUE(node.force.isApprox(Vec3(0, 0, 0.25 * 9.81 * 220.0), 1e-12));
    // Midway between the attachment, which moves, and the anchor, which does not.
    EXPECT_TRUE(node.velocity.isApprox(Vec3(0.5, 0, 0), 1e-12));

    const InteractionDef& first = interaction(d, "c/s0");
    EXPECT_EQ(first.kind, InteractionKind::Stretch);
    EXPECT_EQ(first.point[0], Vec3(5, 0, 0));
    EXPECT_DOUBLE_EQ(first.get("length"), 11.0);
    EXPECT_DOUBLE_EQ(first.get("EA"), 1e8);
    EXPECT_DOUBLE_EQ(first.get("breaking_load"), 2e6);
    EXPECT_DOUBLE_EQ(first.get("tension_only"), 1.0);
    EXPECT_DOUBLE_EQ(first.damping_time[0], 0.5 * 11.0 * std::sqrt(20.0 / 1e8));
    const InteractionDef& bend = interaction(d, "c/b1");
    EXPECT_EQ(bend.body[0], d.find_body("a"));
    EXPECT_EQ(bend.point[0], Vec3(5, 0, 0));
    EXPECT_TRUE(d.find_interaction("c/b3").valid());
    EXPECT_FALSE(d.find_interaction("c/b4").valid());
    EXPECT_EQ(d.interactions.size(), 7U);

    ASSERT_EQ(d.cables.size(), 1U);
    const Cable& c = d.cables.front();
    EXPECT_EQ(c.nodes.size(), 5U);
    EXPECT_EQ(c.nodes.front(), d.find_body("a"));
    EXPECT_EQ(c.stretch.size(), 4U);
    EXPECT_EQ(c.line_type, "wire");
    EXPECT_DOUBLE_EQ(c.length, 44.0);
    EXPECT_EQ(c.color, "#123456");
}

TEST(Cables, free_end_carries_half_an_element) {
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"at": [0, 0, 0]},
            "to": {"free": [0, 0, -10]}, "elements": 5})"));
    EXPECT_DOUBLE_EQ(body(d, "c/5").mass, 20.0);
    EXPECT_DOUBLE_EQ(body(d, "c/4").mass, 40.0);
    double mass = 0.0;
    for (const BodyDef& b : d.bodies) {
        mass += b.name.starts_with("c/") ? b.mass : 0.0;
    }
    // The world carries the half element at the fixed end.
    EXPECT_DOUBLE_EQ(mass, 20.0 * 9.0);
}

TEST(Cables, shape_and_offsets) {
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"at": [0, 0, 0]},
            "to": {"at": [8, 0, 0]}, "shape": [[2, 0, -3], [4, 0, -4], [6, 0, -3]],
            "offsets": [[0, 0.1, 0], [0, -0.1, 0], [0, 0.1, 0]]})"));
    EXPECT_TRUE(body(d, "c/2").position.isApprox(Vec3(4, -0.1, -4), 1e-12));
    // Length along the listed points, before the offsets.
    EXPECT_NEAR(d.cables[0].length, 2 * std::sqrt(13.0) + 2 * std::sqrt(5.0), 1e-12);
}

TEST(Cables, winch_pays_out_the_first_element) {
    const std::string end = R"("to": {"at": [0, 45, 10]}, "elements": 4, )";
    const std::string ways[] = {
        R"("from": {"body": "a", "point": [5, 0, 0]}, "winch": {"drum": "drum", "radius": 0.8})",
        R"("winch": {"drum": "drum", "radius": 0.8,
                     "fairlead": {"body": "a", "point": [5, 0, 0]}})",
        R"("from": {"body": "drum"}, "winch": {"drum": "drum", "radius": 0.8,
                     "fairlead": {"body": "a", "point": [5, 0, 0]}})"};
    for (const std::string& way : ways) {
        std::string cable = R"({"name": "c", "line_type": "wire", )";
        cable.append(end).append(way).append("}");
        const Description d = flat(with_cable(cable));
        const InteractionDef& first = interaction(d, "c/s0");
        EXPECT_EQ(first.kind, InteractionKind::WinchStretch);
        EXPECT_EQ(first.body[0], d.find_body("a"));
        EXPECT_EQ(first.body[2], d.find_body("drum"));
        EXPECT_DOUBLE_EQ(first.get("radius"), 0.8);
        EXPECT_DOUBLE_EQ(first.get("length"), 10.0);
        EXPECT_EQ(interaction(d, "c/s1").kind, InteractionKind::Stretch);
    }
}

/// Version 1 keeps one element. Version 2 feeds elements with their own mass.
TEST(Cables, winch_feeds_elements_in_version_2) {
    const std::string cable = with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"body": "a", "point": [5, 0, 0]},
            "to": {"at": [0, 45, 10]}, "elements": 4, "winch": {"drum": "drum", "radius": 0.8}})");
    const Description one = flat(cable);
    EXPECT_EQ(one.cables.front().drum_element, 0.0);
    EXPECT_TRUE(std::isnan(interaction(one, "c/s1").get("mass")));
    EXPECT_DOUBLE_EQ(body(one, "c/1").mass, 200.0);
    std::string second = cable;
    second.replace(second.find("\"version\": 1"), 12, "\"version\": 2");
    const Description two = flat(second);
    EXPECT_DOUBLE_EQ(two.cables.front().drum_element, 10.0);
    EXPECT_DOUBLE_EQ(interaction(two, "c/s1").get("mass"), 200.0);
    EXPECT_DOUBLE_EQ(body(two, "c/1").mass, 100.0) << "the feed has the half at the drum";
    EXPECT_DOUBLE_EQ(body(two, "c/2").mass, 200.0);
}

/// The element at this position, counted from the first end, and no other.
TEST(Cables, weak_places_and_consistent_mass) {
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"at": [0, 0, 10]},
            "to": {"at": [0, 40, 10]}, "length": 40, "elements": 4,
            "weak": {"at": 25, "breaking_load": 1e6}, "consistent_mass": true})"));
    for (const char* name : {"c/s0", "c/s1", "c/s2", "c/s3"}) {
        const bool weak = std::string(name) == "c/s2";
        EXPECT_DOUBLE_EQ(interaction(d, name).get("breaking_load"), weak ? 1e6 : 2e6) << name;
        EXPECT_DOUBLE_EQ(interaction(d, name).get("mass"), 200.0) << name;
    }
    const Description end = flat(with_cable(
        R"({"name": "c", "line_type": "wire", "from": {"at": [0, 0, 10]},
            "to": {"at": [0, 40, 10]}, "length": 40, "elements": 4,
            "weak": {"at": 40, "breaking_load": 1e6}})"));
    EXPECT_DOUBLE_EQ(interaction(end, "c/s3").get("breaking_load"), 1e6);
    EXPECT_TRUE(std::isnan(interaction(end, "c/s3").get("mass"))) << "the default";
}

TEST(Cables, links_meet_at_their_joints) {
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "chain", "as": "links", "radius": 0.05,
            "from": {"body": "a", "point": [5, 0, 0]}, "to": {"at": [0, 45, -20]},
            "length": 60, "elements": 12, "shape": "catenary"})"));
    for (int i = 0; i < 12; ++i) {
        const BodyDef& link = body(d, "c/" + std::to_string(i));
        EXPECT_EQ(link.kind, BodyKind::rigid);
        EXPECT_DOUBLE_EQ(link.mass, 250.0);
        // Solid cylinder of radius 0.05 and length 5 along x.
        EXPECT_NEAR(link.inertia(0, 0), 250.0 * 0.0025 / 2.0, 1e-12);
        EXPECT_NEAR(link.inertia(1, 1), 250.0 * (3 * 0.0025 + 25.0) / 12.0, 1e-9);
    }
    ASSERT_EQ(d.interactions.size(), 13U);
    for (const InteractionDef& joint : d.interactions) {
        EXPECT_EQ(joint.kind, InteractionKind::Ball);
        const Vec3 gap = d.world_point(joint.body[0], joint.point[0]) -
                         d.world_point(joint.body[1], joint.point[1]);
        // Rounding of coordinates of about 50 m.
        EXPECT_LT(gap.norm(), 1e-12) << joint.name;
    }
    EXPECT_EQ(d.cables[0].nodes.size(), 14U);
    EXPECT_EQ(d.cables[0].nodes.back(), d.find_body("world"));
    EXPECT_TRUE(d.cables[0].links);
}

TEST(Cables, links_backwards_along_x) {
    // There is no shortest arc to the direction opposite to the links' own axis.
    const Description d = flat(with_cable(
        R"({"name": "c", "line_type": "chain", "as": "links", "radius": 0.05,
            "from": {"at": [10, 0, 0]}, "to": {"free": [0, 0, 0]}, "elements": 4})"));
    const BodyDef& link = body(d, "c/0");
    EXPECT_TRUE((link.orientation * Vec3::UnitX()).isApprox(-Vec3::UnitX(), 1e-12));
    EXPECT_EQ(d.interactions.size(), 4U);
}

TEST(Cables, defaults_reach_joints_but_not_elements) {
    const Description d =
        flat(with_cable(R"({"name": "c", "line_type": "chain", "as": "links", "radius": 0.05,
                       "from": {"at": [0, 0, 0]}, "to": {"body": "a"}, "elements": 4},
                      {"name": "e", "line_type": "wire", "from": {"at": [9, 0, 0]},
                       "to": {"body": "a"}, "elements": 3})",
                        R"(, "defaults": {"compliance": 1e-9, "damping_time": 0.07})"));
    EXPECT_EQ(interaction(d, "c/j2").compliance[2], 1e-9);
    EXPECT_EQ(interaction(d, "c/j2").damping_time[0], 0.07);
    EXPECT_TRUE(std::isnan(interaction(d, "e/s1").compliance[0]));
    EXPECT_TRUE(std::isnan(interaction(d, "e/b1").damping_time[0]));
}

}  // namespace
}  // namespace hawser::scene::test
