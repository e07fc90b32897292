// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cases.h
/// Graphs for the comparison of partitioners: bodies, interactions, and the block pattern of the
/// condensed matrix, which is the body graph.

#include "factor/pattern.h"
#include "graph/hypergraph.h"
#include "paper_matrix/block_system.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::bench {

struct PartCase {
    std::string name;
    std::vector<std::uint8_t> size;  ///< Scalars of each body.
    std::vector<std::int32_t> begin{0}, members;
    factor::Pattern pattern;              ///< The body graph.
    std::vector<std::int32_t> contacts;   ///< Edges that change from step to step.
    std::vector<std::int32_t> edited;     ///< Edges that changed, …
    std::vector<std::int32_t> edited_to;  ///< … and their two new members, −1: none.

    [[nodiscard]] graph::Hypergraph graph(const std::vector<std::int64_t>& cost = {}) const {
        return {size, begin, members, {}, {}, {}, cost};
    }
    [[nodiscard]] int bodies() const noexcept { return static_cast<int>(size.size()); }
    void edge(const std::vector<int>& nodes) {
        members.insert(members.end(), nodes.begin(), nodes.end());
        begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    void finish();  ///< Make the pattern from the edges.
};

/// Make a case: bodies are the positive nodes, and edges the neighbours of each other node.
[[nodiscard]] PartCase make_case(const BlockSystem& system);
/// Make the paper's scene, with 20 contacts that change.
[[nodiscard]] PartCase paper_case(bool rigid, int scale, int elements = 94, std::uint64_t seed = 1);
/// Make random edges of two and three bodies, three edges per body, all bodies in one island.
[[nodiscard]] PartCase random_case(int bodies, std::uint64_t seed);
/// Make `wires` wires of `length` point masses on one hull, which touches a fifth of them.
[[nodiscard]] PartCase star_case(int wires, int length, std::uint64_t seed);
/// Split a case into its islands.
[[nodiscard]] std::vector<PartCase> islands_of(const PartCase& all);

}  // namespace hawser::bench
