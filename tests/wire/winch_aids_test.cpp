// SPDX-License-Identifier: Apache-2.0
/// Overload protection and heave compensation of winches.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kAidsLimit = 1e6;

WinchDef winch_with_aids(WireId wire) {
    return {.name = "winch",
            .wire = wire,
            .core_radius = 0.6,
            .width = 2.0,
            .wire_diameter = 0.05,
            .mass_per_length = 10.0,
            .element = 0.0,
            .stored = 600.0,
            .inertia = 2e4,
            .motor_inertia = 2e4,
            .brake_static = 5e6};
}

/// A winch ashore and a ship that drifts off at 1 m/s on a wire of 100 m.
struct DriftingShip {
    World w{WorldDef{.step = 1.0 / 60.0}};
    WireId wire{};
    BodyId drum{};

    explicit DriftingShip(double limit, double mass = 1e8, double retained = 0.0) {
        const BodyId shore = w.add_body({.name = "shore", .kind = BodyKind::fixed});
        const BodyId ship = w.add_body({.name = "ship",
                                        .position = {100, 0, 0},
                                        .velocity = {1, 0, 0},
                                        .mass = mass,
                                        .inertia = 1e9 * Mat3::Identity(),
                                        .gravity = false});
        wire = w.wires().add({.name = "wire",
                              .from = shore,
                              .to = ship,
                              .elements = 1,
                              .length = 100.0,
                              .EA = 1e8,
                              .mass_per_length = 10.0,
                              .breaking_load = 1.1 * kAidsLimit});
        WinchDef def = winch_with_aids(wire);
        def.overload_limit = limit;
        def.overload_retained = retained;
        drum = w.add(def).drum;
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok);
    }
    [[nodiscard]] double signal(const char* name) const {
        return w.system_signal(std::string("winch.") + name);
    }
};

TEST(WinchAids, ProtectionPaysOutAtItsLimit) {
    DriftingShip bare(0.0);
    bare.run(600);
    EXPECT_FALSE(bare.w.intact(bare.w.wires().elements(bare.wire).front()));
    DriftingShip held(kAidsLimit);
    held.run(90);
    double least = 1e300, most = 0.0;
    for (int i = 0; i < 600; ++i) {
        held.run(1);
        least = std::min(least, held.signal("pull"));
        most = std::max(most, held.signal("pull"));
    }
    EXPECT_NEAR(least, kAidsLimit, 1e-3 * kAidsLimit);  // 1e-4 of the drum's inertia is left
    EXPECT_NEAR(most, kAidsLimit, 1e-3 * kAidsLimit);
    EXPECT_TRUE(held.w.intact(held.w.wires().elements(held.wire).front()));
    EXPECT_EQ(held.signal("overload"), 1.0);
    EXPECT_NEAR(held.signal("wire_out"), 100.0 + held.signal("overload_out"), 0.02);
    EXPECT_EQ(held.w.events().extremes(EventKind::render).count, 1);
    // The ship loses limit times wire, and the elastic energy F² L/2EA; the drum has 1e5 J.
    const double speed = held.w.velocity(held.w.find_body("ship")).linear.x();
    const double stretched = kAidsLimit * kAidsLimit * held.signal("wire_out") / 2e8;
    EXPECT_NEAR(0.5e8 * (1.0 - speed * speed), kAidsLimit * held.signal("overload_out") + stretched,
                1.5e5);
}

TEST(WinchAids, InputsDisarmAndReduceIt) {
    DriftingShip off(kAidsLimit);
    off.w.set_system_signal("winch.aops", 0.0);
    off.run(300);
    EXPECT_FALSE(off.w.intact(off.w.wires().elements(off.wire).front()));
    DriftingShip manual(kAidsLimit, 1e8, 5e4);
    manual.w.set_system_signal("winch.mops", 1.0);
    manual.run(300);
    EXPECT_NEAR(manual.signal("pull"), 5e4, 50.0);
    EXPECT_GT(manual.signal("overload_out"), 4.0);
}

