// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partial.h
/// Partial refactorisation: after the values of some blocks changed, only the fronts on their paths
/// to the root are computed again.
///
/// The update matrix of a front is a function of the values in its subtree. If they did not change,
/// the update matrix of the last factorisation is still valid, if it is still stored. The stacks of
/// symbolic.h reuse its memory for the next front. separate_updates() therefore assigns separate
/// memory to each update matrix. The result has the bits of a full factorisation, because each
/// front does the same additions in the same order.
///
/// ```
/// separate_updates(symbolic);                    // once, after analyse()
/// numeric.reserve(symbolic, threads); numeric.clear(...); fill all; numeric.factor(...);
/// ...
/// dirty.find(symbolic, columns);             // which fronts, which panels
/// numeric.clear(symbolic, dirty, executor);  // their panels held L: zero them
/// fill every block whose target lies in dirty.panels: all of them, not only the changed ones
/// numeric.refactor(symbolic, dirty, executor);
/// ```
/// A batch of chains (batches.h) shares its panels among up to eight chains and is refactored as a
/// whole. Parents of its chains without dirty nodes stay clean.

#include "base/memory.h"
#include "factor/symbolic.h"
#include "factor/unsymmetric.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Assign separate memory to every update matrix for the life of the structure.
/// @cost O(fronts); memory: Σ q·ldu doubles instead of the height of the stacks.
void separate_updates(Symbolic& symbolic) noexcept;

/// Offsets [begin, end) of the panel array.
struct PanelRange {
    std::int64_t begin = 0, end = 0;
    friend bool operator==(const PanelRange&, const PanelRange&) = default;
};

/// Return the panels of a batch, which are contiguous.
[[nodiscard]] PanelRange panel_of(const Symbolic& symbolic, const Batch& batch) noexcept;

/// Fronts [begin, end) to factor in sequence, in a node of Symbolic::graph.
struct FrontRange {
    std::int32_t begin = 0, end = 0, node = -1;
};

/// The part of a factorisation that changed values invalidate.
class DirtyParts {
  public:
    /// Reserve memory for any part of this structure; find() then allocates nothing.
    /// @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic);

    /// Return the column of a changed block: the first eliminated of its two nodes, as in
    /// Symbolic::target().
    [[nodiscard]] static std::int32_t column(const Symbolic& s, std::int32_t a,
                                             std::int32_t b) noexcept {
        return s.position[static_cast<std::size_t>(a)] < s.position[static_cast<std::size_t>(b)]
                   ? a
                   : b;
    }

    /// Close a set of columns (nodes, any order, duplicates allowed) under "is an ancestor of".
    /// `unsymmetric`, the set of the next factorisation, affects `flops` only.
    /// @cost O(dirty fronts · log).
    void find(const Symbolic& symbolic, std::span<const std::int32_t> columns,
              const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Return true if blocks in this column must be written again.
    [[nodiscard]] bool refill(const Symbolic& s, std::int32_t column) const noexcept {
        const std::int32_t f = s.node_front[static_cast<std::size_t>(column)];
        const std::int32_t b = s.fronts[static_cast<std::size_t>(f)].batch;
        return b >= 0 ? is_batch(b) : front_mark_[static_cast<std::size_t>(f)] == epoch_;
    }

    /// Return true if a batch is dirty.
    [[nodiscard]] bool is_batch(std::int32_t batch) const noexcept {
        return batch_mark_[static_cast<std::size_t>(batch)] == epoch_;
    }

    std::vector<std::int32_t> fronts;   ///< Dirty fronts, ascending, except chains.
    std::vector<std::int32_t> batches;  ///< Ascending.
    std::vector<PanelRange> panels;     ///< Ranges to clear and refill; ascending and disjoint.
    std::vector<FrontRange> ranges;     ///< Runs of fronts by node, ascending within each.
    std::vector<std::int32_t> nodes;    ///< First range of each node, and the end.
    std::int64_t flops = 0;  ///< Flops of the refactorisation; an unsymmetric front counts twice.

  private:
    void add_panel(std::int64_t begin, std::int64_t end) noexcept;
    void make_ranges(const Symbolic& s) noexcept;

    std::vector<std::uint32_t> front_mark_, batch_mark_;
    std::uint32_t epoch_ = 0;
};

}  // namespace hawser::factor
