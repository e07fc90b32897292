// SPDX-License-Identifier: Apache-2.0
/// Winches in all modes, at the fairlead of a deck, with prescribed motion of the end.
#include "wire/winch_deck.h"

#include <utility>

namespace hawser::test {
namespace {

std::string refusal(WinchDef def) {
    try {
        const Deck deck(std::move(def));
    } catch (const DefError& error) {
        return error.what();
    }
    return "";
}

TEST(Winch, PullsAtAConstantTensionButForItsInertia) {
    WinchDef def = big_winch();
    def.mode = WinchMode::tension;
    def.tension = 4e5;
    def.max_speed = 4.0;
    Deck d(def);
    const double h = d.w.settings().step, rate = 2.0 * M_PI / 8.0;
    double worst = 0.0, most = 0.0, before = 0.0;
    for (long i = 0; i < std::lround(24.0 / h); ++i) {
        d.step(2.0 * rate * std::sin(rate * d.w.time()));
        const double omega = d.w.velocity(d.ids.drum).linear.x();
        const double a = (omega - before) / h * d.get("radius");
        before = omega;
        if (d.w.time() < 8.0) continue;
        const double r = d.get("radius"), expected = 4e5 + d.get("inertia") / (r * r) * a;
        worst = std::max(worst, std::abs(d.tension() - expected) / expected);
        most = std::max(most, std::abs(d.tension() - 4e5));
    }
    EXPECT_LT(worst, 1e-3);
    EXPECT_GT(most, 5e4);  // inertia acts
    EXPECT_EQ(d.count(EventKind::brake_slip), 0);
}

TEST(Winch, BrakeSlipsAtItsTorqueAndHeatIsItsWork) {
    WinchDef def = big_winch();
    def.brake_static = 1.2e6;
    def.brake_dynamic = 1.0e6;
    Deck d(def);
    d.run(0.05, 0.1);
    EXPECT_EQ(d.state(), WinchState::standing);
    double work = 0.0, peak = 0.0;
    const double energy = d.w.energy().friction;
    for (int i = 0; i < 1200; ++i) {
        const double angle = d.w.pose(d.ids.drum).position.x();
        d.step(0.5);
        peak = std::max(peak, std::abs(d.w.force(d.ids.brake)[0]));
        work += std::abs(d.w.force(d.ids.brake)[0]) * (d.w.pose(d.ids.drum).position.x() - angle);
    }
    d.step(0.5);  // includes the last step
    EXPECT_NEAR(peak, 1.2e6, 1.0);
    EXPECT_NEAR(d.tension() * d.get("radius"), 1.0e6, 5e3);
    EXPECT_NEAR(d.get("heat"), work, 1e-3 * work);
    EXPECT_NEAR(d.get("slip"), 2.505 - 1.0e6 / d.get("radius") / 7.5e6, 2e-2);
    EXPECT_EQ(d.count(EventKind::brake_slip), 1);
    EXPECT_EQ(d.state(), WinchState::slipping);
    EXPECT_NE(d.w.energy().friction, energy);
}

TEST(Winch, BandHoldsLessAsWireRunsIn) {
    WinchDef def = big_winch();
    def.brake_static = 1e6;
    def.band_friction = 0.3;
    def.band_angle = 4.0;
    Deck d(def);
    d.run(0.1, 0.0);
    // A torque on the drum, like that of a motor tested against the brake.
    const auto moves = [&](double torque) {
        d.w.set_force(d.ids.drum, {torque, 0, 0}, Vec3::Zero());
        const double before = d.w.pose(d.ids.drum).position.x();
        d.run(0.5, -1.0);  // slack: no other pull
        return std::abs(d.w.pose(d.ids.drum).position.x() - before) > 1e-4;
    };
    const double back = 1e6 * std::exp(-1.2);
    EXPECT_FALSE(moves(-0.999 * back));
    EXPECT_TRUE(moves(-1.01 * back));
    d.w.set_velocity(d.ids.drum, {});
    d.run(0.5, 0.0);
    EXPECT_FALSE(moves(0.999e6));
    EXPECT_TRUE(moves(1.01e6));
    EXPECT_GT(d.get("heat"), 0.0);
}

TEST(Winch, PullFallsWithTheLayer) {
    for (const double stored : {100.0, 700.0, 1500.0}) {
        WinchDef def = big_winch();
        def.stored = stored;
        def.mode = WinchMode::speed;
        def.speed = -0.1;
        def.torque_haul = 5e5;
        Deck d(def);
        d.run(10.0, 0.0);
        EXPECT_NEAR(d.tension() * d.get("radius"), 5e5, 50.0);
        EXPECT_NEAR(d.get("pull_limit") * d.get("radius"), 5e5, 1e-6);
    }
}

TEST(Winch, RendersAboveItsBandAndTakesInBelow) {
    WinchDef def = big_winch();
    def.mode = WinchMode::render;
    def.tension = 4e5;
    def.deadband = 1e5;
    Deck d(def);
    // Hauled in from slack it comes to rest with a tension within the band.
    d.run(30.0, 0.0);
    EXPECT_EQ(d.state(), WinchState::standing);
    EXPECT_GE(d.tension(), 3e5 - 1.0);
    EXPECT_LE(d.tension(), 5e5 + 1.0);
    const auto mean = [&](double speed) {
        d.run(10.0, speed);
        double sum = 0.0;
        for (int i = 0; i < 480; ++i) {
            d.step(speed);
            sum += d.tension() / 480.0;
        }
        return sum;
    };
    EXPECT_EQ(d.count(EventKind::render), 0);
    // Pulled out it pays out at the upper tension, slackened it hauls in at the lower one.
    EXPECT_NEAR(mean(0.3), 5e5, 5e3);
    EXPECT_EQ(d.state(), WinchState::paying);
    EXPECT_GE(d.count(EventKind::render), 1);
    EXPECT_LE(d.count(EventKind::render), 20) << "while the wire swings, not in every step";
    EXPECT_NEAR(mean(-0.3), 3e5, 3e3);
    EXPECT_EQ(d.state(), WinchState::hauling);
}

TEST(Winch, LayersChangeWithoutAJumpOfTheRestLength) {
    WinchDef def = big_winch();
    def.stored = 1420.0;  // layer 9 begins at 1,408 m
    def.mode = WinchMode::tension;
    def.tension = 1e5;
    def.max_speed = 3.0;
    Deck d(def);
    double before = d.w.wires().length(d.wire), began = before, jump = 0.0,
           radius = d.get("radius");
    const double first = radius;
    double climb = 0.0, highest = radius, lowest = radius;
    for (int way : {1, -1})
        for (int i = 0; i < 6 * 240; ++i) {
            d.step(way * 2.5);
            const double speed = d.w.velocity(d.ids.drum).linear.x(),
                         now = d.w.wires().length(d.wire);
            jump = std::max(jump, std::abs(now - before - d.get("radius") * speed / 240.0));
            began = std::exchange(before, now);
            climb = std::max(climb, std::abs(d.get("radius") - radius));
            radius = d.get("radius");
            highest = std::max(highest, radius);
            lowest = std::min(lowest, radius);
        }
    EXPECT_NEAR(radius, first, 2e-4);  // both directions differ by a step
    // It climbs by the wire's diameter over the wire of one turn, 7.5 m, at a constant rate.
    EXPECT_NEAR(highest - lowest, 0.076, 1e-9);
    EXPECT_LT(climb, 0.076 / 7.5 * 3.0 / 240.0);  // at 3 m/s
    EXPECT_EQ(d.count(EventKind::layer), 2);
    EXPECT_LT(jump, 1e-9);
    EXPECT_NEAR(d.get("wire_left") + began, 1460.0, 1e-9);  // at the start of the last step
}

TEST(Winch, ClutchTakesAlongAMotorThatStood) {
    WinchDef def = big_winch();
    def.motor_inertia = 6e4;
    def.mode = WinchMode::free;
    Deck d(def);
    d.set("clutch", 0.0);
    d.step(0.0);
    d.w.set_velocity(d.ids.drum, {.linear = {1.0, 0, 0}});  // slack wire runs out without a pull
    d.step(0.0);
    EXPECT_NEAR(d.w.velocity(d.ids.drum).linear.x(), 1.0, 1e-4);
    const double bare = d.get("inertia"), omega = d.w.velocity(d.ids.drum).linear.x();
    d.set("clutch", 1.0);
    d.step(0.0);
    EXPECT_NEAR(d.get("inertia"), bare + 6e4, 1.0);
    EXPECT_NEAR(d.w.velocity(d.ids.drum).linear.x() * (bare + 6e4) / (bare * omega), 1.0, 1e-5);
}

TEST(Winch, GoesOnBitForBitAfterARestoreAndInATwin) {
    WinchDef def = big_winch();
    def.mode = WinchMode::tension;
    def.tension = 3e5;
    Deck a(def), b(def);
    a.run(2.0, 0.8);
    b.w.state().restore(a.w.state().save());
    World twin = a.w.twin();
    for (int i = 0; i < 240; ++i) {
        a.step(-0.5);
        b.step(-0.5);
        Twist t;
        t.linear.x() = -0.5;
        twin.set_velocity(a.end, t);
        ASSERT_EQ(twin.step(), Status::ok);
    }
    EXPECT_EQ(a.w.state().hash(), b.w.state().hash());
    EXPECT_EQ(a.w.state().hash(), twin.state().hash());
}

TEST(Winch, RefusesWhatIsNoWinch) {
    EXPECT_EQ(refusal(big_winch()), "");
    WinchDef def = big_winch();
    def.core_radius = 0.15;
    EXPECT_NE(refusal(def).find("larger drum"), std::string::npos) << refusal(def);
    def = big_winch();
    def.stored = 5000.0;
    EXPECT_NE(refusal(def).find("the drum holds"), std::string::npos) << refusal(def);
    def = big_winch();
    def.width = 0.07;
    EXPECT_NE(refusal(def).find("no wrap"), std::string::npos) << refusal(def);
    def = big_winch();
    def.brake_static = -1.0;
    EXPECT_NE(refusal(def).find("brake_static"), std::string::npos) << refusal(def);
    def = big_winch();
    def.name = "";
    EXPECT_NE(refusal(def).find("name"), std::string::npos);
    // A method without loads of systems: the wire is unchanged.
    World sweeping(WorldDef{.nonsmooth = Nonsmooth::pgs});
    const BodyId deck = sweeping.add_body({.name = "deck", .kind = BodyKind::fixed});
    def = big_winch();
    def.wire = sweeping.wires().add({.name = "wire",
                                     .from = deck,
                                     .elements = 2,
                                     .length = 40.0,
                                     .EA = 3e8,
                                     .mass_per_length = 25.0});
    EXPECT_THROW((void)sweeping.add(def), DefError);
    EXPECT_EQ(sweeping.interactions().size(), 2U);
    EXPECT_TRUE(sweeping.intact(sweeping.wires().elements(def.wire).front()));
    // Two winches on one end.
    Deck d(big_winch());
    def = big_winch();
    def.name = "second";
    def.wire = d.wire;
    const int bodies = d.w.body_count();
    EXPECT_THROW((void)d.w.add(def), DefError);
    EXPECT_FALSE(d.w.find_body("second/drum").valid());
    EXPECT_EQ(d.w.system_count(), 1);
    EXPECT_LE(d.w.body_count(), bodies + 1);
}

/// A winch lifts m with the power P: v = P/(m g) at the end, and at most P at any step. The drum is
/// light: without a bound inside the solver, one step crosses the whole curve.
TEST(WinchPower, IsTheLimitOfTorqueTimesSpeed) {
    constexpr double kPower = 1e5, kLoad = 2e4, kG = 9.81;
    for (const double step : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
        World w(WorldDef{.step = step});
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        const BodyId load = w.add_body(
            {.name = "load", .kind = BodyKind::lump, .position = {0, 0, -60}, .mass = kLoad});
        const WireId wire = w.wires().add({.name = "wire",
                                           .from = deck,
                                           .to = load,
                                           .elements = 12,
                                           .EA = 1e8,
                                           .mass_per_length = 4.0,
                                           .axial_damping = 0.5,
                                           .consistent_mass = true});
        const WinchIds ids = w.add(WinchDef{.name = "winch",
                                            .wire = wire,
                                            .core_radius = 0.4,
                                            .width = 1.0,
                                            .flange_radius = 0.9,
                                            .wire_diameter = 0.032,
                                            .mass_per_length = 4.0,
                                            .stored = 100.0,
                                            .inertia = 300.0,
                                            .torque_haul = 1.5e5,
                                            .torque_pay = 1.5e5,
                                            .power = kPower,
                                            .speed = -2.0,
                                            .brake_static = 2e5,
                                            .mode = WinchMode::speed});
        double most = 0.0, lowest = 0.0;
        const auto run = [&](double seconds) {
            for (long i = std::lround(seconds / step); i > 0; --i) {
                ASSERT_EQ(w.step(), Status::ok);
                const double torque = w.force(ids.motor)[0];
                most = std::max(most, torque * w.velocity(ids.drum).linear.x());
                lowest = std::min(lowest, w.pose(load).position.z());
            }
        };
        run(30.0);
        // 1e-5: the solver's tolerance of 1e-6 for variable bounds, and rounding.
        EXPECT_LE(most, kPower * (1.0 + 1e-5)) << step;
        EXPECT_GE(lowest, -61.0) << "the load is not lost, step " << step;
        const double hangs = kLoad - 4.0 * w.pose(load).position.z();
        // 2 %: the load still oscillates on its wire, and the wire's weight decreases as it is
        //   hauled in.
        EXPECT_NEAR(w.velocity(load).linear.z(), kPower / (hangs * kG), 0.02) << step;
        // Only the torque limits braking: the winch controls the load while it pays out fast.
        w.set_system_signal("winch.speed", 2.0);
        run(6.0);
        const double radius = w.system_signal("winch.radius");
        EXPECT_NEAR(radius * w.velocity(ids.drum).linear.x(), 2.0, 1e-2) << step;
    }
}

/// A winch that renders around the load's weight hauls with at most its power, although both of its
/// tensions require more: the load rises at v = P/T.
TEST(WinchPower, HoldsWhileAWinchRenders) {
    constexpr double kPower = 4e3, kLoad = 3400.0, kG = 9.81;
    for (const double step : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
        World w(WorldDef{.step = step});
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        const BodyId load = w.add_body(
            {.name = "load", .kind = BodyKind::lump, .position = {0, 0, -30}, .mass = kLoad});
        const WireId wire = w.wires().add({.name = "wire",
                                           .from = deck,
                                           .to = load,
                                           .elements = 11,
                                           .EA = 1.2e7,
                                           .mass_per_length = 1.1,
                                           .consistent_mass = true});
        const WinchIds ids = w.add(WinchDef{.name = "winch",
                                            .wire = wire,
                                            .core_radius = 0.3,
                                            .width = 0.4,
                                            .wire_diameter = 0.018,
                                            .mass_per_length = 1.1,
                                            .stored = 100.0,
                                            .inertia = 60.0,
                                            .torque_haul = 3e4,
                                            .torque_pay = 3e4,
                                            .power = kPower,
                                            .tension = 1.3 * kLoad * kG,
                                            .deadband = 0.05 * kLoad * kG,
                                            .brake_static = 3e4,
                                            .mode = WinchMode::render});
        double most = 0.0;
        for (long i = std::lround(10.0 / step); i > 0; --i) {
            ASSERT_EQ(w.step(), Status::ok) << step;
            most = std::max(most, w.force(ids.motor)[0] * w.velocity(ids.drum).linear.x());
        }
        // The solver's tolerance and rounding, as above.
        EXPECT_LE(most, kPower * (1.0 + 1e-5)) << step;
        const double hangs = kLoad - 1.1 * w.pose(load).position.z();
        // 5 %: the load still oscillates on its wire.
        EXPECT_NEAR(w.velocity(load).linear.z() * hangs * kG / kPower, 1.0, 0.05) << step;
    }
}

}  // namespace
}  // namespace hawser::test
