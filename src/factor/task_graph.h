// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file task_graph.h
/// Which parts of a factorisation wait for which, and who does the next one.
///
/// The nodes are the batches of chains, the tasks (subtrees) and the tasks of the top: paths of
/// fronts between branchings of the elimination tree. Factorisation and forward substitution go
/// up, a node after all that hand it an update matrix; backward substitution goes down.
///
/// ```
///   batch ── task ─┐
///            task ─┴ top ─┐             up: →    down: ←
///   batch ── task ── top ─┴ top
/// ```
/// A thread that is free takes the ready node from which most work is left to the end (critical
/// path scheduling: Hu, "Parallel sequencing and assembly line problems", 1961). Ready nodes are
/// bits, by rank: taking one is an atomic instruction, and no thread waits for a lock. Of several
/// it prefers nodes that it factored last, whose panels it wrote and may still have in its cache:
/// substitutions keep to that as well, but who steps in for another thread there does not go on
/// with the node. Who does what varies from run to run; each node's result does not.

#include "base/executor.h"
#include "base/memory.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::factor {

/// A directed graph without cycles; successors have larger numbers.
struct TaskGraph {
    /// One direction: who waits for a node, how many it waits for, and the order of urgency.
    struct Way {
        std::vector<std::int32_t> start, next;  ///< Compressed rows: whom a node sets free.
        std::vector<std::int32_t> waits;        ///< By node: how many set it free.
        std::vector<std::int32_t> rank;         ///< By node: 0 has the most work behind it.
        std::vector<std::int32_t> by_rank;      ///< Inverse of rank.
        friend bool operator==(const Way&, const Way&) = default;
    };
    std::vector<std::int64_t> work;  ///< By node [flop].
    Way up, down;
    std::int64_t path = 0;  ///< Largest sum of work along a path.

    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(work.size()); }
    /// @param edges  (node, successor), in any order, duplicates allowed.
    /// @param left  Memory to do it in.
    void build(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
               std::vector<std::int64_t>& left);
    void build(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges) {
        std::vector<std::int64_t> left;
        build(edges, left);
    }
    [[nodiscard]] std::size_t bytes() const noexcept;
    friend bool operator==(const TaskGraph&, const TaskGraph&) = default;
};

/// What the nodes of a graph are done for: factor and forward go up, backward down. Who does a node
/// in factor owns it.
enum class TaskPass : std::uint8_t { factor, forward, backward };

/// Deals out the nodes of a graph to threads.
class TaskQueue {
  public:
    /// Room for a graph and so many threads; grows only. @throws std::bad_alloc.
    void reserve(const TaskGraph& graph, int threads);

    /// Call f(node, thread) for every node, none before those it waits for. A single thread goes
    /// by number, which is the order of the memory.
    template <class F>
    void run(const TaskGraph& graph, TaskPass pass, base::Executor& executor, F& f) noexcept {
        const int n = graph.nodes();
        const bool up = pass != TaskPass::backward, owns = pass == TaskPass::factor;
        const TaskGraph::Way& way = up ? graph.up : graph.down;
        executor.announce({way.start, way.next, way.rank});
        if (executor.threads() == 1) {
            auto one = [&](int i, int thread) noexcept {
                const int node = up ? i : n - 1 - i;
                executor.begin_node(node, thread);
                f(node, thread);
            };
            executor.for_each(n, one);
            return;
        }
        begin(way, executor.threads());
        auto task = [&](int, int thread) noexcept {
            const std::int32_t node = take(way, thread, owns);
            executor.begin_node(node, thread);
            f(node, thread);
            finish(way, node);
        };
        executor.for_each(n, task);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return base::bytes(waits_) + base::bytes(ready_) + base::bytes(mine_) + base::bytes(owner_);
    }

  private:
    void begin(const TaskGraph::Way& way, int threads) noexcept;
    [[nodiscard]] std::int32_t take(const TaskGraph::Way& way, int thread, bool owns) noexcept;
    [[nodiscard]] int take_bit(std::size_t w, std::uint64_t among) noexcept;
    void finish(const TaskGraph::Way& way, std::int32_t node) noexcept;

    base::Array<std::int32_t> waits_;   ///< By node: still to come. Atomic while running.
    base::Array<std::uint64_t> ready_;  ///< A bit a rank. Atomic while running.
    base::Array<std::uint64_t> mine_;   ///< A bit a rank, a set for each thread: what it owns.
    base::Array<std::int16_t> owner_;   ///< By node: the thread that owns it.
    std::size_t words_ = 0;
};

}  // namespace hawser::factor
