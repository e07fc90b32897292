// SPDX-License-Identifier: Apache-2.0
// The keys "control" and "dp_capability" of vessels: what they read, what they refuse and where.
#include <hawser/dp_ship_file.h>
#include <hawser/scene.h>
#include <hawser/vessel.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

namespace hawser::scene {
namespace {

std::string ship_text(const std::string& control) {
    return R"({"version": 1, "name": "dp", "settings": {"step": 0.02},
      "bodies": [{"name": "hull", "mass": 5e6, "half_size": [40, 9, 5], "gravity": false,
                  "inertia": [[2e8, 0, 0], [0, 2e9, 0], [0, 0, 2e9]]},
                 {"name": "buoy", "kind": "fixed"}],
      "vessels": [{"name": "ship", "body": "hull", "damping": [1e4, 1e5, 5e6, 5e7, 3e9, 1e8],
        "propulsors": [{"name": "port", "kind": "azimuth", "point": [-35, 5, -3], "thrust": 3e5},
                       {"name": "star", "kind": "azimuth", "point": [-35, -5, -3], "thrust": 3e5},
                       {"name": "bow", "kind": "tunnel", "point": [30, 0, -3], "thrust": 2e5}],
        "control": )" +
           control + "}]}";
}

std::string error_message(const std::string& control) {
    try {
        (void)load_text(ship_text(control), "dp.json");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

TEST(SceneVesselControl, ReadsItsKeys) {
    const Scene scene =
        load_text(ship_text(R"({"mode": "position", "bandwidth": [0.1, 0.2, 0.3], "target": "buoy",
            "heading_alarm_deg": 20, "zones": [{"propulsor": "port", "from_deg": -110, "to_deg": -70}],
            "failures": [{"name": "a", "propulsors": ["port", "bow"]}]})"),
                  "dp.json");
    const auto vessels = vessels_of(scene.world);
    ASSERT_EQ(vessels.size(), 1u);
    const VesselControl& c = vessels[0]->control;
    EXPECT_TRUE(c.active);
    EXPECT_EQ(c.mode, ControlMode::position);
    EXPECT_EQ(c.bandwidth.z(), 0.3);
    EXPECT_NEAR(c.heading_alarm, 20.0 * std::numbers::pi / 180.0, 1e-15);
    ASSERT_EQ(c.zones.size(), 1u);
    EXPECT_NEAR(c.zones[0].from, -110.0 * std::numbers::pi / 180.0, 1e-15);
    ASSERT_EQ(c.failures.size(), 1u);
    EXPECT_EQ(c.failures[0].propulsors.size(), 2u);
    EXPECT_TRUE(scene.world.alive(c.target));
}

TEST(SceneVesselControl, RefusesWithThePlaceAndTheNearestName) {
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_EQ(error_message("{}"), "");
    const std::string zone =
        error_message(R"({"zones": [{"propulsor": "prot", "from_deg": 0, "to_deg": 9}]})");
    EXPECT_TRUE(has(zone, "/vessels/0/control/zones/0/propulsor")) << zone;
    EXPECT_TRUE(has(zone, "port")) << zone;
    const std::string key = error_message(R"({"bandwith": [1, 1, 1]})");
    EXPECT_TRUE(has(key, "bandwidth")) << key;
    const std::string mode = error_message(R"({"mode": "positon"})");
    EXPECT_TRUE(has(mode, "position")) << mode;
    const std::string target = error_message(R"({"mode": "follow"})");
    EXPECT_TRUE(has(target, "/vessels/0/control/mode")) << target;
    EXPECT_TRUE(has(target, "no target")) << target;
    const std::string failure =
        error_message(R"({"failures": [{"name": "a", "propulsors": ["bwo"]}]})");
    EXPECT_TRUE(has(failure, "/vessels/0/control/failures/0/propulsors/0")) << failure;
}

TEST(SceneVesselControl, AFileOfOneShipIsReadByItself) {
    const auto file = std::filesystem::temp_directory_path() / "hawser_dp_ship_test.json";
    const auto write = [&](const char* thruster) {
        std::ofstream(file) << R"({"name": "tug", "dp_capability": {"length": 30, "beam": 10,
            "draught": 4, "bow_angle_deg": 30, "aft_waterplane": 130, "frontal_area": 80,
            "lateral_area": 150, "submerged_area": 110,
            "thrusters": [{"name": "P", "diameter": 2.5, "power": 2e6, "point": [-10, 3, 0]},
                          {"name": "S", "diameter": 2.5, "power": 2e6, "point": [-10, -3, 0]}],
            "failures": [{"name": "a", "thrusters": [")"
                            << thruster << R"("]}]}})";
    };
    write("P");
    EXPECT_TRUE(is_dp_ship_file(file));
    const NamedDpShip ship = load_dp_ship(file);
    EXPECT_EQ(ship.name, "tug");
    EXPECT_EQ(ship.ship.thrusters.size(), 2u);
    write("Q");
    try {
        (void)load_dp_ship(file);
        ADD_FAILURE() << "read a failure of a thruster that is not there";
    } catch (const SceneError& error) {
        EXPECT_EQ(error.path, "/dp_capability/failures/0/thrusters/0");
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser::scene
