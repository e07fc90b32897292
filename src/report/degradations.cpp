// SPDX-License-Identifier: Apache-2.0
#include "report/degradations.h"

#include <algorithm>
#include <bit>

namespace hawser::report {

namespace {

void extend_interval(DegradedSpan& span, const StepStats& s) {
    if (span.steps++ == 0) {
        span.first = s.step;
        span.begin = s.time;
        span.cause = s.degraded_by;
    }
    span.last = s.step;
    span.end = s.time;
    const std::int32_t made = s.degradation.iterations;
    if (made > 0) span.iterations = span.iterations > 0 ? std::min(span.iterations, made) : made;
    span.wires = std::max(span.wires, s.degradation.wires);
    span.interfaces = std::max(span.interfaces, std::popcount(s.compliant));
    if (s.compliant != 0) {
        span.momentum_defect = std::max(span.momentum_defect, s.momentum_defect);
        span.cut_defect = std::max(span.cut_defect, s.cut_defect);
    }
    span.foreseen = std::max(span.foreseen, s.foreseen_seconds);
    span.residual = std::max(span.residual, s.natural_map);
}

}  // namespace

void Degradations::after_step(const StepStats& s) {
    // Requested cuts that contacts keep closed are exact.
    if (s.degradation.iterations == 0 && s.compliant == 0 && s.degradation.wires == 0) return;
    const bool goes_on = all.steps > 0 && all.last == s.step - 1;
    extend_interval(all, s);
    if (s.degradation.wires > 0) extend_interval(wires, s);
    if (s.degradation.iterations > 0) extend_interval(friction, s);
    if (s.compliant != 0) extend_interval(coupling, s);
    ++by_cause[static_cast<std::size_t>(s.degraded_by)];
    if (!goes_on) ++spans;
    if (static_cast<std::size_t>(spans) > kListedSpans) return;
    if (!goes_on) list.emplace_back();
    extend_interval(list.back(), s);
}

}  // namespace hawser::report
