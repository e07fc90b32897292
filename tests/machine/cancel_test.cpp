// SPDX-License-Identifier: Apache-2.0
/// Steps that are cancelled, by another thread or a signal handler, wherever they are.
#include "support/recipe.h"
#include "support/sleep_yard.h"
#include "support/yard.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <sys/time.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace hawser::test {
namespace {

TEST(Cancel, EndsTheNextStepWhereNoneIsUnderWay) {
    World w = mixed(1).make(), twin = mixed(1).make();
    for (int i = 0; i < 3; ++i) {
        w.cancel();
        const std::uint64_t before = w.state_hash();
        EXPECT_EQ(w.step(), Status::cancelled);
        EXPECT_EQ(w.stats().status, Status::cancelled);
        EXPECT_EQ(w.state_hash(), before);
        EXPECT_EQ(w.step(), Status::ok) << "one request ends one step";
        EXPECT_EQ(twin.step(), Status::ok);
        EXPECT_EQ(w.state_hash(), twin.state_hash());
    }
}

/// Boxes that fall onto each other: analyses, impacts and Newton iterations.
World heap(int threads) {
    WorldDef def;
    def.threads = threads;
    def.sleep_after = 0.3;
    Yard yard(def);
    MaterialDef bouncy;
    bouncy.restitution = 0.4;
    bouncy.rolling = 0.01;
    yard.use(bouncy);
    yard.plane(yard.fixed());
    for (int i = 0; i < 24; ++i)
        (void)yard.box({0.4 * (i % 3), 0.3 * (i % 2), 0.7 + 1.2 * (i / 3)}, 10.0, {0.5, 0.5, 0.5});
    return std::move(yard.world);
}

TEST(Cancel, AnywhereInAStepLeavesTheStateAndTheBits) {
    World right = heap(1);
    for (const int threads : {1, 2}) {
        World w = heap(threads), twin = heap(1);
        std::atomic<bool> over{false};
        // At moments that hit all parts of a step, from 0.1 to 3 ms apart.
        std::jthread other([&] {
            for (int i = 0; !over; ++i) {
                std::this_thread::sleep_for(std::chrono::microseconds(100 + 37 * (i % 80)));
                w.cancel();
            }
        });
        int cancelled = 0;
        for (int i = 0; i < 120; ++i) {
            ASSERT_EQ(twin.step(), Status::ok);
            const std::uint64_t before = w.state_hash();
            Status status = w.step();
            for (int again = 0; status == Status::cancelled && again < 10'000; ++again) {
                ASSERT_EQ(w.state_hash(), before) << "step " << i;
                ++cancelled;
                status = w.step();
            }
            ASSERT_EQ(status, Status::ok) << "step " << i;
            ASSERT_EQ(w.state_hash(), twin.state_hash()) << "step " << i;
        }
        over = true;
        EXPECT_GT(cancelled, 20) << "or nothing has been tried";
    }
}

World* signalled = nullptr;

TEST(Cancel, MayBeCalledByASignalHandler) {
    World w = heap(2), twin = heap(1);
    signalled = &w;
    struct sigaction action{};
    action.sa_handler = [](int) { signalled->cancel(); };
    sigaction(SIGALRM, &action, nullptr);
    const itimerval often{{0, 700}, {0, 700}}, never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    int cancelled = 0;
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(twin.step(), Status::ok);
        Status status = w.step();
        for (int again = 0; status == Status::cancelled && again < 10'000; ++again, ++cancelled)
            status = w.step();
        EXPECT_EQ(status, Status::ok) << "step " << i;
        EXPECT_EQ(w.state_hash(), twin.state_hash()) << "step " << i;
    }
    setitimer(ITIMER_REAL, &never, nullptr);
    std::signal(SIGALRM, SIG_DFL);
    EXPECT_GT(cancelled, 10) << "or nothing has been tried";
}

/// A dense matrix of 2,400 scalars takes seconds; what is left of a step after cancel() does not.
TEST(Cancel, DoesNotWaitForTheEndOfALongStep) {
    Yard yard(WorldDef{.gravity = Vec3::Zero()});
    for (int i = 0; i < 400; ++i) yard.ball({0.001 * i, 0.0007 * (i % 17), 0.0}, 1.0, 0.5);
    World& w = yard.world;
    std::jthread other([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            w.cancel();
        }
    });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(w.step(), Status::cancelled);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(w.step_count(), 0);
    std::printf("cancelled after 0.3 s, ended after %.2f s\n", took.count());
}

}  // namespace
}  // namespace hawser::test
