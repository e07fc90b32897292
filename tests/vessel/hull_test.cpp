// SPDX-License-Identifier: Apache-2.0
/// Hull forces as functions, against formulas written separately.
#include <hawser/vessel_hull.h>
#include <hawser/vessel_ships.h>

#include "vessel/hull_forces.h"
#include "vessel/stern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hawser::test {
namespace {

using vessel::Flow;
using vessel::Wrench;

constexpr double kWater = 1025.0;

Flow flow_of(double u, double v, double r, double rudder = 0.0, double rps = 0.0) {
    Flow f;
    f.motion << u, v, 0.0, 0.0, 0.0, r;
    f.rudder = rudder;
    f.rps = rps;
    return f;
}

// Table of MSS, linear between its points.
TEST(Hull, HoernerDrag) {
    EXPECT_NEAR(hoerner_drag(1.8), 0.666411, 1e-5);
    EXPECT_NEAR(hoerner_drag(1.0), 0.82585, 1e-5);
    EXPECT_EQ(hoerner_drag(0.0), hoerner_drag(0.005));
    EXPECT_EQ(hoerner_drag(10.0), hoerner_drag(4.1));
}

TEST(Hull, CrossFlowDragMeetsTheIntegral) {
    const CrossFlow def{.length = 83.0, .beam = 18.0, .draught = 5.0};
    const double c = 0.5 * kWater * 5.0 * 0.666411;
    // Sway alone: C_d L T; exact with any number of strips.
    EXPECT_NEAR(cross_flow_force(def, flow_of(0, 2.0, 0))[1], -c * 83.0 * 4.0, 1e-4 * c * 83 * 4);
    // Yaw alone: c r |r| L^4/32; twenty midpoints give 1 - 1/400 of each half's third moment.
    const double r = 0.03, yaw = c * r * r * std::pow(83.0, 4) / 32.0;
    EXPECT_NEAR(cross_flow_force(def, flow_of(0, 0, r))[5], -0.995 * yaw, 1e-3 * yaw);
    // Steady yaw of a moment of 5 MNm: r = sqrt(64 N/(rho T C_d L^4)) = 0.04443 rad/s.
    EXPECT_NEAR(-cross_flow_force(def, flow_of(0, 0, 4.4432e-2))[5], 5e6, 0.006 * 5e6);
    // The sum of MSS has one more strip.
    CrossFlow ends = def;
    ends.end_strips = true;
    EXPECT_NEAR(cross_flow_force(ends, flow_of(0, 2.0, 0))[1], -1.05 * c * 83.0 * 4.0,
                1e-4 * c * 83 * 4);
    EXPECT_NEAR(cross_flow_force(ends, flow_of(0, 0, r))[5], -1.211 * yaw, 2e-3 * yaw);
}

TEST(Hull, ResistanceIsOddAndContinuous) {
    HullResistance def{.curve = {{0.0, 0.0}, {5.0, 1e5}, {10.0, 6e5}},
                       .linear = 55362.0,
                       .quadratic = 18131.22,
                       .blend = 2.0};
    for (const double u : {0.1, 2.0, 5.0, 9.0, 12.0})
        EXPECT_EQ(vessel::surge_force(def, -u), -vessel::surge_force(def, u));
    EXPECT_EQ(vessel::surge_force(def, 0.0), 0.0);
    def.curve.clear();
    const double u = 3.0, sigma = 1.0 - std::tanh(1.5);
    EXPECT_NEAR(vessel::surge_force(def, u),
                -sigma * 55362.0 * u - (1.0 - sigma) * 18131.22 * u * u, 1e-6);
    def.linear = def.quadratic = 0.0;
    def.curve = {{0.0, 0.0}, {5.0, 1e5}, {10.0, 6e5}};
    EXPECT_NEAR(vessel::surge_force(def, 7.0), -3e5, 1e-6);
    EXPECT_NEAR(vessel::surge_force(def, 20.0), -24e5, 1e-6);  // quadratic beyond the last point
}

// Equation of the MMG standard method at one state, written out.
TEST(Hull, MmgPolynomialAndSternMeetTheFormula) {
    const PublishedShip ship = kvlcc2(KvlccScale::l7);
    const double u = 1.0, v = -0.2, r = 0.04, d = 0.3, n = 11.0, L = 7.0;
    const double U = std::hypot(u, v), vp = v / U, rp = r * L / U;
    const double q = 0.5 * kWater * L * 0.46 * U * U;
    const double x =
        -0.022 - 0.040 * vp * vp + 0.002 * vp * rp + 0.011 * rp * rp + 0.771 * std::pow(vp, 4);
    const double y = -0.315 * vp + 0.083 * rp - 1.607 * vp * vp * vp + 0.379 * vp * vp * rp -
                     0.391 * vp * rp * rp + 0.008 * rp * rp * rp;
    const double nn = -0.137 * vp - 0.049 * rp - 0.030 * vp * vp * vp - 0.294 * vp * vp * rp +
                      0.055 * vp * rp * rp - 0.013 * rp * rp * rp;
    const vessel::Polynomial polynomial(ship.vessel.polynomial, ship.body.mass);
    const Wrench hull = polynomial.force(flow_of(u, v, r, d, n));
    EXPECT_NEAR(hull[0], q * x, 1e-9 * q);
    EXPECT_NEAR(hull[1], q * y, 1e-9 * q);
    EXPECT_NEAR(hull[5], q * L * nn, 1e-9 * q * L);

    const double beta = std::atan2(-v, u), bp = beta + 0.48 * rp, D = 0.216;
    const double w = (1.0 - 0.40) * (1.0 + (1.0 - std::exp(-2.0 * std::abs(bp))) * 0.6);
    const double J = u * w / (n * D), kt = 0.2931 - 0.2753 * J - 0.1385 * J * J;
    const double T = kWater * n * n * std::pow(D, 4) * kt, eta = D / 0.345;
    const double ratio = std::sqrt(1.0 + 8.0 * kt / (std::numbers::pi * J * J));
    const double ur =
        1.09 * u * w * std::sqrt(eta * std::pow(1.0 + 0.50 * (ratio - 1.0), 2) + 1.0 - eta);
    const double br = beta + 0.710 * rp, vr = U * (br < 0 ? 0.395 : 0.640) * br;
    const double fn =
        0.5 * kWater * 0.0539 * (ur * ur + vr * vr) * 2.747 * std::sin(d - std::atan2(vr, ur));
    const Wrench stern = vessel::stern_force(ship.vessel.mmg, flow_of(u, v, r, d, n));
    EXPECT_NEAR(stern[0], 0.78 * T - (1.0 - 0.387) * fn * std::sin(d), 1e-9 * T);
    EXPECT_NEAR(stern[1], -1.312 * fn * std::cos(d), 1e-9 * fn);
    EXPECT_NEAR(stern[5], -(-0.5 + 0.312 * -0.464) * L * fn * std::cos(d), 1e-9 * fn * L);
}

// Berlekom and Goddard's equations at one state in shallow water, written out.
TEST(Hull, EssoPolynomialMeetsTheFormula) {
    const PublishedShip ship = esso_190k(25.0);
    const double L = 304.8, z = 18.46 / (25.0 - 18.46), u = 5.0, v = -0.8, r = 0.006;
    const double n = 80.0 / 60.0, d = -0.2;  // angle with the sign of the source
    const double c2 = 0.605 * u * n + 38.2 * n * n, b = std::atan(v / u);
    const double lg = -0.00695 * u * u - 0.00063 * L * u * n + 0.0000354 * L * L * n * n;
    const double x = (-0.0377 * u * u + 2.020 * L * v * r + 0.3 * v * v - 0.093 * c2 * d * d +
                      0.152 * c2 * b * d + lg * 0.78 - 0.0061 * u * u * z + 0.387 * L * v * r * z +
                      0.0125 * v * v * z * z) /
                     L;
    const double yuvz = -0.85 * (1.0 - 0.8 / z);
    const double y = (-1.205 * u * v - 2.4 * std::abs(v) * v + 0.208 * c2 * d - 0.752 * L * u * r -
                      2.16 * c2 * std::abs(b) * b * std::abs(d) + 0.04 * lg +
                      0.182 * L * u * r * z + yuvz * u * v * z - 1.5 * std::abs(v) * v * z -
                      0.191 * c2 * std::abs(b) * b * std::abs(d) * z) /
                     L;
    const double nn = (-0.451 * u * v - 0.3 * L * std::abs(v) * r - 0.098 * c2 * d -
                       0.231 * L * u * r + 0.688 * c2 * std::abs(b) * b * std::abs(d) - 0.02 * lg -
                       0.047 * L * u * r * z - 0.241 * u * v * z - 0.12 * L * std::abs(v) * r * z +
                       0.344 * c2 * std::abs(b) * b * std::abs(d) * z) /
                      (L * L);
    const vessel::Polynomial polynomial(ship.vessel.polynomial, ship.body.mass);
    const Wrench f = polynomial.force(flow_of(u, v, r, -d, n));
    const double m = ship.body.mass;
    EXPECT_NEAR(f[0], m * x, 1e-9 * m);
    EXPECT_NEAR(f[1], m * y, 1e-9 * m);
    EXPECT_NEAR(f[5], m * L * L * nn, 1e-9 * m * L);
}

// Coefficients describe ships that go ahead. At rest and astern forces stay finite, and the hull
// dissipates energy.
TEST(Hull, PolynomialsAreFiniteAtRestAndBrakeAstern) {
    for (const char* name : kPublishedShips) {
        const PublishedShip ship = published_ship(name);
        if (ship.vessel.polynomial.terms.empty()) continue;
        const vessel::Polynomial p(ship.vessel.polynomial, ship.body.mass);
        const double speed = ship.speed, length = ship.length;
        EXPECT_TRUE(p.force(flow_of(0, 0, 0)).allFinite()) << name;
        // Rotation at rest is resisted; the terms of Mariner and tanker have no resistance there.
        const double r = 0.3 * speed / length;
        if (ship.vessel.mmg.diameter > 0.0 || ship.vessel.son_nomoto.diameter > 0.0) {
            EXPECT_LT(p.force(flow_of(0, 0, r))[5] * r, 0.0) << name;
        }
        // Astern, the hull alone pushes ahead.
        EXPECT_GT(p.force(flow_of(-0.5 * speed, 0, 0))[0], 0.0) << name;
        EXPECT_LT(p.force(flow_of(0, 0.3 * speed, 0))[1], 0.0) << name;
        // Forces are continuous between ahead and astern.
        Wrench before = p.force(flow_of(0.2 * speed, 0.5 * speed, 0));
        const double size = before.head<2>().norm();
        for (int i = 1; i <= 400; ++i) {
            const Wrench now = p.force(flow_of((0.2 - 0.001 * i) * speed, 0.5 * speed, 0));
            EXPECT_LT((now - before).head<2>().norm(), 0.05 * size) << name << " " << i;
            before = now;
        }
    }
}

TEST(Hull, SternsAreFiniteAtRest) {
    for (const char* name : {"kvlcc2", "s175"}) {
        const PublishedShip ship = published_ship(name);
        const VesselDef& v = ship.vessel;
        for (const double n : {0.0, v.steering.rps, -v.steering.rps})
            for (const double u : {0.0, ship.speed, -ship.speed}) {
                const Flow f = flow_of(u, 0.0, 1e-3, 0.5, n);
                const Wrench w =
                    vessel::stern_force(v.mmg, f) + vessel::stern_force(v.son_nomoto, f);
                EXPECT_TRUE(w.allFinite()) << name << " " << n << " " << u;
            }
        // The propeller pushes ahead at rest.
        const Flow rest = flow_of(0, 0, 0, 0.0, v.steering.rps);
        EXPECT_GT((vessel::stern_force(v.mmg, rest) + vessel::stern_force(v.son_nomoto, rest))[0],
                  0.0);
    }
}

TEST(Wind, BlendermannMeetsTheFormula) {
    const WindLoad load{.ship = WindShip::offshore_supply,
                        .frontal_area = 200.0,
                        .lateral_area = 500.0,
                        .length = 80.0,
                        .centre = 4.0,
                        .height = 5.0};
    const double pi = std::numbers::pi;
    EXPECT_NEAR(wind_coefficients(load, 0.0).x, -0.55, 1e-12);
    EXPECT_NEAR(wind_coefficients(load, pi).x, 0.80, 1e-12);
    EXPECT_NEAR(wind_coefficients(load, 0.5 * pi).y, -0.90,
                1e-12);  // from starboard: force to port
    const double e = 0.25 * pi, lateral = 0.55 * 200.0 / 500.0;
    const double share = 1.0 - 0.5 * 0.55 * (1.0 - lateral / 0.90);
    const WindCoefficients c = wind_coefficients(load, e);
    EXPECT_NEAR(c.x, -0.55 * std::cos(e) / share, 1e-12);
    EXPECT_NEAR(c.y, -0.90 * std::sin(e) / share, 1e-12);
    EXPECT_NEAR(c.n, (4.0 / 80.0 - 0.18 * (e - 0.5 * pi)) * c.y, 1e-12);
    EXPECT_NEAR(c.k, 1.2 * 5.0 / (500.0 / 80.0) * c.y, 1e-12);
    const WindCoefficients port = wind_coefficients(load, -e);
    EXPECT_EQ(port.x, c.x);
    EXPECT_EQ(port.y, -c.y);
    EXPECT_EQ(port.n, -c.n);
}

}  // namespace
}  // namespace hawser::test
