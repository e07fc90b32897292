// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// Divide a graph into parts of about equal cost, in two forms.
///
/// *Separators* (separate.cpp) serve the exact solution. Nodes between parts belong to no part, and
/// no edge joins two parts. Parts are eliminated in parallel and separators last. *Cuts* (split.h)
/// serve approximate couplings. Every node belongs to a part, and edges between parts are cut where
/// their weight is low.
///
/// The method is the paper's multilevel idea with one level:
/// 1. The interiors of wires are contracted (wires.h).
/// 2. The remaining units are ordered in a line (lineup.h).
/// 3. Positions in the line are chosen by prefix sums of the cost (cost.h).
/// 4. Each position is then moved to a nearby one where cutting is cheap.
///
/// Islands that fit into a part stay whole and are distributed longest first (Graham, "Bounds on
/// multiprocessing timing anomalies", 1969).
///
/// A partition is a function of the graph and, with follow(), of the partition before it. It
/// depends neither on time nor on the number of threads.

#include "graph/cost.h"
#include "graph/hypergraph.h"
#include "graph/lineup.h"
#include "graph/neighbours.h"
#include "graph/wires.h"

#include <cstdint>
#include <vector>

namespace hawser::graph {

struct PartitionOptions {
    /// Number of parts, ≥ 1. Some stay empty if there are few nodes. With separators an island is
    /// divided into at most a quarter of its nodes (kMinNodes). With cuts each node of a wire may
    /// be a part. The two nodes at each end are excepted: they stay with the body that holds them.
    std::int32_t parts = 4;
};

struct Partition {
    std::int32_t parts = 0;
    std::vector<std::int32_t> part;       ///< Part of each node; kNoPart, kSeparator.
    std::vector<std::int32_t> separator;  ///< Nodes between parts, ascending.
    std::vector<std::int32_t> cut;        ///< Edges with nodes in several parts, ascending.
    std::vector<std::int64_t> cost;       ///< Cost of each part without separators [flops].
    std::int64_t separator_cost = 0;      ///< Cost of the pivots of the separators [flops].
    std::int32_t worse_for =
        /// Number of steps for which follow() has kept a partition that is worse than a new one.
        0;

    /// Return the largest cost over the mean, 1 if the total cost is 0.
    [[nodiscard]] double imbalance() const noexcept;
};

/// Assign items to lanes, longest first, each to the least loaded lane. The makespan is at most 4/3
/// − 1/(3 lanes) of the optimum.
/// @param lane   Out: lane of each item.
/// @param load   In and out: load of each lane; may start above 0.
/// @param order  Scratch.
void distribute(std::span<const std::int64_t> cost, std::span<std::int32_t> lane,
                std::span<std::int64_t> load, std::vector<std::int32_t>& order);

/// Maker of partitions. Its buffers are reused: a second graph of equal size needs no allocation.
class Partitioner {
  public:
    /// Read a graph: neighbours, islands and their cost, units. The views must stay valid until the
    /// partition has been made.
    void read(const Hypergraph& graph);
    /// Compute parts and the separators between them.
    void separate(const PartitionOptions& asked, Partition& out);
    /// Least number of nodes for each part of a divided island.
    static constexpr std::int32_t kMinNodes = 4;

    Hypergraph graph;
    Neighbours neighbours;
    Cost cost;
    Units units;
    Lineup lineup;

  private:
    struct Profile {
        /// Scalars of nodes before a position with neighbours behind it, of the reverse, and of
        /// hubs that reach across.
        std::int32_t ahead, behind, hubs;
        [[nodiscard]] std::int64_t least() const noexcept {
            return hubs + (ahead < behind ? ahead : behind);
        }
    };
    [[nodiscard]] std::int32_t max_parts() const noexcept;
    void assign_islands(const PartitionOptions& options, Partition& out);
    void find_profile();
    void find_reach();
    void choose_cut_positions(const PartitionOptions& options);
    void assign();
    void absorb_separators();
    void write(Partition& out);
    [[nodiscard]] bool separates_parts(std::int32_t place) const noexcept;

    std::vector<std::int64_t> island_cost_, small_cost_, load_, prefix_, sum_;
    std::vector<std::int32_t> island_lane_, order_, line_index_, cut_, lane_of_;
    std::vector<Profile> profile_;
    // By position in the line, which holds the nodes of divided islands.
    std::vector<std::int32_t> line_;
    /// Positions of the first and last neighbour of a node, the node included.
    std::vector<std::int32_t> low_, high_;
    std::vector<std::int32_t> segment_;  ///< Number of cuts before the position.
    std::vector<std::int32_t> part_;     ///< Part; kSeparator: between parts.
    /// Cost; cost in this iteration, without separators.
    std::vector<std::int64_t> cost_, weight_;
    std::vector<std::int32_t> separator_positions_;  ///< Positions of separators.
};

}  // namespace hawser::graph
