// SPDX-License-Identifier: Apache-2.0
/// DNV-ST-0111 Level 1: parts by hand, programs beside closed forms, a solved test ship.
#include <hawser/dp_capability.h>
#include <hawser/hawser.h>
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include "vessel/dp_star.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kDpDeg = std::numbers::pi / 180.0;

/// Return the data of scenes/dp_ship.json, without its failures.
DpShip solved_ship() {
    const scene::Scene scene = scene::load_file("scenes/dp_ship.json");
    for (const BodyId body : scene.world.bodies())
        if (const VesselDef* vessel = find_vessel(scene.world, body))
            if (vessel->dp_capability) {
                DpShip out = *vessel->dp_capability;
                out.failures.clear();
                return out;
            }
    ADD_FAILURE() << "scenes/dp_ship.json has no dp_capability";
    return {};
}

// Printed digits of a ship solved apart.
TEST(DpCapability, LoadsOfATestShip) {
    const DpShip ship = solved_ship();
    const DpLoad a = dp_loads(ship, dp_condition(6), 30.0 * kDpDeg).total;
    EXPECT_NEAR(1e-3 * a.x, -54.39, 0.0051);
    EXPECT_NEAR(1e-3 * a.y, 178.98, 0.0051);
    EXPECT_NEAR(1e-3 * a.n, 2371.44, 0.0051);
    const DpLoad b = dp_loads(ship, dp_condition(8), 330.0 * kDpDeg).total;
    EXPECT_NEAR(1e-3 * b.x, -120.48, 0.0051);
    EXPECT_NEAR(1e-3 * b.y, -332.11, 0.0051);
    EXPECT_NEAR(1e-3 * b.n, -4104.00, 0.0051);
}

TEST(DpCapability, ThrustAstern) {
    DpThruster t = solved_ship().thrusters[0];
    EXPECT_NEAR(1e-3 * dp_nominal_thrust(t, true), 264.262, 5e-4);
    t.propeller = DpPropeller::open;
    const double ahead = dp_nominal_thrust(t, false);
    EXPECT_DOUBLE_EQ(dp_nominal_thrust(t, true), 0.9 * ahead);
    t.controllable = true;
    EXPECT_DOUBLE_EQ(dp_nominal_thrust(t, true), 0.65 * ahead);
    t.propeller = DpPropeller::ducted;
    EXPECT_DOUBLE_EQ(dp_nominal_thrust(t, true), 0.5 * dp_nominal_thrust(t, false));
}

TEST(DpCapability, ZonesSkegAndRudder) {
    const DpShip ship = solved_ship();
    const auto zones = dp_forbidden_zones(ship, 0, {});
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].from / kDpDeg, 69.56, 0.005);
    EXPECT_NEAR(zones[0].to / kDpDeg, 110.44, 0.005);
    EXPECT_TRUE(dp_forbidden_zones(ship, 0, {false, true, false, false}).empty());
    double least = 1.0, at = 0.0;
    for (double a = -180.0; a < 180.0; a += 0.01)
        if (const double f = dp_skeg_factor(ship, ship.thrusters[0], a * kDpDeg); f < least) {
            least = f;
            at = a;
        }
    EXPECT_NEAR(least, 0.565, 5e-4);
    EXPECT_NEAR(at, 140.85, 0.015);
    // The other side is the mirror image.
    for (double a = -180.0; a < 180.0; a += 7.0)
        EXPECT_NEAR(dp_skeg_factor(ship, ship.thrusters[0], a * kDpDeg),
                    dp_skeg_factor(ship, ship.thrusters[1], -a * kDpDeg), 1e-12);
    DpThruster shaft;
    shaft.kind = DpThrusterKind::shaft;
    shaft.diameter = 3.0;
    shaft.rudder.area = 9.0;
    const DpRudderForce f = dp_rudder_force(shaft, 30.0 * kDpDeg);
    EXPECT_NEAR(f.x, 0.75052, 5e-6);
    EXPECT_NEAR(f.y, 0.4158, 5e-6);
}

