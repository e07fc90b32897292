// SPDX-License-Identifier: Apache-2.0
/// The keys "power", "current" and "thruster_losses" of a vessel, and losses of its propulsors.
#include <hawser/scene.h>
#include <hawser/vessel.h>

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace hawser::scene::test {
namespace {

constexpr const char* kPowered = R"({
  "version": 1, "name": "powered", "settings": {"step": 0.016666666666666666, "duration": 1},
  "bodies": [{"name": "hull", "mass": 5e6, "box": [40, 9, 5], "gravity": false}],
  "vessels": [
    {"name": "ship", "body": "hull", "thruster_losses": true, "damping": [0, 1e5, 0, 0, 0, 1e8],
     "current": {"length": 80, "draught": 5,
                 "points": [[0, -0.05, 0, 0], [90, 0.01, -0.6, 0.02], [180, 0.06, 0, 0]]},
     "propulsors": [
       {"name": "main", "propeller": {"diameter": 3}, "most_rps": 2, "ventilates": true},
       {"name": "az", "kind": "azimuth", "thrust": 1e5, "diameter": 2, "hull_loss": 0.03},
       {"name": "voith", "kind": "cycloidal", "thrust": 1e5, "ramp": 3}],
     "power": {"share": 0.8, "tied": true,
       "boards": [{"name": "a", "generators": [{"name": "g1", "power": 2e6}]},
                  {"name": "b", "generators": [{"name": "g2", "power": 1e6}]}],
       "consumers": [{"name": "main", "board": "a", "priority": 3},
                     {"name": "az", "board": "b", "power": 8e5, "efficiency": 0.85},
                     {"name": "winch", "board": "b", "signal": "tow.power"},
                     {"name": "hotel", "board": "a", "power": 3e5}]}}]
})";

TEST(SceneVesselPower, KeysReachTheDefinition) {
    const Scene scene = load_text(kPowered, "powered");
    const VesselDef* v = find_vessel(scene.world, scene.world.find_body("hull"));
    ASSERT_NE(v, nullptr);
    EXPECT_TRUE(v->thruster_losses);
    ASSERT_EQ(v->current.points.size(), 3u);
    EXPECT_NEAR(v->current.points[1].angle, 0.5 * std::numbers::pi, 1e-12);
    EXPECT_EQ(v->current.points[1].y, -0.6);
    EXPECT_EQ(v->current.length, 80.0);
    EXPECT_TRUE(v->propulsors[0].ventilates);
    EXPECT_EQ(v->propulsors[1].hull_loss, 0.03);
    EXPECT_EQ(v->propulsors[1].diameter, 2.0);
    EXPECT_EQ(v->propulsors[2].kind, PropulsorKind::cycloidal);
    EXPECT_EQ(v->power.share, 0.8);
    EXPECT_TRUE(v->power.tied);
    ASSERT_EQ(v->power.boards.size(), 2u);
    EXPECT_EQ(v->power.boards[1].generators[0].name, "g2");
    EXPECT_EQ(v->power.boards[1].generators[0].power, 1e6);
    ASSERT_EQ(v->power.consumers.size(), 4u);
    EXPECT_EQ(v->power.consumers[0].priority, 3);
    EXPECT_EQ(v->power.consumers[1].efficiency, 0.85);
    EXPECT_EQ(v->power.consumers[2].signal, "tow.power");
    EXPECT_EQ(v->power.consumers[3].power, 3e5);
    EXPECT_EQ(scene.world.system_signal("ship.hotel"), 3e5);
    EXPECT_EQ(scene.world.system_signal("ship.tie"), 1.0);
}

TEST(SceneVesselPower, RefusesWithThePlaceAndTheNearestName) {
    struct Slip {
        const char *from, *to, *said;
    };
    const Slip slips[] = {
        {R"("board": "b", "power": 8e5)", R"("board": "bb", "power": 8e5)",
         "/vessels/0/power/consumers/1/board: there is no switchboard \"bb\"; did you mean \"b\""},
        {R"("priority": 3)", R"("priorty": 3)", "did you mean \"priority\""},
        {R"("kind": "cycloidal")", R"("kind": "cycloid")", "did you mean \"cycloidal\""},
        {R"("power": 8e5, )", "", "/vessels/0/power/consumers/1/power: 0"},
        {R"("name": "hotel")", R"("name": "g1")",
         "/vessels/0/power/consumers/3/name: the name 'g1' is taken"},
        {R"("signal": "tow.power")", R"("signal": "tow")", "/vessels/0/power/consumers/2/signal: "},
        {R"("hull_loss": 0.03)", R"("hull_loss": 1.5)", "hull_loss"},
        {R"([90, 0.01)", R"([190, 0.01)", "/vessels/0/current/points"},
        {R"("thruster_losses": true)", R"("cross_flow": {"length": 80, "beam": 18, "draught": 5})",
         "/vessels/0/current: "},
        {R"("thrust": 1e5, "ramp": 3)", R"("propeller": {"diameter": 2}, "most_rps": 2)",
         "/vessels/0/propulsors/2/propeller: a cycloidal propeller is ideal"}};
    for (const Slip& slip : slips) {
        std::string text = kPowered;
        const auto at = text.find(slip.from);
        ASSERT_NE(at, std::string::npos) << slip.from;
        text.replace(at, std::string(slip.from).size(), slip.to);
        std::string said = "accepted";
        try {
            (void)load_text(text, "powered");
        } catch (const SceneError& error) {
            said = error.what();
        }
        EXPECT_NE(said.find(slip.said), std::string::npos) << slip.to << ": " << said;
    }
}

}  // namespace
}  // namespace hawser::scene::test
