// SPDX-License-Identifier: Apache-2.0
/// A world used by two threads at once: the second one is rejected without effect.
#include "world/use.h"
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

namespace hawser::test {
namespace {

TEST(Use, OneThreadAtATimeAndNoneWithinAStep) {
    world::Use use;
    const auto elsewhere = [&] {
        int granted = -1;
        std::thread([&] { granted = use.take(); }).join();
        return granted;
    };
    EXPECT_EQ(use.take(), 1);
    EXPECT_EQ(elsewhere(), 0);
    EXPECT_EQ(use.take(), 2);  // a call within a call
    use.mark_stepping(true);
    EXPECT_EQ(use.take(), 0);  // a change within a step
    EXPECT_THROW(world::Using(use, "add_body"), UseError);
    use.mark_stepping(false);
    EXPECT_EQ(use.take(), 2);
    use.leave();
    {
        const world::Using mine(use, "add_body");
        const world::Using again(use, "add_body");
        EXPECT_EQ(elsewhere(), 0);
    }
    EXPECT_EQ(elsewhere(), 1);
    try {
        const world::Using mine(use, "set_pose");
        FAIL() << "another thread has it";
    } catch (const UseError& error) {
        EXPECT_NE(std::string(error.what()).find("set_pose"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("thread"), std::string::npos);
    }
}

/// Rejected forces do not act, rejected steps are not made, and accepted ones are complete: the
/// state equals that of as many steps by one thread.
TEST(Use, ASecondThreadIsRefusedAndLeavesNoTrace) {
    const Recipe recipe = link_chain(40);
    World world = recipe.make(), alone = recipe.make();
    world.prepare();
    std::atomic<bool> done{false};
    std::atomic<long> refused{0};
    std::thread other([&] {
        while (!done) {
            try {
                world.set_force({1}, {0, 0, 0}, {0, 0, 0});
            } catch (const UseError&) {
                ++refused;
            }
        }
    });
    int steps = 0;
    long in_use = 0;
    // Until both threads have met: on one core that takes some time.
    for (int i = 0; i < 200'000 && (steps < 50 || refused + in_use == 0); ++i) {
        const Status status = world.step();
        in_use += status == Status::in_use ? 1 : 0;
        steps += status == Status::ok ? 1 : 0;
        if (status != Status::ok && status != Status::in_use) break;
    }
    done = true;
    other.join();
    EXPECT_GT(refused + in_use, 0);
    for (int i = 0; i < steps; ++i) ASSERT_EQ(alone.step(), Status::ok);
    EXPECT_EQ(world.state().hash(), alone.state().hash());
    EXPECT_EQ(world.step_count(), steps);
}

}  // namespace
}  // namespace hawser::test
