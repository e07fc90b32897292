// SPDX-License-Identifier: Apache-2.0
/// A saved state continues in scenes that differ only in numbers.
#include <hawser/session.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace hawser::test {

namespace {

/// Return a box at rest on a spring: z = −m g/k.
std::string hung_box(double mass, double compliance, const std::string& more = "") {
    return R"({"version": 1, "name": "hung", "settings": {"step": 0.01, "duration": 20},
        "bodies": [{"name": "frame", "kind": "fixed", "position": [0, 0, 0]},
                   {"name": "box", "kind": "lump", "position": [0, 0, -1], "mass": )" +
           std::to_string(mass) + R"(, "linear_damping": [400, 400, 400]}],
        "interactions": [{"name": "rod", "kind": "distance", "bodies": ["frame", "box"],
                          "length": 1, "compliance": )" +
           std::to_string(compliance) + "}" + more + "]}";
}

/// Write a file with the state of the box of 100 kg after 10 s.
std::filesystem::path settled_file() {
    const auto file = std::filesystem::path(::testing::TempDir()) / "restore_variant.hws";
    Session session({.scene_text = hung_box(100.0, 1e-4)});
    while (session.time() < 10.0) EXPECT_EQ(session.step(), Status::ok);
    session.save(file);
    return file;
}

double height_of(const Session& session) {
    return session.world().pose(session.world().find_body("box")).position.z();
}

}  // namespace

TEST(RestoreVariant, OtherNumbersGoOnFromTheSameState) {
    const auto file = settled_file();
    const double stretch = 100.0 * 9.81 * 1e-4;
    for (const double mass : {50.0, 100.0, 200.0}) {
        Session session({.scene_text = hung_box(mass, 1e-4), .restore = file});
        EXPECT_NEAR(session.time(), 10.0, 1e-9);
        EXPECT_NEAR(height_of(session), -1.0 - stretch, 1e-4);
        ASSERT_EQ(session.differences().size(), mass == 100.0 ? 0u : 1u);
        if (mass != 100.0) {
            EXPECT_NE(session.differences()[0].find("mass: 100.0 -> "), std::string::npos)
                << session.differences()[0];
        }
        while (session.time() < 20.0) ASSERT_EQ(session.step(), Status::ok);
        // At rest: the spring is stretched by its own weight, m g/k.
        EXPECT_NEAR(height_of(session), -1.0 - mass * 9.81 * 1e-4, 1e-5);
        EXPECT_EQ(session.world().verdict().grade, Grade::good);
    }
}

TEST(RestoreVariant, TheSameSceneKeepsItsBits) {
    const auto file = settled_file();
    Session whole({.scene_text = hung_box(100.0, 1e-4)});
    while (whole.time() < 12.0) ASSERT_EQ(whole.step(), Status::ok);
    Session rest({.scene_text = hung_box(100.0, 1e-4), .restore = file});
    while (rest.time() < 12.0) ASSERT_EQ(rest.step(), Status::ok);
    EXPECT_EQ(whole.world().state().hash(), rest.world().state().hash());
}

TEST(RestoreVariant, AnotherStructureIsRefusedWithTheFirstDifference) {
    const auto file = settled_file();
    const auto refusal = [&](const SessionDef& def) {
        try {
            Session session(def);
        } catch (const std::runtime_error& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    const std::string more = R"(, {"name": "second", "kind": "distance",
        "bodies": ["frame", "box"], "length": 1, "compliance": 1e-4})";
    const std::string one = refusal({.scene_text = hung_box(100.0, 1e-4, more), .restore = file});
    EXPECT_NE(one.find("/interactions: a list of 1 -> a list of 2"), std::string::npos) << one;
    std::string lump = hung_box(100.0, 1e-4);
    const std::string kind = "\"mass\"";
    lump.replace(lump.find(kind), kind.size(), "\"gravity\": false, \"mass\"");
    const std::string two = refusal({.scene_text = lump, .restore = file});
    EXPECT_NE(two.find("/bodies/1/gravity"), std::string::npos) << two;
    scene::Options finer;
    finer.step = 0.005;
    const std::string three =
        refusal({.scene_text = hung_box(100.0, 1e-4), .options = finer, .restore = file});
    EXPECT_NE(three.find("/settings/step"), std::string::npos) << three;
}

}  // namespace hawser::test
