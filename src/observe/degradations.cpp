// SPDX-License-Identifier: Apache-2.0
#include "observe/degradations.h"

#include <algorithm>

namespace hawser::observe {

namespace {

void extend(DegradedSpan& span, const StepStats& s) {
    span.last = s.step;
    span.end = s.time;
    span.iterations = std::min(span.iterations, s.degradation.iterations);
    span.foreseen = std::max(span.foreseen, s.foreseen_seconds);
    span.residual = std::max(span.residual, s.natural_map);
}

DegradedSpan start(const StepStats& s) {
    DegradedSpan span;
    span.first = s.step;
    span.begin = s.time;
    span.iterations = s.degradation.iterations;
    span.cause = s.degraded_by;
    extend(span, s);
    return span;
}

}  // namespace

void Degradations::after_step(const StepStats& s) {
    if (!s.degradation.any()) return;
    const bool goes_on = steps > 0 && all.last == s.step - 1;
    steps > 0 ? extend(all, s) : void(all = start(s));
    ++steps;
    ++by_cause[static_cast<std::size_t>(s.degraded_by)];
    if (!goes_on) ++spans;
    if (static_cast<std::size_t>(spans) > kListedSpans) return;
    if (goes_on)
        extend(list.back(), s);
    else
        list.push_back(start(s));
}

}  // namespace hawser::observe
