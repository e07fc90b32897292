// SPDX-License-Identifier: Apache-2.0
/// Steps cancelled by another thread or a signal handler, at any point.
#include "support/recipe.h"
#include "support/sanitizer.h"
#include "support/yard.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <sys/time.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

namespace hawser::test {
namespace {

TEST(Cancel, EndsTheNextStepWhereNoneIsUnderWay) {
    World w = mixed(1).make(), twin = mixed(1).make();
    for (int i = 0; i < 3; ++i) {
        w.cancel();
        const std::uint64_t before = w.state().hash();
        EXPECT_EQ(w.step(), Status::cancelled);
        EXPECT_EQ(w.stats().status, Status::cancelled);
        EXPECT_EQ(w.state().hash(), before);
        EXPECT_EQ(w.step(), Status::ok) << "one request ends one step";
        EXPECT_EQ(twin.step(), Status::ok);
        EXPECT_EQ(w.state().hash(), twin.state().hash());
    }
}

/// Make boxes that fall onto each other: analyses, impacts and Newton iterations.
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
    for (int i = 0; i < 24; ++i) {
        const int layer = i / 3;
        (void)yard.box({0.4 * (i % 3), 0.3 * (i % 2), 0.7 + 1.2 * layer}, 10.0, {0.5, 0.5, 0.5});
    }
    return std::move(yard.world);
}

/// Try a step, with more time in each attempt, until it completes. @param arm  Requests the
/// cancellation after a number of seconds. @return number of cancelled attempts.
template <class Arm>
int attempt_until_done(World& w, Arm&& arm) {
    const std::uint64_t before = w.state().hash();
    double delay = 10e-6;
    for (int cancelled = 0; cancelled < 60; ++cancelled, delay *= 1.35) {
        arm(delay);
        const Status status = w.step();
        if (status == Status::ok) return cancelled;
        EXPECT_EQ(status, Status::cancelled);
        EXPECT_EQ(w.state().hash(), before) << "cancelled after " << delay << " s";
        if (testing::Test::HasFailure()) break;
    }
    ADD_FAILURE() << "no attempt ended";
    return 0;
}

/// Cancels from another thread, at times in all parts of a step.
class CancelLater {
  public:
    explicit CancelLater(World& w)
        : thread_([this, &w](const std::stop_token& stop) {
              for (int seen = 0;;) {
                  armed_.wait(seen);
                  if (stop.stop_requested()) return;
                  seen = armed_.load();
                  std::this_thread::sleep_for(std::chrono::duration<double>(delay_.load()));
                  w.cancel();
              }
          }) {}
    ~CancelLater() {
        thread_.request_stop();
        ++armed_;
        armed_.notify_all();
    }
    CancelLater(const CancelLater&) = delete;
    CancelLater& operator=(const CancelLater&) = delete;
    void operator()(double seconds) {
        delay_ = seconds;
        ++armed_;
        armed_.notify_all();
    }

  private:
    std::atomic<int> armed_{0};
    std::atomic<double> delay_{0.0};
    std::jthread thread_;
};

TEST(Cancel, AnywhereInAStepLeavesTheStateAndTheBits) {
    for (const int threads : {1, 2}) {
        World w = heap(threads), twin = heap(1);
        CancelLater later(w);
        int cancelled = 0;
        // The scheduler determines how many attempts a step takes: continue until enough were made.
        constexpr int kEnough = 20, kMaxSteps = 400;
        const int least = kSanitized ? 10 : 40;
        for (int i = 0; (i < least || cancelled <= kEnough) && i < kMaxSteps && !HasFailure();
             ++i) {
            ASSERT_EQ(twin.step(), Status::ok);
            cancelled += attempt_until_done(w, later);
            ASSERT_EQ(w.state().hash(), twin.state().hash()) << "step " << i;
        }
        EXPECT_GT(cancelled, kEnough) << "or nothing has been tried";
    }
}

World* signalled = nullptr;

TEST(Cancel, MayBeCalledByASignalHandler) {
    World w = heap(2), twin = heap(1);
    signalled = &w;
    struct sigaction action{};
    action.sa_handler = [](int) { signalled->cancel(); };
    sigaction(SIGALRM, &action, nullptr);
    int cancelled = 0;
    for (int i = 0; i < 20 && !HasFailure(); ++i) {
        ASSERT_EQ(twin.step(), Status::ok);
        cancelled += attempt_until_done(w, [](double seconds) {
            const auto micro = static_cast<suseconds_t>(1e6 * seconds);
            const itimerval once{{0, 0}, {micro / 1'000'000, micro % 1'000'000}};
            setitimer(ITIMER_REAL, &once, nullptr);
        });
        ASSERT_EQ(w.state().hash(), twin.state().hash()) << "step " << i;
    }
    const itimerval never{};
    setitimer(ITIMER_REAL, &never, nullptr);
    std::signal(SIGALRM, SIG_DFL);
    EXPECT_GT(cancelled, 10) << "or nothing has been tried";
}

/// A dense matrix of 2,400 scalars takes seconds; the rest of a step after cancel() takes less.
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
