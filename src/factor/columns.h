// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file columns.h
/// The structure of L by block columns, and its repair.
///
/// Definition: struct(v) = neighbours of v after it ∪ struct of its children, less v itself. The
/// parent of v in the elimination tree is the first node of struct(v) (Liu, "The role of
/// elimination trees in sparse factorization", 1990). Both depend only on the neighbours of v and
/// on its children. After an edit a repair therefore computes only columns whose neighbours,
/// children or children's structures changed. The change stops at a column that comes out
/// unchanged. A set of positions lists the stale columns, and the lowest is next. The repair reads
/// no other column.
///
/// Columns are stored by node, not by position in the order. An unchanged column needs no update
/// when nodes before it are added or removed.

#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

class Columns {
  public:
    /// Build the structure of all columns.
    /// @param position  The inverse of `order`.
    /// @throws std::bad_alloc.
    void build(const Pattern& pattern, std::span<const std::int32_t> order,
               std::span<const std::int32_t> position);

    /// Apply a new numbering of nodes to the structure. New nodes (−1) get empty columns. Parents
    /// of removed nodes are marked stale.
    void renumber(std::span<const std::int32_t> old_of_new, std::int32_t old_nodes);

    /// Mark a node as stale because its neighbours or children have changed. A node that has moved
    /// in the order also makes its neighbours stale.
    void mark_stale(std::int32_t node) {
        if (stale_[static_cast<std::size_t>(node)] != 0) return;
        stale_[static_cast<std::size_t>(node)] = 1;
        stale_list_.push_back(node);
    }
    void mark_moved(const Pattern& pattern, std::int32_t node);

    /// Compute stale columns again, and the columns above them until a column is unchanged. Nodes
    /// that are not marked as moved must keep their relative order.
    void repair(const Pattern& pattern, std::span<const std::int32_t> order,
                std::span<const std::int32_t> position);

    [[nodiscard]] std::int32_t parent(std::int32_t node) const noexcept {
        return parent_[static_cast<std::size_t>(node)];
    }
    /// Return the rows of a column: the later nodes in which it has entries, in the order of
    /// elimination.
    [[nodiscard]] std::span<const std::int32_t> rows(std::int32_t node) const noexcept {
        const auto n = static_cast<std::size_t>(node);
        return {pool_.data() + begin_[n], static_cast<std::size_t>(count_[n])};
    }
    /// Return the number of scalar rows below the diagonal block of a node.
    [[nodiscard]] std::int32_t below(std::int32_t node) const noexcept {
        return below_[static_cast<std::size_t>(node)];
    }
    /// Return true if the last build() or repair() changed the rows, position or children of this
    /// node. A branch of the tree without such nodes is unchanged.
    [[nodiscard]] bool column_changed(std::int32_t node) const noexcept {
        return changed_[static_cast<std::size_t>(node)] != 0;
    }
    /// Return the number of columns that the last build() or repair() computed.
    [[nodiscard]] std::int32_t columns_computed() const noexcept { return computed_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void resize(std::size_t nodes);
    void link_all();
    void link(std::int32_t node) noexcept;
    void unlink(std::int32_t node) noexcept;
    void queue_position(std::int32_t position) noexcept {
        todo_[static_cast<std::size_t>(position / 64)] |= std::uint64_t{1} << (position % 64);
    }
    void compute(const Pattern& pattern, std::span<const std::int32_t> order,
                 std::span<const std::int32_t> position, std::int32_t node);
    [[nodiscard]] bool is_unchanged(std::int32_t node, std::size_t found) const noexcept;
    void store_column(std::int32_t node, std::size_t found);
    void compact_pool();

    std::vector<std::int32_t> parent_, count_, below_;
    /// Offset into pool_, which has gaps after columns were moved.
    std::vector<std::int64_t> begin_;
    std::vector<std::int32_t> pool_, found_rows_;
    std::vector<std::int32_t> spare_;  ///< Buffer for the pool, and for rows during build().
    std::vector<std::int32_t> head_, next_, prev_;  ///< Lists of children during a call.
    bool linked_ = false;
    std::vector<std::int32_t> mark_;   ///< Last column that marked each node.
    std::vector<std::uint64_t> todo_;  ///< Stale columns by position that repair() must compute.
    std::vector<std::int32_t> stale_list_, moved_list_;  ///< Nodes that stale_ and moved_ mark.
    std::vector<std::int32_t> rows_;                     ///< Scratch of build().
    std::vector<std::int64_t> cursor_;                   ///< Scratch of build().
    std::vector<std::size_t> row_end_;                   ///< Scratch of build().
    std::vector<std::uint8_t> stale_, moved_, changed_;
    std::vector<std::int32_t> new_of_old_, carried_;  ///< Scratch of renumber().
    std::vector<std::int64_t> carried_begin_;         ///< Scratch of renumber().
    std::vector<std::uint8_t> carried_stale_;         ///< Scratch of renumber().
    std::int64_t rows_in_use_ = 0;
    std::int32_t computed_ = 0;
};

}  // namespace hawser::factor
