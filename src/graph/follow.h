// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file follow.h
/// Separators kept up to date while a few edges change: contacts come, go and move in every step.
///
/// An edge that comes to join two parts makes separators of as many of its nodes as it takes; a
/// separator node whose last edges into all parts but one went away joins that part. What a change
/// costs is its own nodes' edges, whatever the size of the graph; nothing is allocated. Parts stay
/// where they are, which is the temporal coherence that the paper asks for: worn() tells when the
/// modelled makespan has become 1.15 times what it was, and a new partition is due.

#include "graph/partition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

class Follower {
  public:
    static constexpr std::int32_t kMostMembers = 4;  ///< Of an edge that is followed.
    static constexpr double kWorn = 1.15;

    /// Take over a partition with separators. @param node_cost  By node, in flops. Edges with more
    /// than kMostMembers members must not change; separators among those stay. @throws
    /// std::bad_alloc.
    void start(const Hypergraph& graph, std::span<const std::int64_t> node_cost,
               const Partition& partition);

    /// Edge e gets these members; none: it is gone.
    void change(std::int32_t e, std::span<const std::int32_t> members) noexcept;

    [[nodiscard]] const std::vector<std::int32_t>& part() const noexcept { return part_; }
    [[nodiscard]] std::span<const std::int64_t> cost() const noexcept { return load_; }
    [[nodiscard]] std::int64_t separator_cost() const noexcept { return between_; }
    [[nodiscard]] bool worn() const noexcept;
    /// The partition as it is now.
    void copy_to(Partition& out) const;

  private:
    void link(std::int32_t slot) noexcept;
    void unlink(std::int32_t slot) noexcept;
    void keep_apart(std::int32_t e) noexcept;
    void rejoin(std::int32_t node) noexcept;
    void set_part(std::int32_t node, std::int32_t part) noexcept;
    /// The largest part, then all separators.
    [[nodiscard]] std::int64_t makespan() const noexcept;

    std::vector<std::int32_t> member_, next_, previous_;  ///< By slot: kMostMembers an edge.
    std::vector<std::int32_t> head_;                      ///< By node: a slot of its, −1: none.
    std::vector<std::uint8_t> count_, size_;
    std::vector<std::uint8_t> stays_;  ///< By node: member of an edge that is not followed.
    std::vector<std::int32_t> part_;
    std::vector<std::int64_t> load_, node_cost_;
    std::int64_t between_ = 0, makespan_ = 0;
};

}  // namespace hawser::graph
