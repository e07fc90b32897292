// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file split.h
/// Assign every node to a part and cut edges between parts where this is cheap.
///
/// 1. Edges of weight kNeverCut and groups requested by the user are contracted. Such clusters are
/// bodies in contact, machines, and hulls with bolted parts.
/// 2. Wires are contracted as for separators. A few *clusters* and the wires between them remain.
/// 3. Large clusters are placed in order of decreasing cost, in two variants: into the fullest part
/// with enough capacity, or into the emptiest part. The variant with fewer cuts is used.
/// 4. Small clusters are placed by their position in the line.
/// 5. Wires fill the parts up to equal cost, with as few cuts as possible.
/// 6. Every cut moves along its wire to the position of least weight, by at most a tenth of a part.
///
/// The function split_from_previous() keeps the partition of the previous step. At most one cut
/// moves in a step, and only if the gain is large enough. A new partition is chosen if the graph no
/// longer allows the old cuts. It is also chosen if the old makespan has exceeded 1.15 times the
/// new one for 30 steps.

#include "graph/cost.h"
#include "graph/hypergraph.h"
#include "graph/lineup.h"
#include "graph/neighbours.h"
#include "graph/partition.h"
#include "graph/wires.h"

#include <cstdint>
#include <vector>

namespace hawser::graph {

class Splitter {
  public:
    void split(const Hypergraph& graph, const PartitionOptions& options, Partition& out);
    /// Split the graph, starting from the partition of the previous step in `out`. @return true if
    /// the result continues that partition.
    bool split_from_previous(const Hypergraph& graph, const PartitionOptions& options,
                             Partition& out);

    std::int64_t largest_cluster = 0;  ///< Cost of the most expensive cluster [flops].
    std::int32_t clusters = 0;

  private:
    /// Number of end nodes of a wire that stay with the body that holds it: forces change fastest
    /// there.
    static constexpr std::int32_t kStubNodes = 2;

    void prepare(const Hypergraph& graph, const PartitionOptions& options);
    void contract();
    [[nodiscard]] std::int64_t node_cost(std::size_t node) const noexcept {
        return graph_.cost.empty() ? full_cost_.node[node] : graph_.cost[node];
    }
    [[nodiscard]] std::int32_t find(std::int32_t node) noexcept;
    void unite_clusters(std::int32_t a, std::int32_t b) noexcept;
    void build_quotient();
    void compute_cut_weights();
    void choose_parts();
    void choose_parts(bool together);
    [[nodiscard]] std::int32_t count_cuts() const noexcept;
    void assign_part(std::int32_t cluster, std::int32_t part) noexcept;
    void assign_islands();
    void assign_clusters(bool together);
    void assign_wires();
    void balance_parts();
    bool move_filler(std::int32_t from, std::int32_t to, std::int64_t amount);
    void move_cuts();
    [[nodiscard]] std::int32_t cheaper_cut_near(std::int32_t wire,
                                                std::int32_t left) const noexcept;
    void move_cut(std::int32_t old_left, std::int32_t left) noexcept;
    [[nodiscard]] std::int32_t neighbouring_part(std::int32_t cluster,
                                                 std::int32_t wire) const noexcept;
    void write(Partition& out) const;
    [[nodiscard]] bool start_from_previous(const Partition& before);
    void move_best_cut();

    Hypergraph graph_;
    PartitionOptions options_;
    // Clusters are the nodes of the quotient graph.
    std::vector<std::int32_t> root_, cluster_;
    std::vector<std::uint8_t> size_;
    std::vector<std::int64_t> node_cost_;
    std::vector<std::int32_t> member_begin_, members_, group_part_;
    Neighbours full_neighbours_, neighbours_;  // of the graph, of its clusters
    Cost full_cost_, cost_;                    // by the model, if the graph has no costs
    Units units_;
    Lineup lineup_;
    std::int64_t mean_load_ = 0;
    std::vector<std::int64_t> weight_;  ///< Weight of a cut behind each index of units_.nodes.
    /// Price of repairing an existing cut behind each index of units_.nodes.
    std::vector<std::int64_t> repair_;
    std::vector<std::int32_t> wire_position_;
    /// Part of each cluster: chosen, newly computed, of the other variant.
    std::vector<std::int32_t> part_, new_part_, other_part_;
    std::vector<std::int64_t> other_load_;
    std::vector<std::int64_t> load_, free_capacity_, island_cost_;
    std::vector<std::int32_t> lane_, order_;
    std::vector<std::uint8_t> is_stuck_, is_open_;
};

}  // namespace hawser::graph
