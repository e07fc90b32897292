// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file symbolic.h
/// Structure of a factorisation: all data that do not depend on values.
///
/// Multifrontal LDLᵀ (Duff, Reid 1983; Liu, "The multifrontal method", 1992). A *front* is a dense
/// lower trapezoid: p pivot columns over p + q rows. Eliminating its pivots leaves a q × q update
/// matrix that is added into the parent front (extend-add):
///
/// ```
///        p        q
///     ┌──────┐                     panel: columns of length ld ≥ p + q, stored for the solve
///   p │ L11  │                     update: q × q lower triangle, lives until the parent has
///     │      ├────────┐                    taken it
///   q │ L21  │ update │
///     └──────┴────────┘
/// ```
/// Fronts are numbered in postorder. So a subtree is a contiguous range of fronts, and its pivots
/// are a contiguous range of the permuted vector. Update matrices form stacks: fronts at even depth
/// push on one stack, at odd depth on another. The children of a front are on top of the other
/// stack when the front is reached. partial.h assigns separate memory instead. All addresses are
/// therefore known here, and the numeric phase allocates nothing. The stacks of a task belong to
/// the thread that runs it, so the next task finds them in the cache.
///
/// Subtrees of roughly equal work are *tasks* that run in parallel. The fronts above them are the
/// *top*, cut into paths that run when their predecessors are done (task_graph.h). Tasks depend on
/// the tree alone, never on the number of threads.
///
/// Unsymmetric values double some of the fronts, on the same structure: unsymmetric.h.
///
/// A chain (chains.h) is also one front, but only its update matrix is an ordinary one. A batch
/// (batches.h) eliminates its pivots before the tasks that read its update.

#include "base/memory.h"
#include "factor/batches.h"
#include "factor/task_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// One front. Plain data, which the kernels read directly.
struct Front {
    std::int32_t offset = 0;    ///< First pivot in the permuted vector.
    std::int32_t p = 0, q = 0;  ///< Pivot and update scalars.
    std::int32_t ld = 0;        ///< Column stride of the panel, a multiple of 8.
    std::int32_t ldu = 0;       ///< Column stride of the update matrix, a multiple of 8.
    std::int32_t parent = -1;   ///< Front, −1 at a root.
    std::int32_t child_begin = 0, child_end = 0;  ///< Range in Symbolic::children.
    std::int32_t run_begin = 0, run_end = 0;      ///< Range in Symbolic::runs: into the parent.
    std::int32_t node_begin = 0, node_end = 0;    ///< Pivot nodes, as positions in the order.
    std::int32_t batch = -1, lane = 0;  ///< Batch and lane that eliminate the pivots of a chain.
    std::int64_t panel = 0;             ///< Offset into the panel array.
    std::int64_t update = 0;            ///< Offset into the work array.
    /// Offset into Symbolic::rows (q entries) and into the carry vector of the solve.
    std::int64_t rows = 0;
    friend bool operator==(const Front&, const Front&) = default;
};

/// `length` update rows from `from` land on rows from `to` of the parent front.
struct Run {
    std::int32_t from, to, length;
    friend bool operator==(const Run&, const Run&) = default;
};

/// Address of a block of the matrix: entry (i, j) at address + i step + j ld of the panel array.
struct BlockTarget {
    std::int64_t address = 0;
    std::int32_t step = 1;
    std::int32_t ld = 0;
};

/// A contiguous range of fronts, or of entries of `top`, that no other task modifies.
struct TaskRange {
    std::int32_t begin, end;
    std::int64_t flops;
    friend bool operator==(const TaskRange&, const TaskRange&) = default;
};

struct Symbolic {
    std::vector<std::int32_t> order;        ///< order[k] = node eliminated k-th.
    std::vector<std::int32_t> position;     ///< Inverse of order.
    std::vector<std::int32_t> node_offset;  ///< First scalar of each node, permuted vector.
    std::vector<std::int32_t> node_front;   ///< Front of each node.
    std::vector<Front> fronts;              ///< In postorder.
    std::vector<std::int32_t> children;     ///< Grouped by front, ascending.
    std::vector<std::int32_t> rows;         ///< Permuted scalar index of each update row.
    std::vector<Run> runs;
    std::vector<std::int8_t> sign;     ///< Expected sign of each permuted pivot.
    std::vector<TaskRange> tasks;      ///< Subtrees, in postorder.
    std::vector<std::int32_t> top;     ///< Fronts above the tasks, by task, ascending within each.
    std::vector<TaskRange> top_tasks;  ///< Ranges of `top`, each a path towards the root.
    std::vector<std::int32_t> front_task;  ///< By front: its node of the graph.
    TaskGraph graph;  ///< Graph of batches, tasks, top_tasks, numbered in this order.

    std::vector<Batch> batches;  ///< Eliminated first, each by one thread.
    std::vector<BatchStep> batch_steps;
    std::vector<std::int8_t> slot_sign;    ///< Expected sign of each pivot slot of the steps.
    std::vector<std::int32_t> slot_index;  ///< Eight per slot: permuted scalar, −1: padding.
    std::vector<std::int32_t> tail_slot;   ///< Update slot of each row of a chain.
    std::vector<std::int32_t> node_step;   ///< Step of each node of a chain, −1: in no chain.
    std::vector<std::int32_t> node_slot;   ///< First pivot slot of each node of a chain.
    std::int64_t batch_scratch = 0;        ///< Doubles of scratch for any batch.

    std::int32_t scalars = 0;
    std::int64_t panel_size = 0, work_size = 0;  ///< Doubles.
    /// Offset of the part of the work array that each thread has for itself.
    std::int64_t stack_begin = 0;
    bool updates_kept = false;   ///< See partial.h.
    std::int32_t max_front = 0;  ///< Largest ld.
    std::int64_t matrix_nnz = 0, factor_nnz = 0, flops = 0, critical_flops = 0;

    /// Return the address of the block (row node, column node). The row must not precede the column
    /// in the order, and the pair must be a diagonal block or an edge of the pattern.
    [[nodiscard]] BlockTarget target(std::int32_t row, std::int32_t column) const noexcept;
    /// Return the panel offset at which the columns of the k-th node of the order begin. Chains in
    /// the lanes of one step share it.
    [[nodiscard]] std::int64_t column_address(std::int32_t k) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;
    friend bool operator==(const Symbolic&, const Symbolic&) = default;
};

/// Computes Symbolic::target() for one column at a time. Common data of its rows are looked up
/// once.
class ColumnTargets {
  public:
    ColumnTargets(const Symbolic& symbolic, std::int32_t column) noexcept;
    [[nodiscard]] BlockTarget of(std::int32_t row) const noexcept;

  private:
    [[nodiscard]] std::int32_t panel_row_of(std::size_t row) const noexcept;

    const Symbolic& s_;
    const Front& front_;
    std::int32_t index_;               ///< Index of the front.
    const BatchStep* step_ = nullptr;  ///< Step of a chain's column.
    std::int32_t step_index_ = 0;      ///< Index of this step.
    std::int64_t begin_;               ///< Address of the front's first row in the column.
};

/// Return the flops of one front, multiplications and additions counted separately: Σ_k m(m+2), m
/// rows below pivot k.
[[nodiscard]] std::int64_t front_flops(int p, int q) noexcept;

}  // namespace hawser::factor
