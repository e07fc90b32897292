// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file playing.h
/// The clock of what is shown, a live run (driver.h) or a recording (player.h): whether steps are
/// taken, at which rate, and when the next one is due.

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
    /// Whether steps are taken: it is not paused, or some were asked for one by one.
    [[nodiscard]] bool runs() const noexcept { return !paused_ || to_go_ > 0; }
    [[nodiscard]] double rate() const noexcept { return rate_; }  ///< Simulated over wall time.
    /// How late the last step ended, below 0: early [s].
    [[nodiscard]] double late() const noexcept { return pace_.late(); }

    void pause() noexcept {
        paused_ = true;
        to_go_ = 0;
    }
    /// The next step is due at once.
    void begin_clock() noexcept { pace_.begin(); }
    /// Steps that were asked for are forgotten.
    void forget_steps() noexcept { to_go_ = 0; }

    /// Does pause, resume, step and rate; other commands are nothing to it.
    void perform(const Command& command) noexcept {
        switch (command.kind) {
            case CommandKind::pause:
                pause();
                return;
            case CommandKind::resume:
                paused_ = false;
                to_go_ = 0;
                break;
            case CommandKind::step:
                paused_ = true;
                to_go_ = static_cast<int>(command.value);
                break;
            case CommandKind::rate:
                rate_ = command.value;
                break;
            default:
                return;
        }
        pace_.begin();
    }

    /// A step of so much time [s] has been taken, or failed: the next one is due behind it.
    void took(double step) noexcept { pace_.took(step, rate_); }
    /// One of the steps that were asked for. @return whether it was the last of them.
    bool count_step() noexcept {
        if (to_go_ <= 0) return false;
        --to_go_;
        return to_go_ == 0;
    }

    /// Until the next step is due, in slices, so that at low rates, too, commands are taken at
    /// once; a slice where none is. `take` takes what is waiting and says whether that ends the
    /// waiting.
    template <class Take>
    void wait(Take&& take) {
        if (!runs()) {
            std::this_thread::sleep_for(kSlice);
            pace_.begin();
            return;
        }
        for (auto now = Pace::Clock::now(); runs() && now < pace_.due(); now = Pace::Clock::now()) {
            const auto until = std::min(pace_.due(), now + kSlice);
            std::this_thread::sleep_until(until);
            if (until != pace_.due() && take()) return;
        }
    }

    /// Note that a frame has just been shown.
    void showed() noexcept { shown_ = Pace::Clock::now(); }
    /// What stands still is shown ten times a second, so that who comes late sees it, too.
    [[nodiscard]] bool due_to_show() const noexcept {
        return Pace::Clock::now() - shown_ >= std::chrono::milliseconds{100};
    }

  private:
    static constexpr std::chrono::milliseconds kSlice{5};

    Pace pace_;
    bool paused_;
    int to_go_ = 0;  ///< Steps that were asked for one by one and are left.
    double rate_ = 1.0;
    Pace::Clock::time_point shown_{};
};

}  // namespace hawser::live
