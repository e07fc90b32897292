// SPDX-License-Identifier: Apache-2.0
/// Stability gauge (hawser/stability.h).
#include <hawser/hawser.h>
#include <hawser/stability.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

constexpr double kGaugeDegree = 0.0174532925199433;

/// A weightless ship with GZ = GM sin φ, and a towline to a fixed point at 20 degrees to starboard
/// and 10 degrees down.
struct GaugedShip {
    World w{WorldDef{.step = 1.0 / 60.0}};
    BodyId ship{};
    double alpha = 20.0 * kGaugeDegree, beta = 10.0 * kGaugeDegree;

    explicit GaugedShip(double tension, StabilityDef def = {}, bool mirrored = false) {
        const Vec3 pin(-30, -2, 4);
        const Vec3 along(-std::cos(beta) * std::cos(alpha), -std::cos(beta) * std::sin(alpha),
                         -std::sin(beta));
        // Headed to 90 degrees: the gauge reads directions in the ship's frame.
        const Quat turn(Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitZ()));
        ship = w.add_body({.name = "ship",
                           .orientation = turn,
                           .mass = 5e6,
                           .inertia = Vec3(2e8, 2e9, 2e9).asDiagonal(),
                           .gravity = false});
        const BodyId far = w.add_body(
            {.name = "far", .kind = BodyKind::fixed, .position = turn * (pin + 800.0 * along)});
        def.wire = w.wires().add({.name = "tow",
                                  .from = ship,
                                  .from_point = pin,
                                  .to = far,
                                  .elements = 1,
                                  .length = 800.0 / (1.0 + tension / 1e8),
                                  .EA = 1e8,
                                  .mass_per_length = 1.0});
        if (mirrored) {
            // From a fixed point aboard, 2 m inside the pin, to the other side.
            const Vec3 mirror(along.x(), -along.y(), along.z());
            const BodyId aboard = w.add_body({.name = "aboard",
                                              .kind = BodyKind::fixed,
                                              .position = turn * (pin - 2.0 * mirror)});
            const BodyId beyond = w.add_body({.name = "beyond",
                                              .kind = BodyKind::fixed,
                                              .position = turn * (pin + 798.0 * mirror)});
            def.others = {w.wires().add({.name = "chain",
                                         .from = beyond,
                                         .to = aboard,
                                         .elements = 4,
                                         .length = 800.0 / (1.0 + tension / 1e8),
                                         .EA = 1e8,
                                         .mass_per_length = 1e-3})};
        }
        def.name = "gauge";
        def.body = ship;
        def.pin = pin;
        def.thrust_height = -2.0;
        def.gm = 1.2;
        w.add(def);
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok);
    }
    [[nodiscard]] double signal(const char* name) const {
        return w.system_signal(std::string("gauge.") + name);
    }
};

TEST(Stability, ReadsTheWireInTheFrameOfTheShip) {
    GaugedShip g(5e5);
    g.run(2);
    EXPECT_NEAR(g.signal("alpha"), g.alpha, 1e-4);
    EXPECT_NEAR(g.signal("beta"), g.beta, 1e-4);
    EXPECT_NEAR(g.signal("tension"), 5e5, 50.0);  // the ship has moved by a fraction of a mm
    const double moment =
        5e5 * (6.0 * std::sin(g.alpha) * std::cos(g.beta) + 2.0 * std::sin(g.beta));
    EXPECT_NEAR(g.signal("moment"), moment, 2e-4 * moment);
    EXPECT_NEAR(g.signal("lever"), moment / (5e6 * 9.81), 1e-5);
    EXPECT_NEAR(std::tan(g.signal("worst_beta")), 2.0 / (6.0 * std::sin(g.alpha)), 1e-3);
}

TEST(Stability, AddsOtherWiresThatPassTheStern) {
    GaugedShip g(5e5, {}, true);
    g.run(2);
    // Two equal tensions at 20 degrees to both sides: the sum points aft.
    const double aft = 2.0 * 5e5 * std::cos(g.alpha) * std::cos(g.beta);
    const double down = 2.0 * 5e5 * std::sin(g.beta);
    EXPECT_NEAR(g.signal("tension"), std::hypot(aft, down), 200.0);
    EXPECT_NEAR(g.signal("alpha"), 0.0, 2e-4);
    EXPECT_NEAR(g.signal("beta"), std::atan2(down, aft), 2e-4);
    StabilityDef twice;
    twice.others = {WireId{}};
    EXPECT_THROW(GaugedShip(5e5, twice), DefError);
}

