// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// Parts of about equal cost, in two forms.
///
/// *Separators* (separate.cpp), for the exact solution: nodes between parts are in none of them,
/// and no edge joins two parts, so that parts are eliminated side by side and separators last.
/// *Cuts* (split.h), for approximate couplings: every node is in a part, and edges between parts
/// are cut where their weight is low.
///
/// The paper's multilevel idea with one level: insides of wires are contracted (wires.h), what is
/// left is put in a line (lineup.h), and places of the line are chosen by prefix sums of the cost
/// (cost.h), then slid to where cutting is cheap. Islands that fit into a part stay whole and are
/// shared out longest first (Graham, "Bounds on multiprocessing timing anomalies", 1969).
///
/// A partition is a function of the graph and, with follow(), of the partition before it. It
/// depends neither on time nor on a number of threads.

#include "graph/cost.h"
#include "graph/hypergraph.h"
#include "graph/lineup.h"
#include "graph/neighbours.h"
#include "graph/wires.h"

#include <cstdint>
#include <vector>

namespace hawser::graph {

struct PartitionOptions {
    /// At least 1. Some stay empty where there are few nodes: with separators an island is divided
    /// into at most a quarter of its nodes (kLeastNodes); with cuts each of a wire's nodes may be a
    /// part, but for those that stay with what it is fastened to (two at each end).
    std::int32_t parts = 4;
};

struct Partition {
    std::int32_t parts = 0;
    std::vector<std::int32_t> part;       ///< By node; kNoPart, kSeparator.
    std::vector<std::int32_t> separator;  ///< Nodes between parts, ascending.
    std::vector<std::int32_t> cut;        ///< Edges with nodes in several parts, ascending.
    std::vector<std::int64_t> cost;       ///< By part: flops, separators apart.
    std::int64_t separator_cost = 0;      ///< Of the separators' own pivots, in flops.
    std::int32_t worse_for =
        0;  ///< Steps that follow() has kept it for though a new one is better.

    /// Largest cost over the mean; 1 without any.
    [[nodiscard]] double imbalance() const noexcept;
};

/// Longest first on the least loaded: makespan at most 4/3 − 1/(3 lanes) of the best one.
/// @param lane  Out, by item. @param load  In and out, by lane: load that is there already.
/// @param order  Scratch.
void share_out(std::span<const std::int64_t> cost, std::span<std::int32_t> lane,
               std::span<std::int64_t> load, std::vector<std::int32_t>& order);

/// Makes partitions; its buffers live as long as it does, so that a second graph of a size seen
/// before needs no memory.
class Partitioner {
  public:
    /// Read a graph: neighbours, islands and their cost, units. The views must stay until the
    /// partition has been made.
    void read(const Hypergraph& graph);
    /// Parts and the separators between them.
    void separate(const PartitionOptions& asked, Partition& out);
    /// Of an island that is divided, so many for each part.
    static constexpr std::int32_t kLeastNodes = 4;

    Hypergraph graph;
    Neighbours neighbours;
    Cost cost;
    Units units;
    Lineup lineup;

  private:
    struct Profile {
        std::int32_t ahead, behind, hubs;  ///< Scalars: left and right of a place, of hubs across.
        [[nodiscard]] std::int64_t least() const noexcept {
            return hubs + (ahead < behind ? ahead : behind);
        }
    };
    [[nodiscard]] std::int32_t most_parts() const noexcept;
    void place_islands(const PartitionOptions& options, Partition& out);
    void find_profile();
    void find_reach();
    void choose_places(const PartitionOptions& options);
    void assign();
    void join_back();
    void write(Partition& out);
    [[nodiscard]] bool is_between(std::int32_t place) const noexcept;

    std::vector<std::int64_t> island_cost_, small_cost_, load_, prefix_, sum_;
    std::vector<std::int32_t> island_lane_, order_, place_, cut_, lane_of_;
    std::vector<Profile> profile_;
    // By place of the line, in which the nodes of islands that are divided stand.
    std::vector<std::int32_t> line_;
    std::vector<std::int32_t> low_, high_;     ///< First and last neighbour, itself included.
    std::vector<std::int32_t> segment_;        ///< Cuts before it.
    std::vector<std::int32_t> part_;           ///< kSeparator: between parts.
    std::vector<std::int64_t> cost_, weight_;  ///< Cost; in this round, without separators.
    std::vector<std::int32_t> between_;        ///< Places of separators.
};

}  // namespace hawser::graph
