// SPDX-License-Identifier: Apache-2.0
/// The key "vessels" of a scene.
#include <hawser/scene.h>
#include <hawser/vessel_ships.h>

#include "vessel_scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

constexpr double kVesselRadians = std::numbers::pi / 180.0;

std::string vessel_text(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string vessel_refusal(const std::string& text) {
    try {
        (void)load_text(text, "vessels");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SceneVessels, KeysReachTheDefinition) {
    const Scene scene = load_text(std::string(kVessels), "vessels");
    const World& w = scene.world;
    const VesselDef* tug = find_vessel(w, w.find_body("hull"));
    ASSERT_NE(tug, nullptr);
    EXPECT_EQ(tug->origin, Vec3(1, 0, -1));
    EXPECT_EQ(tug->added_mass(4, 4), 1e9);
    EXPECT_EQ(tug->damping(1, 5), 1e4);
    EXPECT_EQ(tug->coriolis, AddedCoriolis::planar);
    EXPECT_EQ(tug->resistance.curve[1].resistance, 5e4);
    EXPECT_EQ(tug->polynomial.rudder_sign, -1.0);
    bool found = false;
    for (const HullTerm& t : tug->polynomial.terms)
        if (t.axis == HullAxis::n && t.of == "vvr") found = std::abs(t.value + 0.01) < 1e-15;
    EXPECT_TRUE(found);  // times the factor
    EXPECT_NEAR(tug->steering.rate, 3.0 * kVesselRadians, 1e-12);
    EXPECT_EQ(tug->wind.ship, WindShip::tender);
    ASSERT_EQ(tug->propulsors.size(), 3u);
    EXPECT_EQ(tug->propulsors[1].propeller.series, PropellerSeries::ka4_70);
    EXPECT_NEAR(tug->propulsors[1].most_angle, 90.0 * kVesselRadians, 1e-12);
    EXPECT_EQ(tug->rudders[0].behind, "main");
    EXPECT_NEAR(tug->rudders[0].stall, 30.0 * kVesselRadians, 1e-12);
    // The published ship of a template, in both instances and in the copies.
    const PublishedShip esso = esso_190k(23.0);
    for (const char* name : {"a/hull", "b/hull", "1:a/hull", "1:b/hull"}) {
        const VesselDef* v = find_vessel(w, w.find_body(name));
        ASSERT_NE(v, nullptr) << name;
        EXPECT_EQ(v->added_mass, esso.vessel.added_mass);
    }
    EXPECT_EQ(vessels_of(w).size(), 6u);
}

TEST(SceneVessels, RefusesWithThePlaceAndTheNearestName) {
    const std::string good(kVessels);
    struct Slip {
        const char *from, *to, *said;
    };
    const Slip slips[] = {
        {R"("behind": "main")", R"("behind": "mian")",
         "/vessels/0/rudders/0/behind: there is no propulsor \"mian\"; did you mean \"main\""},
        {R"("ship": "esso_190k")", R"("ship": "esso_190")", "did you mean \"esso_190k\""},
        {R"("ship": "esso_190k")", R"("ship": "kvlcc2")", "/vessels/0/ship: kvlcc2 has"},
        {R"("depth": 23})", R"("depth": 18})", "/vessels/0/depth: 18 m"},
        {R"("body": "hull", "origin")", R"("body": "hul", "origin")",
         "/vessels/0/body: there is no body \"hul\""},
        {R"("vvr": -10)", R"("vwr": -10)", "/vessels/0/polynomial/n/vwr: 'vwr' has the letter 'w'"},
        {R"("cross_flow")", R"("crossflow")", "did you mean \"cross_flow\""},
        {R"("name": "az", )", R"("name": "main", )",
         "/vessels/0/propulsors/1/name: the name 'main' is taken"},
        {R"("rate_deg": 4)", R"("rate_deg": 0)", "/vessels/0/rudders/0/rate_deg: 0"},
        {R"("restoring": [0, 0, 1e7)", R"("restoring": [1, 0, 1e7)", "/vessels/0/restoring: "}};
    for (const Slip& slip : slips) {
        const std::string said = vessel_refusal(vessel_text(good, slip.from, slip.to));
        EXPECT_NE(said.find(slip.said), std::string::npos) << slip.to << ": " << said;
    }
    // A thruster on a body without a hull.
    const std::string bare = vessel_refusal(R"({"version": 1, "name": "bare",
      "bodies": [{"name": "box", "mass": 1e6, "box": [10, 5, 2], "gravity": false}],
      "vessels": [{"name": "v", "body": "box",
                   "propulsors": [{"name": "bow", "kind": "tunnel", "thrust": 1e5}]}]})");
    EXPECT_NE(bare.find("/vessels/0/propulsors: the body has no hull"), std::string::npos) << bare;
}

TEST(SceneVessels, ShippedSceneIsUnderWayAndTurns) {
    Scene scene = load_file("scenes/osv.json");
    World& w = scene.world;
    w.set_system_signal("osv.port", 1.0);
    w.set_system_signal("osv.starboard", 1.0);
    for (int i = 0; i < 60 * 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    // As validated in still water, 6.97 m/s, except for the wind and 5 % less cross-flow drag.
    EXPECT_NEAR(w.system_signal("osv.speed"), 6.97, 0.2);
    w.set_system_signal("osv.port_angle", -0.349);
    w.set_system_signal("osv.starboard_angle", -0.349);
    for (int i = 0; i < 60 * 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_GT(w.system_signal("osv.turn_rate"), 0.01);  // to starboard
}

/// Tutorial of docs/vessels.md: its figures are those of its runs.
struct VesselTutorial {
    std::string text;
    std::vector<std::string> blocks;

    VesselTutorial() {
        std::ifstream in("docs/vessels.md");
        text.assign(std::istreambuf_iterator<char>(in), {});
        text = text.substr(0, text.find("## Equations"));
        std::size_t at = 0;
        while ((at = text.find("```json", at)) != std::string::npos) {
            const std::size_t begin = text.find('\n', at) + 1, end = text.find("```", begin);
            blocks.push_back(text.substr(begin, end - begin));
            at = end + 3;
        }
    }
    /// Return the number at the position of "#".
    [[nodiscard]] double figure(std::string words) const {
        words.replace(words.find('#'), 1, "([0-9.]+)");
        std::smatch found;
        if (!std::regex_search(text, found, std::regex(words))) {
            ADD_FAILURE() << "docs/vessels.md does not say: " << words;
            return 0.0;
        }
        return std::stod(found[1]);
    }
};

TEST(SceneVessels, TutorialGivesItsFigures) {
    constexpr double kHundredth = 0.0051;
    const VesselTutorial page;
    ASSERT_EQ(page.blocks.size(), 7u);
    nlohmann::json boat = nlohmann::json::parse(page.blocks[0]);
    {
        Scene scene = load_text(boat.dump(), "boat");
        for (int i = 0; i < 60 * 60; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
        EXPECT_NEAR(scene.world.system_signal("boat.speed"),
                    page.figure("After 60 s it makes # m/s"), kHundredth);
    }
    boat["vessels"][0].update(nlohmann::json::parse("{" + page.blocks[1] + "}"));
    boat.update(nlohmann::json::parse("{" + page.blocks[2] + "}"));
    Scene scene = load_text(boat.dump(), "boat");
    World& w = scene.world;
    w.set_system_signal("boat.main", 1.0);
    for (int i = 0; i < 60 * 120; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.system_signal("boat.speed"), page.figure("it makes # m/s after 120 s"),
                kHundredth);
    w.set_system_signal("boat.rudder", 0.5);
    for (int i = 0; i < 60 * 180; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.system_signal("boat.turn_rate") / kVesselRadians,
                page.figure("turns to starboard at # "), kHundredth);
    // The published ship is accepted as written.
    const nlohmann::json ship = nlohmann::json::parse("{" + page.blocks[3] + "}");
    nlohmann::json whole = {{"version", 1}, {"name", "ship"}};
    whole.update(ship);
    EXPECT_EQ(vessels_of(load_text(whole.dump(), "ship").world).size(), 1u);
}

// The supply vessel with the control of the page stays in place, and follows the page's orders.
TEST(SceneVessels, TutorialOfPositioningWorks) {
    const VesselTutorial page;
    ASSERT_EQ(page.blocks.size(), 7u);
    std::ifstream in("scenes/osv.json");
    const nlohmann::json shipped = nlohmann::json::parse(in);
    for (const std::size_t control : {4u, 6u}) {
        nlohmann::json osv = shipped;
        osv.erase("timeline");
        osv["vessels"][0].update(nlohmann::json::parse("{" + page.blocks[control] + "}"));
        Scene scene = load_text(osv.dump(), "osv");
        World& w = scene.world;
        const Vec3 start = w.pose(w.find_body("hull")).position;
        for (int i = 0; i < 60 * 60; ++i) ASSERT_EQ(w.step(), Status::ok);
        // The ship is under way at the start and has to stop: within its own length.
        EXPECT_LT((w.pose(w.find_body("hull")).position - start).head<2>().norm(), 83.0);
        EXPECT_EQ(w.system_signal("osv.mode_now"), 3.0);
    }
    nlohmann::json ordered = shipped;
    ordered["vessels"][0].update(nlohmann::json::parse("{" + page.blocks[4] + "}"));
    ordered.update(nlohmann::json::parse("{" + page.blocks[5] + "}"));
    EXPECT_NO_THROW((void)load_text(ordered.dump(), "osv"));
}

}  // namespace
}  // namespace hawser::scene::test
