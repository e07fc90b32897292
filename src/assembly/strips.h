// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file strips.h
/// Which rows and bodies are worked on together, while they are in the cache.
///
/// A step sweeps over rows and over bodies by turns: a body's right-hand side needs the rows that
/// touch it, a row's residual needs the new velocities of its bodies. Sweep by sweep, a large scene
/// would pass through memory each time. A *strip* is a stretch of consecutive bodies with the
/// interactions whose last body lies in it; bodies that no other strip's interaction touches are
/// the strip's own. Two sweeps become one: rows of a strip, then its own bodies. The few *shared*
/// bodies (hulls, and two or three of a wire at each border) wait for all strips.
///
/// ```
///   bodies        0 ······│·······│·······     strips are tasks: what one writes
///   interactions    ─── ──┼── ────┼─ ─────     no other one reads before the shared
///   shared        S      S S     S S           bodies' turn
/// ```
/// Strips depend on the scene alone, so sums that are merged strip by strip do not depend on
/// threads. Numbering at random makes every body shared: the sweeps are then apart again.

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

class Strips {
  public:
    /// @param dof  Degrees of freedom by body. @param rests  1 an interaction that is left out.
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
    /// Shared bodies come in groups of some hundred.
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
    std::vector<std::int32_t> last_, interaction_strip_, work_, strip_of_, own_, group_, cursor_;
    std::vector<IndexRange> bodies_, interactions_, shared_;
    std::vector<PoolRange> pools_;
    std::vector<std::int32_t> body_begin_{0}, interaction_begin_{0}, pool_begin_{0},
        group_begin_{0};
};

}  // namespace hawser::assembly
