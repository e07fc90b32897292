// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_graph.h
/// Random hypergraphs, and checks of the invariants of their partitions.

#include "graph/partition.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hawser::test {

using graph::Hypergraph;
using graph::kNeverCut;
using graph::kNoPart;
using graph::kSeparator;
using graph::Partition;
using graph::PartitionOptions;

struct Graph {
    std::vector<std::uint8_t> size;
    std::vector<std::int32_t> begin{0}, members, edge_weight, node_weight, group;

    int node(int scalars) {
        size.push_back(static_cast<std::uint8_t>(scalars));
        node_weight.push_back(0);
        group.push_back(-1);
        return static_cast<int>(size.size()) - 1;
    }
    int edge(const std::vector<int>& nodes, std::int32_t weight = 1) {
        members.insert(members.end(), nodes.begin(), nodes.end());
        begin.push_back(static_cast<std::int32_t>(members.size()));
        edge_weight.push_back(weight);
        return static_cast<int>(edge_weight.size()) - 1;
    }
    /// Add point masses in a row with stretch and bend, from one node (−1: none) to another.
    std::vector<int> wire(int from, int count, int to) {
        std::vector<int> all;
        if (from >= 0) all.push_back(from);
        for (int i = 0; i < count; ++i) all.push_back(node(3));
        if (to >= 0) all.push_back(to);
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            edge({all[i], all[i + 1]});
            if (i + 2 < all.size()) edge({all[i], all[i + 1], all[i + 2]});
        }
        return all;
    }
    [[nodiscard]] Hypergraph view() const {
        return {size, begin, members, edge_weight, node_weight, group, {}};
    }
};

/// Make a graph of any kind: hubs, wires, clusters, fixed nodes, islands, repeated edges.
inline Graph any_graph(Random& random) {
    Graph g;
    const int start = random.integer(1, 40);
    for (int i = 0; i < start; ++i) g.node(random.chance(0.1) ? 0 : random.integer(1, 6));
    const auto pick = [&] { return random.integer(0, static_cast<int>(g.size.size()) - 1); };
    const int wires = random.integer(0, 6);
    for (int i = 0; i < wires; ++i)
        g.wire(random.chance(0.8) ? pick() : -1, random.integer(1, 40),
               random.chance(0.5) ? pick() : -1);
    const int edges = random.integer(0, 3 * static_cast<int>(g.size.size()));
    for (int i = 0; i < edges; ++i) {
        std::vector<int> nodes{pick()};
        for (int k = random.integer(0, 2); k > 0; --k) nodes.push_back(pick());
        g.edge(nodes, random.chance(0.3) ? kNeverCut : random.integer(0, 100));
    }
    if (random.chance(0.5)) {  // a star graph
        const int hub = pick();
        for (int i = random.integer(10, 60); i > 0; --i) g.edge({hub, pick()});
    }
    for (std::size_t v = 0; v < g.size.size(); ++v) {
        g.node_weight[v] = random.integer(0, 50);
        if (random.chance(0.02)) g.group[v] = random.integer(0, 2);
    }
    return g;
}

inline void expect_sums(const Graph& g, const Partition& p, const std::vector<std::int64_t>& cost) {
    std::vector<std::int64_t> sums(p.cost.size(), 0);
    std::int64_t between = 0;
    for (std::size_t v = 0; v < g.size.size(); ++v) {
        if (p.part[v] == kNoPart) continue;
        (p.part[v] == kSeparator ? between : sums[at(p.part[v])]) += cost[v];
    }
    EXPECT_EQ(sums, p.cost);
    EXPECT_EQ(between, p.separator_cost);
}

/// Check that every moving node is in exactly one part or in the separator, and that no edge joins
/// two parts.
inline void expect_separated(const Graph& g, const Partition& p) {
    ASSERT_EQ(p.part.size(), g.size.size());
    std::vector<std::int32_t> between;
    for (std::size_t v = 0; v < g.size.size(); ++v) {
        ASSERT_EQ(p.part[v] == kNoPart, g.size[v] == 0);
        ASSERT_LT(p.part[v], p.parts);
        if (p.part[v] == kSeparator) between.push_back(static_cast<std::int32_t>(v));
    }
    ASSERT_EQ(between, p.separator);
    ASSERT_TRUE(p.cut.empty());
    for (int e = 0; e < g.view().edges(); ++e) {
        int part = -1;
        for (const std::int32_t v : g.view().edge(e)) {
            if (p.part[at(v)] < 0) continue;
            ASSERT_TRUE(part < 0 || part == p.part[at(v)]) << "edge " << e;
            part = p.part[at(v)];
        }
    }
}

/// Check that every moving node is in one part, that the cut edges are exactly those between parts,
/// and that edges that must not be cut are not.
inline void expect_split(const Graph& g, const Partition& p) {
    std::vector<std::int32_t> cut;
    for (std::size_t v = 0; v < g.size.size(); ++v)
        ASSERT_TRUE(g.size[v] == 0 ? p.part[v] == kNoPart : p.part[v] >= 0 && p.part[v] < p.parts);
    for (int e = 0; e < g.view().edges(); ++e) {
        int low = p.parts, high = -1;
        for (const std::int32_t v : g.view().edge(e)) {
            if (p.part[at(v)] < 0) continue;
            low = std::min(low, p.part[at(v)]);
            high = std::max(high, p.part[at(v)]);
        }
        if (high > low) cut.push_back(e);
        if (g.edge_weight[at(e)] == kNeverCut) {
            ASSERT_FALSE(high > low) << "edge " << e;
        }
    }
    EXPECT_EQ(cut, p.cut);
}

}  // namespace hawser::test
