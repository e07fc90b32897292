// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partial.h
/// Partial refactorisation: after the values of some blocks changed, only the fronts on their
/// paths to the root are computed again.
///
/// The update matrix of a front is a function of the values in its subtree. Where those did not
/// change, the update matrix of the last factorisation is still right, if it is still there: the
/// stacks of symbolic.h hand its place to the next front, so a structure that is to be
/// refactored in part gets a place for each update matrix (keep_updates()). The result has the
/// bits of a full factorisation, because each front does the same additions in the same order.
///
/// ```
/// keep_updates(symbolic);                    // once, after analyse()
/// numeric.reserve(symbolic, threads); numeric.clear(...); fill all; numeric.factor(...);
/// ...
/// dirty.find(symbolic, columns);             // which fronts, which panels
/// numeric.clear(symbolic, dirty, executor);  // their panels held L: zero them
/// fill every block whose target lies in dirty.panels: all of them, not only the changed ones
/// numeric.refactor(symbolic, dirty, executor);
/// ```
/// A batch of chains (batches.h) shares its panels among up to eight chains and is done whole;
/// parents of its chains without dirty nodes stay clean.

#include "base/memory.h"
#include "factor/symbolic.h"
#include "factor/unsymmetric.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Give every update matrix a place of its own, for as long as the structure lives.
/// @cost O(fronts); memory: Σ q·ldu doubles instead of the height of the stacks.
void keep_updates(Symbolic& symbolic) noexcept;

/// Offsets [begin, end) of the panel array.
struct PanelRange {
    std::int64_t begin = 0, end = 0;
    friend bool operator==(const PanelRange&, const PanelRange&) = default;
};

/// The panels of a batch: contiguous, step after step.
[[nodiscard]] PanelRange panel_of(const Symbolic& symbolic, const Batch& batch) noexcept;

/// Fronts [begin, end) to factor in sequence, in a node of Symbolic::graph.
struct FrontRange {
    std::int32_t begin = 0, end = 0, node = -1;
};

/// The part of a factorisation that changed values make stale.
class DirtyParts {
  public:
    /// Room for any part of this structure; find() then allocates nothing. @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic);

    /// The column of a changed block: of its two nodes the one eliminated first, as in
    /// Symbolic::target().
    [[nodiscard]] static std::int32_t column(const Symbolic& s, std::int32_t a,
                                             std::int32_t b) noexcept {
        return s.position[static_cast<std::size_t>(a)] < s.position[static_cast<std::size_t>(b)]
                   ? a
                   : b;
    }

    /// Close a set of columns (nodes, any order, duplicates allowed) under "is an ancestor of".
    /// `unsymmetric`, of the next factorisation, matters to `flops` only.
    /// @cost O(dirty fronts · log).
    void find(const Symbolic& symbolic, std::span<const std::int32_t> columns,
              const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Whether blocks in this column must be written again.
    [[nodiscard]] bool refill(const Symbolic& s, std::int32_t column) const noexcept {
        const std::int32_t f = s.node_front[static_cast<std::size_t>(column)];
        const std::int32_t b = s.fronts[static_cast<std::size_t>(f)].batch;
        return b >= 0 ? is_batch(b) : front_mark_[static_cast<std::size_t>(f)] == epoch_;
    }

    /// Whether a batch is dirty.
    [[nodiscard]] bool is_batch(std::int32_t batch) const noexcept {
        return batch_mark_[static_cast<std::size_t>(batch)] == epoch_;
    }

    std::vector<std::int32_t> fronts;   ///< Dirty, ascending; chains are in `batches`.
    std::vector<std::int32_t> batches;  ///< Ascending.
    std::vector<PanelRange> panels;     ///< To clear and refill; ascending, apart.
    std::vector<FrontRange> ranges;     ///< The fronts in runs, by node, ascending within each.
    std::vector<std::int32_t> nodes;    ///< First of `ranges` of each node, and one more at end.
    std::int64_t flops = 0;  ///< Of the refactorisation; an unsymmetric front counts twice.

  private:
    void add_panel(std::int64_t begin, std::int64_t end) noexcept;
    void make_ranges(const Symbolic& s) noexcept;

    std::vector<std::uint32_t> front_mark_, batch_mark_;
    std::uint32_t epoch_ = 0;
};

}  // namespace hawser::factor
