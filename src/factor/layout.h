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

/// Lays out a Symbolic. A used one needs no memory for a structure of about the same size.
class Layout {
  public:
    /// @param symbolic  order is an order of elimination with these columns, position its inverse;
    ///        the rest is overwritten, `updates_kept` obeyed.
    /// @param edited  Where the columns are those of the last call after a Columns::repair(), nodes
    ///        and chains the same, and `symbolic` is as the last call left it but for the order:
    ///        the nodes that got other neighbours. What did not change is taken over then.
    /// @param team  Finds rows and runs beside batches, tasks and update matrices: neither reads
    ///        what the other writes. nullptr: one after the other.
    void run(const Pattern& pattern, const Columns& columns, const Chains& chains,
             Symbolic& symbolic, std::optional<std::span<const std::int32_t>> edited = {},
             base::Executor* team = nullptr);
    /// Fronts of the last call that are as they were before it.
    [[nodiscard]] std::int32_t same() const noexcept { return same_count_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Entries of a node are written so many at a time, and those past its end again by the next: a
    /// loop of fixed length is one or two vector stores.
    static constexpr std::int32_t kWide = 8;
    static_assert(kWide >= kMaxBlock);

    /// The last pivot's node: its structure covers every pivot's rows behind the front.
    [[nodiscard]] static std::int32_t last_node(const Symbolic& s, const Front& front) noexcept {
        return s.order[static_cast<std::size_t>(front.node_end - 1)];
    }
    void place_nodes(const Pattern& pattern, Symbolic& s);
    void count_entries(const Pattern& pattern, std::optional<std::span<const std::int32_t>> edited);
    void lay_out_fronts(const Columns& columns, Symbolic& s);
    [[nodiscard]] bool in_chain(const Symbolic& s, const Front& front) const noexcept;
    void fill_rows(const Pattern& pattern, const Columns& columns, bool of_chains, Symbolic& s);
    void find_same_fronts(const Columns& columns, const Symbolic& s, bool follows);
    void link_children(Symbolic& s);
    void find_all_runs(const Pattern& pattern, const Columns& columns, Symbolic& s);
    void find_runs(const Pattern& pattern, const Columns& columns, Front& front, Symbolic& s);
    void choose_tasks(Symbolic& s);  // tasks.cpp
    void choose_top_tasks(Symbolic& s, std::int64_t target);
    void link_tasks(Symbolic& s);
    void place_updates(Symbolic& s);

    TreeBuilder tree_;
    Supernodes supernodes_;
    std::vector<std::int32_t> chain_of_, front_of_chain_, cursor_, task_;
    std::vector<std::int64_t> flops_, subtree_, path_, height_;
    std::vector<std::int32_t> entries_;  ///< By node: of the matrix, twice those of its triangle.
    std::int64_t matrix_entries_ = 0;    ///< Their sum.
    /// The last layout's, and which of its fronts each front is, −1: none.
    std::vector<Front> old_fronts_;
    std::vector<Run> old_runs_;
    std::vector<std::int32_t> old_order_, old_node_front_, same_;
    std::int32_t same_count_ = 0;
    std::vector<std::int64_t>
        chain_rows_;                    ///< Where those of the chains begin, and the end of all.
    std::vector<std::int64_t> freed_;   ///< By front: update matrices that it takes from a stack.
    std::vector<std::int32_t> row_of_;  ///< By node: its row in a parent, if it has one.
    std::vector<std::uint8_t> parity_, crosses_;
    std::vector<std::pair<std::int32_t, std::int32_t>> edges_;
    std::vector<std::int64_t> left_;  ///< Scratch of link_tasks().
    BatchBuilder batches_;
};

}  // namespace hawser::factor
