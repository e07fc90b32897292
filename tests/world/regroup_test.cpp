// SPDX-License-Identifier: Apache-2.0
/// Groups that the world makes itself and that follow its state.
#include "support/tier.h"
#include "world/three_cables.h"

#include <hawser/experimental/splits.h>

#include <map>

namespace hawser::test::regrouping {
namespace {

/// Return the sum of the weights of the cuts, computed from the state.
double weight_of_cuts(const World& w) {
    PartitionRequest request{.use = PartitionUse::cuts, .parts = 2, .exact_cost = false};
    request.group = w.splits().groups();
    double sum = 0.0;
    for (const CutInteraction& c : w.splits().partition(request).cuts) sum += c.weight;
    return sum;
}

TEST(Regroup, TheCutOfARunningWorldLeavesTheCableThatAccelerates) {
    for (std::size_t fast = 0; fast < 3; ++fast) {
        SCOPED_TRACE(fast);
        const Cables t(2);
        World w = t.recipe.make();
        const std::vector<std::int32_t> first = w.splits().groups();
        EXPECT_EQ(std::set<std::int32_t>(first.begin(), first.end()).size(), 2U);
        t.turn(w, fast);
        t.pull(w, (fast + 1) % 3);
        run(w, 9 * kEvery);
        const std::set<std::size_t> cut = t.cut_cables(w);
        ASSERT_FALSE(cut.empty());
        EXPECT_FALSE(cut.contains(fast));
    }
}

/// With one cut, at first by hand the only cable that moves: the cut cable starts to rotate.
TEST(Regroup, ACutMovesAlongACableThatStartsToTurn) {
    const Cables t(2);
    World moves = t.recipe.make();
    World stays = t.recipe.make();
    run(moves, kEvery);
    run(stays, kEvery);
    stays.splits().follow_groups(2, 0);
    const std::int64_t settled = stays.stats().regroupings;
    const auto before = moves.splits().groups();
    ASSERT_EQ(before, stays.splits().groups());
    const std::size_t cut = *t.cut_cables(moves).begin();
    for (World* w : {&moves, &stays}) t.turn(*w, cut);
    run(moves, 8 * kEvery);
    run(stays, 8 * kEvery);
    EXPECT_NE(moves.splits().groups(), before);
    EXPECT_EQ(stays.splits().groups(), before);
    EXPECT_GT(moves.stats().regroupings, settled);
    EXPECT_GT(moves.stats().regrouped_bodies, stays.stats().regrouped_bodies);
    EXPECT_EQ(stays.stats().regroupings, settled);
    EXPECT_LT(weight_of_cuts(moves), weight_of_cuts(stays));
}

/// Check that groups no longer change after the oscillations due to a pull have decayed, within
/// some seconds.
void leave_alone(Coupling coupling, Predictor predictor) {
    Cables t(3);
    t.recipe.world.coupling = coupling;
    t.recipe.world.predictor = predictor;
    World w = t.recipe.make();
    for (std::size_t c = 0; c < 3; ++c) t.pull(w, c);
    run(w, 20 * kEvery);
    const std::int64_t once = w.stats().regroupings;
    const auto groups = w.splits().groups();
    run(w, 40 * kEvery);
    EXPECT_EQ(w.stats().regroupings, once);
    EXPECT_EQ(w.splits().groups(), groups);
}

TEST(Regroup, ASteadySceneIsLeftAlone) {
    leave_alone(Coupling::compliant, Predictor::hold);
    leave_alone(Coupling::kinematic, Predictor::clique);
}

TEST(Regroup, GroupsByHandStay) {
    const Cables t(3);
    World w = t.recipe.make();
    for (const BodyId b : t.cable[1]) w.splits().set_group(b, "mine");
    w.splits().set_group(t.cable[2].back(), "other");
    t.turn(w, 0);
    t.pull(w, 2);
    for (int k = 0; k < 6 * kEvery; ++k) {
        run(w, 1);
        const auto groups = w.splits().groups();
        const auto of = [&](BodyId b) { return groups[static_cast<std::size_t>(b.index)]; };
        for (const BodyId b : t.cable[1]) ASSERT_EQ(of(b), of(t.cable[1].front())) << k;
        ASSERT_NE(of(t.cable[2].back()), of(t.cable[1].front())) << k;
        // The others are distributed nevertheless.
        ASSERT_EQ(std::set<std::int32_t>(groups.begin(), groups.end()).size(), 3U) << k;
    }
    w.splits().set_group(t.cable[2].back(), "");
    run(w, 1);
    EXPECT_EQ(w.body_def(t.cable[1][0]).group, "mine");
}

TEST(Regroup, GroupsByHandEndIt) {
    const Cables t(2);
    World w = t.recipe.make();
    run(w, 2 * kEvery);
    w.splits().set_groups(2);
    EXPECT_EQ(w.settings().parts, 0);
    const auto groups = w.splits().groups();
    const std::int64_t before = w.stats().regroupings;
    const std::size_t cut = *t.cut_cables(w).begin();
    t.turn(w, cut);
    run(w, 6 * kEvery);
    EXPECT_EQ(w.splits().groups(), groups);
    EXPECT_EQ(w.stats().regroupings, before);
}

TEST(Regroup, CanBeBegunAndEndedInARunningWorld) {
    const Cables t(0);
    World w = t.recipe.make();
    run(w, 5);
    EXPECT_TRUE(w.splits().cuts().empty());
    w.splits().follow_groups(2, kEvery);
    run(w, 5);
    EXPECT_FALSE(w.splits().cuts().empty());
    w.splits().follow_groups(0);
    run(w, 5);
    EXPECT_TRUE(w.splits().cuts().empty());
    EXPECT_THROW(w.splits().follow_groups(-1), DefError);
    EXPECT_THROW(w.splits().follow_groups(4097), DefError);
    EXPECT_THROW(w.splits().follow_groups(2, -1), DefError);
    EXPECT_EQ(w.settings().parts, 0);
    // Exact coupling needs no groups.
    for (std::int32_t i = 0; i < w.interaction_count(); ++i)
        w.splits().set_coupling(InteractionId{i}, Coupling::exact);
    w.splits().follow_groups(2);
    run(w, 5);
    EXPECT_EQ(w.stats().cuts, 0);
}

TEST(Regroup, WhatIsCoupledExactlyIsNotCut) {
    const Cables t(2);
    World w = t.recipe.make();
    for (std::int32_t i = 0; i < 2 * kNodes; ++i)
        w.splits().set_coupling(InteractionId{i}, Coupling::exact);
    EXPECT_EQ(t.cut_cables(w), std::set<std::size_t>{2});
    run(w, 3 * kEvery);
    EXPECT_EQ(t.cut_cables(w), std::set<std::size_t>{2});
}

/// Act on a world whose groups move several times: the loads of a step.
void play(const Cables& t, World& w, int step) {
    if (step == kEvery + 3) t.turn(w, *t.cut_cables(w).begin());
    if (step == 3 * kEvery) t.pull(w, 1);
    if (step == 5 * kEvery + 1) t.turn(w, *t.cut_cables(w).begin());
}

TEST(Regroup, IsTheSameForAnyNumberOfThreads) {
    std::map<int, std::vector<std::uint64_t>> hash;
    for (const int threads : {1, 2, 5}) {
        const Cables t(3, kEvery, threads);
        World w = t.recipe.make();
        for (int i = 0; i < 8 * kEvery; ++i) {
            play(t, w, i);
            ASSERT_EQ(w.step(), Status::ok);
            hash[threads].push_back(w.state().hash());
        }
        EXPECT_GT(w.stats().regroupings, 1);
    }
    EXPECT_EQ(hash[1], hash[2]);
    EXPECT_EQ(hash[1], hash[5]);
}

TEST(Regroup, GoesOnBitForBitFromASnapshotOfAnyStep) {
    const Cables t(3);
    World a = t.recipe.make();
    std::vector<std::vector<std::byte>> saved;
    std::vector<std::uint64_t> hash;
    std::vector<std::int64_t> changes;
    constexpr int kSteps = 8 * kEvery;
    for (int i = 0; i < kSteps; ++i) {
        play(t, a, i);
        saved.push_back(a.state().save());
        changes.push_back(a.stats().regroupings);
        ASSERT_EQ(a.step(), Status::ok);
        hash.push_back(a.state().hash());
    }
    ASSERT_GT(a.stats().regroupings, 1);
    // In a world that is new each time, and in one whose groups are from another time.
    World again = t.recipe.make();
    run(again, 2 * kEvery + 7);
    Random random(first_seed(5));
    const int longest_stride = by_tier(21, 7, 1);
    for (int i = 1; i < kSteps; i += random.integer(1, longest_stride)) {
        SCOPED_TRACE(i);
        World fresh = t.recipe.make();
        for (World* w : {&fresh, &again}) {
            w->state().restore(saved[static_cast<std::size_t>(i)]);
            ASSERT_EQ(w->state().save(), saved[static_cast<std::size_t>(i)]);
            for (int k = i; k < std::min(kSteps, i + kEvery + 12); ++k) {
                if (k > i) play(t, *w, k);  // the snapshot was taken after it
                ASSERT_EQ(w->step(), Status::ok);
                ASSERT_EQ(w->state().hash(), hash[static_cast<std::size_t>(k)]) << "step " << k;
            }
        }
    }
    // Damage is rejected, for any groups.
    const auto& good = saved[kSteps - 1];
    again.state().restore(saved[1]);
    const std::uint64_t before = again.state().hash();
    const int trials = by_tier(100, 500, 5000);
    for (int trial = 0; trial < trials; ++trial) {
        auto bytes = good;
        const int where = random.integer(0, static_cast<int>(bytes.size()) - 1);
        bytes[static_cast<std::size_t>(where)] ^= static_cast<std::byte>(random.integer(1, 255));
        EXPECT_THROW(again.state().restore(bytes), DefError) << "byte " << where;
        ASSERT_EQ(again.state().hash(), before);
    }
    EXPECT_EQ(again.state().save(), saved[1]);
}

TEST(Regroup, TwinsHaveTheGroupsAndGoOnAlike) {
    const Cables t(3);
    World a = t.recipe.make();
    for (int i = 0; i < 4 * kEvery - 2; ++i) {
        play(t, a, i);
        ASSERT_EQ(a.step(), Status::ok);
    }
    ASSERT_GT(a.stats().regroupings, 0);
    World b = a.twin();
    EXPECT_EQ(b.splits().groups(), a.splits().groups());
    EXPECT_EQ(b.state().hash(), a.state().hash());
    World c = t.recipe.make();
    c.state().copy_from(a);
    EXPECT_EQ(c.splits().groups(), a.splits().groups());
    World exact = a.twin(Coupling::exact);
    EXPECT_TRUE(exact.splits().cuts().empty());
    run(exact, kEvery);
    for (int i = 4 * kEvery - 2; i < 6 * kEvery; ++i) {
        play(t, a, i);
        play(t, b, i);
        play(t, c, i);
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(b.step(), Status::ok);
        ASSERT_EQ(c.step(), Status::ok);
        ASSERT_EQ(b.splits().groups(), a.splits().groups()) << i;
        ASSERT_EQ(c.splits().groups(), a.splits().groups()) << i;
    }
}

}  // namespace
}  // namespace hawser::test::regrouping
