// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file split.h
/// Every node in a part, and edges between parts cut where that is cheap.
///
/// Edges of weight kNeverCut and groups asked for by hand are contracted first (contact clusters,
/// machines, hulls with what is bolted to them); wires are contracted as for separators, so what
/// is left are a few *clusters* and wires between them. Large clusters go into the fullest part
/// that they fit into or into the emptiest, whichever cuts less, dearest first, small ones where
/// they stand in the line. Wires are sand: they
/// fill the parts up to an even share, cut as seldom as that needs. At last every cut slides along
/// its wire, within a tenth of a part's share, to where its weight is least.
///
/// follow() keeps the partition of the step before: at most one cut moves in a step, and only for
/// a gain that is worth it; all is chosen anew when the graph no longer allows the old cuts, or
/// when the old makespan has been more than 1.15 times a new one for 30 steps.

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
    /// The same beside the partition of the step before, which `out` holds. @return whether it goes
    /// on from that one.
    bool follow(const Hypergraph& graph, const PartitionOptions& options, Partition& out);

    std::int64_t largest_cluster = 0;  ///< Cost of the dearest thing that stays whole.
    std::int32_t clusters = 0;

  private:
    /// Nodes of a wire that stay with what it is fastened to: forces change fastest there.
    static constexpr std::int32_t kStub = 2;

    void prepare(const Hypergraph& graph, const PartitionOptions& options);
    void contract();
    [[nodiscard]] std::int64_t cost_of(std::size_t node) const noexcept {
        return graph_.cost.empty() ? whole_cost_.node[node] : graph_.cost[node];
    }
    [[nodiscard]] std::int32_t find(std::int32_t node) noexcept;
    void join(std::int32_t a, std::int32_t b) noexcept;
    void build_quotient();
    void weigh_places();
    void choose();
    void choose(bool together);
    [[nodiscard]] std::int32_t count_cuts() const noexcept;
    void put(std::int32_t cluster, std::int32_t part) noexcept;
    void place_islands();
    void place_clusters(bool together);
    void place_wires();
    void level();
    bool move_sand(std::int32_t from, std::int32_t to, std::int64_t amount);
    void slide();
    [[nodiscard]] std::int32_t slide_to(std::int32_t wire, std::int32_t left) const noexcept;
    void cut_behind(std::int32_t old_left, std::int32_t left) noexcept;
    [[nodiscard]] std::int32_t part_beside(std::int32_t cluster, std::int32_t wire) const noexcept;
    void write(Partition& out) const;
    [[nodiscard]] bool adopt(const Partition& before);
    void move_one();

    Hypergraph graph_;
    PartitionOptions options_;
    // Clusters: nodes of the quotient.
    std::vector<std::int32_t> root_, cluster_;
    std::vector<std::uint8_t> size_;
    std::vector<std::int64_t> node_cost_;
    std::vector<std::int32_t> member_begin_, members_, group_part_;
    Neighbours whole_, neighbours_;  // those of the graph, of its clusters
    Cost whole_cost_, cost_;         // by the model, where the graph brings none
    Units units_;
    Lineup lineup_;
    std::int64_t share_ = 0;
    std::vector<std::int64_t> weight_;  ///< By place in units_.nodes: of a cut behind it.
    std::vector<std::int64_t> mend_;  ///< By place in units_.nodes: of mending a cut that is there.
    std::vector<std::int32_t> wire_place_;
    std::vector<std::int32_t> part_, fresh_part_, other_part_;  ///< By cluster.
    std::vector<std::int64_t> other_load_;
    std::vector<std::int64_t> load_, room_, island_cost_;
    std::vector<std::int32_t> lane_, order_;
    std::vector<std::uint8_t> stuck_, open_;
};

}  // namespace hawser::graph
