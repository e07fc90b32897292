// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file realtime.h
/// Synchronise a run with the wall clock.

#include <chrono>
#include <cstdint>
#include <string>

namespace hawser::cli {

/// Waits until each frame is due and counts those that came late.
class Pacer {
  public:
    explicit Pacer(double step);
    /// Wait until the next frame is due. Call after each step.
    void wait();
    [[nodiscard]] std::int64_t frames_missed() const noexcept { return missed_; }
    /// Return the largest delay [s].
    [[nodiscard]] double lateness_max() const noexcept { return lateness_max_; }

  private:
    using Clock = std::chrono::steady_clock;
    double step_;
    Clock::time_point start_;
    std::int64_t frame_ = 0, missed_ = 0;
    double lateness_max_ = 0.0;
};

/// Request real-time scheduling (SCHED_FIFO) and restrict the process to `threads` processors.
/// Later threads inherit both. @return a text about the granted and rejected requests.
[[nodiscard]] std::string request_realtime(int threads);

}  // namespace hawser::cli
