// SPDX-License-Identifier: Apache-2.0
/// Physically impossible lines: overstretched, or hauled in beyond their end; and energy accounts
/// of edits and friction.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

/// Make a point mass of 1,000 kg that moves away from an element of 1 m at a speed.
World shot(double speed, double bears) {
    Recipe r;
    r.world.gravity = Vec3::Zero();
    r.world.on_diverged = OnDiverged::stop;
    const BodyId g = r.ground(), b = r.lump({1.0, 0, 0}, 1000.0);
    r.bodies.back().velocity = {speed, 0, 0};
    InteractionDef d = between(InteractionKind::Stretch, {g, b});
    r.add(d.set("length", 1.0).set("EA", 1e7).set("breaking_load", bears));
    return r.make();
}

Status run_steps(World& w, int steps) {
    Status status = Status::ok;
    for (int i = 0; i < steps && status == Status::ok; ++i) status = w.step();
    return status;
}

TEST(MonitorBearing, AnElementFarBeyondItsStrengthFailsAlthoughItPartsInThatStep) {
    // 500 m/s at 1/60 s: 8 m in the first step, at most m v/h = 30 MN, four times its length.
    World w = shot(500.0, 1e5);
    EXPECT_EQ(run_steps(w, 5), Status::diverged);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.grade, Grade::wrong);
    EXPECT_EQ(v.judge, Judge::cable);
    EXPECT_LT(v.of(Judge::cable).value, -0.5);
    EXPECT_TRUE(v.of(Judge::cable).interaction.valid());
}

TEST(MonitorBearing, ALineThatPartsUnderABlowIsGood) {
    // 2 m/s: T = v √(EA m/l) = 200 kN at most, 2 % of strain, 40 times its breaking load.
    World w = shot(2.0, 5e3);
    EXPECT_EQ(run_steps(w, 60), Status::ok);
    EXPECT_EQ(w.stats().event_count[static_cast<std::size_t>(EventKind::line_break)], 1);
    EXPECT_EQ(w.verdict().grade, Grade::good) << to_string(w.verdict().judge);
}

/// Make 2 m of line to a load that a drum, or the slide of a route, hauls in at 0.8 m/s.
World wound(InteractionKind kind) {
    Recipe r;
    r.world.on_diverged = OnDiverged::stop;
    const BodyId g = r.ground(), drum = r.scalar(0.0, 30.0);
    r.bodies.back().gravity = false;
    const BodyId load = r.lump({0, 0, -2.0}, 500.0);
    InteractionDef line = between(kind, {g, load, drum});
    line.name = "line";
    r.add(line.set("length", 2.0).set("EA", 1e6).set("radius", 0.4));
    InteractionDef motor = between(InteractionKind::ScalarMotor, {drum});
    r.add(motor.set("speed", -2.0));
    return r.make();
}

TEST(MonitorBearing, ADrumKeepsTheLeastOfItsElement) {
    World w = wound(InteractionKind::WinchStretch);
    EXPECT_EQ(run_steps(w, 300), Status::ok);
    EXPECT_EQ(w.verdict().grade, Grade::good) << to_string(w.verdict().judge);
    // 2 % of 2 m, and its stretch under 4.9 kN: W l/EA = 0.2 mm. It arrived at 0.8 m/s, which lifts
    //   it by v²/2g = 33 mm while the line is slack.
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_LT(w.pose(w.bodies()[2]).position.norm(), 0.02 * 2.0 + 0.033);
    }
}

TEST(MonitorBearing, ASlideThatTakesInMoreThanThereIsFails) {
    World w = wound(InteractionKind::EndSpan);
    EXPECT_EQ(run_steps(w, 300), Status::diverged);
    // 2 m at 0.8 m/s.
    EXPECT_NEAR(w.time(), 2.5, 0.2);
    EXPECT_EQ(w.verdict().grade, Grade::wrong);
}

