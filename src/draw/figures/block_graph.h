// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_graph.h
/// Represent a block matrix as a graph, whole or split into parts by the method of the paper.
///
/// "The paper": C. Lacoursière, F. Nordfeldth, M. Linde, "A partitioning method for parallelization
/// of large systems in realtime".

#include "draw/spy.h"

#include <hawser/factor.h>
#include <hawser/hawser.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::draw {

struct BlockGraph {
    std::vector<std::int8_t> size;       ///< Number of scalars of each node.
    std::vector<std::int8_t> sign;       ///< +1: body, −1: rows of an interaction or contact.
    std::vector<std::int32_t> start;     ///< Offsets of the nodes in `adjacent`, nodes + 1 entries.
    std::vector<std::int32_t> adjacent;  ///< Neighbours, ascending, both directions.
    /// Node of the whole matrix for each node; cut rows occur once in each part.
    std::vector<std::int32_t> origin;
    std::vector<std::int32_t> part;  ///< Part of each node; −1: none.

    [[nodiscard]] std::int32_t nodes() const { return static_cast<std::int32_t>(size.size()); }
    [[nodiscard]] std::span<const std::int32_t> neighbours(std::int32_t node) const {
        const auto i = static_cast<std::size_t>(node);
        return {adjacent.data() + start[i], adjacent.data() + start[i + 1]};
    }
};

/// Return the matrix of a world's last step. @param part_of_body  Part of each body; empty: no
/// parts.
[[nodiscard]] BlockGraph block_graph_of_world(const SystemView& view,
                                              std::span<const std::int32_t> part_of_body = {});

/// Return the graph part by part: all bodies of the part, then all rows that act on one of them.
/// Rows that act on bodies of several parts occur in each of these parts, without the bodies of the
/// others. This is the paper's kinematic split, in which each side solves for the force at the cut.
/// Nodes in no part are left out.
[[nodiscard]] BlockGraph split_graph(const BlockGraph& whole, std::int32_t parts);

/// Return one part of a split graph; `origin` refers to the nodes of `split`.
[[nodiscard]] BlockGraph part_graph(const BlockGraph& split, std::int32_t part);

[[nodiscard]] BlockPattern pattern_of(const BlockGraph& graph);

/// Counts of a factorisation in this order; zeros of merged fronts are not counted.
struct MatrixCounts {
    std::int64_t nodes = 0, scalars = 0;
    std::int64_t nnz = 0;         ///< Number of scalars of the lower triangle of K, dense blocks.
    std::int64_t factor_nnz = 0;  ///< Number of scalars of L, dense blocks.
    std::int64_t flops = 0;       ///< Σ m (m + 2), with m scalars below each pivot.
};
[[nodiscard]] MatrixCounts count(const BlockGraph& graph, std::span<const std::int32_t> order,
                                 const FactorBlocks& factor);

}  // namespace hawser::draw
