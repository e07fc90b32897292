// SPDX-License-Identifier: Apache-2.0
#include <hawser/trace.h>

#include "world/impl.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace hawser {

void WorldSolver::start_trace(std::size_t spans) {
    const world::Using use(impl().use, "start_trace");
    constexpr std::size_t kMaxSpans = std::size_t{1} << 28;
    if (spans > kMaxSpans)
        throw DefError("start_trace: spans = " + std::to_string(spans) + "; give at most " +
                       std::to_string(kMaxSpans));
    context::StepContext& c = impl().ctx;
    std::unique_ptr<runtime::Trace> trace;
    if (spans > 0) trace = std::make_unique<runtime::Trace>(c.pool.threads(), spans);
    c.pool.record(nullptr);
    c.trace = std::move(trace);
    c.pool.record(c.trace.get());
}

TraceView WorldSolverView::trace(std::int64_t steps) const {
    TraceView view;
    const runtime::Trace* const trace = impl().ctx.trace.get();
    if (trace == nullptr) return view;
    trace->copy(trace->end_of_overwritten(), view);
    // The last of the complete steps.
    std::vector<double> begin;
    double end = 0.0;
    for (const TraceSpan& s : view.spans) {
        if (s.kind != SpanKind::step) continue;
        begin.push_back(s.begin);
        end = s.end;
    }
    const auto kept = static_cast<std::size_t>(
        std::clamp<std::int64_t>(steps, 0, static_cast<std::int64_t>(begin.size())));
    const double from =
        kept > 0 ? begin[begin.size() - kept] : std::numeric_limits<double>::infinity();
    std::erase_if(view.spans, [&](const TraceSpan& s) { return s.begin < from || s.end > end; });
    view.steps = static_cast<std::int64_t>(kept);
    view.steps_lost = trace->steps - static_cast<std::int64_t>(begin.size());
    return view;
}

}  // namespace hawser