TEST(Stability, HeelsAtTheLimitByTheFormula) {
    GaugedShip g(5e5);
    g.run(2);
    // Criterion 1 at 15 degrees: tan φ = HM/(Δ GM), Δ = m g + F sin β.
    const double arm = 6.0 * std::sin(g.alpha) * std::cos(g.beta) + 2.0 * std::sin(g.beta);
    const double k = 1.2 * std::tan(15.0 * kGaugeDegree);
    const double force = k * 5e6 * 9.81 / (arm - k * std::sin(g.beta));
    EXPECT_NEAR(permissible_tension(g.w, "gauge", g.alpha, g.beta), force, 1e-4 * force);
    EXPECT_NEAR(permissible_tension(g.w, "gauge", -g.alpha, g.beta), force, 1e-4 * force);
    EXPECT_EQ(check_stability(g.w, "gauge", 1.001 * force, g.alpha, g.beta).criterion, 1);
    EXPECT_NEAR(g.signal("permissible"), force, 1e-3 * force);
    EXPECT_EQ(g.signal("criterion"), 1.0);
    // Along the centreline and level there is no moment: the weight of the ship bounds it.
    EXPECT_EQ(permissible_tension(g.w, "gauge", 0.0, 0.0), 5e6 * 9.81);
    EXPECT_GT(permissible_tension(g.w, "gauge", 0.1, 0.0),
              permissible_tension(g.w, "gauge", 1.5, 0.0));
}

TEST(Stability, WorstAngleIsBoundedByTheBollardPull) {
    EXPECT_NEAR(worst_towing_angle(1e6, 0.5236, 4.5, 2.0, 0.0), std::atan(2.0 / 2.25), 1e-5);
    // acos(1.5 BP/(F cos α)) = 60 degrees.
    EXPECT_NEAR(worst_towing_angle(3e6, 0.0, 4.5, 0.0, 1e6), 60.0 * kGaugeDegree, 1e-9);
}

TEST(Stability, AlarmsHaveHysteresis) {
    GaugedShip g(1e5, {.warn = 0.8, .hysteresis = 0.05});
    g.run(2);
    EXPECT_EQ(g.signal("alarm"), 0.0);
    const double most = g.signal("permissible");
    const auto pull = [&](double share) {
        // The wire is stretched by its length: an input of the element would do as well.
        GaugedShip other(share * most, {.warn = 0.8, .hysteresis = 0.05});
        other.run(2);
        return other.signal("alarm");
    };
    EXPECT_EQ(pull(0.78), 0.0);
    EXPECT_EQ(pull(0.82), 1.0);
    EXPECT_EQ(pull(1.02), 2.0);
    // A wire that slackens from 0.82 to 0.78 keeps its warning, at 0.7 it ends.
    GaugedShip down(0.82 * most, {.warn = 0.8, .hysteresis = 0.05});
    down.run(2);
    EXPECT_EQ(down.w.events().extremes(EventKind::alarm).count, 1);
    double alarm = 1.0, used = 1.0;
    while (alarm > 0.5 && down.w.time() < 60.0) {  // the ship is drawn to the far end
        used = down.signal("utilisation");
        down.run(1);
        alarm = down.signal("alarm");
    }
    EXPECT_LT(down.signal("utilisation"), 0.75);
    EXPECT_GE(used, 0.749);
    EXPECT_EQ(down.w.events().extremes(EventKind::alarm_end).count, 1);
}

TEST(Stability, RefusesAShipWithoutHullOrWire) {
    const auto refusal = [](auto change) -> std::string {
        GaugedShip g(1e5);
        StabilityDef def{.name = "other", .body = g.ship, .wire = g.w.wires().find("tow")};
        def.thrust_height = 0.0;
        def.gm = 1.0;
        change(def, g.w);
        try {
            g.w.add(def);
        } catch (const DefError& error) {
            return error.what();
        }
        return "accepted";
    };
    const auto none = [](StabilityDef&, World&) {};
    EXPECT_EQ(refusal(none), "accepted");
    EXPECT_NE(refusal([](StabilityDef& d, World&) { d.gm = kDefault; }).find("gm: the body has no"),
              std::string::npos);
    EXPECT_NE(refusal([](StabilityDef& d, World&) { d.wire = {}; }).find("wire: there is no"),
              std::string::npos);
    EXPECT_NE(refusal([](StabilityDef& d, World& w) { d.body = w.find_body("far"); }).find("body:"),
              std::string::npos);
    EXPECT_NE(refusal([](StabilityDef& d, World&) { d.warn = 2.0; }).find("warn: 2"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser::test
