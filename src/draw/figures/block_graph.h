// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_graph.h
/// A block matrix as a graph, whole or split into parts as the paper splits it.
///
/// "The paper": C. Lacoursière, F. Nordfeldth, M. Linde, "A partitioning method for
/// parallelization of large systems in realtime".

#include "draw/spy.h"

#include <hawser/factor.h>
#include <hawser/hawser.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::draw {

struct BlockGraph {
    std::vector<std::int8_t> size;       ///< Scalars of each node.
    std::vector<std::int8_t> sign;       ///< +1: body, −1: rows of an interaction or contact.
    std::vector<std::int32_t> start;     ///< nodes + 1 offsets into `adjacent`.
    std::vector<std::int32_t> adjacent;  ///< Neighbours, ascending, both directions.
    /// Which node of the whole matrix each is; rows that are cut stand once in each part.
    std::vector<std::int32_t> origin;
    std::vector<std::int32_t> part;  ///< Of each node; −1: in none.

    [[nodiscard]] std::int32_t nodes() const { return static_cast<std::int32_t>(size.size()); }
    [[nodiscard]] std::span<const std::int32_t> neighbours(std::int32_t node) const {
        const auto i = static_cast<std::size_t>(node);
        return {adjacent.data() + start[i], adjacent.data() + start[i + 1]};
    }
};

/// The matrix of a world's last step. @param part_of_body  Empty: no parts.
[[nodiscard]] BlockGraph graph_of(const SystemView& view,
                                  std::span<const std::int32_t> part_of_body = {});

/// Part by part: all bodies of the part, then all rows that act on one of them. Rows that act on
/// bodies of several parts are in each of these, without the bodies of the others: the paper's
/// kinematic split, in which each side solves for the force at the cut. What is in no part is left
/// out.
[[nodiscard]] BlockGraph split_graph(const BlockGraph& whole, std::int32_t parts);

/// One part of a split graph; `origin` numbers the nodes of `split`.
[[nodiscard]] BlockGraph part_graph(const BlockGraph& split, std::int32_t part);

[[nodiscard]] BlockPattern pattern_of(const BlockGraph& graph);

/// What a factorisation in this order has, zeros of merged fronts not counted.
struct MatrixCounts {
    std::int64_t nodes = 0, scalars = 0;
    std::int64_t nnz = 0;         ///< Scalars of the lower triangle of K, dense blocks.
    std::int64_t factor_nnz = 0;  ///< Of L, dense blocks.
    std::int64_t flops = 0;       ///< Σ m (m + 2), m scalars below each pivot.
};
[[nodiscard]] MatrixCounts count(const BlockGraph& graph, std::span<const std::int32_t> order,
                                 const FactorBlocks& factor);

}  // namespace hawser::draw
