// SPDX-License-Identifier: Apache-2.0
#include "runtime/trace.h"

#include <algorithm>
#include <tuple>

namespace hawser::runtime {

Trace::Trace(int threads, std::size_t capacity)
    : ring_(static_cast<std::size_t>(std::max(threads, 1))) {
    capacity = std::max<std::size_t>(capacity, 1);
    for (Ring& r : ring_) r.span.resize(capacity);
    // Assume that every node is a task and has about two edges.
    graphs_.resize(capacity / 8 + 1);
    numbers_.resize(4 * capacity);
}

void Trace::announce(const base::TaskOrder& order) noexcept {
    Graph& g = graphs_[graph_count_++ % graphs_.size()];
    g = {loops, static_cast<std::int32_t>(order.rank.size()),
         static_cast<std::int32_t>(order.next.size()), number_count_};
    for (const auto part : {order.start, order.next, order.rank})
        for (const std::int32_t n : part) numbers_[number_count_++ % numbers_.size()] = n;
}

std::vector<std::int32_t> Trace::copy_numbers(std::uint64_t begin, std::size_t count) const {
    std::vector<std::int32_t> out(count);
    for (std::size_t i = 0; i < count; ++i) out[i] = numbers_[(begin + i) % numbers_.size()];
    return out;
}

double Trace::end_of_overwritten() const noexcept {
    double until = 0.0;
    for (const Ring& r : ring_) until = std::max(until, r.end_of_overwritten);
    return until;
}

void Trace::copy(double from, TraceView& to) const {
    to = {};
    to.threads = threads();
    for (const Ring& r : ring_) {
        const auto held = static_cast<std::size_t>(std::min<std::uint64_t>(r.count, r.span.size()));
        for (std::size_t i = 0; i < held; ++i)
            if (r.span[i].begin >= from) to.spans.push_back(r.span[i]);
    }
    std::sort(to.spans.begin(), to.spans.end(), [](const TraceSpan& a, const TraceSpan& b) {
        return std::tuple(a.begin, -a.end, a.kind, a.thread, a.task) <
               std::tuple(b.begin, -b.end, b.kind, b.thread, b.task);
    });
    std::int32_t first = loops;
    for (const TraceSpan& s : to.spans)
        if (s.kind == SpanKind::loop) first = std::min(first, s.loop);
    const std::uint64_t kept = std::min<std::uint64_t>(graph_count_, graphs_.size());
    for (std::uint64_t k = graph_count_ - kept; k < graph_count_; ++k) {
        const Graph& g = graphs_[k % graphs_.size()];
        if (g.loop < first || number_count_ - g.begin > numbers_.size()) continue;
        const auto nodes = static_cast<std::size_t>(g.nodes);
        const auto edges = static_cast<std::size_t>(g.edges);
        to.graph_loop.push_back(g.loop);
        to.graph.push_back({copy_numbers(g.begin, nodes + 1),
                            copy_numbers(g.begin + nodes + 1, edges),
                            copy_numbers(g.begin + nodes + 1 + edges, nodes)});
    }
}

}  // namespace hawser::runtime

namespace hawser {

const char* to_string(SpanKind kind) noexcept {
    constexpr const char* kNames[] = {"step", "stage", "loop", "task"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace hawser
