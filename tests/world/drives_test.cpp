// SPDX-License-Identifier: Apache-2.0
/// Motors, winches and driven lengths: the energy balance closes, forces beyond a motor's range are
/// logged, the stiffness of a line depends on its length.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

/// Return the energy between two states that the balance leaves unexplained [J].
double unexplained(const Energy& a, const Energy& b) {
    return b.mechanical() - a.mechanical() - (b.applied - a.applied) - (b.driven - a.driven) +
           (b.dissipated - a.dissipated);
}

InputId drive(World& w, InteractionId interaction, const char* param) {
    InputDef def;
    def.name = param;
    def.interaction = interaction;
    def.param = param;
    return w.add_input(def);
}

/// A mass that hangs below a fairlead on a line from a drum, which a motor turns.
struct Winch {
    Recipe recipe;
    BodyId drum, load;
    InteractionId line, motor;
    static constexpr double kMass = 500.0, kLength = 20.0, kEA = 1e6, kRadius = 0.4;
};

Winch winch(double damping_time) {
    Winch w;
    const BodyId g = w.recipe.ground();
    w.drum = w.recipe.scalar(0.0, 30.0);
    w.recipe.bodies.back().gravity = false;
    w.load = w.recipe.lump({0, 0, -Winch::kLength}, Winch::kMass);
    InteractionDef line = between(InteractionKind::WinchStretch, {g, w.load, w.drum});
    line.set("length", Winch::kLength).set("EA", Winch::kEA).set("radius", Winch::kRadius);
    line.damping_time[0] = damping_time;
    w.line = w.recipe.add(line);
    w.motor = w.recipe.add(between(InteractionKind::ScalarMotor, {w.drum}));
    return w;
}

/// Vertical hauling is linear: without damping the scheme conserves energy exactly (A.2.3), so that
/// the work of the motor must equal the change.
TEST(Drives, AWinchThatHaulsAMassBalances) {
    const Winch parts = winch(0.0);
    World w = parts.recipe.make();
    const InputId speed = drive(w, parts.motor, "speed");
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    for (int i = 0; i < 600; ++i) {
        if (i == 60) w.set_input(speed, -2.0);
        if (i == 500) w.set_input(speed, 1.0);
        ASSERT_EQ(w.step(), Status::ok);
    }
    const Energy end = w.energy();
    const double lift = Winch::kRadius * (440 * 2.0 - 101 * 1.0) / 60.0;
    // The line stretches with the load; its length differs by less than 0.1 m.
    EXPECT_NEAR(w.pose(parts.load).position.z(), -Winch::kLength + lift, 0.2);
    EXPECT_NEAR(end.driven - start.driven, Winch::kMass * 9.81 * lift, 1e3) << "of 25 kJ";
    EXPECT_EQ(end.applied, 0.0);
    EXPECT_EQ(end.dissipated, 0.0);
    // The rest is the loss in the motor's compliance, 1e-12 rad/s/(N m), of λ²γ/h, and the change
    // of strain energy as the stiffness changes once per step. Measured: 3e-4 of the work.
    EXPECT_LT(std::abs(unexplained(start, end)), 1e-3 * (end.driven - start.driven));
}

/// A winch hauls in a line with damping: only the loss of the line's damping is left.
TEST(Drives, TheLinesDampingIsWhatIsLeft) {
    const Winch parts = winch(0.05);
    World w = parts.recipe.make();
    const InputId speed = drive(w, parts.motor, "speed");
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy still = w.energy();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(unexplained(still, w.energy()), 0.0, 1e-6) << "at rest";
    w.set_input(speed, -2.0);
    for (int i = 0; i < 300; ++i) ASSERT_EQ(w.step(), Status::ok);
    const double left = unexplained(still, w.energy());
    EXPECT_LT(left, 0.0);
    // A jerk of 500 kg to 0.8 m/s: at most 160 J can oscillate and be damped, twice that with the
    // motor's work during the jerk.
    EXPECT_GT(left, -330.0);
}

