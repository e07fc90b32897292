// SPDX-License-Identifier: Apache-2.0
/// Propulsors and rudders of vessels.
#include <hawser/hawser.h>
#include <hawser/vessel_ships.h>

#include "vessel/actuators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace hawser::test {
namespace {

constexpr double kSea = 1025.0;

TEST(Actuators, FollowIsLimitedInRateThenExponential) {
    double x = 0.0;
    // Rate 2, time constant 0.5: constant rate down to an error of 1, then e^(-t/0.5).
    EXPECT_TRUE(vessel::follow(x, 5.0, 2.0, 0.5, 1.0));
    EXPECT_DOUBLE_EQ(x, 2.0);
    EXPECT_FALSE(vessel::follow(x, 5.0, 2.0, 0.5, 1.5));  // 1 s to an error of 1, and 0.5 s more
    EXPECT_NEAR(x, 5.0 - std::exp(-1.0), 1e-12);
    double y = 0.0;
    for (int i = 0; i < 250; ++i) (void)vessel::follow(y, 5.0, 2.0, 0.5, 0.01);
    EXPECT_NEAR(y, x, 1e-12);  // for any step
    double z = 1.0;
    EXPECT_FALSE(vessel::follow(z, 0.5, 2.0, 0.0, 1.0));
    EXPECT_EQ(z, 0.5);
}

TEST(Actuators, RudderStallsAndIsOdd) {
    const RudderDef r{.area = 10.0, .aspect = 1.5};
    const double slope = 6.13 * 1.5 / 3.75;
    EXPECT_NEAR(rudder_normal(r, 0.2), slope * std::sin(0.2), 1e-12);
    EXPECT_NEAR(rudder_normal(r, 1.0), 1.2 * std::sin(1.0), 1e-12);
    EXPECT_LT(rudder_normal(r, r.stall + 0.17), rudder_normal(r, r.stall));
    for (const double a : {0.1, 0.7, 1.5, 2.5, 3.1})
        EXPECT_EQ(rudder_normal(r, -a), -rudder_normal(r, a));
    EXPECT_NEAR(rudder_normal(r, std::numbers::pi - 0.2), 0.5 * slope * std::sin(0.2), 1e-9);
    double before = 0.0;
    for (int i = 1; i <= 3140; ++i) {
        const double now = rudder_normal(r, 0.001 * i);
        EXPECT_LT(std::abs(now - before), 0.05) << i;
        before = now;
    }
}

/// Moment about O of a force at a point, by the cross product.
TEST(Actuators, PropulsorsPushWhereTheyStand) {
    PropulsorDef def;
    def.name = "az";
    def.kind = PropulsorKind::azimuth;
    def.point = {-40.0, 7.0, -3.0};  // port side, below
    def.thrust = 1e5;
    const vessel::Propulsor p(def, Vec3(2.0, 0.0, -1.0));
    vessel::PropulsorState s;
    s.level = 0.5;
    s.angle = 0.3;
    vessel::Flow flow;
    const vessel::Wrench f = p.force(s, flow);
    const Vec3 force(2.5e4 * std::cos(0.3), 2.5e4 * std::sin(0.3), 0.0);
    const Vec3 at(-42.0, -7.0, 2.0);  // marine frame from O
    EXPECT_NEAR((f.head<3>() - force).norm(), 0.0, 1e-9);
    EXPECT_NEAR((f.tail<3>() - at.cross(force)).norm(), 0.0, 1e-6);
    s.level = -1.0;
    def.astern = 0.6;
    EXPECT_NEAR(vessel::Propulsor(def, Vec3::Zero()).force(s, flow).head<3>().norm(), 6e4, 1e-9);
    def.kind = PropulsorKind::tunnel;
    def.lost_at = 4.0;
    flow.motion[0] = 1.0;
    const vessel::Wrench t = vessel::Propulsor(def, Vec3::Zero()).force(s, flow);
    EXPECT_NEAR(t[1], -0.75 * 6e4, 1e-9);
    EXPECT_EQ(t[0], 0.0);
}

TEST(Actuators, RudderInTheSlipstreamMeetsMomentumTheory) {
    RudderDef def{.area = 20.0, .aspect = 1.5, .covered = 0.8, .slipstream = 0.5};
    const vessel::Rudder rudder(def, Vec3::Zero(), 0);
    vessel::RudderState s;
    s.angle = 0.25;
    vessel::Flow flow;
    flow.motion[0] = 4.0;
    const double thrust = 5e5, d = 4.0;
    const double jet = std::sqrt(16.0 + 8.0 * thrust / (std::numbers::pi * kSea * d * d));
    const double inner = 4.0 + 0.5 * (jet - 4.0);
    const double square = 0.8 * inner * inner + 0.2 * 16.0;
    const double normal = 0.5 * kSea * 20.0 * square * 6.13 * 1.5 / 3.75 * std::sin(0.25);
    const vessel::Wrench f = rudder.force(s, flow, thrust, d);
    EXPECT_NEAR(f[0], -normal * std::sin(0.25), 1e-6 * normal);
    EXPECT_NEAR(f[1], -normal * std::cos(0.25), 1e-6 * normal);
    // At rest only the slipstream of the propeller makes a rudder force; without both it is 0.
    flow.motion[0] = 0.0;
    EXPECT_LT(rudder.force(s, flow, thrust, d)[1], 0.0);
    EXPECT_EQ(rudder.force(s, flow, 0.0, 0.0)[1], 0.0);
}

/// A hull with one shaft: 8,000 t, a Ka4-70 of 4 m with 5 MW.
struct Tug {
    World world{WorldDef{.step = 1.0 / 60.0}};
    VesselDef def;
    explicit Tug(double power, double speed = 0.0, double resistance = 1e9) {
        BodyDef body{.name = "tug", .mass = 8e6, .inertia = 1e9 * Mat3::Identity()};
        body.gravity = false;
        body.velocity = {speed, 0, 0};
        def.name = "tug";
        def.body = world.add_body(body);
        def.resistance.linear = resistance;  // stays at rest
        def.resistance.blend = 100.0;
        PropulsorDef p;
        p.name = "main";
        p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = 1.2};
        p.most_rps = 3.0;
        p.shaft_inertia = 2e4;
        p.most_power = power;
        def.propulsors.push_back(p);
    }
    void add() { world.add(def); }
    void run(double seconds) {
        for (long i = std::lround(seconds * 60.0); i > 0; --i)
            ASSERT_EQ(world.step(), Status::ok) << to_string(world.bad_load(), world);
    }
    [[nodiscard]] double get(const char* name) const {
        return world.system_signal(std::string("tug.") + name);
    }
};

