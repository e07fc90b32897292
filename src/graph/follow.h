// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file follow.h
/// Update separators while a few edges change, because contacts appear, vanish and move in every
/// step.
///
/// If an edge comes to join two parts, the necessary number of its nodes become separators. A
/// separator node whose remaining edges lead into one part only joins that part. A change costs
/// time proportional to the edges of its own nodes, for any size of the graph. It allocates
/// nothing.
///
/// Other nodes keep their part, which is the temporal coherence that the paper requires. The
/// function needs_new_partition() returns true if the modelled makespan exceeds 1.15 times its
/// initial value. A new partition is then due.

#include "graph/partition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

class Follower {
  public:
    static constexpr std::int32_t kMaxMembers = 4;  ///< Most members of an edge that is followed.
    static constexpr double kReplanRatio = 1.15;

    /// Start from a partition with separators. Edges with more than kMaxMembers members must not
    /// change; separators among their nodes stay.
    /// @param node_cost  Cost of each node [flops].
    /// @throws std::bad_alloc.
    void start(const Hypergraph& graph, std::span<const std::int64_t> node_cost,
               const Partition& partition);

    /// Set the members of edge e; an empty list removes the edge.
    void change(std::int32_t e, std::span<const std::int32_t> members) noexcept;

    [[nodiscard]] const std::vector<std::int32_t>& part() const noexcept { return part_; }
    [[nodiscard]] std::span<const std::int64_t> cost() const noexcept { return load_; }
    [[nodiscard]] std::int64_t separator_cost() const noexcept { return separator_cost_; }
    [[nodiscard]] bool needs_new_partition() const noexcept;
    /// Copy the current partition to `out`.
    void copy_to(Partition& out) const;

  private:
    void link(std::int32_t slot) noexcept;
    void unlink(std::int32_t slot) noexcept;
    void separate_parts_of_edge(std::int32_t e) noexcept;
    void absorb_separator(std::int32_t node) noexcept;
    void set_part(std::int32_t node, std::int32_t part) noexcept;
    /// Return the cost of the largest part plus the cost of all separators [flops].
    [[nodiscard]] std::int64_t makespan() const noexcept;

    /// By slot; each edge has kMaxMembers slots.
    std::vector<std::int32_t> member_, next_, previous_;
    std::vector<std::int32_t> head_;  ///< First slot in the list of each node, −1: none.
    std::vector<std::uint8_t> count_, size_;
    /// 1 for each node that is a member of an edge too large to be followed.
    std::vector<std::uint8_t> stays_;
    std::vector<std::int32_t> part_;
    std::vector<std::int64_t> load_, node_cost_;
    std::int64_t separator_cost_ = 0, makespan_ = 0;
};

}  // namespace hawser::graph
