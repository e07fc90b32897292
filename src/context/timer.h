// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timer.h
/// Measure wall time by stage. Stages nest if iterations factor; time then counts for the innermost
/// stage. A trace uses the same readings of the clock.

#include "context/context.h"

#include <chrono>

namespace hawser::context {

/// Timer of a stage: counts the time to the end of the scope, without that of inner timers.
class StageTimer {
  public:
    StageTimer(StepContext& ctx, Stage stage) noexcept
        : ctx_(ctx), outer_stage_(ctx.work.clock.current_stage) {
        change_to(static_cast<int>(stage));
        begin_ = ctx.work.clock.stage_since;
    }
    ~StageTimer() {
        const int stage = ctx_.work.clock.current_stage;
        change_to(outer_stage_);
        if (ctx_.trace != nullptr) write_down(stage);
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    void change_to(int stage) noexcept {
        const auto now = std::chrono::steady_clock::now();
        if (ctx_.work.clock.current_stage >= 0)
            ctx_.work.stats
                .stage_seconds[static_cast<std::size_t>(ctx_.work.clock.current_stage)] +=
                std::chrono::duration<double>(now - ctx_.work.clock.stage_since).count();
        ctx_.work.clock.current_stage = stage;
        ctx_.work.clock.stage_since = now;
        if (ctx_.trace != nullptr) ctx_.trace->stage = static_cast<std::int8_t>(stage);
    }
    void write_down(int stage) noexcept {
        TraceSpan span;
        span.kind = SpanKind::stage;
        span.stage = static_cast<std::int8_t>(stage);
        span.step = ctx_.trace->step;
        span.begin = ctx_.trace->seconds(begin_);
        span.end = ctx_.trace->seconds(ctx_.work.clock.stage_since);
        ctx_.trace->push(span);
    }

    StepContext& ctx_;
    int outer_stage_;
    std::chrono::steady_clock::time_point begin_;
};

/// Timer of a step: records the time to the end of the scope as a step of the trace, if there is
/// one.
class StepTimer {
  public:
    explicit StepTimer(StepContext& ctx) noexcept : trace_(ctx.trace.get()) {
        if (trace_ == nullptr) return;
        trace_->step = span_.step = ctx.state.step + 1;
        ++trace_->steps;
        span_.kind = SpanKind::step;
        span_.begin = trace_->now();
    }
    ~StepTimer() {
        if (trace_ == nullptr) return;
        span_.end = trace_->now();
        trace_->push(span_);
    }
    StepTimer(const StepTimer&) = delete;
    StepTimer& operator=(const StepTimer&) = delete;

  private:
    runtime::Trace* trace_;
    TraceSpan span_;
};

template <class F>
auto timed(StepContext& ctx, Stage stage, F&& f) noexcept {
    const StageTimer timer(ctx, stage);
    return f(ctx);
}

}  // namespace hawser::context
