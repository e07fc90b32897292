// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file columns.h
/// The structure of L, block column by block column, and its repair.
///
/// struct(v) = neighbours of v after it ∪ struct of its children, less v itself; the parent of v
/// in the elimination tree is the first node of struct(v) (Liu, "The role of elimination trees in
/// sparse factorization", 1990). Both are functions of the neighbours of v and of its children,
/// so after an edit only those columns are computed again whose neighbours, children or
/// children's structures changed, and the change stops where a column comes out as it was: a set of
/// positions, of which the lowest is always next. No other column is looked at.
///
/// Everything is named by node, not by position in the order: a column that does not change is
/// not even touched when nodes before it come and go.

#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

class Columns {
  public:
    /// From nothing. `position` is the inverse of `order`. @throws std::bad_alloc.
    void build(const Pattern& pattern, std::span<const std::int32_t> order,
               std::span<const std::int32_t> position);

    /// Carry the structure over to another numbering; new nodes (−1) get empty columns. Parents
    /// of nodes that went are marked stale.
    void renumber(std::span<const std::int32_t> old_of_new, std::int32_t old_nodes);

    /// Stale: neighbours or children changed. Moved: also at another place in the order, which
    /// makes its neighbours stale too.
    void mark_stale(std::int32_t node) {
        if (stale_[static_cast<std::size_t>(node)] != 0) return;
        stale_[static_cast<std::size_t>(node)] = 1;
        stale_list_.push_back(node);
    }
    void mark_moved(const Pattern& pattern, std::int32_t node);

    /// Compute stale columns again, and those above them as far as anything changes. Nodes that
    /// are not marked moved keep their relative order.
    void repair(const Pattern& pattern, std::span<const std::int32_t> order,
                std::span<const std::int32_t> position);

    [[nodiscard]] std::int32_t parent(std::int32_t node) const noexcept {
        return parent_[static_cast<std::size_t>(node)];
    }
    /// Nodes after it that it fills, in the order of elimination.
    [[nodiscard]] std::span<const std::int32_t> rows(std::int32_t node) const noexcept {
        const auto n = static_cast<std::size_t>(node);
        return {pool_.data() + begin_[n], static_cast<std::size_t>(count_[n])};
    }
    /// How many scalar rows those nodes make together.
    [[nodiscard]] std::int32_t below(std::int32_t node) const noexcept {
        return below_[static_cast<std::size_t>(node)];
    }
    /// Did the last build() or repair() give this node other rows, another place or other children?
    /// Where it did not for a node and all below it in the tree, that whole branch is as it was.
    [[nodiscard]] bool fresh(std::int32_t node) const noexcept {
        return fresh_[static_cast<std::size_t>(node)] != 0;
    }
    /// Columns that the last build() or repair() computed.
    [[nodiscard]] std::int32_t computed() const noexcept { return computed_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void resize(std::size_t nodes);
    void link_all();
    void link(std::int32_t node) noexcept;
    void unlink(std::int32_t node) noexcept;
    void put_off(std::int32_t position) noexcept {
        todo_[static_cast<std::size_t>(position / 64)] |= std::uint64_t{1} << (position % 64);
    }
    void compute(const Pattern& pattern, std::span<const std::int32_t> order,
                 std::span<const std::int32_t> position, std::int32_t node);
    [[nodiscard]] bool same_as_before(std::int32_t node, std::size_t found) const noexcept;
    void store(std::int32_t node, std::size_t found);
    void compact();

    std::vector<std::int32_t> parent_, count_, below_;
    std::vector<std::int64_t> begin_;  ///< Into pool_, which has gaps where columns were moved.
    std::vector<std::int32_t> pool_, found_;
    std::vector<std::int32_t> spare_;  ///< For the pool, and for rows while build() finds them.
    std::vector<std::int32_t> head_, next_, prev_;  ///< Lists of children while they are linked.
    bool linked_ = false;
    std::vector<std::int32_t> mark_;   ///< Who took a node last.
    std::vector<std::uint64_t> todo_;  ///< By position: stale columns that repair() must do.
    std::vector<std::int32_t> stale_list_, moved_list_;  ///< Nodes that stale_ and moved_ mark.
    std::vector<std::int32_t> rows_;                     ///< Scratch of build().
    std::vector<std::int64_t> cursor_;                   ///< Scratch of build().
    std::vector<std::size_t> row_end_;                   ///< Scratch of build().
    std::vector<std::uint8_t> stale_, moved_, fresh_;
    std::vector<std::int32_t> new_of_old_, carried_;  ///< Scratch of renumber().
    std::vector<std::int64_t> carried_begin_;         ///< Scratch of renumber().
    std::vector<std::uint8_t> carried_stale_;         ///< Scratch of renumber().
    std::int64_t live_ = 0;
    std::int32_t computed_ = 0;
};

}  // namespace hawser::factor