/// Make a ship with one azimuth at the origin and two tunnels, without loads in yaw.
DpShip plain_ship() {
    DpShip s = solved_ship();
    s.skegs.clear();
    s.thrusters.erase(s.thrusters.begin() + 1);
    s.thrusters[0].point = {0.0, 0.0, 1.0};
    return s;
}

// Head-on a single azimuth takes all: U = F/T; with a switchboard U = F/T (P/0.9 P_b)^(2/3).
TEST(DpCapability, HeadOnIsLoadOverThrust) {
    DpShip s = plain_ship();
    const DpCondition at = dp_condition(7);
    const double load = -dp_loads(s, at, 0.0).total.x;
    const double thrust = 0.9 * dp_nominal_thrust(s.thrusters[0], false) *
                          dp_ventilation(s, s.thrusters[0], at, 0.0, false);
    EXPECT_NEAR(dp_utilisation(s, 7, 0.0).value, load / thrust, 1e-9);
    s.switchboards = {{"a", 1e6, {"AZ1"}}};
    const double limited = load / thrust * std::pow(2e6 / 0.9e6, 2.0 / 3.0);
    EXPECT_NEAR(dp_utilisation(s, 7, 0.0).value, limited, 1e-5 * limited);
    s.switchboards = {{"a", 1e7, {"AZ1"}}};
    EXPECT_NEAR(dp_utilisation(s, 7, 0.0).value, load / thrust, 1e-9);
}

// Two equal shafts at ±y on one board share the power: r^1.5 · 2 P = 0.9 P_b.
TEST(DpCapability, ShaftsShareASwitchboard) {
    DpShip s = plain_ship();
    s.thrusters.clear();
    for (const double y : {4.0, -4.0}) {
        DpThruster t;
        t.name = y > 0.0 ? "P" : "S";
        t.kind = DpThrusterKind::shaft;
        t.point = {-35.0, y, 2.0};
        t.diameter = 3.0;
        t.power = 1e6;
        s.thrusters.push_back(t);
    }
    s.switchboards = {{"a", 1.2e6, {"P", "S"}}};
    const DpCondition at = dp_condition(5);
    const double load = -dp_loads(s, at, 0.0).total.x;
    const double thrust = 1.8 * dp_nominal_thrust(s.thrusters[0], false) *
                          dp_ventilation(s, s.thrusters[0], at, 0.0, false);
    const double expected = load / thrust * std::pow(2e6 / (0.9 * 1.2e6), 2.0 / 3.0);
    EXPECT_NEAR(dp_utilisation(s, 5, 0.0).value, expected, 1e-5 * expected);
    // Shafts without rudders hold nothing abeam.
    EXPECT_TRUE(std::isinf(dp_utilisation(s, 1, 90.0 * kDpDeg).value));
}

// The forces of a solution balance the load, and their fractions are at most U.
TEST(DpCapability, SolutionsBalanceTheLoad) {
    const DpShip ship = solved_ship();
    for (const double from : {0.0, 35.0, 62.0, 90.0, 141.0, 200.0, 277.0, 333.0})
        for (const auto& failed :
             {std::vector<bool>{}, std::vector<bool>{true, false, true, false}}) {
            const DpUtilisation u = dp_utilisation(ship, 5, from * kDpDeg, failed);
            const DpLoad load = dp_loads(ship, dp_condition(5), from * kDpDeg).total;
            double x = load.x, y = load.y, n = load.n;
            for (std::size_t i = 0; i < ship.thrusters.size(); ++i) {
                const DpThrust& t = u.thrusts[i];
                const Vec3& p = ship.thrusters[i].point;
                x += t.x;
                y += t.y;
                n += p.x() * t.y - p.y() * t.x;
                EXPECT_LE(t.fraction, u.value * (1.0 + 1e-6)) << from;
                if (!failed.empty() && failed[i]) {
                    EXPECT_EQ(std::hypot(t.x, t.y), 0.0);
                }
            }
            // Rounding of forces of 1e5 N and levers of 40 m.
            EXPECT_NEAR(x, 0.0, 1e-3);
            EXPECT_NEAR(y, 0.0, 1e-3);
            EXPECT_NEAR(n, 0.0, 0.1);
        }
}

