// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stopwatch.h
/// CPU time of the threads of a pool. An interface, so that decisions by time can be tested.

#include "runtime/tasks.h"

#include <vector>

namespace hawser::runtime {

class Stopwatch {
  public:
    virtual ~Stopwatch() = default;
    virtual void start() noexcept = 0;
    /// Return the CPU time that the slowest thread has used since start() [s].
    [[nodiscard]] virtual double seconds() noexcept = 0;
};

/// Reads the clock of each thread, with one system call each. A thread that waits for others within
/// a step spins, which counts. Time without a processor does not count.
class PoolStopwatch final : public Stopwatch {
  public:
    explicit PoolStopwatch(Pool& pool)
        : pool_(pool), begin_(static_cast<std::size_t>(pool.threads())) {}
    /// Start the measurement. The calling thread counts as thread 0 of the pool.
    void start() noexcept override {
        for (std::size_t t = 0; t < begin_.size(); ++t) begin_[t] = cpu(t);
    }
    [[nodiscard]] double seconds() noexcept override {
        double most = 0.0;
        for (std::size_t t = 0; t < begin_.size(); ++t)
            if (const double used = cpu(t) - begin_[t]; used > most) most = used;
        return most;
    }

  private:
    [[nodiscard]] double cpu(std::size_t thread) const noexcept {
        return pool_.cpu_seconds(static_cast<int>(thread));
    }
    Pool& pool_;
    std::vector<double> begin_;
};

}  // namespace hawser::runtime
