// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hypergraph.h
/// Nodes and what couples them, as integers: the input of everything about parts.
///
/// A node is what moves (a body), an edge is what couples one to several of them (an interaction
/// of two or three bodies, a pair that touches). Whatever physics has to say comes as integer
/// weights, so that sums do not depend on the order in which they are formed.

#include "base/index.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hawser::graph {

/// Edge weight of what must stay whole: contacts, joints of a machine.
inline constexpr std::int32_t kNeverCut = std::numeric_limits<std::int32_t>::max();

inline constexpr std::int32_t kNoPart = -1;     ///< Of a node that does not move.
inline constexpr std::int32_t kSeparator = -2;  ///< Of a node between parts.

/// A view; the arrays belong to the caller. Optional ones may be empty.
struct Hypergraph {
    std::span<const std::uint8_t> size;           ///< Scalars of each node; 0: does not move.
    std::span<const std::int32_t> member_begin;   ///< edges + 1 offsets into members.
    std::span<const std::int32_t> members;        ///< Nodes of each edge, in the order of a path.
    std::span<const std::int32_t> edge_weight{};  ///< ≥ 0: price of cutting it; optional.
    std::span<const std::int32_t> node_weight{};  ///< ≥ 0: price of a cut beside it; optional.
    std::span<const std::int32_t> group{};        ///< Part asked for by hand, −1: none; optional.
    std::span<const std::int64_t>
        cost{};  ///< Flops of each node's pivots, ≥ 0, all below 2⁶²; optional.
    /// ≥ 0: price of making whole an edge that is cut, for Splitter::follow(); optional.
    std::span<const std::int32_t> mend_weight{};

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
