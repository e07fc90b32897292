// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace.h
/// A ring buffer of spans for each thread. Writing needs no lock and allocates nothing. Only the
/// thread that calls the loops may read, and only between loops.

#include <hawser/trace.h>

#include "base/executor.h"
#include "base/memory.h"

#include <chrono>
#include <cstdint>
#include <vector>

namespace hawser::runtime {

class Trace {
  public:
    /// Allocate the ring buffers. @param capacity  Number of spans per thread, at least 1. @throws
    /// std::bad_alloc.
    Trace(int threads, std::size_t capacity);

    /// Return the time since construction [s].
    [[nodiscard]] double now() const noexcept { return seconds(Clock::now()); }
    [[nodiscard]] double seconds(std::chrono::steady_clock::time_point at) const noexcept {
        return std::chrono::duration<double>(at - origin_).count();
    }
    /// Store a span. Call on the thread that the span names.
    void push(const TraceSpan& span) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(span.thread)];
        TraceSpan& to = ring.span[ring.next];
        if (ring.count >= ring.span.size()) ring.end_of_overwritten = to.end;
        to = span;
        ++ring.count;
        if (++ring.next == ring.span.size()) ring.next = 0;
    }
    /// Record that a thread begins a node of a graph. task() stores the node in the span of its
    /// task.
    void begin_node(int node, int thread) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(thread)];
        ring.node = node;
        ring.begun = now();
    }
    /// Run the task f. Store its start and end in the trace.
    template <class F>
    void task(TraceSpan span, F&& f) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(span.thread)];
        ring.node = -1;
        span.begin = now();
        f();
        span.end = now();
        if (ring.node >= 0) {  // the task waited for its node first
            span.begin = ring.begun;
            span.task = ring.node;
        }
        push(span);
    }
    /// Store the graph of the next loop. Call on the thread that runs the loops.
    void announce(const base::TaskOrder& order) noexcept;
    [[nodiscard]] int threads() const noexcept { return static_cast<int>(ring_.size()); }
    /// Return the latest time before which spans may be missing [s].
    [[nodiscard]] double end_of_overwritten() const noexcept;
    /// Copy all spans that begin at `from` [s] or later and the graphs of their loops. Spans are
    /// sorted by their begin, and by descending length for equal begins.
    void copy(double from, TraceView& to) const;

    // Values of the calling thread for later spans: index of the step.
    std::int64_t step = 0;
    std::int32_t loops = 0;  ///< Number of loops since construction.
    std::int8_t stage = -1;
    std::int64_t steps = 0;  ///< Number of steps traced since construction.

  private:
    using Clock = std::chrono::steady_clock;
    struct alignas(64) Ring {
        base::Array<TraceSpan> span;
        std::size_t next = 0;
        std::uint64_t count = 0;
        double end_of_overwritten = 0.0;  ///< End of the most recently overwritten span [s].
        double begun = 0.0;               ///< Begin of the current node [s]; see begin_node().
        std::int32_t node = -1;
    };
    /// Graph of a loop: its numbers start at `begin` in the ring `numbers_`.
    struct Graph {
        std::int32_t loop = -1;
        std::int32_t nodes = 0, edges = 0;
        std::uint64_t begin = 0;
    };
    [[nodiscard]] std::vector<std::int32_t> copy_numbers(std::uint64_t begin,
                                                         std::size_t count) const;

    std::vector<Ring> ring_;
    std::vector<Graph> graphs_;  ///< Ring buffer, like `numbers_`.
    std::uint64_t graph_count_ = 0;
    std::vector<std::int32_t> numbers_;
    std::uint64_t number_count_ = 0;
    Clock::time_point origin_ = Clock::now();
};

}  // namespace hawser::runtime
