// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file task_graph.h
/// Dependencies between the parts of a factorisation, and their distribution to threads.
///
/// The nodes are the batches of chains, the tasks (subtrees) and the tasks of the top: paths of
/// fronts between branchings of the elimination tree. Factorisation and forward substitution go up:
/// a node runs after all nodes that pass an update matrix to it. Backward substitution goes down.
///
/// ```
///   batch ── task ─┐
///            task ─┴ top ─┐             up: →    down: ←
///   batch ── task ── top ─┴ top
/// ```
/// A free thread picks the ready node with the most work left to the end (critical path scheduling:
/// Hu, "Parallel sequencing and assembly line problems", 1961). Ready nodes are bits, by rank.
/// Picking a node is an atomic instruction, and no thread waits for a lock. A thread prefers nodes
/// that it factored last, since their panels may still be in its cache. Substitutions follow this
/// ownership but do not change it. The assignment varies from run to run; the result of each node
/// does not.

#include "base/executor.h"
#include "base/memory.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::factor {

/// A directed graph without cycles; successors have larger numbers.
struct TaskGraph {
    /// One direction: successors of each node, number of predecessors, and order of urgency.
    struct Way {
        std::vector<std::int32_t> start, next;  ///< Compressed rows: successors of each node.
        std::vector<std::int32_t> waits;        ///< By node: number of predecessors.
        std::vector<std::int32_t> rank;         ///< By node: 0 has the most work left.
        std::vector<std::int32_t> by_rank;      ///< Inverse of rank.
        friend bool operator==(const Way&, const Way&) = default;
    };
    std::vector<std::int64_t> work;  ///< By node [flop].
    Way upward, downward;
    std::int64_t path = 0;  ///< Largest sum of work along a path.

    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(work.size()); }
    /// Build the graph.
    /// @param edges  (node, successor), in any order, duplicates allowed.
    /// @param left  Scratch.
    void build(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
               std::vector<std::int64_t>& left);
    void build(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges) {
        std::vector<std::int64_t> left;
        build(edges, left);
    }
    [[nodiscard]] std::size_t bytes() const noexcept;
    friend bool operator==(const TaskGraph&, const TaskGraph&) = default;
};

/// Pass over a graph: factor and forward go up, backward goes down. The thread that factors a node
/// owns it.
enum class TaskPass : std::uint8_t { factor, forward, backward };

/// Distributes the nodes of a graph to threads.
class TaskQueue {
  public:
    /// Reserve memory for a graph and a number of threads. Memory only grows.
    /// @throws std::bad_alloc.
    void reserve(const TaskGraph& graph, int threads);

    /// Call f(node, thread) for every node after its predecessors. A single thread follows the
    /// indices, which is the order of the memory.
    template <class F>
    void run(const TaskGraph& graph, TaskPass pass, base::Executor& executor, F& f) noexcept {
        const int n = graph.nodes();
        const bool upward = pass != TaskPass::backward, owns = pass == TaskPass::factor;
        const TaskGraph::Way& way = upward ? graph.upward : graph.downward;
        executor.announce({way.start, way.next, way.rank});
        if (executor.threads() == 1) {
            auto one = [&](int i, int thread) noexcept {
                const int node = upward ? i : n - 1 - i;
                executor.begin_node(node, thread);
                f(node, thread);
            };
            executor.for_each(n, one);
            return;
        }
        begin(way, executor.threads());
        auto task = [&](int, int thread) noexcept {
            const std::int32_t node = next_ready_node(way, thread, owns);
            executor.begin_node(node, thread);
            f(node, thread);
            finish(way, node);
        };
        executor.for_each(n, task);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return base::bytes(waits_) + base::bytes(ready_) + base::bytes(owned_) +
               base::bytes(owner_);
    }

  private:
    void begin(const TaskGraph::Way& way, int threads) noexcept;
    [[nodiscard]] std::int32_t next_ready_node(const TaskGraph::Way& way, int thread,
                                               bool owns) noexcept;
    [[nodiscard]] int claim_ready_bit(std::size_t w, std::uint64_t among) noexcept;
    void finish(const TaskGraph::Way& way, std::int32_t node) noexcept;

    /// By node: predecessors still to run. Atomic while running.
    base::Array<std::int32_t> waits_;
    base::Array<std::uint64_t> ready_;  ///< One bit per rank. Atomic while running.
    /// One bit per rank and thread: the nodes that the thread owns.
    base::Array<std::uint64_t> owned_;
    base::Array<std::int16_t> owner_;  ///< By node: the thread that owns it.
    std::size_t words_ = 0;
};

}  // namespace hawser::factor
