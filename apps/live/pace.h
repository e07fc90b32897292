// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pace.h
/// Compute when the next step is due, at a rate of simulated over wall time.

#include <chrono>

namespace hawser::live {

class Pace {
  public:
    using Clock = std::chrono::steady_clock;
    /// Restart: the next step is due at once.
    void begin() noexcept { due_ = Clock::now(); }
    /// Record a step of this length [s]. If it is late by more than a quarter of a second, restart
    /// the clock. Steps therefore never follow each other at full speed to catch up.
    void record_step(double step, double rate) noexcept {
        due_ +=
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(step / rate));
        const auto now = Clock::now();
        delay_ = std::chrono::duration<double>(now - due_).count();
        if (delay_ > 0.25) due_ = now;
    }
    [[nodiscard]] Clock::time_point due() const noexcept { return due_; }
    /// Return the delay of the last step's end; negative: early [s].
    [[nodiscard]] double delay() const noexcept { return delay_; }

  private:
    Clock::time_point due_ = Clock::now();
    double delay_ = 0.0;
};

}  // namespace hawser::live
