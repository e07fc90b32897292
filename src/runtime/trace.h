// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace.h
/// A ring of spans for each thread. Writing takes no lock and no memory; only the thread that calls
/// the loops may read, between them.

#include <hawser/trace.h>

#include "base/executor.h"
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
    [[nodiscard]] double now() const noexcept { return seconds(Clock::now()); }
    [[nodiscard]] double seconds(std::chrono::steady_clock::time_point at) const noexcept {
        return std::chrono::duration<double>(at - origin_).count();
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
    /// A thread has begun the node of a graph: what its task's span is to say.
    void begin_node(int node, int thread) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(thread)];
        ring.node = node;
        ring.begun = now();
    }
    /// Run a task and write down its span.
    template <class F>
    void task(TraceSpan span, F&& f) noexcept {
        Ring& ring = ring_[static_cast<std::size_t>(span.thread)];
        ring.node = -1;
        span.begin = now();
        f();
        span.end = now();
        if (ring.node >= 0) {  // it waited first
            span.begin = ring.begun;
            span.task = ring.node;
        }
        push(span);
    }
    /// By the calling thread: the loop that follows is of a graph.
    void announce(const base::TaskOrder& order) noexcept;
    [[nodiscard]] int threads() const noexcept { return static_cast<int>(ring_.size()); }
    /// Spans up to here are not complete [s].
    [[nodiscard]] double lost_until() const noexcept;
    /// All spans that begin at `from` [s] or later, sorted by begin, longer ones first, and the
    /// graphs of their loops.
    void copy(double from, TraceView& to) const;

    // Of the calling thread, for spans that follow.
    std::int64_t step = 0;
    std::int32_t loops = 0;  ///< So far.
    std::int8_t stage = -1;
    std::int64_t steps = 0;  ///< Traced so far.

  private:
    using Clock = std::chrono::steady_clock;
    struct alignas(64) Ring {
        base::Array<TraceSpan> span;
        std::size_t next = 0;
        std::uint64_t count = 0;
        double lost_until = 0.0;  ///< End of the span overwritten last [s].
        double begun = 0.0;       ///< See begin_node().
        std::int32_t node = -1;
    };
    /// The graph of a loop: numbers from `begin` on in the ring of graphs.
    struct Graph {
        std::int32_t loop = -1;
        std::int32_t nodes = 0, edges = 0;
        std::uint64_t begin = 0;
    };
    [[nodiscard]] std::vector<std::int32_t> numbers(std::uint64_t begin, std::size_t count) const;

    std::vector<Ring> ring_;
    std::vector<Graph> graphs_;  ///< A ring, as the numbers are.
    std::uint64_t graph_count_ = 0;
    std::vector<std::int32_t> numbers_;
    std::uint64_t number_count_ = 0;
    Clock::time_point origin_ = Clock::now();
};

}  // namespace hawser::runtime
