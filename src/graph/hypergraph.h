// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hypergraph.h
/// Define the graph of nodes and couplings in integers. It is the input of all partitioning.
///
/// A node is a moving body. An edge couples one or several nodes: an interaction of two or three
/// bodies, or a pair in contact. Physical quantities enter as integer weights, so that sums do not
/// depend on the order of summation.

#include "base/index.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hawser::graph {

/// Edge weight of an edge that must not be cut: contacts, joints of a machine.
inline constexpr std::int32_t kNeverCut = std::numeric_limits<std::int32_t>::max();

inline constexpr std::int32_t kNoPart = -1;     ///< Part of a node that does not move.
inline constexpr std::int32_t kSeparator = -2;  ///< Part of a node between parts.

/// View of a graph; the caller owns the arrays. Optional arrays may be empty.
struct Hypergraph {
    std::span<const std::uint8_t> size;  ///< Number of scalars of each node; 0: does not move.
    /// Offsets of the edges in `members`, edges + 1 entries.
    std::span<const std::int32_t> member_begin;
    std::span<const std::int32_t> members;        ///< Nodes of each edge, in the order of a path.
    std::span<const std::int32_t> edge_weight{};  ///< Price of cutting each edge, ≥ 0; optional.
    /// Price of a cut next to each node, ≥ 0; optional.
    std::span<const std::int32_t> node_weight{};
    /// Part requested by the user for each node, −1: none; optional.
    std::span<const std::int32_t> group{};
    std::span<const std::int64_t>
        cost{};  ///< Cost of the pivots of each node [flops], ≥ 0, sum below 2⁶²; optional.
    /// Price of repairing each cut edge, ≥ 0, for Splitter::follow(); optional.
    std::span<const std::int32_t> repair_weight{};

    [[nodiscard]] std::int32_t nodes() const noexcept {
        return static_cast<std::int32_t>(size.size());
    }
    [[nodiscard]] std::int32_t edges() const noexcept {
        return static_cast<std::int32_t>(member_begin.size()) - 1;
    }
    [[nodiscard]] std::span<const std::int32_t> edge(std::int32_t e) const noexcept {
        const auto i = static_cast<std::size_t>(e);
        return members.subspan(static_cast<std::size_t>(member_begin[i]),
                               static_cast<std::size_t>(member_begin[i + 1] - member_begin[i]));
    }
};

}  // namespace hawser::graph
