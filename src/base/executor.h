// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file executor.h
/// The one interface through which the solver reaches threads. Algorithms hand over a list of
/// independent tasks; who runs them, and how many do, cannot change a result.

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser::base {

/// Tasks of `size` items each that `count` items make.
[[nodiscard]] constexpr int chunks(std::size_t count, int size) noexcept {
    return (static_cast<int>(count) + size - 1) / size;
}

/// Tasks that wait for each other, for those who watch: what a node sets free (next[start[i]] to
/// next[start[i + 1]]), and which of those ready goes first (the lowest rank).
struct TaskOrder {
    std::span<const std::int32_t> start, next, rank;
};

class Executor {
  public:
    using Task = void (*)(void* context, int index, int thread) noexcept;
    virtual ~Executor() = default;
    /// Run task(context, i, thread) for i in [0, count), each once; return when all are done.
    virtual void run(int count, Task task, void* context) noexcept = 0;
    /// Threads that may run tasks; `thread` above is in [0, threads()).
    [[nodiscard]] virtual int threads() const noexcept = 0;

    /// What is under way is to end soon: long tasks may be left out, since nobody is going to use
    /// what they give.
    [[nodiscard]] virtual bool stopping() const noexcept { return false; }

    /// The next run() is of the nodes of a graph, which its tasks choose themselves.
    virtual void announce(const TaskOrder& order) noexcept { static_cast<void>(order); }
    /// In such a task: it is this node, and what it waited for is done.
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
