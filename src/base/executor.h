// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file executor.h
/// The only interface of the solver to threads. An algorithm submits a list of independent tasks.
/// The result depends neither on the number of threads nor on the assignment of tasks.

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser::base {

/// Return the number of tasks for `count` items, if each task processes `size` items.
[[nodiscard]] constexpr int chunks(std::size_t count, int size) noexcept {
    return (static_cast<int>(count) + size - 1) / size;
}

/// Dependencies between tasks, for traces. The successors of node i are next[start[i]] to
/// next[start[i + 1] − 1]. The ready node with the lowest rank runs first.
struct TaskOrder {
    std::span<const std::int32_t> start, next, rank;
};

class Executor {
  public:
    using Task = void (*)(void* context, int index, int thread) noexcept;
    virtual ~Executor() = default;
    /// Run task(context, i, thread) for i in [0, count), each once; return when all are done.
    virtual void run(int count, Task task, void* context) noexcept = 0;
    /// Return the number of threads that may run tasks; `thread` above is in [0, threads()).
    [[nodiscard]] virtual int threads() const noexcept = 0;

    /// True if the current work is to end soon. Long tasks may then be skipped, because their
    /// results are not used.
    [[nodiscard]] virtual bool stopping() const noexcept { return false; }

    /// Announce that the tasks of the next run() are nodes of a dependency graph. Each task chooses
    /// its nodes itself.
    virtual void announce(const TaskOrder& order) noexcept { static_cast<void>(order); }
    /// Report that a task begins a node whose predecessors have ended. Call within the task.
    virtual void begin_node(int node, int thread) noexcept {
        static_cast<void>(node);
        static_cast<void>(thread);
    }

    /// Run a callable with signature void(int index, int thread) noexcept.
    template <class F>
    void for_each(int count, F& f) noexcept {
        run(count, [](void* c, int i, int t) noexcept { (*static_cast<F*>(c))(i, t); }, &f);
    }
};

/// Runs every task in order on the calling thread.
class SerialExecutor final : public Executor {
  public:
    void run(int count, Task task, void* context) noexcept override {
        for (int i = 0; i < count; ++i) task(context, i, 0);
    }
    [[nodiscard]] int threads() const noexcept override { return 1; }
};

}  // namespace hawser::base
