// SPDX-License-Identifier: Apache-2.0
/// Worlds in a forked child, which has none of their worker threads, and moved-from worlds.
#include <hawser/hawser.h>

#include "support/recipe.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace hawser::test {
namespace {

/// Return the exit of a child; −1: it did not end within some seconds, and was killed.
int ended(pid_t child) {
    for (int i = 0; i < 500; ++i) {
        int status = 0;
        if (::waitpid(child, &status, WNOHANG) == child)
            return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ::kill(child, SIGKILL);
    (void)::waitpid(child, nullptr, 0);
    return -1;
}

TEST(ForkedWorld, StepsAndEndsInTheChild) {
    // A sanitizer's own threads do not survive a fork.
    if (kSanitized) GTEST_SKIP() << "forks";
    Recipe r = chains(2, 2, 6);
    r.world.threads = 3;
    auto world = std::make_unique<World>(r.make());
    ASSERT_EQ(world->step(), Status::ok);
    World twin = world->twin();
    ASSERT_EQ(twin.step(), Status::ok);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const bool same =
            world->step() == Status::ok && world->state().hash() == twin.state().hash();
        world.reset();
        ::_exit(same ? 0 : 1);
    }
    EXPECT_EQ(ended(child), 0) << "-1: it waits for threads that it does not have";
    EXPECT_EQ(world->step(), Status::ok) << "the parent goes on";
    EXPECT_EQ(world->state().hash(), twin.state().hash());
}

TEST(MovedWorld, MayBeAssignedToAndDestroyed) {
    Recipe r = chains(1, 2, 6);
    World first = r.make(), other = r.make();
    World second = std::move(first);
    ASSERT_EQ(second.step(), Status::ok);
    first = std::move(other);
    ASSERT_EQ(first.step(), Status::ok);
    EXPECT_EQ(first.state().hash(), second.state().hash());
    World third = std::move(first);  // `first` is destroyed in its moved-from state
    EXPECT_EQ(third.step_count(), 1);
}

#ifndef NDEBUG
TEST(MovedWorldDeathTest, IsNotUsed) {
    World first = chains(1, 2, 6).make();
    const World second = std::move(first);
    EXPECT_DEATH((void)first.step(), "moved from");  // NOLINT(bugprone-use-after-move)
}
#endif

}  // namespace
}  // namespace hawser::test