TEST(Drives, AHingeMotorThatLiftsABarBalances) {
    Recipe r;
    const Quat about_y(Eigen::AngleAxisd(-EIGEN_PI / 2, Vec3::UnitX()));
    const BodyId g = r.ground();
    const BodyId bar = r.rigid({0.5, 0, 0}, Quat::Identity(), 3.0, {0.1, 0.3, 0.3});
    r.add(r.at(InteractionKind::Hinge, {g, bar}, {0, 0, 0}, about_y));
    InteractionDef motor = r.at(InteractionKind::HingeMotor, {g, bar}, {0, 0, 0}, about_y);
    const InteractionId id = r.add(motor.set("speed", -0.5));
    World w = r.make();
    for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    for (int i = 0; i < 120; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy end = w.energy();
    const double angle = 0.5 * 120 / 60.0;  // rotation from 0.25 rad on
    const double lift = 3.0 * 9.81 * 0.5 * (std::sin(0.25 + angle) - std::sin(0.25));
    EXPECT_NEAR(end.driven - start.driven, lift, 0.02 * lift)
        << "steady speed: all goes into height";
    // The hinge lags by h²v²(1 + 2n)/4L (A.2.5), here 4e-5 m, and its damping dissipates energy.
    EXPECT_LT(std::abs(unexplained(start, end)), 2e-3 * lift);
    (void)id;
}

/// A length that an input shortens in each step lifts the mass like a winch.
TEST(Drives, AShortenedLineBalancesAndKeepsItsStiffness) {
    Recipe r;
    const BodyId g = r.ground(), load = r.lump({0, 0, -20}, 500.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, load});
    d.damping_time[0] = 0.02;
    const InteractionId line = r.add(d.set("length", 20.0).set("EA", 1e6));
    World w = r.make();
    const InputId length = drive(w, line, "length");
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    constexpr int kHaul = 900;
    for (int i = 0; i < kHaul; ++i) {
        w.set_input(length, 20.0 - 15.0 * (i + 1) / kHaul);
        ASSERT_EQ(w.step(), Status::ok);
    }
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy end = w.energy();
    const double weight = 500.0 * 9.81;
    EXPECT_NEAR(-w.force(line)[0], weight, 1e-6);
    // T L/EA with the remaining length: 5 m give 24.5 mm; the 20 m of the start gave 98.1 mm.
    EXPECT_NEAR(w.violation(line)[0], weight * 5.0 / 1e6, 1e-9);
    EXPECT_LE(w.stats().stretch_error_max, 1e-9);
    const double left = unexplained(start, end), work = end.driven - start.driven;
    // Lifted by 15 m less the change of stretch; the strain energy of the line decreases with it.
    const double stored = weight * (15.0 + 0.0981 - 0.0245) - 0.5 * weight * (0.0981 - 0.0245);
    EXPECT_NEAR(work + left, stored, 50.0);
    // Lengths change in jumps that are not in the rate of the row's damper τ EA/L: it works against
    // the whole shortening at w = 1 m/s. Integrated, τ w EA ln(20/5); the jerks add some per cent.
    EXPECT_NEAR(left, -0.02 * 1e6 * std::log(4.0), 0.05 * 0.02 * 1e6 * std::log(4.0));
}

TEST(Drives, AWinchLineIsAsStiffAsWhatIsPaidOut) {
    const Winch parts = winch(0.05);
    World w = parts.recipe.make();
    const InputId speed = drive(w, parts.motor, "speed");
    const double weight = Winch::kMass * 9.81;
    for (const double target : {-1.0, 0.0, 3.0, 0.0}) {  // hauls in, stops, pays out, stops
        w.set_input(speed, target);
        for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
        if (target != 0.0) continue;
        const double out = Winch::kLength + Winch::kRadius * w.pose(parts.drum).position.x();
        EXPECT_GT(std::abs(out - Winch::kLength), 3.0);
        EXPECT_NEAR(w.violation(parts.line)[0], weight * out / Winch::kEA, 1e-8);
        EXPECT_NEAR(-w.force(parts.line)[0], weight, 1e-4);
    }
}

/// A carrier that rises at constant speed lifts the hanging load.
TEST(Drives, ACarrierDoesTheWork) {
    Recipe r;
    const BodyId cart =
        r.add({.name = "cart", .kind = BodyKind::kinematic, .velocity = {0, 0, 0.5}});
    const BodyId load = r.lump({0, 0, -2}, 10.0);
    InteractionDef d = between(InteractionKind::Distance, {cart, load});
    d.compliance[0] = 1e-4;
    d.damping_time[0] = 0.0;
    r.add(d.set("length", 2.0));
    World w = r.make();
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy end = w.energy();
    EXPECT_NEAR(end.driven - start.driven, 10.0 * 9.81 * 5.0, 10.0) << "it bobs on its spring";
    EXPECT_NEAR(unexplained(start, end), 0.0, 1e-8) << "linear and undamped: exact";
}