TEST(WinchAids, InertiaIsThatOfTheDrumWhileNothingYields) {
    // A free drum with 4e4 kg m² at r = 0.625 m is turned by 1000 N in the wire.
    for (const double limit : {0.0, kAidsLimit}) {
        DriftingShip s(limit);
        s.w.set_system_signal("winch.mode", 4.0);
        s.run(1);
        const double wound = s.signal("inertia") - 4e4;
        EXPECT_GT(wound, 0.0);
        EXPECT_NEAR(s.signal("inertia"), 4e4 + wound, 1e-9);
        EXPECT_EQ(s.w.body_def(s.drum).mass, limit > 0.0 ? 2.0 : 2e4);
    }
    DriftingShip plain(0.0, 2e4), armed(kAidsLimit, 2e4);
    for (DriftingShip* s : {&plain, &armed}) s->w.set_system_signal("winch.mode", 4.0);
    plain.run(120);
    armed.run(120);
    const double a = plain.w.velocity(plain.w.find_body("ship")).linear.x();
    EXPECT_LT(a, 0.3);  // the ship shares its momentum with the drum
    EXPECT_NEAR(armed.w.velocity(armed.w.find_body("ship")).linear.x(), a,
                0.05 * std::abs(a));  // damping of the wire's mode with the lighter drum
}

/// Return the heave of a load below a ship that heaves by 1 m at 0.1 Hz, relative to the ship's
/// heave.
double compensated_heave(WinchMode mode, double speed) {
    constexpr double kShip = 1e7, kLoad = 1e4, kOmega = 0.6283185307179586;
    World w(WorldDef{.step = 1.0 / 60.0});
    const BodyId ship = w.add_body({.name = "ship",
                                    .position = {0, 0, 50},
                                    .velocity = {0, 0, kOmega},
                                    .mass = kShip,
                                    .inertia = 1e9 * Mat3::Identity(),
                                    .gravity = false});
    const BodyId load = w.add_body({.name = "load", .kind = BodyKind::lump, .mass = kLoad});
    WinchDef def = winch_with_aids(w.wires().add({.name = "wire",
                                                  .from = ship,
                                                  .to = load,
                                                  .elements = 1,
                                                  .length = 49.95,
                                                  .EA = 1e8,
                                                  .mass_per_length = 10.0}));
    def.mode = mode;
    def.heave_speed = speed;
    w.add(def);
    double low = 1e300, high = -1e300;
    for (int i = 0; i < 1800; ++i) {
        w.set_force(ship,
                    {0, 0, -kShip * kOmega * kOmega * std::sin(kOmega * w.time()) + kLoad * 9.81},
                    Vec3::Zero());
        EXPECT_EQ(w.step(), Status::ok);
        if (w.time() < 10.0) continue;
        low = std::min(low, w.pose(load).position.z());
        high = std::max(high, w.pose(load).position.z());
    }
    return 0.5 * (high - low);
}

TEST(WinchAids, LoadKeepsItsHeight) {
    EXPECT_LT(compensated_heave(WinchMode::heave, 2.0), 0.02);
    EXPECT_NEAR(compensated_heave(WinchMode::brake, 2.0), 1.0, 0.05);
    // 0.63 m/s are needed.
    EXPECT_GT(compensated_heave(WinchMode::heave, 0.2), 0.4);
}

TEST(WinchAids, GoesOnFromASnapshotToTheSameBits) {
    DriftingShip a(kAidsLimit), b(kAidsLimit);
    a.run(200);
    b.w.state().restore(a.w.state().save());
    a.run(100);
    b.run(100);
    EXPECT_EQ(a.w.state().hash(), b.w.state().hash());
}

TEST(WinchAids, RefusesWhatMakesNoSense) {
    const auto refusal = [](auto change) -> std::string {
        DriftingShip s(0.0);
        const BodyId far = s.w.add_body({.name = "far", .kind = BodyKind::fixed});
        WinchDef def = winch_with_aids(s.w.wires().add({.name = "other",
                                                        .from = far,
                                                        .to = s.w.find_body("ship"),
                                                        .elements = 1,
                                                        .length = 120.0,
                                                        .EA = 1e8,
                                                        .mass_per_length = 10.0}));
        def.name = "second";
        change(def);
        try {
            s.w.add(def);
        } catch (const DefError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(refusal([](WinchDef& d) { d.mode = WinchMode::heave; }).find("heave_speed"),
              std::string::npos);
    EXPECT_NE(refusal([](WinchDef& d) { d.overload_limit = -1.0; }).find("overload_limit"),
              std::string::npos);
    EXPECT_NE(refusal([](WinchDef& d) { d.overload_retained = 1.0; }).find("above overload_limit"),
              std::string::npos);
    EXPECT_EQ(refusal([](WinchDef& d) { d.heave_speed = 1.0; }), "accepted");
}

}  // namespace
}  // namespace hawser::test