TEST(EnergyAccounts, FrictionOfJointsIsNotDriven) {
    // A block slides to rest on a slide with friction: v²/2µg without a motor.
    Recipe r;
    r.world.gravity = Vec3::Zero();
    const BodyId g = r.ground(), b = r.rigid({0, 0, 0}, Quat::Identity(), 10.0, {1, 1, 1});
    r.bodies.back().velocity = {3.0, 0, 0};
    InteractionDef slide = r.at(InteractionKind::Prismatic, {g, b}, {0, 0, 0});
    slide.frame[0] = slide.frame[1] = turn_between(Vec3::UnitZ(), Vec3::UnitX());
    r.add(slide);
    InteractionDef friction = r.at(InteractionKind::SlideFriction, {g, b}, {0, 0, 0});
    friction.frame[0] = friction.frame[1] = slide.frame[0];
    r.add(friction.set("force", 20.0));
    World w = r.make();
    ASSERT_EQ(run_steps(w, 240), Status::ok);
    const Energy e = w.energy();
    EXPECT_EQ(e.driven, 0.0);
    EXPECT_EQ(e.edited, 0.0);
    // All of ½ m v², less half a step at the start.
    EXPECT_NEAR(e.friction, 45.0, 0.02 * 45.0);
    EXPECT_LT(e.kinetic, 1e-6);
}

TEST(EnergyAccounts, EditsAreNotDriven) {
    // A swinging row of nodes loses one: its energy is counted as edited.
    Recipe r;
    const BodyId g = r.ground(), a = r.lump({1, 0, 0}, 5.0), b = r.lump({2, 0, 0}, 5.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, a});
    r.add(d.set("length", 1.0).set("EA", 1e5));
    d = between(InteractionKind::Stretch, {a, b});
    r.add(d.set("length", 1.0).set("EA", 1e5));
    World w = r.make();
    ASSERT_EQ(run_steps(w, 60), Status::ok);
    const Vec3 v = w.velocity(b).linear;
    const double height = w.pose(b).position.z() - 0.5 * w.settings().step * v.z();
    (void)w.remove_body(b);
    ASSERT_EQ(w.step(), Status::ok);
    const Energy e = w.energy();
    EXPECT_EQ(e.driven, 0.0);
    // Its motion and weight, except for the energy of its element of 1e-5 m/N under up to 250 N.
    EXPECT_NEAR(e.edited, -(2.5 * v.squaredNorm() + 5.0 * 9.81 * height), 0.35);
}

TEST(MonitorStart, ASpringThatMovesAtTheStartMakesNoEnergy) {
    // (ωh)² = 0.14: half a step before the start the spring has ½ k (v h/2)², 3.5 % of ½ m v².
    for (const bool carried : {false, true}) {
        Recipe r;
        r.world.gravity = Vec3::Zero();
        const BodyId b = r.rigid({0, 0, 0}, Quat::Identity(), 100.0, {1, 1, 1});
        r.bodies.back().velocity = carried ? Vec3(0, 0, 0) : Vec3(2, 0, 0);
        BodyDef carriage;
        carriage.kind = BodyKind::kinematic;
        carriage.position = {2, 0, 0};
        carriage.velocity = carried ? Vec3(2, 0, 0) : Vec3(0, 0, 0);
        r.bodies.push_back(carriage);
        InteractionDef d = between(InteractionKind::Distance,
                                   {BodyId{static_cast<std::int32_t>(r.bodies.size()) - 1}, b});
        d.compliance[0] = 1.0 / 5e4;
        d.damping_time[0] = 0.0;
        r.add(d.set("length", 2.0));
        World w = r.make();
        ASSERT_EQ(run_steps(w, 600), Status::ok);
        EXPECT_EQ(w.verdict().grade, Grade::good) << carried << w.verdict().of(Judge::energy).value;
    }
}

}  // namespace
}  // namespace hawser::test