// A motor at its power limit turns the propeller at the speed given by the series.
TEST(Propulsors, PowerLimitGivesTheBollardPull) {
    Tug t(5e6);
    t.add();
    t.world.set_system_signal("tug.main", 1.0);
    t.run(60.0);
    EXPECT_NEAR(t.get("main_thrust") * 1e-3, 919.2, 0.005 * 919.2);
    EXPECT_NEAR(t.get("main_rps"), 2.2470, 0.005 * 2.2470);
    EXPECT_NEAR(t.get("main_power"), 5e6, 1e-3 * 5e6);
    EXPECT_EQ(t.world.events().extremes(EventKind::saturation).count, 1);
    EXPECT_NEAR(t.world.events().extremes(EventKind::saturation).worst.value, 5e6, 1e-2 * 5e6);
}

TEST(Propulsors, ShaftFollowsItsOrderWithinItsLimits) {
    Tug t(0.0);
    t.def.propulsors[0].response = 2.0;
    t.add();
    t.world.set_system_signal("tug.main", 0.5);
    t.run(2.0);
    EXPECT_NEAR(t.get("main_rps"), 1.5 * (1.0 - std::exp(-1.0)), 0.01);
    t.run(30.0);
    EXPECT_NEAR(t.get("main_rps"), 1.5, 1e-6);
    EXPECT_EQ(t.world.events().extremes(EventKind::saturation).count, 0);
}

// The water turns a light shaft without motor torque: stable for any inertia.
TEST(Propulsors, WindmillsAndStopsWithoutNoise) {
    for (const double inertia : {1.0, 1e3, 1e6}) {
        Tug t(0.0, 5.0, 0.0);
        t.def.propulsors[0].most_torque = 1.0;
        t.def.resistance.quadratic = 100.0;
        t.def.propulsors[0].shaft_inertia = inertia;
        t.add();
        t.run(20.0);
        double before = t.get("main_rps");
        double most = 0.0;
        for (int i = 0; i < 60; ++i) {
            t.run(1.0 / 60.0);
            most = std::max(most, std::abs(t.get("main_rps") - before));
            before = t.get("main_rps");
        }
        EXPECT_GT(before, 0.0) << inertia;  // it windmills
        EXPECT_LT(most, 0.05) << inertia;
    }
}

TEST(Propulsors, ControllablePitchReversesThrust) {
    Tug t(0.0);
    t.def.propulsors[0].controllable = true;
    t.def.propulsors[0].pitch_time = 10.0;
    t.add();
    t.world.set_system_signal("tug.main", 0.5);
    t.run(20.0);
    const double ahead = t.get("main_thrust");
    EXPECT_GT(ahead, 0.0);
    t.world.set_system_signal("tug.main_pitch", -1.0);
    t.run(10.0);
    EXPECT_NEAR(t.get("main_set"), 0.0, 1e-6);
    EXPECT_NEAR(t.get("main_thrust"), 0.0, 0.01 * ahead);
    t.run(11.0);
    EXPECT_NEAR(t.get("main_thrust"), -ahead, 1e-3 * ahead);  // mirror image at rest
}

TEST(Propulsors, AzimuthTurnsTheShorterWayAndReportsItsRate) {
    PublishedShip ship = osv();
    World world(WorldDef{.step = 1.0 / 60.0});
    ship.vessel.body = world.add_body(ship.body);
    ship.vessel.propulsors[2].turn_rate = 0.2;
    world.add(ship.vessel);
    world.set_system_signal("osv.port_angle", 3.0);
    for (int i = 0; i < 60 * 20; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_NEAR(world.system_signal("osv.port_turned"), 3.0, 1e-9);
    EXPECT_EQ(world.events().extremes(EventKind::saturation).count, 1);
    EXPECT_DOUBLE_EQ(world.events().extremes(EventKind::saturation).worst.value, 0.2);
    world.set_system_signal("osv.port_angle", -3.0);  // over pi: 0.283 rad
    for (int i = 0; i < 60 * 2; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_NEAR(world.system_signal("osv.port_turned"), -3.0, 1e-9);
}

}  // namespace
}  // namespace hawser::test
