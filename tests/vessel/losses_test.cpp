// SPDX-License-Identifier: Apache-2.0
/// Losses of thrust, failures, cycloidal propellers, loads of a current by heading.
#include <hawser/hawser.h>
#include <hawser/sea.h>
#include <hawser/vessel.h>

#include "vessel/held_ship.h"
#include "vessel/hull_forces.h"
#include "vessel/losses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace hawser::test {
namespace {

constexpr double kPiLosses = std::numbers::pi;

/// A held ship with thrusters that turn at once.
struct Held : HeldShip {
    PropulsorDef& thruster(const char* name, double x, double y) {
        PropulsorDef& p = azimuth(name);
        p.point = {x, y, 0.0};
        p.diameter = 2.0;
        p.turn_rate = 100.0;
        return p;
    }
};

// Values of the formula by hand; the ends of its range meet 0 and 1 within its own rounding.
TEST(Losses, VentilationMeetsItsFormula) {
    EXPECT_NEAR(ventilated_thrust(0.0), 0.325, 1e-12);
    EXPECT_NEAR(ventilated_thrust(1.0), 1.0 - 0.675 * std::exp(1.258 * std::log(0.231)), 1e-12);
    EXPECT_EQ(ventilated_thrust(2.0), 1.0);
    EXPECT_EQ(ventilated_thrust(-1.0), 0.0);
    EXPECT_NEAR(ventilated_thrust(1.2999), 1.0, 1e-3);
    EXPECT_NEAR(ventilated_thrust(-0.4799), 0.0, 3e-3);
    for (double r = -1.0, last = 0.0; r < 2.0; r += 0.01) {
        const double now = ventilated_thrust(r);
        EXPECT_GE(now, last);
        last = now;
    }
}

TEST(Losses, RaceMeetsItsFormula) {
    EXPECT_NEAR(race_thrust(1.0, 0.0), 0.25, 1e-12);
    EXPECT_NEAR(race_thrust(8.0, 0.0), 1.0 - std::pow(0.75, 4.0), 1e-12);
    const double t = 1.0 - std::pow(0.75, 4.0);
    EXPECT_NEAR(race_thrust(8.0, kPiLosses / 9.0),
                t + (1.0 - t) * 8000.0 / (130.0 / (t * t * t) + 8000.0), 1e-12);
    EXPECT_GT(race_thrust(8.0, 0.5 * kPiLosses), 0.99);
}

// Two thrusters ahead in line, 16 m and 8 diameters apart: the one behind has a loss.
TEST(Losses, ThrusterInARaceLoses) {
    Held h;
    h.thruster("fore", 8.0, 0.0);
    h.thruster("aft", -8.0, 0.0);
    h.def.thruster_losses = true;
    h.world.add(h.def);
    h.set("fore", 1.0);
    h.set("aft", 1.0);
    h.run(1.0);
    EXPECT_NEAR(h.get("fore_thrust"), 1e5, 1e-6);
    EXPECT_NEAR(h.get("aft_thrust"), 1e5 * (1.0 - std::pow(0.75, 4.0)), 1.0);
    EXPECT_NEAR(h.get("aft_loss"), std::pow(0.75, 4.0), 1e-5);
    // With half the load of the race, √¼ of the loss.
    h.set("fore", 0.5);
    h.run(1.0);
    EXPECT_NEAR(h.get("aft_loss"), 0.5 * std::pow(0.75, 4.0), 1e-5);
    // Astern, the race of the aft thruster reaches the other; abeam none does.
    h.set("fore", 1.0);
    h.set("aft", -1.0);
    h.set("fore_angle", 0.5 * kPiLosses);
    h.run(1.0);
    EXPECT_NEAR(h.get("aft_loss"), 0.0, 0.01);
    EXPECT_GT(h.get("fore_loss"), 0.2);
}

TEST(Losses, RaceUnderTheHullLoses) {
    Held h;
    h.thruster("port", 0.0, 5.0).hull_loss = 0.03;
    h.world.add(h.def);
    h.set("port", 1.0);
    for (const auto& [angle, loss] : {std::pair<double, double>{0.0, 0.0},
                                      {-0.5 * kPiLosses, 0.03},  // pushes to port, race inboard
                                      {0.5 * kPiLosses, 0.0}}) {
        h.set("port_angle", angle);
        h.run(1.0);
        EXPECT_NEAR(h.get("port_loss"), loss, 1e-12) << angle;
    }
}

// Depth of the hub from the public sea, as the ship keeps its position.
TEST(Losses, HubNearTheSurfaceVentilatesInWaves) {
    Held h;
    SeaDef sea{.depth = 100.0};
    sea.waves.push_back({.kind = WaveKind::regular, .height = 3.0, .period = 8.0});
    h.world.add(sea);
    PropulsorDef& p = h.thruster("main", 10.0, 0.0);
    p.point.z() = -1.5;
    p.ventilates = true;
    h.world.add(h.def);
    h.set("main", 1.0);
    const Sea water(sea);
    double least = 1.0, most = 0.0;
    for (int i = 0; i < 600; ++i) {
        const double time = h.world.time();
        h.run(1.0 / 60.0);
        const double depth = water.elevation(water.at(time), 10.0, 0.0) + 1.5;
        const double kept = ventilated_thrust(depth);  // radius 1 m
        if (i > 0) {
            EXPECT_NEAR(h.get("main_loss"), 1.0 - kept, 1e-6) << time;
        }
        least = std::min(least, kept);
        most = std::max(most, kept);
    }
    EXPECT_LT(least, 0.4);
    EXPECT_EQ(most, 1.0);
}

TEST(Failures, PropulsorsStopStayOrRunAway) {
    Held h;
    h.thruster("az", 0.0, 0.0).ramp = 1.0;
    h.world.add(h.def);
    h.set("az", 0.5);
    h.set("az_angle", 0.7);
    h.run(2.0);
    h.set("az_failed", 2.0);
    h.set("az", -1.0);
    h.set("az_angle", 2.0);
    h.run(2.0);
    EXPECT_NEAR(h.get("az_thrust"), 2.5e4, 1e-6);
    EXPECT_NEAR(h.get("az_turned"), 0.7, 1e-12);
    h.set("az_failed", 3.0);
    h.run(2.0);
    EXPECT_NEAR(h.get("az_thrust"), 1e5, 1e-6);
    h.set("az_failed", 1.0);
    h.run(2.0);
    EXPECT_EQ(h.get("az_thrust"), 0.0);
    EXPECT_NEAR(h.get("az_turned"), 0.7, 1e-12);
    EXPECT_EQ(h.world.events().extremes(EventKind::failure).count, 3);
    h.set("az_failed", 0.0);
    h.run(2.0);
    EXPECT_NEAR(h.get("az_thrust"), -1e5, 1e-6);
    EXPECT_NEAR(h.get("az_turned"), 2.0, 1e-12);
}

TEST(Failures, StoppedShaftRunsDownWithoutPower) {
    Held h;
    PropulsorDef p;
    p.name = "main";
    p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = 1.2};
    p.most_rps = 2.0;
    p.shaft_inertia = 2e4;
    h.def.propulsors.push_back(p);
    h.world.add(h.def);
    h.set("main", 1.0);
    h.run(20.0);
    EXPECT_NEAR(h.get("main_rps"), 2.0, 1e-6);
    h.set("main_failed", 1.0);
    h.run(1.0);
    EXPECT_EQ(h.get("main_power"), 0.0);
    h.run(30.0);
    // 2πI ṅ = −cn²: n = 1/(1/n₀ + ct/(2πI)) with c = K_Qρ D⁵; K_Q(0) .066829 of the published
    // table.
    const double c = 0.066829 * 1025.0 * std::pow(4.0, 5.0);
    const double n = 1.0 / (0.5 + c * 31.0 / (2.0 * kPiLosses * 2e4));
    EXPECT_NEAR(h.get("main_rps"), n, 0.03 * n);  // first order in the step, largest at the start
}

