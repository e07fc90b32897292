// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file strips.h
/// Row blocks that are processed together while they are in the cache.
///
/// A step sweeps over rows and bodies in turn. The right-hand side of a body needs the rows of its
/// interactions. The residual of a row needs the new velocities of its bodies. With separate sweeps
/// a large scene would be read from memory each time.
///
/// A *row block* is a range of consecutive bodies with the interactions whose last body lies in it.
/// Bodies without interactions of other row blocks are own bodies of the row block. Two sweeps
/// become one: rows of a row block, then its own bodies. The few *shared* bodies (hulls, and two or
/// three of a wire at each border) are processed after all row blocks.
///
/// ```
///   bodies        0 ······│·······│·······     row blocks are tasks: no other row block reads
///   interactions    ─── ──┼── ────┼─ ─────     the output before the shared bodies are processed
///   shared        S      S S     S S
/// ```
/// Row blocks depend on the scene alone, so that sums merged by row block do not depend on threads.
/// If bodies are numbered at random, all are shared, and the sweeps are separate again.

#include "model/bodies.h"
#include "model/interactions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::assembly {

struct IndexRange {
    std::int32_t begin, end;
};
/// Consecutive entries of the pool of one kind.
struct PoolRange {
    std::int32_t begin, end;
    InteractionKind kind;
};

class RowBlocks {
  public:
    /// Build the row blocks.
    /// @param dof  Degrees of freedom by body.
    /// @param rests  1 for each interaction to leave out.
    /// @throws std::bad_alloc.
    void build(std::span<const std::uint8_t> dof, std::span<const std::uint8_t> rests,
               const model::Interactions& interactions);

    [[nodiscard]] int count() const noexcept { return static_cast<int>(body_begin_.size()) - 1; }
    [[nodiscard]] std::span<const IndexRange> bodies(int strip) const noexcept {
        return part(bodies_, body_begin_, strip);
    }
    [[nodiscard]] std::span<const IndexRange> interactions(int strip) const noexcept {
        return part(interactions_, interaction_begin_, strip);
    }
    [[nodiscard]] std::span<const PoolRange> pools(int strip) const noexcept {
        return part(pools_, pool_begin_, strip);
    }
    /// Return the number of groups of shared bodies. A group has a few hundred bodies.
    [[nodiscard]] int groups() const noexcept { return static_cast<int>(group_begin_.size()) - 1; }
    [[nodiscard]] std::span<const IndexRange> shared(int group) const noexcept {
        return part(shared_, group_begin_, group);
    }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    template <class T>
    static std::span<const T> part(const std::vector<T>& all, const std::vector<std::int32_t>& cut,
                                   int i) noexcept {
        const auto k = static_cast<std::size_t>(i);
        return {all.data() + cut[k], all.data() + cut[k + 1]};
    }

    void sort_into(const std::vector<std::int32_t>& bucket, std::int32_t buckets,
                   std::vector<IndexRange>& ranges, std::vector<std::int32_t>& begin);
    void sort_pools(const model::Interactions& interactions, std::int32_t strips);

    // Scratch of build(), by interaction and by body, and by bucket.
    std::vector<std::int32_t> last_, block_of_interaction_, work_, block_of_, own_, group_, cursor_;
    std::vector<IndexRange> bodies_, interactions_, shared_;
    std::vector<PoolRange> pools_;
    std::vector<std::int32_t> body_begin_{0}, interaction_begin_{0}, pool_begin_{0},
        group_begin_{0};
};

}  // namespace hawser::assembly
