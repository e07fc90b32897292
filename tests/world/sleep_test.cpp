// SPDX-License-Identifier: Apache-2.0
/// Islands at rest sleep without changing a bit, and continue from that state when they wake.
#include "support/sleep_yard.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <string>
#include <vector>

namespace hawser {
namespace {

using test::SleepYard;

WorldDef sleepy(Nonsmooth method = Nonsmooth::newton, int threads = 1) {
    WorldDef def;
    def.sleep_after = 0.5;
    def.sleep_speed = 1e-4;
    def.nonsmooth = method;
    def.threads = threads;
    return def;
}

constexpr int kSettled = 600;
constexpr const char* kAll = "zzzzzzzzz";

TEST(Sleep, IsOffByDefault) {
    SleepYard y{WorldDef{}};
    y.run(kSettled);
    EXPECT_EQ(y.asleep(), ".........");
    EXPECT_EQ(y.w.stats().asleep, 0);
}

TEST(Sleep, KeepsEveryBitAndLeavesNothingToSolve) {
    SleepYard y(sleepy());
    y.run(kSettled);
    ASSERT_EQ(y.asleep(), kAll);
    EXPECT_EQ(y.w.stats().asleep, 9);
    const std::vector<double> before = y.state();
    const Energy energy = y.w.energy();
    const std::vector<ContactView> contacts = y.w.contacts();
    y.run(300);
    EXPECT_EQ(y.state(), before);
    EXPECT_EQ(y.w.energy().mechanical(), energy.mechanical());
    EXPECT_EQ(y.w.energy().friction, energy.friction);
    EXPECT_EQ(y.w.stats().matrix_nnz, 0);
    EXPECT_EQ(y.w.stats().islands, 0);
    // Contacts that carry a load are still reported: 3 boxes and a ball.
    const std::vector<ContactView> now = y.w.contacts();
    ASSERT_EQ(now.size(), contacts.size());
    double weight = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_TRUE(now[i].asleep);
        EXPECT_EQ(now[i].force, contacts[i].force);
        if (y.w.shape_def(now[i].shape[0]).body.index == y.ground.index) weight += now[i].force.z();
    }
    EXPECT_NEAR(weight, 310.0 * 9.81, 1e-3);
    EXPECT_NEAR(-y.w.force({0})[0], 8.0 * 9.81, 1e-3);
}

/// For any duration of sleep, the step after it is the same.
TEST(Sleep, EndsWhereItBegan) {
    std::vector<double> after[2];
    for (int k = 0; k < 2; ++k) {
        SleepYard y(sleepy());
        y.run(kSettled + 200 * k);
        ASSERT_EQ(y.asleep(), kAll);
        for (const BodyId id : y.moving()) y.w.wake(id);
        y.run(20);
        EXPECT_EQ(y.asleep(), ".........");
        after[k] = y.state();
    }
    EXPECT_EQ(after[0], after[1]);
}

/// An island continues as if it had not slept. Reference: one that stayed awake, from the step in
/// which the other fell asleep, to the rounding of another order of elimination.
TEST(Sleep, IsNotNoticed) {
    SleepYard y(sleepy()), other{WorldDef{}};
    int steps = 0;
    while (!y.w.asleep(y.box[0]) && steps < kSettled) {
        y.run(1);
        other.run(1);
        ++steps;
    }
    ASSERT_LT(steps, kSettled);
    y.run(64);
    y.w.wake(y.box[1]);
    const auto kick = [](SleepYard& s) {
        s.w.set_velocity(s.box[2], {{0.5, 0.2, 0.0}, {0, 0, 1}});
    };
    kick(y);
    kick(other);
    for (int i = 0; i < 60; ++i) {
        y.run(1);
        other.run(1);
        for (int k = 0; k < 3; ++k) {
            const Pose p = y.w.pose(y.box[k]), q = other.w.pose(other.box[k]);
            EXPECT_LT((p.position - q.position).norm(), 1e-9) << k << " at " << i;
        }
    }
}

TEST(Sleep, WhatIsTouchedWakes) {
    SleepYard y(sleepy());
    y.run(kSettled);
    ASSERT_EQ(y.asleep(), kAll);
    y.w.set_input(y.brake, 300.0);  // unchanged value
    y.w.set_force(y.box[0], Vec3::Zero(), Vec3::Zero());
    y.run(1);
    EXPECT_EQ(y.asleep(), kAll);
    y.w.set_input(y.brake, 50.0);
    y.run(1);
    EXPECT_EQ(y.asleep(), "zzzzzzzz.");
    y.run(30);
    EXPECT_GT(y.w.velocity(y.slide).linear.norm(), 1.0);
    y.w.set_input(y.push, 5.0);
    y.run(1);
    EXPECT_EQ(y.asleep(), "zzzz.....");
    y.w.set_force(y.ball, {0, 20.0, 0}, Vec3::Zero());
    y.run(1);
    EXPECT_EQ(y.asleep(), "zzz......");
    Pose p = y.w.pose(y.box[2]);
    p.position.x() += 0.1;
    y.w.set_pose(y.box[2], p);
    y.run(1);
    EXPECT_EQ(y.asleep(), ".........");
}

TEST(Sleep, ABlowWakesTheStackAndNothingElse) {
    SleepYard y(sleepy());
    y.run(kSettled);
    ASSERT_EQ(y.asleep(), kAll);
    y.w.set_velocity(y.ball, {{-12.0, 0.0, 0.0}, {0.0, -24.0, 0.0}});
    const double before = y.w.pose(y.box[0]).position.x();
    int woken = 0;
    for (int i = 0; i < 180; ++i) {
        y.run(1);
        if (woken == 0 && !y.w.asleep(y.box[0])) {
            woken = i;
            EXPECT_EQ(y.asleep(), "....zzzzz");
        }
    }
    EXPECT_GT(woken, 10);
    EXPECT_LT(y.w.pose(y.box[0]).position.x(), before - 1e-3);
}

TEST(Sleep, CarriersThatMoveKeepAwake) {
    WorldDef def = sleepy();
    World w(def);
    BodyDef d;
    d.kind = BodyKind::kinematic;
    const BodyId deck = w.add_body(d);
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    plane.body = deck;
    w.add_shape(plane);
    d.kind = BodyKind::rigid;
    d.mass = 100.0;
    d.inertia = 100.0 / 6.0 * Mat3::Identity();
    d.position = {0, 0, 0.5};
    const BodyId box = w.add_body(d);
    ShapeDef s;
    s.kind = ShapeKind::box;
    s.half_size = {0.5, 0.5, 0.5};
    s.body = box;
    w.add_shape(s);
    d.kind = BodyKind::lump;
    d.position = {5, 0, -1};
    d.linear_damping = {40, 40, 40};
    const BodyId bob = w.add_body(d);
    InteractionDef line;
    line.kind = InteractionKind::Stretch;
    line.body = {deck, bob};
    line.point[0] = {5, 0, 0};
    line.set("EA", 1e6);
    w.add_interaction(line);
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok);
    };
    run(240);
    EXPECT_TRUE(w.asleep(box));
    EXPECT_TRUE(w.asleep(bob));
    // Slower than sleep_speed: the cargo is at rest by its speed, but its carrier is not.
    w.set_velocity(deck, {{5e-5, 0, 0}, Vec3::Zero()});
    run(1);
    EXPECT_FALSE(w.asleep(box));
    EXPECT_FALSE(w.asleep(bob));
    run(240);
    EXPECT_FALSE(w.asleep(box));
    EXPECT_NEAR(w.pose(box).position.x(), 241 * 5e-5 / 60.0, 1e-6);
    w.set_velocity(deck, {});
    run(240);
    EXPECT_TRUE(w.asleep(box));
    EXPECT_TRUE(w.asleep(bob));
    // A new pose wakes all bodies that may depend on it.
    Pose p = w.pose(deck);
    p.position.z() += 0.01;
    w.set_pose(deck, p);
    run(1);
    EXPECT_FALSE(w.asleep(box));
    EXPECT_FALSE(w.asleep(bob));
}

