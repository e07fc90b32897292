// SPDX-License-Identifier: Apache-2.0
/// Scenes with contacts give the same bits for any number of threads, and after restoring a state
/// into a world with another number of threads. `hawser-bench hashes` runs 1,000 steps of each.
#include "hashes/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace hawser::bench {
namespace {

void expect_equal(const HashComparison& c) {
    EXPECT_EQ(c.status, Status::ok) << c.scene;
    for (const HashRun& r : c.runs)
        EXPECT_EQ(r.first_difference, 0)
            << c.scene << ": step that differs on " << r.threads
            << " thread(s), restored from a state of " << r.restored_from;
}

/// Enough steps for sliding, or for the landing of bodies that do not slide, or for joints at their
/// ends.
const std::map<std::string, int> kSteps = {
    {"bouncing_ball", 200}, {"painleve", 500}, {"joint_limits", 200}};
constexpr int kFewSteps = 20;
const std::set<std::string> kAtRest = {
    "anchor_adaptive", "anchor_contact",     "arch",          "bouncing_ball", "box_stack",
    "box_stack_1e6",   "rolling_resistance", "crane_knuckle", "crane_lattice", "chaser",
    "wire_edge",       "wire_pins",          "wire_slide"};

/// Scenes with friction, ranges and motors, without contacts.
const std::set<std::string> kJoints = {
    "anchor_lines", "anchor_sea", "joint_friction", "joint_limits", "motor_limits", "payout",
    "slider_crank", "tackle",     "winch_modes",    "wire_part",    "wire_bollard"};

TEST(Hashes, DoNotDependOnThreadsOrRestoring_full) {
    const auto files = nonsmooth_scenes("scenes");
    EXPECT_GE(files.size(), 24U);
    for (const std::string& file : files) {
        const std::string name = file.substr(7, file.size() - 12);
        HashOptions options;
        const auto steps = kSteps.find(name);
        options.steps = steps == kSteps.end() ? kFewSteps : steps->second;
        const HashComparison c = compare_hashes(file, options);
        EXPECT_EQ(c.scene, name);
        EXPECT_EQ(c.runs.size(), 7U) << "three from the start, four from states";
        expect_equal(c);
        EXPECT_EQ(c.contacts_max > 0, !kJoints.contains(name)) << name;
        EXPECT_EQ(c.sliding_steps > 0, !kAtRest.contains(name) && !kJoints.contains(name)) << name;
    }
}

/// Nodes are inserted and removed, also in the step after a saved state. `make test-long` runs
/// whole scenes.
TEST(Hashes, DoNotDependOnRestoringWhereNodesComeAndGo) {
    for (const char* scene : {"payout", "tow_payout"}) {
        HashOptions options;
        options.steps = 1700;
        options.threads = {1, 2};
        options.restores = 20;
        const HashComparison c = compare_hashes(std::string("scenes/") + scene + ".json", options);
        EXPECT_GE(c.runs.size(), 10U);
        EXPECT_GE(c.edited_steps, 1) << scene;
        expect_equal(c);
    }
}

/// Scenes of many parallel wires, with more threads than most machines have. `make test-long` runs
/// 600 steps.
TEST(Hashes, DoNotDependOnManyThreads) {
    for (const char* scene : {"anchor_lines", "mooring"}) {
        HashOptions options;
        options.steps = 24;
        options.threads = {1, 2, 3, 4, 8};
        const HashComparison c = compare_hashes(std::string("scenes/") + scene + ".json", options);
        EXPECT_EQ(c.runs.size(), 9U) << "four from the start, five from states";
        expect_equal(c);
    }
}

TEST(Hashes, DoNotDependOnThreadsWithAnyMethod) {
    for (const char* scene : {"incline", "wall_648", "chain_pile"}) {
        std::set<std::uint64_t> hashes;
        for (const char* method : {"newton", "pivoting", "split", "pgs", "convex"}) {
            HashOptions options;
            options.steps = 14;
            options.threads = {1, 2, 4};
            options.set = {std::string("settings.nonsmooth=") + method};
            const HashComparison c =
                compare_hashes(std::string("scenes/") + scene + ".json", options);
            SCOPED_TRACE(method);
            expect_equal(c);
            EXPECT_GT(c.contacts_max, 0);
            hashes.insert(c.hash);
        }
        EXPECT_EQ(hashes.size(), 5U) << scene << ": methods differ in their last bits at least";
    }
}

}  // namespace
}  // namespace hawser::bench
