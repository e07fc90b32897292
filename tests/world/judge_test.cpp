// SPDX-License-Identifier: Apache-2.0
/// Physically impossible states end a run, with a message, and equally after a restore.
#include "support/recipe.h"

#include <hawser/limits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

/// Two boxes under gravity, one hanging from the ground.
struct Boxes {
    Recipe recipe;
    BodyId a, b;
    Boxes() {
        const BodyId g = recipe.ground();
        a = recipe.rigid({0, 0, -1}, Quat::Identity(), 100.0, {30, 30, 10});
        b = recipe.rigid({1, 0, -1}, Quat::Identity(), 50.0, {8, 8, 8});
        recipe.add(recipe.at(InteractionKind::Ball, {g, a}, {0, 0, 0}));
        recipe.add(recipe.at(InteractionKind::Ball, {a, b}, {0.5, 0, -1}));
    }
    /// Add a second ball joint 0.5 m from the first one in a, 0.9 m in b: no pose can close both.
    Boxes& contradict() {
        InteractionDef d = between(InteractionKind::Ball, {a, b});
        d.name = "other";
        d.point[0] = {0.5, 0.5, 0};
        d.point[1] = {-0.5, 0, 0.9};
        recipe.add(d);
        return *this;
    }
};

/// Step until a step is not ok, at most `steps` times. @return the last status.
Status run(World& w, int steps) {
    Status status = Status::ok;
    for (int i = 0; i < steps && status == Status::ok; ++i) status = w.step();
    return status;
}

TEST(Judge, WhatSwingsIsGood) {
    World w = Boxes().recipe.make();
    ASSERT_EQ(run(w, 120), Status::ok);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.grade, Grade::good) << to_string(v.judge);
    for (const Finding& f : v.worst) EXPECT_LT(f.wrong, 0.2);  // far from every limit
    EXPECT_EQ(w.stats().event_count[static_cast<std::size_t>(EventKind::joint_open)], 0);
}

TEST(Judge, ContradictoryJointsEndAsDivergedAndTheStateBeforeStays) {
    Recipe contradicting = Boxes().contradict().recipe;
    contradicting.world.on_diverged = OnDiverged::stop;
    World w = contradicting.make();
    ASSERT_EQ(run(w, 60), Status::diverged);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.grade, Grade::wrong);
    EXPECT_GT(std::max(v.of(Judge::violation).wrong, v.of(Judge::energy).wrong), 1.0);
    EXPECT_TRUE(v.of(Judge::violation).interaction.valid());
    EXPECT_LE(v.of(v.judge).time, w.time());
    const std::uint64_t hash = w.state().hash();
    const std::int64_t steps = w.step_count();
    EXPECT_EQ(w.step(), Status::diverged) << "the next call tries the same step again";
    EXPECT_EQ(w.state().hash(), hash);
    EXPECT_EQ(w.step_count(), steps);
    EXPECT_NE(std::string(remedy(v.judge)), "");
}

TEST(Judge, WarnGoesOnAndSaysSo) {
    Recipe r = Boxes().contradict().recipe;
    r.world.on_diverged = OnDiverged::warn;
    World w = r.make();
    ASSERT_EQ(run(w, 60), Status::ok);
    EXPECT_EQ(w.verdict().grade, Grade::wrong);
    const std::vector<Event> events = w.events().take();
    const auto open = std::find_if(events.begin(), events.end(),
                                   [](const Event& e) { return e.kind == EventKind::joint_open; });
    ASSERT_NE(open, events.end());
    EXPECT_TRUE(open->interaction.valid());
    EXPECT_GT(open->value, limit::kOpen.doubtful);
}

World open_rod(Nonsmooth method) {
    Recipe r;
    r.world.gravity = Vec3::Zero();
    r.world.nonsmooth = method;
    r.world.on_diverged = OnDiverged::stop;
    const BodyId g = r.ground(), b = r.lump({1.3, 0, 0}, 1.0);
    InteractionDef d = between(InteractionKind::Distance, {g, b});
    r.add(d.set("length", 1.0));
    return r.make();
}

/// A scene may start with an open joint: poses that the first step closes are good.
TEST(Judge, AJointThatStartsOpenMayClose) {
    World w = open_rod(Nonsmooth::newton);
    ASSERT_EQ(run(w, 120), Status::ok);
    EXPECT_EQ(w.verdict().grade, Grade::good) << to_string(w.verdict().judge);
}

