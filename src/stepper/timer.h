// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timer.h
/// Wall time by stage. Stages nest where iterations factor: time counts for the innermost one.

#include "stepper/context.h"

#include <chrono>

namespace hawser::stepper {

/// Time from here to the end of the scope is of this stage, but for what inner timers take.
class StageTimer {
  public:
    StageTimer(StepContext& ctx, Stage stage) noexcept : ctx_(ctx), outer_(ctx.stage_now) {
        change_to(static_cast<int>(stage));
    }
    ~StageTimer() { change_to(outer_); }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    void change_to(int stage) noexcept {
        const auto now = std::chrono::steady_clock::now();
        if (ctx_.stage_now >= 0)
            ctx_.stats.stage_seconds[static_cast<std::size_t>(ctx_.stage_now)] +=
                std::chrono::duration<double>(now - ctx_.stage_since).count();
        ctx_.stage_now = stage;
        ctx_.stage_since = now;
    }

    StepContext& ctx_;
    int outer_;
};

template <class F>
auto timed(StepContext& ctx, Stage stage, F&& f) noexcept {
    const StageTimer timer(ctx, stage);
    return f(ctx);
}

}  // namespace hawser::stepper
