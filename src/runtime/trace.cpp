// SPDX-License-Identifier: Apache-2.0
#include "runtime/trace.h"

#include <algorithm>
#include <tuple>

namespace hawser::runtime {

Trace::Trace(int threads, std::size_t capacity)
    : ring_(static_cast<std::size_t>(std::max(threads, 1))) {
    for (Ring& r : ring_) r.span.resize(std::max<std::size_t>(capacity, 1));
}

double Trace::lost_until() const noexcept {
    double until = 0.0;
    for (const Ring& r : ring_) until = std::max(until, r.lost_until);
    return until;
}

void Trace::copy(double from, std::vector<TraceSpan>& to) const {
    for (const Ring& r : ring_) {
        const std::size_t held =
            static_cast<std::size_t>(std::min<std::uint64_t>(r.count, r.span.size()));
        for (std::size_t i = 0; i < held; ++i)
            if (r.span[i].begin >= from) to.push_back(r.span[i]);
    }
    std::sort(to.begin(), to.end(), [](const TraceSpan& a, const TraceSpan& b) {
        return std::tuple(a.begin, -a.end, a.kind, a.thread, a.task) <
               std::tuple(b.begin, -b.end, b.kind, b.thread, b.task);
    });
}

}  // namespace hawser::runtime

namespace hawser {

const char* to_string(SpanKind kind) noexcept {
    constexpr const char* kNames[] = {"step", "stage", "loop", "task"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace hawser