TEST(Drives, AppliedForceAndDragBalanceExactly) {
    Recipe r;
    r.world.gravity = {0, 0, 0};
    const BodyId b = r.lump({0, 0, 0}, 2.0);
    r.bodies.back().force = {10, 0, 0};
    r.bodies.back().linear_damping = {3, 3, 3};
    World w = r.make();
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    for (int i = 0; i < 100; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(unexplained(start, w.energy()), 0.0, 1e-12);
    EXPECT_GT(w.energy().dissipated, 1.0);
    (void)b;
}

/// A motor weaker than the load lowers it at (m g r − T) / (J + m r²).
TEST(Drives, AMotorAtTheEndOfItsRangeGivesWay) {
    constexpr double kTorque = 1500.0;  // 500 kg need 1962 N m
    Winch parts = winch(0.05);
    parts.recipe.interactions[1].set("force_min", -kTorque).set("force_max", kTorque);
    World w = parts.recipe.make();
    const InputId speed = drive(w, parts.motor, "speed");
    for (int i = 0; i < 120; ++i)
        ASSERT_EQ(w.step(), Status::ok);  // the vibration of the line
                                          // decays
    auto saturations = [&] {
        std::vector<Event> out;
        for (const Event& e : w.events().take())
            if (e.kind == EventKind::saturation) out.push_back(e);
        return out;
    };
    auto events = saturations();
    ASSERT_GE(events.size(), 1U);
    EXPECT_LE(events.size(), 3U) << "it rings in once or twice";
    EXPECT_EQ(events[0].interaction, parts.motor);
    EXPECT_NEAR(std::abs(events[0].value), kTorque, 1e-9);
    const double before = w.velocity(parts.drum).linear.x();
    const Energy start = w.energy();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_TRUE(saturations().empty()) << "it goes on, it does not begin";
    constexpr double m = Winch::kMass, r = Winch::kRadius;
    // The length paid out is stretched by T/EA, 0.4 %.
    const double strain = m * (9.81 - 4.2 * r) / Winch::kEA;
    const double exact = (m * 9.81 * r - kTorque) / (30.0 + m * r * r * (1.0 + strain));
    EXPECT_NEAR(w.velocity(parts.drum).linear.x() - before, exact, 1e-4 * exact);
    EXPECT_NEAR(std::abs(w.force(parts.motor)[0]), kTorque, 1e-9);
    const Energy end = w.energy();
    EXPECT_NEAR(unexplained(start, end) / (end.driven - start.driven), 0.0, 1e-3);
    // A lighter load is held: the motor accelerates the drum to the requested speed with its full
    // torque.
    w.set_force(parts.load, {0, 0, 3000}, {0, 0, 0});
    w.set_input(speed, 0.5);
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(parts.drum).linear.x(), 0.5, 1e-6);
    (void)saturations();
    w.set_force(parts.load, {0, 0, 0}, {0, 0, 0});
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_GE(saturations().size(), 1U) << "it began anew";
    // A restored world does not report an earlier event again, and continues equally.
    World again = parts.recipe.make();
    (void)drive(again, parts.motor, "speed");
    again.state().restore(w.state().save());
    ASSERT_EQ(again.step(), Status::ok);
    for (const Event& e : again.events().take()) EXPECT_NE(e.kind, EventKind::saturation);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.state().hash(), again.state().hash());
}

TEST(Snapshot, RefusesOtherParameters) {
    const Winch parts = winch(0.05);
    World a = parts.recipe.make();
    (void)drive(a, parts.motor, "speed");
    for (int i = 0; i < 10; ++i) ASSERT_EQ(a.step(), Status::ok);
    a.set_input(a.find_input("speed"), -1.5);
    const auto bytes = a.state().save();
    auto refused = [&](auto change) {
        Winch other = parts;
        InputDef input;
        input.name = "speed";
        input.interaction = parts.motor;
        input.param = "speed";
        change(other.recipe, input);
        World b = other.recipe.make();
        (void)b.add_input(input);
        try {
            b.state().restore(bytes);
        } catch (const DefError& e) {
            return std::string(e.what()).find("parameters") != std::string::npos;
        }
        return false;
    };
    EXPECT_FALSE(refused([](Recipe&, InputDef&) {}));
    EXPECT_FALSE(refused([](Recipe& r, InputDef&) { r.interactions[1].set("speed", 3.0); }))
        << "the input's value is part of the state";
    EXPECT_FALSE(refused([](Recipe& r, InputDef&) { r.world.threads = 2; }));
    EXPECT_FALSE(refused([](Recipe& r, InputDef&) { r.bodies[2].name = "load"; }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.bodies[2].mass = 501.0; }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.interactions[0].set("EA", 2e6); }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.interactions[0].point[0] = {1, 0, 0}; }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.interactions[0].damping_time[0] = 0.06; }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.world.gravity = {0, 0, -1.6}; }));
    EXPECT_TRUE(refused([](Recipe& r, InputDef&) { r.bodies[2].linear_damping = {1, 0, 0}; }));
    EXPECT_TRUE(refused([](Recipe&, InputDef& i) { i.max = 5.0; }));
}

TEST(World, GrowsBetweenSteps) {
    Recipe r = pendulum();
    World w = r.make();
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Vec3 end = w.pose(BodyId{1}).position;
    const BodyId more =
        w.add_body({.kind = BodyKind::lump, .position = end + Vec3(0, 0, -1), .mass = 2.0});
    InteractionDef d = between(InteractionKind::Distance, {BodyId{1}, more});
    w.add_interaction(d.set("length", 1.0));
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR((w.pose(more).position - w.pose(BodyId{1}).position).norm(), 1.0, 0.02);
    EXPECT_EQ(w.stats().bodies, 2);
}

}  // namespace
}  // namespace hawser::test
