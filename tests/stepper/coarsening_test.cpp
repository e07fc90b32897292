// SPDX-License-Identifier: Apache-2.0
// Coarsening of wires against the rule of docs/theory/deadlines.md.
#include "budget/coarsening.h"

#include <gtest/gtest.h>

namespace hawser::budget {
namespace {

int level_after(Coarsening& c, int steps, double demand, double factor = 1.0) {
    for (int i = 0; i < steps; ++i, demand *= factor) c.add_sample(demand);
    return c.level();
}

TEST(Coarsening, NeedsWiresThatCanBeCoarser) {
    Coarsening c;
    EXPECT_FALSE(c.has_priority());
    EXPECT_EQ(level_after(c, 1000, 2.0), 0);
    c.possible = true;
    EXPECT_TRUE(c.has_priority());
    EXPECT_EQ(level_after(c, 1, 2.0), 1) << "what is known of times goes on";
    EXPECT_TRUE(c.has_priority()) << "it has its time to act";
    (void)level_after(c, Coarsening::kObservedSteps, 0.9);
    EXPECT_EQ(c.level(), 1);
    EXPECT_FALSE(c.has_priority()) << "other things may be left out";
}

TEST(Coarsening, RisesWhereStepsStayTooLong) {
    Coarsening c;
    c.possible = true;
    EXPECT_EQ(level_after(c, Rate::kSettledSamples - 1, 1.3), 0);
    EXPECT_EQ(level_after(c, 1, 1.3), 1);
    EXPECT_EQ(level_after(c, Coarsening::kObservedSteps - 1, 1.3), 1);
    EXPECT_EQ(level_after(c, 1, 1.3), 2) << "nothing has changed";
    EXPECT_EQ(level_after(c, 1000, 1.3), Coarsening::kMaxLevel);
}

TEST(Coarsening, WaitsWhileItActs) {
    Coarsening c;
    c.possible = true;
    EXPECT_EQ(level_after(c, 16, 3.0), 1);
    // 6 % in 60 steps: the level decreases from 3 to 1 within a thousand.
    EXPECT_EQ(level_after(c, 1000, 3.0, 0.999), 1);
}

TEST(Coarsening, FallsWhereThereIsRoom) {
    Coarsening c;
    c.possible = true;
    EXPECT_EQ(level_after(c, 16 + Coarsening::kObservedSteps, 1.5), 2);
    EXPECT_EQ(level_after(c, 1000, 0.7), 2) << "a level down might take 1.05";
    EXPECT_EQ(level_after(c, 40, 0.5), 1);
    EXPECT_EQ(level_after(c, Coarsening::kMinStepsAtLevel - 45, 0.5), 1) << "it stays for a while";
    EXPECT_EQ(level_after(c, 50, 0.5), 0);
}

}  // namespace
}  // namespace hawser::budget
