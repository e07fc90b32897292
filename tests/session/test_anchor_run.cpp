// SPDX-License-Identifier: Apache-2.0
// The frozen scene anchor_run: its size, its first seconds, the same bits on any number of threads
// and after a restore; as a long test, all its operations.

#include <hawser/session.h>

#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr const char* kRunScene = "scenes/anchor_run.json";

/// Return the number of compared steps: lines are released and shackled in the first, nodes are
/// removed in all of them.
int compared_steps() { return test::by_tier(30, 60, 1000); }

SessionDef run_on(int threads) {
    SessionDef def{.scene = kRunScene};
    def.options.threads = threads;
    return def;
}

std::vector<std::uint64_t> run_hashes(Session& session, int steps) {
    std::vector<std::uint64_t> out;
    for (int i = 0; i < steps; ++i) {
        EXPECT_EQ(session.step(), Status::ok) << "step " << i;
        out.push_back(session.world().state().hash());
    }
    return out;
}

// Compare the frozen copy with its original counts and hash (CONTRIBUTING.md).
TEST(AnchorRun, IsFrozen) {
    Session session({.scene = "bench/scenes/frozen/anchor_run.json"});
    EXPECT_EQ(session.scene().hash, 0x04bab8e3874bba63U);
    EXPECT_EQ(session.world().body_count(), 1882);
    EXPECT_EQ(session.scene().timeline.size(), 23U);
    int elements = 0;
    for (const WireId id : session.world().wires().ids())
        elements += static_cast<int>(session.world().wires().elements(id).size());
    EXPECT_GE(elements, 1000);
}

TEST(AnchorRun, StartsCertifiedAsOneIsland) {
    Session session(run_on(1));
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(session.step(), Status::ok) << "step " << i;
        const StepStats& stats = session.world().stats();
        ASSERT_LE(stats.natural_map, 1e-6) << "step " << i;  // Guarantee of the solver.
        ASSERT_EQ(stats.flips_left, 0) << "step " << i;
        ASSERT_EQ(stats.islands, 1) << "step " << i;
    }
}

TEST(AnchorRun, HasTheSameBitsOnAnyNumberOfThreadsAndRestored) {
    const int steps = compared_steps();
    Session one(run_on(1));
    const std::vector<std::uint64_t> first = run_hashes(one, steps);
    const Structure made_of = one.world().state().structure();
    const std::vector<std::byte> state = one.world().state().save();
    const std::vector<std::uint64_t> rest = run_hashes(one, steps);
    for (const int threads : {2, 4, 8}) {
        Session more(run_on(threads));
        EXPECT_EQ(run_hashes(more, steps), first) << threads << " threads";
    }
    Session again(run_on(2));
    again.restore(made_of, state);
    EXPECT_EQ(run_hashes(again, steps), rest);
}

/// Run all ten minutes, phase by phase.
TEST(AnchorRun, TakesTheAnchorChangesToChainAndRunsItOut_long) {
    Session session(run_on(1));
    World& world = session.world();
    const auto run_to = [&](double time) {
        while (session.time() < time - 1e-6) {
            ASSERT_EQ(session.step(), Status::ok) << session.time();
            ASSERT_LE(world.stats().natural_map, 1e-6) << session.time();
            ASSERT_EQ(world.stats().flips_left, 0) << session.time();
            for (const Event& e : session.events())
                ASSERT_NE(e.kind, EventKind::line_break) << session.time();
        }
    };
    const BodyId anchor = world.find_body("anchor1"), ship = world.find_body("ahts1/hull");
    const auto on_deck = [&] {
        const Vec3 at = world.local_point(ship, world.pose(anchor).position);
        // Its middle is half its height, 0.8 m, above the deck at 1.2 m, which yields by
        // millimetres.
        return at.x() > -33.0 && at.x() < -29.0 && std::abs(at.y() - 1.0) < 0.5 &&
               std::abs(at.z() - 2.0) < 0.02;
    };
    ASSERT_NO_FATAL_FAILURE(run_to(211.0));
    EXPECT_TRUE(on_deck());
    ASSERT_NO_FATAL_FAILURE(run_to(231.0));
    EXPECT_EQ(world.system_signal("jaw.state"), 2.0);  // StopperState::holding
    const double alone = world.system_signal("jaw.load");
    EXPECT_GT(alone, 2e5) << "it has the chain, the wire is slack";
    EXPECT_LT(world.system_signal("work1_winch.pull"), 1e4);
    ASSERT_NO_FATAL_FAILURE(run_to(249.0));
    EXPECT_FALSE(world.find_interaction("chain1_shackle").valid()) << "the anchor has nothing";
    EXPECT_TRUE(world.find_interaction("chain_strop").valid());
    ASSERT_NO_FATAL_FAILURE(run_to(284.0));
    EXPECT_LT(world.system_signal("jaw.load"), 0.5 * alone) << "the wire has taken the chain over";
    ASSERT_NO_FATAL_FAILURE(run_to(299.0));
    EXPECT_EQ(world.system_signal("jaw.state"), 0.0);
    const double in = world.system_signal("work1_winch.wire_left");
    ASSERT_NO_FATAL_FAILURE(run_to(430.0));
    EXPECT_NEAR(in - world.system_signal("work1_winch.wire_left"), 84.0, 0.5);  // 120 s, 0.7 m/s
    ASSERT_NO_FATAL_FAILURE(run_to(600.0));
    EXPECT_TRUE(on_deck()) << "the anchor stayed where it was";
    EXPECT_EQ(world.stats().islands, 1);
    EXPECT_NE(world.verdict().grade, Grade::wrong);
}

}  // namespace
}  // namespace hawser
