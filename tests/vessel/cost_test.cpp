// SPDX-License-Identifier: Apache-2.0
/// Time of a vessel's system in a step.
#include <hawser/hawser.h>
#include <hawser/sea.h>
#include <hawser/vessel_ships.h>

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Make the supply vessel with two propellers, two rudders, four thrusters, power bus and losses.
VesselDef full_ship(const PublishedShip& ship) {
    VesselDef def = ship.vessel;
    def.propulsors.clear();
    def.wind = {.ship = WindShip::offshore_supply,
                .frontal_area = 230.0,
                .lateral_area = 480.0,
                .length = 83.0};
    def.polynomial.length = 83.0;
    def.polynomial.area = 415.0;
    def.polynomial.terms = {{HullAxis::y, "v", -0.32},
                            {HullAxis::y, "r", 0.07},
                            {HullAxis::n, "v", -0.07},
                            {HullAxis::n, "r", -0.07}};
    def.thruster_losses = true;
    def.power.boards = {{"a", {{"a1", 5e6}}}, {"b", {{"b1", 5e6}}}};
    for (const double y : {-4.5, 4.5}) {
        PropulsorDef p;
        p.name = y < 0.0 ? "starboard" : "port";
        p.point = {-33.0, y, -4.3};
        p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 3.6, .pitch = 1.2};
        p.most_rps = 2.5;
        p.shaft_inertia = 14800.0;
        p.most_power = 3.5e6;
        p.controllable = true;
        p.ventilates = true;
        def.propulsors.push_back(p);
        def.rudders.push_back(
            {.name = p.name + "_rudder", .point = {-35.7, y, -4.3}, .area = 8.5, .behind = p.name});
        def.power.consumers.push_back({.name = p.name, .board = y < 0.0 ? "a" : "b"});
    }
    for (int i = 0; i < 4; ++i) {
        PropulsorDef p;
        p.name = "thruster" + std::to_string(i);
        p.kind = i < 2 ? PropulsorKind::tunnel : PropulsorKind::azimuth;
        p.point = {41.5 - 4.0 * i, 0.0, -5.0};
        p.thrust = 3e5;
        p.diameter = 2.0;
        def.propulsors.push_back(p);
        def.power.consumers.push_back({.name = p.name, .board = "a", .priority = 2, .power = 1e6});
    }
    def.control.active = true;
    def.control.mode = ControlMode::position;
    return def;
}

// Required limit: 50 us per step. The first decile of the steps is little disturbed by other
// programs.
TEST(VesselCost, FullShipTakesUnderFiftyMicroseconds) {
    if (kSanitized) GTEST_SKIP() << "times of a sanitizer are not those of the program";
    World world{WorldDef{.step = 1.0 / 60.0}};
    SeaDef sea{.depth = 200.0};
    sea.waves.push_back(
        {.kind = WaveKind::jonswap, .height = 2.5, .period = 9.0, .components = 60});
    sea.current.push_back({.depth = 0.0, .speed = 0.5, .direction = 1.0});
    world.add(sea);
    const PublishedShip ship = osv();
    VesselDef def = full_ship(ship);
    def.body = world.add_body(ship.body);
    world.add(def);
    std::vector<double> times;
    for (int i = 0; i < 2000; ++i) {
        ASSERT_EQ(world.step(), Status::ok);
        times.push_back(world.stats().stage_seconds[static_cast<std::size_t>(Stage::prestep)]);
    }
    const auto tenth = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 10);
    std::nth_element(times.begin(), tenth, times.end());
    std::printf("prestep of a full ship: %.1f us\n", 1e6 * *tenth);
    EXPECT_LT(*tenth, 50e-6);
    EXPECT_EQ(world.system_signal("osv.mode_now"), 3.0);
    for (const char* order : {"port", "thruster0", "thruster2"})
        EXPECT_NE(world.system_signal(std::string("osv.") + order), 0.0) << order;
}

}  // namespace
}  // namespace hawser::test
