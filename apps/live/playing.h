// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file playing.h
/// Clock of a live run (driver.h) or a recording (player.h). It stores whether it is paused, its
/// rate, and the time of the next step.

#include "live/command.h"
#include "live/pace.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace hawser::live {

class Playing {
  public:
    explicit Playing(bool paused = false) : paused_(paused) {}

    [[nodiscard]] bool paused() const noexcept { return paused_; }
    /// True if the run is not paused or single steps were requested.
    [[nodiscard]] bool is_running() const noexcept { return !paused_ || steps_left_ > 0; }
    [[nodiscard]] double rate() const noexcept {
        return rate_;
    }  ///< Return the rate of simulated over wall time.
    /// Return the delay of the last step's end; negative: early [s].
    [[nodiscard]] double delay() const noexcept { return pace_.delay(); }

    void pause() noexcept {
        paused_ = true;
        steps_left_ = 0;
    }
    /// Restart the clock, so that the next step is due at once.
    void begin_clock() noexcept { pace_.begin(); }
    /// Discard the single steps that were requested and not made.
    void forget_steps() noexcept { steps_left_ = 0; }

    /// Perform pause, resume, step and rate; ignore other commands.
    void perform(const Command& command) noexcept {
        switch (command.kind) {
            case CommandKind::pause:
                pause();
                return;
            case CommandKind::resume:
                paused_ = false;
                steps_left_ = 0;
                break;
            case CommandKind::step:
                paused_ = true;
                steps_left_ = static_cast<int>(command.value);
                break;
            case CommandKind::rate:
                rate_ = command.value;
                break;
            default:
                return;
        }
        pace_.begin();
    }

    /// Record the time of a completed or failed step. The next step is due after this length.
    /// @param step Its length [s].
    void record_step(double step) noexcept { pace_.record_step(step, rate_); }
    /// Count a requested single step. @return true if it was the last one.
    bool count_step() noexcept {
        if (steps_left_ <= 0) return false;
        --steps_left_;
        return steps_left_ == 0;
    }

    /// Wait until the next step is due. The wait is divided into slices, so that commands are
    /// performed at once even at low rates. If the run is paused, wait one slice. `take` performs
    /// pending commands and returns true to end the wait.
    template <class Take>
    void wait(Take&& take) {
        if (!is_running()) {
            std::this_thread::sleep_for(kWaitSlice);
            pace_.begin();
            return;
        }
        for (auto now = Pace::Clock::now(); is_running() && now < pace_.due();
             now = Pace::Clock::now()) {
            const auto until = std::min(pace_.due(), now + kWaitSlice);
            std::this_thread::sleep_until(until);
            if (until != pace_.due() && take()) return;
        }
    }

    /// Store the present time as the time at which a frame was shown.
    void note_shown() noexcept { shown_ = Pace::Clock::now(); }
    /// True if 100 ms have passed since the last frame. A paused scene is sent ten times a second,
    /// so that new clients receive it.
    [[nodiscard]] bool is_frame_due() const noexcept {
        return Pace::Clock::now() - shown_ >= std::chrono::milliseconds{100};
    }

  private:
    static constexpr std::chrono::milliseconds kWaitSlice{5};

    Pace pace_;
    bool paused_;
    int steps_left_ = 0;  ///< Number of remaining single steps.
    double rate_ = 1.0;
    Pace::Clock::time_point shown_{};
};

}  // namespace hawser::live
