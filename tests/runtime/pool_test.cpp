// SPDX-License-Identifier: Apache-2.0
/// The worker pool: every task runs once, batches never mix, and it always shuts down.
#include "runtime/tasks.h"

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace hawser::runtime {
namespace {

/// Run many batches of changing size and check that each task ran once with a valid thread. `seen`
/// is plain memory, so that the thread sanitizer checks the order that run() guarantees.
void stress(Pool& pool, int batches) {
    std::vector<std::int64_t> seen(257, 0);
    std::vector<std::int64_t> want(257, 0);
    for (int b = 0; b < batches; ++b) {
        const int count = (b * 37) % 257;
        auto task = [&](int i, int thread) noexcept {
            if (thread >= 0 && thread < pool.threads()) seen[static_cast<std::size_t>(i)] += b + 1;
        };
        pool.for_each(count, task);
        for (int i = 0; i < count; ++i) want[static_cast<std::size_t>(i)] += b + 1;
        ASSERT_EQ(seen, want) << "batch " << b;
    }
}

TEST(Pool, EachTaskRunsOnceWhateverTheNumberOfThreads) {
    for (int threads : {1, 2, 3, 4, 8, 16}) {
        Pool pool(threads);
        ASSERT_EQ(pool.threads(), threads);
        stress(pool, 50);  // paused: on the calling thread
        pool.resume();
        stress(pool, 1500);
        pool.pause();
    }
}

TEST(Pool, PausesAndResumesBetweenBatches) {
    Pool pool(4);
    std::vector<int> seen(64, 0);
    auto task = [&](int i, int) noexcept { ++seen[static_cast<std::size_t>(i)]; };
    constexpr int kRounds = 500;
    for (int round = 0; round < kRounds; ++round) {
        pool.resume();
        pool.resume();  // a second call has no effect
        pool.for_each(64, task);
        if (round % 3 == 0) std::this_thread::yield();
        pool.pause();
        pool.pause();
    }
    for (int n : seen) EXPECT_EQ(n, kRounds);
}

/// Tasks of very different length: run() waits for a slow one after the list is empty.
TEST(Pool, WaitsForTheSlowestTask) {
    Pool pool(3);
    pool.resume();
    for (int round = 0; round < 20; ++round) {
        int done = 0;  // written by one task, read after run()
        auto task = [&](int i, int) noexcept {
            if (i != 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            done = 1;
        };
        pool.for_each(6, task);
        ASSERT_EQ(done, 1);
    }
}

/// Loops over the same items then find them in the cache of the core that wrote them.
TEST(Pool, EachThreadBeginsWithItsOwnPart) {
    constexpr int kThreads = 3, kTasks = 10;
    Pool pool(kThreads);
    pool.resume();
    for (int round = 0; round < 20; ++round) {
        std::atomic<int> begun{0};
        int first[kThreads] = {-1, -1, -1};
        auto task = [&](int i, int thread) noexcept {
            int& mine = first[thread];
            if (mine >= 0) return;
            mine = i;
            ++begun;
            while (begun.load() < kThreads) std::this_thread::yield();
        };
        pool.for_each(kTasks, task);
        for (int t = 0; t < kThreads; ++t) EXPECT_EQ(first[t], kTasks * t / kThreads);
    }
}

TEST(Pool, ScratchOfAThreadIsItsOwn) {
    Pool pool(8);
    pool.resume();
    // One accumulator per thread, not atomic: two threads with one number would race.
    std::vector<std::int64_t> sum(8 * 16, 0);
    for (int round = 0; round < 400; ++round) {
        auto task = [&](int i, int thread) noexcept {
            sum[static_cast<std::size_t>(thread) * 16] += i;
        };
        pool.for_each(100, task);
    }
    std::int64_t total = 0;
    for (std::int64_t s : sum) total += s;
    EXPECT_EQ(total, 400 * 4950);
}

/// A worker may be between its check of the stop flag and its sleep when the pool is destroyed, and
/// must still wake up. The iterations differ in the progress of the workers. Without the order of
/// reads in Pool::work a run of 20,000 hangs more often than not.
TEST(Pool, AlwaysShutsDown) {
    const int rounds = test::kSanitized ? 1'500 : 12'000;
    std::atomic<bool> finished{false};
    std::thread work([&] {
        for (int round = 0; round < rounds; ++round) {
            Pool pool(2 + round % 3);
            int sum[8] = {};
            auto task = [&](int i, int) noexcept { sum[i] += i; };
            pool.resume();
            for (int batch = 0; batch < 3; ++batch) pool.for_each(8, task);
            for (int spin = 0; spin < (round * 7) % 3000; ++spin)
                std::atomic_signal_fence(std::memory_order_seq_cst);
            pool.pause();
        }
        finished = true;
    });
    // 20,000 thread starts take about a second; under a sanitizer and load about a minute.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(240);
    while (!finished && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!finished) {
        work.detach();
        FAIL() << "a pool did not shut down: a worker sleeps through the stop request";
    }
    work.join();
}

}  // namespace
}  // namespace hawser::runtime
