// SPDX-License-Identifier: Apache-2.0
#include "assembly/strips.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

/// Minimum number of bodies and interactions of a row block. They need some hundred kilobytes, a
/// fraction of the cache of a core, and some twenty microseconds.
constexpr std::int32_t kBlockWork = 384;
/// Large scenes with enough row blocks use longer ones: 6 % less time. The probable cause is
/// prefetching of longer parts of the forty arrays that a row block reads in turn. It outweighs the
/// data that remain in the cache for the next sweep.
constexpr std::int32_t kLongBlockWork = 1536, kStrips = 32;
constexpr std::int32_t kSharedBodiesPerGroup = 128;  ///< Shared bodies per group.

/// Call f(bucket, range) for each run of indices with the same bucket. @param bucket  Bucket of an
/// index; −1: none.
template <class B, class F>
void each_range(std::int32_t n, B&& bucket, F&& f) {
    for (std::int32_t a = 0, b = 0; a < n; a = b) {
        const std::int32_t k = bucket(a);
        for (b = a; b < n && bucket(b) == k;) ++b;
        if (k >= 0) f(k, IndexRange{a, b});
    }
}

}  // namespace

/// Sort the indices 0 … n − 1 into buckets, as ranges in ascending order within each.
void RowBlocks::sort_into(const std::vector<std::int32_t>& bucket, std::int32_t buckets,
                          std::vector<IndexRange>& ranges, std::vector<std::int32_t>& begin) {
    const auto n = static_cast<std::int32_t>(bucket.size());
    auto of = [&](std::int32_t i) { return bucket[at(i)]; };
    begin.assign(at(buckets) + 1, 0);
    each_range(n, of, [&](std::int32_t k, IndexRange) { ++begin[at(k) + 1]; });
    for (std::int32_t k = 0; k < buckets; ++k) begin[at(k) + 1] += begin[at(k)];
    ranges.resize(at(begin.back()));
    cursor_.assign(begin.begin(), begin.end() - 1);
    each_range(n, of, [&](std::int32_t k, IndexRange r) { ranges[at(cursor_[at(k)]++)] = r; });
}

/// Sort pools by row block, then by kind.
void RowBlocks::sort_pools(const model::Interactions& in, std::int32_t strips) {
    auto each = [&](auto&& f) {
        for (std::size_t kind = 0; kind < kInteractionKindCount; ++kind) {
            const auto& ids = in.pool[kind].ids;
            each_range(
                static_cast<std::int32_t>(ids.size()),
                [&](std::int32_t i) { return block_of_interaction_[at(ids[at(i)])]; },
                [&](std::int32_t k, IndexRange r) {
                    f(k, PoolRange{r.begin, r.end, static_cast<InteractionKind>(kind)});
                });
        }
    };
    pool_begin_.assign(at(strips) + 1, 0);
    each([&](std::int32_t k, const PoolRange&) { ++pool_begin_[at(k) + 1]; });
    for (std::int32_t k = 0; k < strips; ++k) pool_begin_[at(k) + 1] += pool_begin_[at(k)];
    pools_.resize(at(pool_begin_.back()));
    cursor_.assign(pool_begin_.begin(), pool_begin_.end() - 1);
    each([&](std::int32_t k, const PoolRange& r) { pools_[at(cursor_[at(k)]++)] = r; });
}

void RowBlocks::build(std::span<const std::uint8_t> dof, std::span<const std::uint8_t> rests,
                      const model::Interactions& in) {
    const auto body_count = static_cast<std::int32_t>(dof.size());
    // An interaction belongs to the row block of the last of its bodies that move.
    last_.assign(at(in.count()), 0);
    work_.assign(dof.size(), 1);
    for (std::int32_t i = 0; i < in.count(); ++i) {
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            if (dof[at(body)] > 0) last_[at(i)] = std::max(last_[at(i)], body);
        }
        if (body_count > 0) ++work_[at(last_[at(i)])];
    }
    const std::int32_t block_work =
        std::clamp((body_count + in.count()) / kStrips, kBlockWork, kLongBlockWork);
    block_of_.resize(dof.size());
    std::int32_t strips = 0, sum = 0;
    for (std::int32_t b = 0; b < body_count; ++b) {
        block_of_[at(b)] = strips;
        sum += work_[at(b)];
        if (sum < block_work) continue;
        ++strips;
        sum = 0;
    }
    if (sum > 0) ++strips;

    block_of_interaction_.resize(at(in.count()));
    own_ = block_of_;
    for (std::int32_t i = 0; i < in.count(); ++i) {
        if (rests[at(i)]) {
            block_of_interaction_[at(i)] = -1;
            continue;
        }
        const std::int32_t s = block_of_interaction_[at(i)] = block_of_[at(last_[at(i)])];
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            if (dof[at(body)] > 0 && block_of_[at(body)] != s) own_[at(body)] = -1;
        }
    }
    group_.assign(dof.size(), -1);
    std::int32_t shared = 0;
    for (std::int32_t b = 0; b < body_count; ++b)
        if (own_[at(b)] < 0) group_[at(b)] = shared++ / kSharedBodiesPerGroup;
    sort_into(own_, strips, bodies_, body_begin_);
    sort_into(group_, (shared + kSharedBodiesPerGroup - 1) / kSharedBodiesPerGroup, shared_,
              group_begin_);
    sort_into(block_of_interaction_, strips, interactions_, interaction_begin_);
    sort_pools(in, strips);
}

std::size_t RowBlocks::bytes() const noexcept {
    using base::bytes;
    return bytes(bodies_) + bytes(interactions_) + bytes(shared_) + bytes(pools_) +
           bytes(body_begin_) + bytes(interaction_begin_) + bytes(pool_begin_) +
           bytes(group_begin_) + bytes(last_) + bytes(block_of_interaction_) + bytes(work_) +
           bytes(block_of_) + bytes(own_) + bytes(group_) + bytes(cursor_);
}

}  // namespace hawser::assembly