TEST(Sleep, WhatLosesItsSupportFalls) {
    SleepYard y(sleepy());
    y.run(kSettled);
    ASSERT_EQ(y.asleep(), kAll);
    Pose p = y.w.pose(y.box[0]);
    p.position.x() += 20.0;
    y.w.set_pose(y.box[0], p);
    y.run(kSettled);
    EXPECT_NEAR(y.w.pose(y.box[1]).position.z(), 0.5, 1e-3);
    EXPECT_NEAR(y.w.pose(y.box[2]).position.z(), 1.5, 1e-3);
}

/// The force of an input and that of the user are separate: together they may balance a body.
TEST(Sleep, ForcesThatHeldEachOtherWakeWhereOneEnds) {
    SleepYard y(sleepy());
    InputDef in;
    in.name = "shove";
    in.body = y.ball;
    const InputId shove = y.w.add_input(in);
    y.w.set_input(shove, 60.0);
    y.w.set_force(y.ball, {-60.0, 0.0, 0.0}, Vec3::Zero());
    y.run(kSettled);
    ASSERT_TRUE(y.w.asleep(y.ball));
    const double x = y.w.pose(y.ball).position.x();
    y.w.set_input(shove, 60.0);
    y.run(2);
    ASSERT_TRUE(y.w.asleep(y.ball));
    y.w.set_force(y.ball, Vec3::Zero(), Vec3::Zero());
    y.run(60);
    EXPECT_GT(y.w.pose(y.ball).position.x(), x + 0.5);
}

