// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file layout.h
/// From the structure of the columns to addresses: fronts, rows, runs, tasks, update matrices.

#include "base/executor.h"
#include "factor/chains.h"
#include "factor/columns.h"
#include "factor/lay_out_batches.h"
#include "factor/symbolic.h"
#include "factor/tree.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hawser::factor {

/// Lays out a Symbolic. A second run on a structure of similar size allocates nothing.
class Layout {
  public:
    /// Lay out the structure.
    /// @param symbolic  `order` is an order of elimination with these columns, `position` its
    ///        inverse. `updates_kept` is an input, too. All other members are overwritten.
    /// @param edited  The nodes with changed neighbours, if three conditions hold: the columns
    ///        result from the last call and a Columns::repair(), nodes and chains are unchanged,
    ///        and only the order of `symbolic` has changed. Unchanged parts are then reused.
    /// @param team  Executor that computes rows and runs in parallel with batches, tasks and update
    ///        matrices; null: sequential.
    void run(const Pattern& pattern, const Columns& columns, const Chains& chains,
             Symbolic& symbolic, std::optional<std::span<const std::int32_t>> edited = {},
             base::Executor* team = nullptr);
    /// Return the number of fronts that the last call left unchanged.
    [[nodiscard]] std::int32_t same() const noexcept { return unchanged_count_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Number of entries of a node written at a time; the next node overwrites those past its end.
    /// A loop of fixed length is one or two vector stores.
    static constexpr std::int32_t kCopyWidth = 8;
    static_assert(kCopyWidth >= kMaxBlock);

    /// Return the node of the last pivot of a front. Its structure contains the rows of every pivot
    /// behind the front.
    [[nodiscard]] static std::int32_t last_node(const Symbolic& s, const Front& front) noexcept {
        return s.order[static_cast<std::size_t>(front.node_end - 1)];
    }
    void assign_node_columns(const Pattern& pattern, Symbolic& s);
    void count_entries(const Pattern& pattern, std::optional<std::span<const std::int32_t>> edited);
    void lay_out_fronts(const Columns& columns, Symbolic& s);
    [[nodiscard]] bool in_chain(const Symbolic& s, const Front& front) const noexcept;
    void fill_rows(const Pattern& pattern, const Columns& columns, bool of_chains, Symbolic& s);
    void find_unchanged_fronts(const Columns& columns, const Symbolic& s, bool follows);
    void link_children(Symbolic& s);
    void find_all_runs(const Pattern& pattern, const Columns& columns, Symbolic& s);
    void find_runs(const Pattern& pattern, const Columns& columns, Front& front, Symbolic& s);
    void choose_tasks(Symbolic& s);  // tasks.cpp
    void choose_top_tasks(Symbolic& s, std::int64_t target);
    void link_tasks(Symbolic& s);
    void assign_update_addresses(Symbolic& s);

    TreeBuilder tree_;
    Supernodes supernodes_;
    std::vector<std::int32_t> chain_of_, front_of_chain_, cursor_, task_of_front_;
    std::vector<std::int64_t> flops_, subtree_flops_, path_, height_;
    std::vector<std::int32_t> entries_;  ///< Matrix entries by node, twice those of its triangle.
    std::int64_t matrix_entries_ = 0;    ///< Their sum.
    /// Data of the last layout, and the index of each front in it, −1: none.
    std::vector<Front> old_fronts_;
    std::vector<Run> old_runs_;
    std::vector<std::int32_t> old_order_, old_node_front_, unchanged_front_;
    std::int32_t unchanged_count_ = 0;
    std::vector<std::int64_t>
        chain_rows_;  ///< Offset of the rows of the chains, and the end of all rows.
    /// By front: size of the update matrices that it pops from a stack.
    std::vector<std::int64_t> freed_;
    std::vector<std::int32_t> row_of_;  ///< By node: its row in a parent, if any.
    std::vector<std::uint8_t> parity_, crosses_;
    std::vector<std::pair<std::int32_t, std::int32_t>> edges_;
    std::vector<std::int64_t> predecessors_left_;  ///< Scratch of link_tasks().
    BatchBuilder batches_;
};

}  // namespace hawser::factor
