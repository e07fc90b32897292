// SPDX-License-Identifier: Apache-2.0
// The frozen scene anchor_run: its size, its first seconds, the same bits on any number of threads
// and after a restore; as a long test, all that is done in it.

#include <hawser/session.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr const char* kRunScene = "scenes/anchor_run.json";

/// Steps compared: lines are let go and shackled in the first, nodes go in all of them.
int compared_steps() { return std::getenv("HAWSER_LONG") != nullptr ? 1000 : 60; }

SessionDef run_on(int threads) {
    SessionDef def{.scene = kRunScene};
    def.options.threads = threads;
    return def;
}

std::vector<std::uint64_t> run_hashes(Session& session, int steps) {
    std::vector<std::uint64_t> out;
    for (int i = 0; i < steps; ++i) {
        EXPECT_EQ(session.step(), Status::ok) << "step " << i;
        out.push_back(session.world().state_hash());
    }
    return out;
}

// As with the other frozen scenes: a change of these numbers is a change of the scene, or of how
// scene files are read.
TEST(AnchorRun, IsFrozen) {
    Session session(run_on(1));
    EXPECT_EQ(session.scene().hash, 0x4a9aa5fee79bb623U);
    EXPECT_EQ(session.world().body_count(), 1882);
    EXPECT_EQ(session.scene().timeline.size(), 23U);
    int elements = 0;
    for (const WireId id : session.world().wires())
        elements += static_cast<int>(session.world().elements(id).size());
    EXPECT_GE(elements, 1000);
}

TEST(AnchorRun, StartsCertifiedAsOneIsland) {
    Session session(run_on(1));
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(session.step(), Status::ok) << "step " << i;
        const StepStats& stats = session.world().stats();
        ASSERT_LE(stats.natural_map, 1e-6) << "step " << i;  // What the solver promises.
        ASSERT_EQ(stats.flips_left, 0) << "step " << i;
        ASSERT_EQ(stats.islands, 1) << "step " << i;
    }
}

TEST(AnchorRun, HasTheSameBitsOnAnyNumberOfThreadsAndRestored) {
    const int steps = compared_steps();
    Session one(run_on(1));
    const std::vector<std::uint64_t> first = run_hashes(one, steps);
    const Structure made_of = one.world().structure();
    const std::vector<std::byte> state = one.world().save();
    const std::vector<std::uint64_t> rest = run_hashes(one, steps);
    for (const int threads : {2, 4, 8}) {
        Session more(run_on(threads));
        EXPECT_EQ(run_hashes(more, steps), first) << threads << " threads";
    }
    Session again(run_on(2));
    again.restore(made_of, state);
    EXPECT_EQ(run_hashes(again, steps), rest);
}

}  // namespace
}  // namespace hawser