/// A slide whose friction depends on the load of another one, without a common body.
TEST(Sleep, LoadsOfFrictionBelongToIt) {
    World w(sleepy());
    BodyDef d;
    d.kind = BodyKind::fixed;
    const BodyId ground = w.add_body(d);
    d.kind = BodyKind::rigid;
    d.mass = 10.0;
    d.inertia = Mat3::Identity();
    const auto slide = [&](double x, const Quat& along) {
        d.position = {x, 0, 0};
        InteractionDef s;
        s.kind = InteractionKind::Prismatic;
        s.body = {ground, w.add_body(d)};
        s.point[0] = d.position;
        s.frame[0] = s.frame[1] = along;
        return w.add_interaction(s);
    };
    const InteractionId bears = slide(0.0, Quat(Eigen::AngleAxisd(1.5707963, Vec3::UnitY())));
    const InteractionId hangs = slide(5.0, Quat::Identity());
    InteractionDef f = w.interaction_def(hangs);
    const BodyId weight = f.body[1], load = w.interaction_def(bears).body[1];
    f.kind = InteractionKind::SlideFriction;
    f.compliance.fill(kDefault);
    f.damping_time.fill(kDefault);
    f.params.fill(kDefault);
    f.load[0] = {bears, 2.0};
    w.add_interaction(f);
    for (int i = 0; i < 240; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_TRUE(w.asleep(weight));
    w.set_force(load, {0, 0, 98.1}, Vec3::Zero());
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.pose(weight).position.z(), -4.0);
}

/// Events of limits belong to a step: an analysis in between loses none.
TEST(Sleep, LosesNoEvent) {
    std::int64_t met[2] = {};
    int slept = 0;
    for (int sleeps = 0; sleeps < 2; ++sleeps) {
        WorldDef def;
        def.sleep_after = sleeps ? 0.01 : 0.0;
        World w(def);
        BodyDef d;
        d.kind = BodyKind::fixed;
        const BodyId ground = w.add_body(d);
        d.kind = BodyKind::rigid;
        d.mass = 10.0;
        d.inertia = Mat3::Identity();
        d.gravity = false;
        const BodyId still = w.add_body(d);
        for (int k = 0; k < 60; ++k) {
            d.position = {2.0 + k, 0, 0};
            d.velocity = {0, 0, 1.0};
            InteractionDef s;
            s.kind = InteractionKind::Prismatic;
            s.body = {ground, w.add_body(d)};
            s.point[0] = d.position;
            w.add_interaction(s);
            InteractionDef range = s;
            range.kind = InteractionKind::SlideRange;
            // Each is reached in another step.
            range.set("min", -10.0).set("max", 0.3 + k / 60.0);
            w.add_interaction(range);
        }
        for (int i = 0; i < 100; ++i) {
            if (i % 5 == 0) w.wake(still);
            slept += w.asleep(still) ? 1 : 0;
            ASSERT_EQ(w.step(), Status::ok);
        }
        met[sleeps] = w.stats().event_count[static_cast<std::size_t>(EventKind::range)];
    }
    EXPECT_EQ(met[0], met[1]);
    EXPECT_GE(met[0], 60);
    EXPECT_GT(slept, 10);
}