/// A joint that takes several steps to close is reported as open, but not rejected.
TEST(Judge, AJointThatStartsOpenAndStaysSoIsDoubtful) {
    World w = open_rod(Nonsmooth::pivoting);  // without position projection
    ASSERT_EQ(run(w, 120), Status::ok);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.grade, Grade::doubtful);
    EXPECT_EQ(v.judge, Judge::violation) << to_string(v.judge);
    EXPECT_LT(v.of(Judge::violation).wrong, 1.0);
    EXPECT_LT(w.stats().violation_max, limit::kOpen.doubtful);
}

/// A body on a short rod whips round its lowest point within two steps. In these two the energy
/// error is 3 % of the exchanged energy, and half a per cent is lost afterwards. Each halving of
/// the step reduces the error to a quarter.
TEST(Judge, EnergyThatSwingsForTwoStepsIsNotCreated) {
    Recipe r;
    r.world.step = 0.01024;
    const BodyId g = r.ground();
    const Vec3 half(0.1176, 0.2497, 0.4314);
    const double mass = 748.0;
    const Vec3 principal(half.y() * half.y() + half.z() * half.z(),
                         half.z() * half.z() + half.x() * half.x(),
                         half.x() * half.x() + half.y() * half.y());
    const BodyId b =
        r.rigid({0.44359, 0.01237, -0.27831}, Quat(0.1918, 0.18422, 0.41623, -0.8695).normalized(),
                mass, mass / 3.0 * principal);
    InteractionDef rod = between(InteractionKind::Distance, {g, b});
    rod.point[0] =
        Quat(0.68944, -0.02239, -0.14713, -0.70889).normalized() * Vec3(-0.14296, 0.05506, 0.24717);
    rod.point[1] = {0.40321, -0.14633, 0.27973};
    r.add(rod);
    World w = r.make();
    double least = 1e300, swing = 0.0;
    for (int i = 0; i < 98; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const double total = w.energy().mechanical();
        least = std::min(least, total);
        swing = std::max(swing, total - least);
    }
    EXPECT_GT(swing, 100.0) << "[J]: else this tests nothing";
    EXPECT_EQ(w.verdict().grade, Grade::good) << to_string(w.verdict().judge);
}

/// The monitor's sums are part of the state: a restored world rejects the same step.
TEST(Judge, ARestoredWorldGivesTheSameVerdict) {
    Recipe r = Boxes().contradict().recipe;
    r.world.on_diverged = OnDiverged::stop;
    World w = r.make();
    ASSERT_EQ(run(w, 1), Status::ok);
    const std::vector<std::byte> saved = w.state().save();
    const Status end = run(w, 2000);
    ASSERT_NE(end, Status::ok) << "joints that contradict each other";
    World other = r.make();
    other.state().restore(saved);
    EXPECT_EQ(run(other, 2000), end);
    EXPECT_EQ(other.step_count(), w.step_count());
    EXPECT_EQ(other.state().hash(), w.state().hash());
    EXPECT_EQ(other.state().save(), w.state().save());
}

TEST(Judge, PuttingABodyElsewhereIsNoEnergyOutOfNothing) {
    Recipe r;
    const BodyId b = r.rigid({0, 0, 0}, Quat::Identity(), 10.0, {1, 1, 1});
    World w = r.make();
    ASSERT_EQ(run(w, 60), Status::ok);
    w.set_pose(b, {{0, 0, 1000.0}, Quat::Identity()});
    w.set_velocity(b, {{100, 0, 0}, {0, 0, 0}});
    ASSERT_EQ(run(w, 60), Status::ok);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

TEST(Judge, AFastTurnIsToldWithItsBody) {
    Recipe r;
    const BodyId b = r.add({.kind = BodyKind::rigid,
                            .angular_velocity = {0, 0, 60.0},  // a radian per step
                            .mass = 10.0,
                            .inertia = Mat3::Identity()});
    World w = r.make();
    ASSERT_EQ(run(w, 30), Status::ok);
    const std::vector<Event> events = w.events().take();
    ASSERT_EQ(events.size(), 1U) << "once until it is well again";
    EXPECT_EQ(events[0].kind, EventKind::fast);
    EXPECT_EQ(events[0].body, b);
    EXPECT_NEAR(events[0].value, 1.0, 1e-9);
    EXPECT_EQ(w.verdict().grade, Grade::good) << "speed alone makes nothing doubtful";
}

}  // namespace
}  // namespace hawser::test
