// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file realtime.h
/// Keeps a run in step with the wall clock.

#include <chrono>
#include <cstdint>
#include <string>

namespace hawser::cli {

/// Waits until each frame is due and counts those that came late.
class Pacer {
  public:
    explicit Pacer(double step);
    /// Call after each step.
    void wait();
    [[nodiscard]] std::int64_t missed() const noexcept { return missed_; }
    [[nodiscard]] double lateness_max() const noexcept { return lateness_max_; }  ///< [s]

  private:
    using Clock = std::chrono::steady_clock;
    double step_;
    Clock::time_point start_;
    std::int64_t frame_ = 0, missed_ = 0;
    double lateness_max_ = 0.0;
};

/// Ask for real-time scheduling (SCHED_FIFO) and keep to `threads` processors. Threads made
/// afterwards inherit both.
/// @return What was granted and what was not, as text.
[[nodiscard]] std::string request_realtime(int threads);

}  // namespace hawser::cli
