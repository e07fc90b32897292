// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace.h
/// A ring of spans for each thread. Writing takes no lock and no memory; only the thread that calls
/// the loops may read, between them.

#include <hawser/trace.h>

#include "base/memory.h"

#include <chrono>
#include <cstdint>
#include <vector>

namespace hawser::runtime {

class Trace {
  public:
    /// @param capacity  Spans a thread, at least 1. @throws std::bad_alloc.
    Trace(int threads, std::size_t capacity);

    /// Since this was made [s].
    [[nodiscard]] double now() const noexcept {
        return std::chrono::duration<double>(Clock::now() - origin_).count();
    }
    /// By the thread named in the span.
    void push(const TraceSpan& span) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(span.thread)];
        TraceSpan& to = ring.span[ring.next];
        if (ring.count >= ring.span.size()) ring.lost_until = to.end;
        to = span;
        ++ring.count;
        if (++ring.next == ring.span.size()) ring.next = 0;
    }
    [[nodiscard]] int threads() const noexcept { return static_cast<int>(ring_.size()); }
    /// Spans up to here are not complete [s].
    [[nodiscard]] double lost_until() const noexcept;
    /// All spans that begin at `from` [s] or later, sorted by begin, longer ones first.
    void copy(double from, std::vector<TraceSpan>& to) const;

    // Of the calling thread, for spans that follow.
    std::int64_t step = 0;
    std::int32_t loops = 0;  ///< So far.
    Stage stage = Stage::prestep;

  private:
    using Clock = std::chrono::steady_clock;
    struct alignas(64) Ring {
        base::Array<TraceSpan> span;
        std::size_t next = 0;
        std::uint64_t count = 0;
        double lost_until = 0.0;  ///< End of the span overwritten last [s].
    };
    std::vector<Ring> ring_;
    Clock::time_point origin_ = Clock::now();
};

}  // namespace hawser::runtime
