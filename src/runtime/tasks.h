// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tasks.h
/// A fixed pool of workers behind base::Executor.
///
/// Inside a step the workers spin (a fork and join costs about a microsecond). Between steps they
/// sleep on a futex. Waking costs tens of microseconds and happens once per step. The assignment of
/// tasks to threads varies; the results do not. A worker that is still waking delays no other: a
/// batch is done when its tasks are done.
///
/// Each thread begins with a contiguous part of the tasks, which it claims by an atomic counter of
/// this part. Then it claims tasks of the next threads:
///
///     thread 0   0 1 2 3 |               then 4, 5, … if thread 1 has not claimed them
///     thread 1           | 4 5 6 7       then 0, 1, …
///
/// *Locality.* Later loops over the same items therefore find them in the cache of the core that
/// wrote them. The transfer of a cache line between cores costs a tenth of a microsecond.

#include "base/executor.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace hawser::runtime {

class Trace;

class Pool final : public base::Executor {
  public:
    /// Start the threads.
    /// @param threads  Number of threads including the caller, at least 1.
    /// @throws ThreadError if they cannot start, std::bad_alloc. No thread runs after an exception.
    explicit Pool(int threads);
    ~Pool() override;
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Wake the workers. Until pause() they wait actively for tasks.
    void resume() noexcept;
    /// Let the workers sleep.
    void pause() noexcept;

    /// Request that stopping() returns true until clear_stop(). Any thread or a signal handler may
    /// call it.
    void stop() noexcept { stopping_.store(true, std::memory_order_relaxed); }
    void clear_stop() noexcept { stopping_.store(false, std::memory_order_relaxed); }
    /// Block stop requests: stopping() returns false until the block ends, so that changes of the
    /// state are completed.
    void block_stop(bool on) noexcept { stop_blocked_.store(on, std::memory_order_relaxed); }
    [[nodiscard]] bool stopping() const noexcept override {
        return stopping_.load(std::memory_order_relaxed) &&
               !stop_blocked_.load(std::memory_order_relaxed);
    }

    /// Return the CPU time of a thread since its start [s]; 0: the calling thread.
    [[nodiscard]] double cpu_seconds(int thread) noexcept;

    /// Start to record loops and tasks in `trace`; null ends the recording. Call between loops
    /// only.
    void record(Trace* trace) noexcept { trace_ = trace; }

    void run(int count, Task task, void* context) noexcept override;
    void announce(const base::TaskOrder& order) noexcept override;
    void begin_node(int node, int thread) noexcept override;
    [[nodiscard]] int threads() const noexcept override { return threads_; }

  private:
    void distribute_tasks(int count, Task task, void* context) noexcept;
    void distribute_recorded_tasks(int count, Task task, void* context) noexcept;
    void work(const std::stop_token& stop, int thread) noexcept;
    void end_workers() noexcept;
    void run_remaining_tasks(int thread) noexcept;

    /// Ticket = batch number (high half) and next task (low half). While the fields of the ticket
    /// change, the low half is kTicketClosed. A worker that read an old ticket with new fields then
    /// fails its compare-and-swap.
    static constexpr std::uint64_t kTicketClosed = 0xffffffffU;

    /// First tasks of a thread, in a cache line of their own.
    struct alignas(64) Part {
        std::atomic<std::uint64_t> ticket{kTicketClosed};
        std::atomic<std::int32_t> end{0};
    };
    int run_remaining_tasks(Part& part, int thread) noexcept;

    // One cache line each, so that spinning on one does not slow the other.
    alignas(64) std::atomic<std::uint32_t> awake_{0};   ///< Odd while a step runs.
    alignas(64) std::atomic<std::uint64_t> opened_{0};  ///< Batch that the workers poll.
    alignas(64) std::atomic<std::int32_t> done_{0};     ///< Tasks of this batch that are done.
    alignas(64) std::atomic<Task> task_{nullptr};
    std::atomic<void*> context_{nullptr};
    std::atomic<bool> stopping_{false}, stop_blocked_{false};
    static_assert(std::atomic<bool>::is_always_lock_free);  // signal handlers
    Trace* trace_ = nullptr;
    const int threads_;  ///< With the caller. Workers read it while others start and end.
    const std::unique_ptr<Part[]> parts_;  ///< One a thread.
    std::vector<std::jthread> workers_;
    int process_ = 0;  ///< In which they run; a forked child has none of them.
};

}  // namespace hawser::runtime