// A pitch at its rate is reported once; the torque of the water is that of the published table.
TEST(Actuators, PitchRateIsReportedAndTorqueIsAnOutput) {
    Held h;
    PropulsorDef p;
    p.name = "main";
    p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = 1.2};
    p.most_rps = 2.0;
    p.controllable = true;
    p.pitch_time = 4.0;
    h.def.propulsors.push_back(p);
    h.world.add(h.def);
    h.set("main", 1.0);
    h.run(1.0);
    EXPECT_NEAR(h.get("main_torque"), 0.066829 * 1025.0 * 4.0 * std::pow(4.0, 5.0), 300.0);
    EXPECT_EQ(h.world.events().extremes(EventKind::saturation).count, 0);
    h.set("main_pitch", -1.0);
    h.run(4.0);
    EXPECT_NEAR(h.get("main_set"), 0.0, 0.005);
    h.run(5.0);
    EXPECT_EQ(h.get("main_set"), -1.0);
    EXPECT_EQ(h.world.events().extremes(EventKind::saturation).count, 1);
    EXPECT_NEAR(h.world.events().extremes(EventKind::saturation).worst.value, 0.25, 1e-12);
}

TEST(Failures, RuddersJamOrGoHardOver) {
    Held h;
    RudderDef r;
    r.area = 10.0;
    h.def.rudders.push_back(r);
    h.world.add(h.def);
    h.set("rudder", 0.2);
    h.run(20.0);
    h.set("rudder_failed", 1.0);
    h.set("rudder", -0.2);
    h.run(20.0);
    EXPECT_NEAR(h.get("rudder_at"), 0.2, 1e-12);
    h.set("rudder_failed", 2.0);
    h.run(40.0);
    EXPECT_NEAR(h.get("rudder_at"), r.most_angle, 1e-12);
    h.set("rudder_failed", 3.0);
    h.run(40.0);
    EXPECT_NEAR(h.get("rudder_at"), -r.most_angle, 1e-12);
    EXPECT_EQ(h.world.events().extremes(EventKind::failure).count, 3);
}

