// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sweeps.h
/// How a step goes through bodies and rows: coarse tasks of fixed size.

#include "context/context.h"

#include <algorithm>
#include <span>

namespace hawser::stepper {

/// Run f(begin, end) over chunks of [0, count).
template <class F>
void over(runtime::Pool& pool, std::int32_t count, F&& f) noexcept {
    constexpr std::int32_t size = StepContext::kChunk;
    auto task = [&](int i, int) noexcept { f(i * size, std::min((i + 1) * size, count)); };
    pool.for_each(StepContext::chunks(count), task);
}

/// The results of f(begin, end) over chunks of [0, count), merged in their order: they do not
/// depend on threads. There is room for as many as there are contacts (contact.cpp).
template <class F, class Merge>
[[nodiscard]] double merged_over(SolveWork& solve, runtime::Pool& pool, std::int32_t count, F&& f,
                                 Merge&& merge) noexcept {
    over(pool, count, [&](std::int32_t a, std::int32_t b) {
        solve.partial[static_cast<std::size_t>(a / StepContext::kChunk)] = f(a, b);
    });
    double sum = 0.0;
    for (int i = 0; i < StepContext::chunks(count); ++i)
        sum = merge(sum, solve.partial[static_cast<std::size_t>(i)]);
    return sum;
}

/// Call f for each of some ranges.
template <class F>
void each(std::span<const assembly::IndexRange> ranges, F&& f) noexcept {
    for (const assembly::IndexRange& r : ranges) f(r.begin, r.end);
}

/// rows(strip), then own(begin, end) for the strip's own bodies, strip by strip; then own() for
/// the shared bodies. The last argument of own() is a place in ctx.work.solve.norms; that of the
/// rows is `strip`.
template <class Rows, class Own>
void sweep(const Model& model, runtime::Pool& pool, Rows&& rows, Own&& own) noexcept {
    const assembly::Strips& strips = model.system.strips;
    auto strip = [&](int i, int) noexcept {
        rows(i);
        each(strips.bodies(i), [&](std::int32_t a, std::int32_t b) { own(a, b, i); });
    };
    auto group = [&](int i, int) noexcept {
        each(strips.shared(i),
             [&](std::int32_t a, std::int32_t b) { own(a, b, strips.count() + i); });
    };
    pool.for_each(strips.count(), strip);
    pool.for_each(strips.groups(), group);
}

/// f(begin, end) for ranges that make up all interactions but those that sleep.
template <class F>
void over_interactions(const Model& model, runtime::Pool& pool, F&& f) noexcept {
    const assembly::Strips& strips = model.system.strips;
    auto strip = [&](int i, int) noexcept { each(strips.interactions(i), f); };
    pool.for_each(strips.count(), strip);
}

}  // namespace hawser::stepper
