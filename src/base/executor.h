// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file executor.h
/// The one interface through which the solver reaches threads. Algorithms hand over a list of
/// independent tasks; who runs them, and how many do, cannot change a result.

namespace hawser::base {

class Executor {
  public:
    using Task = void (*)(void* context, int index, int thread) noexcept;
    virtual ~Executor() = default;
    /// Run task(context, i, thread) for i in [0, count), each once; return when all are done.
    virtual void run(int count, Task task, void* context) noexcept = 0;
    /// Threads that may run tasks; `thread` above is in [0, threads()).
    [[nodiscard]] virtual int threads() const noexcept = 0;

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
