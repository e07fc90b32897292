// SPDX-License-Identifier: Apache-2.0
#include "assembly/strips.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

/// Bodies and interactions of a strip at least: some hundred kilobytes, a share of a core's own
/// cache, and some twenty microseconds.
constexpr std::int32_t kStripWork = 384;
/// Large scenes have longer strips, if they have so many: 6 % less time there. Probably longer
/// stretches of the forty arrays that a strip reads in turns come from memory ahead of their use,
/// which counts for more than what is still in the cache at the next sweep.
constexpr std::int32_t kLongStripWork = 1536, kStrips = 32;
constexpr std::int32_t kGroup = 128;  ///< Shared bodies of a group.

/// Sort the indices 0 … n − 1 into buckets, as ranges in ascending order within each.
/// @param bucket  By index; −1: in none.
void collect(const std::vector<std::int32_t>& bucket, std::int32_t buckets,
             std::vector<IndexRange>& ranges, std::vector<std::int32_t>& begin) {
    auto each_range = [&](auto&& f) {
        const auto n = static_cast<std::int32_t>(bucket.size());
        for (std::int32_t a = 0, b = 0; a < n; a = b) {
            for (b = a; b < n && bucket[at(b)] == bucket[at(a)];) ++b;
            if (bucket[at(a)] >= 0) f(bucket[at(a)], IndexRange{a, b});
        }
    };
    begin.assign(at(buckets) + 1, 0);
    each_range([&](std::int32_t k, IndexRange) { ++begin[at(k) + 1]; });
    for (std::int32_t k = 0; k < buckets; ++k) begin[at(k) + 1] += begin[at(k)];
    ranges.resize(at(begin.back()));
    std::vector<std::int32_t> cursor(begin.begin(), begin.end() - 1);
    each_range([&](std::int32_t k, IndexRange r) { ranges[at(cursor[at(k)]++)] = r; });
}

}  // namespace

void Strips::build(std::span<const std::uint8_t> dof, std::span<const std::uint8_t> rests,
                   const model::Interactions& in) {
    const auto body_count = static_cast<std::int32_t>(dof.size());
    // An interaction goes with the last of its bodies that move.
    std::vector<std::int32_t> last(at(in.count()), 0), work(dof.size(), 1);
    for (std::int32_t i = 0; i < in.count(); ++i) {
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            if (dof[at(body)] > 0) last[at(i)] = std::max(last[at(i)], body);
        }
        if (body_count > 0) ++work[at(last[at(i)])];
    }
    const std::int32_t strip_work =
        std::clamp((body_count + in.count()) / kStrips, kStripWork, kLongStripWork);
    std::vector<std::int32_t> strip_of(dof.size());
    std::int32_t strips = 0, sum = 0;
    for (std::int32_t b = 0; b < body_count; ++b) {
        strip_of[at(b)] = strips;
        sum += work[at(b)];
        if (sum < strip_work) continue;
        ++strips;
        sum = 0;
    }
    if (sum > 0) ++strips;

    std::vector<std::int32_t> interaction_strip(at(in.count())), own = strip_of;
    for (std::int32_t i = 0; i < in.count(); ++i) {
        if (rests[at(i)]) {
            interaction_strip[at(i)] = -1;
            continue;
        }
        const std::int32_t s = interaction_strip[at(i)] = strip_of[at(last[at(i)])];
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            if (dof[at(body)] > 0 && strip_of[at(body)] != s) own[at(body)] = -1;
        }
    }
    std::vector<std::int32_t> group(dof.size(), -1);
    std::int32_t shared = 0;
    for (std::int32_t b = 0; b < body_count; ++b)
        if (own[at(b)] < 0) group[at(b)] = shared++ / kGroup;
    collect(own, strips, bodies_, body_begin_);
    collect(group, (shared + kGroup - 1) / kGroup, shared_, group_begin_);
    collect(interaction_strip, strips, interactions_, interaction_begin_);

    // Pools, kind by kind, then strip by strip.
    std::vector<std::vector<PoolRange>> by_strip(at(strips));
    std::vector<std::int32_t> bucket, begin;
    std::vector<IndexRange> ranges;
    for (int kind = 0; kind < kInteractionKindCount; ++kind) {
        bucket.clear();
        for (std::int32_t id : in.pool[at(kind)].ids) bucket.push_back(interaction_strip[at(id)]);
        collect(bucket, strips, ranges, begin);
        for (std::int32_t s = 0; s < strips; ++s)
            for (std::int32_t k = begin[at(s)]; k < begin[at(s) + 1]; ++k)
                by_strip[at(s)].push_back(
                    {ranges[at(k)].begin, ranges[at(k)].end, static_cast<InteractionKind>(kind)});
    }
    pools_.clear();
    pool_begin_.assign(1, 0);
    for (const std::vector<PoolRange>& list : by_strip) {
        pools_.insert(pools_.end(), list.begin(), list.end());
        pool_begin_.push_back(static_cast<std::int32_t>(pools_.size()));
    }
}

std::size_t Strips::bytes() const noexcept {
    using base::bytes;
    return bytes(bodies_) + bytes(interactions_) + bytes(shared_) + bytes(pools_) +
           bytes(body_begin_) + bytes(interaction_begin_) + bytes(pool_begin_) +
           bytes(group_begin_);
}

}  // namespace hawser::assembly
