// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sweeps.h
/// Traverse bodies and rows in coarse tasks of fixed size.

#include "context/context.h"

#include <algorithm>
#include <span>

namespace hawser::context {

/// Run f(begin, end) over chunks of [0, count).
template <class F>
void over(runtime::Pool& pool, std::int32_t count, F&& f) noexcept {
    constexpr std::int32_t size = StepContext::kChunk;
    auto task = [&](int i, int) noexcept { f(i * size, std::min((i + 1) * size, count)); };
    pool.for_each(StepContext::chunks(count), task);
}

/// Call f(begin, end) over chunks of [0, count) and merge the results in the order of chunks, so
/// that the result does not depend on threads. The buffer solve.partial has one slot for each
/// chunk.
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

/// Call f(begin, end) for each range of indices.
template <class F>
void each(std::span<const assembly::IndexRange> ranges, F&& f) noexcept {
    for (const assembly::IndexRange& r : ranges) f(r.begin, r.end);
}

/// Call rows(block) for each row block, followed by own(begin, end, slot) for the bodies of this
/// block. Then call own() for the bodies that several blocks share. `slot` is an index in
/// ctx.work.solve.norms; for the bodies of a row block it is the index of the block.
template <class Rows, class Own>
void sweep(const Model& model, runtime::Pool& pool, Rows&& rows, Own&& own) noexcept {
    const assembly::RowBlocks& strips = model.system.strips;
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

/// Call f(begin, end) for ranges that cover all interactions except sleeping ones.
template <class F>
void over_interactions(const Model& model, runtime::Pool& pool, F&& f) noexcept {
    const assembly::RowBlocks& strips = model.system.strips;
    auto strip = [&](int i, int) noexcept { each(strips.interactions(i), f); };
    pool.for_each(strips.count(), strip);
}

}  // namespace hawser::context