/// Utilisation of number 5 with polygons of another step.
double utilisation_by_arcs(const DpShip& ship, double degrees, double from,
                           const std::vector<bool>& failed) {
    const DpCondition at = dp_condition(5);
    std::vector<vessel::Star> stars;
    for (std::size_t i = 0; i < ship.thrusters.size(); ++i)
        stars.push_back(
            vessel::capacity_star(ship, i, at, from * kDpDeg, failed, degrees * kDpDeg));
    return vessel::smallest_utilisation(stars, {}, dp_loads(ship, at, from * kDpDeg).total).value;
}

// An inscribed polygon promises no thrust beyond the circle, and at least cos(step/2) of it.
TEST(DpCapability, PolygonsApproachTheCircleFromInside) {
    const DpShip ship = solved_ship();
    for (double from = 0.0; from <= 180.0; from += 15.0)
        for (const auto& failed :
             {std::vector<bool>{}, std::vector<bool>{true, false, true, false}}) {
            const double fine = utilisation_by_arcs(ship, 0.5, from, failed);
            const double coarse = utilisation_by_arcs(ship, 10.0, from, failed);
            EXPECT_NEAR(coarse, dp_utilisation(ship, 5, from * kDpDeg, failed).value, 1e-9);
            EXPECT_GE(coarse, fine * (1.0 - 1e-6)) << from;
            EXPECT_LE(coarse, fine / std::cos(5.0 * kDpDeg)) << from;
            // Chords in the dip of a skeg, whose radius is linear in the angle, add to 1 − cos
            // 0.5°.
            EXPECT_LE(utilisation_by_arcs(ship, 1.0, from, failed), fine * 1.0003) << from;
        }
}

TEST(DpCapability, NumbersAndResultOfATestShip) {
    DpShip ship = solved_ship();
    ship.failures = {{"a", {"AZ1", "BT1"}}, {"b", {"AZ2", "BT2"}}};
    const DpCapability c = dp_capability(ship);
    ASSERT_EQ(c.headings.size(), 36u);
    constexpr int kNumbers[] = {11, 11, 9, 8, 7, 7, 6, 6, 6, 6, 6, 7, 7, 8, 8, 9, 10, 11, 11};
    for (std::size_t k = 0; k < 36; ++k)
        EXPECT_EQ(c.headings[k].number, kNumbers[k <= 18 ? k : 36 - k]) << 10 * k;
    EXPECT_NEAR(c.headings[9].utilisation, 0.759, 1e-3);
    EXPECT_NEAR(c.headings[9].next, 1.071, 1e-3);
    EXPECT_EQ(c.text(), "DP capability-L1(8, 6, 5, 3)");
    // Without failures in the data each thruster is one.
    ship.failures.clear();
    EXPECT_EQ(dp_capability(ship, 30.0 * kDpDeg).failures.size(), 4u);
    EXPECT_THROW((void)dp_capability(ship, 25.0 * kDpDeg), DefError);
}

TEST(DpCapability, RefusesDataByItsField) {
    const auto refused = [](const std::function<void(DpShip&)>& change) {
        DpShip s = solved_ship();
        change(s);
        try {
            check_dp_ship(s);
        } catch (const DefError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refused([](DpShip&) {}), "");
    EXPECT_NE(
        refused([](DpShip& s) { s.thrusters[1].diameter = 0.0; }).find("thrusters/1/diameter"),
        std::string::npos);
    EXPECT_NE(refused([](DpShip& s) { s.failures = {{"x", {"AZ3"}}}; }).find("AZ3"),
              std::string::npos);
    EXPECT_NE(refused([](DpShip& s) { s.thrusters[0].point.z() = 7.0; }).find("thrusters/0/point"),
              std::string::npos);
    EXPECT_NE(refused([](DpShip& s) { s.thrusters[0].rudder.area = 3.0; }).find("rudder"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser::test