// From full ahead to full astern in `ramp`, straight through zero, without a sideways component.
TEST(Cycloidal, VectorGoesStraight) {
    Held h;
    PropulsorDef& p = h.thruster("voith", 0.0, 0.0);
    p.kind = PropulsorKind::cycloidal;
    p.ramp = 3.0;
    h.world.add(h.def);
    const auto ahead = [&] { return h.get("voith_thrust") * std::cos(h.get("voith_turned")); };
    const auto aside = [&] { return h.get("voith_thrust") * std::sin(h.get("voith_turned")); };
    h.set("voith", 1.0);
    h.run(3.0);
    EXPECT_NEAR(ahead(), 1e5, 1e-6);
    h.set("voith_angle", kPiLosses);
    h.run(1.5);
    EXPECT_LT(std::abs(h.get("voith_thrust")), 1e5 * 0.02 * 0.02);  // midway: no thrust
    for (int i = 0; i < 92; ++i) {
        h.run(1.0 / 60.0);
        EXPECT_NEAR(aside(), 0.0, 1e-6) << i;
    }
    EXPECT_NEAR(ahead(), -1e5, 1e-6);
    h.set("voith_angle", 0.5 * kPiLosses);
    h.set("voith", 0.5);
    h.run(3.0);
    EXPECT_NEAR(aside(), 2.5e4, 1e-6);
    EXPECT_NEAR(ahead(), 0.0, 1e-6);
}

TEST(CurrentLoad, MeetsItsTableOnBothSides) {
    CurrentLoad load;
    load.length = 80.0;
    load.draught = 6.0;
    load.points = {
        {0.0, -0.05, 0.0, 0.0}, {0.5 * kPiLosses, 0.01, -0.6, 0.02}, {kPiLosses, 0.06, 0.0, 0.0}};
    vessel::Flow flow;
    flow.density = 1025.0;
    const double q = 0.5 * 1025.0 * 80.0 * 6.0;
    flow.motion[0] = 2.0;  // ahead: water from ahead
    EXPECT_NEAR(vessel::current_force(load, flow)[0], -0.05 * q * 4.0, 1e-6);
    flow.motion[0] = 0.0;
    flow.motion[1] = -1.0;  // to port: water from port pushes to starboard
    const vessel::Wrench port = vessel::current_force(load, flow);
    EXPECT_NEAR(port[1], 0.6 * q, 1e-6);
    EXPECT_NEAR(port[5], -0.02 * q * 80.0, 1e-6);
    flow.motion[0] = 1.0;
    flow.motion[1] = 1.0;  // 45° from starboard: midway between two points
    const vessel::Wrench bow = vessel::current_force(load, flow);
    EXPECT_NEAR(bow[0], -0.02 * q * 2.0, 1e-6);
    EXPECT_NEAR(bow[1], -0.3 * q * 2.0, 1e-6);
    EXPECT_NEAR(bow[5], 0.01 * q * 2.0 * 80.0, 1e-5);
}

}  // namespace
}  // namespace hawser::test
