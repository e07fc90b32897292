// SPDX-License-Identifier: Apache-2.0
// Positions of the nodes of cables at the start.
#include "support.h"

#include <cmath>

namespace hawser::scene::test {
namespace {

/// Return a scene with a wire of 20 kg/m in air, 20 elements and more keys.
std::string with_wire(const std::string& keys) {
    return R"({"version": 1, "name": "t",
      "line_types": {"wire": {"mass_per_length": 20, "EA": 1e8, "diameter": 0.1}},
      "bodies": [{"name": "a", "position": [0, 0, 10], "mass": 1e5, "box": [5, 2, 1]}],
      "cables": [{"name": "c", "line_type": "wire", "elements": 20, )" +
           keys + "}]}";
}

std::vector<Vec3> nodes(const Description& d) {
    std::vector<Vec3> out;
    for (const BodyId id : d.cables.at(0).nodes) out.push_back(d.body(id).position);
    return out;
}

double tension(const Description& d, std::size_t e) {
    const auto p = nodes(d);
    const double l = d.cables[0].length / 20.0;
    return 1e8 * ((p[e + 1] - p[e]).norm() / l - 1.0);
}

void expect_refused(const std::string& text, const std::string& path, const std::string& words) {
    const std::string said = refusal(text);
    EXPECT_TRUE(said.starts_with("test.json: " + path + ":")) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

constexpr double kWeight = 20.0 * 9.81;  // weight per metre [N]

TEST(CableShapes, hanging_has_the_tension_it_starts_with) {
    const Description d = flat(with_wire(
        R"("from": {"at": [0, 0, 0]}, "to": {"at": [80, 0, 0]}, "length": 100,
           "shape": "hanging")"));
    // a = 33.82 m: docs/theory/catenary.md.
    EXPECT_NEAR(tension(d, 10), 33.82 * kWeight, 0.01 * 33.82 * kWeight);
    // Half the weight, less half an element.
    const auto p = nodes(d);
    const double up = tension(d, 0) * -(p[1] - p[0]).normalized().z();
    EXPECT_NEAR(up, 47.5 * kWeight, 1.0);
}

TEST(CableShapes, hanging_where_a_catenary_of_rigid_elements_is_none) {
    // Shorter than the distance, and between ends on one vertical line.
    const Description taut = flat(with_wire(
        R"("from": {"at": [0, 0, 0]}, "to": {"at": [80, 0, 0]}, "length": 79.9,
           "shape": "hanging")"));
    EXPECT_GT(tension(taut, 3), 1e5);
    const Description fold = flat(with_wire(
        R"("from": {"at": [0, 0, 0]}, "to": {"at": [0, 0, -10]}, "length": 30,
           "shape": "hanging")"));
    double lowest = 0.0;
    for (const Vec3& p : nodes(fold)) lowest = std::min(lowest, p.z());
    EXPECT_NEAR(lowest, -20.0, 0.8);
}

TEST(CableShapes, catenary_lies_on_its_seabed) {
    const std::string keys = R"("from": {"at": [0, 0, -20]}, "to": {"at": [80, 0, 0]},
        "length": 90, "shape": "catenary", "seabed": {"height": -20, "friction": 0.6})";
    const Description d = flat(with_wire(keys));
    EXPECT_EQ(nodes(d)[1].z(), -20.0);
    EXPECT_EQ(nodes(d)[5].z(), -20.0);
    EXPECT_GT(nodes(d)[18].z(), -10.0);
    // Friction reduces the tension by 0.6 of an element's weight at each node.
    EXPECT_NEAR(tension(d, 0), 0.0, 1e-3);
    EXPECT_NEAR(tension(d, 11) - tension(d, 10), 0.6 * 4.5 * kWeight, 1.0);
    // With contact it lies higher by its radius.
    const Description thick = flat(with_wire(keys + R"(, "contact": {"radius": 0.5})"));
    EXPECT_NEAR(nodes(thick)[5].z(), -19.5, 1e-12);
}

TEST(CableShapes, laid_is_as_long_as_its_way) {
    const Description d = flat(with_wire(
        R"("from": {"at": [0, 0, -20]}, "to": {"at": [60, 0, 0]},
           "shape": "laid", "seabed": {"height": -20})"));
    EXPECT_GT(d.cables[0].length, 0.97 * 80.0);
    EXPECT_LT(d.cables[0].length, 80.0);
    EXPECT_NEAR(nodes(d)[10].z(), -20.0, 1e-12);
    EXPECT_NEAR(nodes(d)[10].y(), 0.0, 1e-3);
    // Longer: the additional length lies in an arc.
    const Description longer = flat(with_wire(
        R"("from": {"at": [0, 0, -20]}, "to": {"at": [60, 0, 0]}, "length": 100,
           "shape": "laid", "seabed": {"height": -20})"));
    EXPECT_GT(std::abs(nodes(longer)[8].y()), 5.0);
}

TEST(CableShapes, path_goes_round_corners_evenly) {
    const Description d = flat(with_wire(
        R"("from": {"at": [0, 0, 0]}, "to": {"at": [10, 10, 0]}, "shape": "path",
           "path": [[10, 0, 0]])"));
    EXPECT_TRUE(nodes(d)[5].isApprox(Vec3(5, 0, 0), 1e-12));
    EXPECT_TRUE(nodes(d)[15].isApprox(Vec3(10, 5, 0), 1e-12));
    EXPECT_NEAR(d.cables[0].length, 20.0, 1e-12);
}

TEST(CableShapes, free_ends_start_where_they_rest) {
    const std::string from = R"("from": {"at": [0, 0, 0]}, "length": 50, "shape": "hanging", )";
    const Description d = flat(with_wire(from + R"("to": {"free": [0, 0, -50]})"));
    EXPECT_NEAR(nodes(d).back().z(), -50.0 - kWeight * 1250.0 / 1e8, 1e-9);
    EXPECT_NEAR(tension(d, 19), 1.25 * kWeight, 1e-3);  // the mass of its last node is half
    expect_refused(with_wire(from + R"("to": {"free": [30, 0, -40]})"), "/cables/0/to/free",
                   "at rest its free end is at [0, 0, -50");
    // Friction alone keeps it in place.
    const Description lies = flat(with_wire(
        R"("from": {"at": [0, 0, 0]}, "length": 75, "shape": "hanging",
           "to": {"free": [70, 0, -10]}, "seabed": {"height": -10, "friction": 1})"));
    EXPECT_NEAR(tension(lies, 19), 0.0, 1e-3);
    EXPECT_GT(tension(lies, 0), 100.0);
    // The first end may be the free one.
    const Description first = flat(with_wire(
        R"("from": {"free": [0, 0, -50]}, "to": {"at": [0, 0, 0]}, "length": 50,
           "shape": "hanging")"));
    EXPECT_LT(nodes(first)[0].z(), -50.0);
}

TEST(CableShapes, links_keep_their_length) {
    const Description d = flat(with_wire(
        R"("from": {"at": [0, 0, -20]}, "to": {"at": [80, 0, 0]}, "length": 90, "as": "links",
           "shape": "hanging", "seabed": {"height": -20})"));
    for (const InteractionDef& joint : d.interactions) {
        const Vec3 gap = d.world_point(joint.body[0], joint.point[0]) -
                         d.world_point(joint.body[1], joint.point[1]);
        EXPECT_LT(gap.norm(), 1e-12);
    }
    for (std::size_t i = 1; i < 21; ++i)
        EXPECT_NEAR(d.body(d.cables[0].nodes[i]).half_size.x(), 2.25, 1e-6);
}

/// A wire in the sea once started with its weight in air. Under water it now has the shape of a
/// wire in air with its weight in water. Above the water its shape is the one without a sea.
TEST(CableShapes, in_the_sea_lines_have_their_weight_in_water) {
    const auto scene = [](const std::string& type, const std::string& sea, const std::string& shape,
                          double z) {
        return flat(R"({"version": 1, "name": "t", "line_types": {"wire": {"mass_per_length": 20,
          "EA": 1e8, "diameter": 0.1, )" +
                    type + R"(}}, )" + sea + R"("cables": [{"name": "c", "line_type": "wire",
          "elements": 20, "length": 100, "shape": ")" +
                    shape + R"(", "from": {"at": [0, 0, )" + std::to_string(z) +
                    R"(]}, "to": {"at": [80, 0, )" + std::to_string(z - 30.0) + "]}}]}");
    };
    // 0.007854 m² of 1,030 kg/m³, less 20 kg/m.
    const double factor = 1.0 - 1030.0 * 0.25 * 3.14159265358979 * 0.01 / 20.0;
    const std::string wet = R"("cd_normal": 1.2)", dry = R"("ca_normal": 1)",
                      light = R"("submerged_factor": )" + std::to_string(factor);
    const std::string sea = R"("sea": {"depth": 500, "density": 1030, "level":
        [{"time": -100, "level": 0}, {"time": 100, "level": 4}]}, )";  // 2 m at the start
    for (const char* shape : {"hanging", "catenary"}) {
        const auto under = nodes(scene(wet, sea, shape, 1.9)),
                   over = nodes(scene(wet, sea, shape, 90.0));
        const auto in_water = nodes(scene(light, "", "hanging", 1.9)),
                   in_air = nodes(scene(dry, "", "hanging", 90.0));
        for (std::size_t i = 0; i < under.size(); ++i) {
            // std::to_string keeps six digits of the factor, which hardly move the nodes.
            EXPECT_LT((under[i] - in_water[i]).norm(), 1e-6) << shape << i;
            EXPECT_LT((over[i] - in_air[i]).norm(), 1e-9) << shape << i;
        }
    }
}

TEST(CableShapes, refusals_say_why) {
    const std::string ends = R"("from": {"at": [0, 0, 0]}, "to": {"at": [80, 0, 0]}, )";
    expect_refused(with_wire(ends + R"("shape": "laid")"), "/cables/0/shape", "needs \"seabed\"");
    expect_refused(with_wire(ends + R"("shape": "path")"), "/cables/0/path", "key \"path\"");
    expect_refused(with_wire(ends + R"("path": [[1, 0, 0]])"), "/cables/0/path", "shape \"path\"");
    expect_refused(with_wire(ends + R"("seabed": {"height": -5})"), "/cables/0/seabed",
                   "\"hanging\"");
    expect_refused(with_wire(ends + R"("shape": "hanging", "seabed": {"height": 5})"),
                   "/cables/0/seabed", "is below the seabed");
    expect_refused(with_wire(R"("from": {"free": [0, 0, 0]}, "to": {"free": [80, 0, 0]},
                                "shape": "hanging")"),
                   "/cables/0/shape", "an end that is held");
}

}  // namespace
}  // namespace hawser::scene::test