TEST(Sleep, ABodyThatIsAddedWakesWhatItFallsOn) {
    SleepYard y(sleepy());
    y.run(kSettled);
    ASSERT_EQ(y.asleep(), kAll);
    const BodyId more = y.add_box({0.0, 0.0, 4.0});
    y.run(1);
    EXPECT_EQ(y.asleep(), kAll) << "it is in the air";
    EXPECT_FALSE(y.w.asleep(more));
    y.run(30);
    EXPECT_EQ(y.w.stats().asleep, 9 - 3) << "the stack that it fell on is awake";
    y.run(kSettled);
    EXPECT_TRUE(y.w.asleep(more));
    EXPECT_EQ(y.w.stats().asleep, 10);
    EXPECT_NEAR(y.w.pose(more).position.z(), 3.5, 1e-3);
}

TEST(Sleep, SnapshotsAndThreadsKeepTheBits) {
    const auto disturb = [](SleepYard& y, int step) {
        if (step == 20) y.w.set_input(y.brake, 50.0);
        if (step == 50) y.w.set_velocity(y.ball, {{-12.0, 0.0, 0.0}, {0.0, -24.0, 0.0}});
    };
    SleepYard y(sleepy());
    y.run(kSettled);
    const std::vector<std::byte> saved = y.w.state().save();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 400; ++i) {
        disturb(y, i);
        y.run(1);
        hashes.push_back(y.w.state().hash());
    }
    for (const int threads : {1, 2, 4}) {
        SleepYard z(sleepy(Nonsmooth::newton, threads));
        z.w.state().restore(saved);
        EXPECT_EQ(z.asleep(), kAll);
        EXPECT_EQ(z.w.stats().asleep, 9);
        for (int i = 0; i < 400; ++i) {
            disturb(z, i);
            z.run(1);
            ASSERT_EQ(z.w.state().hash(), hashes[static_cast<std::size_t>(i)])
                << threads << " " << i;
        }
    }
    // Settings of sleep must agree.
    SleepYard awake{WorldDef{}};
    EXPECT_THROW(awake.w.state().restore(saved), DefError);
}

class SleepMethods : public testing::TestWithParam<Nonsmooth> {};

TEST_P(SleepMethods, FallAsleepAndWake) {
    WorldDef def = sleepy(GetParam());
    // Sweeps end without convergence.
    def.sleep_speed = 1e-2;
    SleepYard y(def);
    y.run(kSettled);
    EXPECT_EQ(y.asleep(), kAll);
    const std::vector<double> before = y.state();
    y.run(60);
    EXPECT_EQ(y.state(), before);
    y.w.set_velocity(y.ball, {{-12.0, 0.0, 0.0}, {0.0, -24.0, 0.0}});
    y.w.set_input(y.brake, 50.0);
    y.run(30);
    EXPECT_EQ(y.asleep(), "....zzzz.");
    EXPECT_LT(y.w.pose(y.ball).position.x(), 3.0);
}

INSTANTIATE_TEST_SUITE_P(All, SleepMethods,
                         testing::Values(Nonsmooth::newton, Nonsmooth::pivoting, Nonsmooth::split,
                                         Nonsmooth::pgs, Nonsmooth::convex));

}  // namespace
}  // namespace hawser
