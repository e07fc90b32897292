// SPDX-License-Identifier: Apache-2.0
/// Properties of partitions, on random graphs and on wires.
#include "graph/partition.h"
#include "graph/follow.h"
#include "graph/random_graph.h"
#include "graph/split.h"
#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace hawser::test {
namespace {

TEST(Partition, AnyGraphFallsIntoParts) {
    graph::Partitioner partitioner;
    Partition p;
    std::size_t separators = 0;
    const auto all = seeds(1, kSanitized ? 20 : 200, kSanitized ? 60 : 800, 16'000);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Graph g = any_graph(random);
        const PartitionOptions options{random.integer(1, 9)};
        partitioner.read(g.view());
        partitioner.separate(options, p);
        EXPECT_EQ(p.parts, options.parts);
        expect_separated(g, p);
        expect_sums(g, p, partitioner.cost.node);
        if (HasFatalFailure()) return;
        separators += p.separator.size();
        // Buffers keep no data of earlier graphs.
        graph::Partitioner other;
        Partition q;
        other.read(g.view());
        other.separate(options, q);
        EXPECT_EQ(p.part, q.part);
    }
    if (all.size() > 1) {
        EXPECT_GT(separators, all.size());
    }
}

/// Islands that fit fill every part evenly, although one is too large for a part.
TEST(Partition, NoPartHasRoomForTheLargestIsland) {
    Partition p;
    bool divided = false;
    for (const int parts : {22, 64, 300})
        for (const int links : {3, 20, 40}) {
            SCOPED_TRACE(std::to_string(parts) + " parts, " + std::to_string(links) + " links");
            Graph g;
            for (int v = 0; v < 10 * parts + links; ++v) g.node(3);
            for (int v = 0; v + 1 < links; ++v) g.edge({10 * parts + v, 10 * parts + v + 1}, 0);
            graph::Partitioner partitioner;  // a new one: the test needs no buffers of an earlier
                                             // graph
            partitioner.read(g.view());
            partitioner.separate({parts}, p);
            expect_separated(g, p);
            expect_sums(g, p, partitioner.cost.node);
            divided |= !p.separator.empty();
        }
    EXPECT_TRUE(divided);
}

TEST(Partition, SeparatorsFollowEdits) {
    graph::Partitioner partitioner;
    Partition p;
    for (const std::uint32_t seed : seeds(1, kSanitized ? 10 : 100, kSanitized ? 30 : 300, 6000)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph g = any_graph(random);
        if (g.view().edges() == 0) continue;
        partitioner.read(g.view());
        partitioner.separate({random.integer(1, 9)}, p);
        graph::Follower follower;
        follower.start(g.view(), partitioner.cost.node, p);
        const auto last = static_cast<int>(g.size.size()) - 1;
        for (int step = 0; step < 20; ++step) {
            for (int k = random.integer(1, 20); k > 0; --k) {
                // Exchange members; their number stays, so that the arrays of this test remain
                // valid.
                const int e = random.integer(0, g.view().edges() - 1);
                std::vector<std::int32_t> members(g.view().edge(e).begin(), g.view().edge(e).end());
                for (std::int32_t& v : members)
                    if (random.chance(0.6)) v = random.integer(0, last);
                std::copy(members.begin(), members.end(), g.members.begin() + g.begin[at(e)]);
                follower.change(e, members);
            }
            follower.copy_to(p);
            expect_separated(g, p);
            expect_sums(g, p, partitioner.cost.node);
            if (HasFatalFailure()) return;
        }
    }
}

/// Wires of few nodes and more parts than nodes allow: as many parts as possible are used, evenly
/// if each has some nodes.
TEST(Partition, ShortWiresFillAsManyPartsAsTheyCan) {
    graph::Partitioner partitioner;
    graph::Splitter splitter;
    Partition p;
    const auto used = [&] {
        return static_cast<int>(std::count_if(p.cost.begin(), p.cost.end(),
                                              [](std::int64_t cost) { return cost > 0; }));
    };
    for (const bool bends : {false, true})
        for (int n = 1; n <= 60; ++n)
            for (const int parts : {1, 2, 3, 4, 8, 16, 64}) {
                SCOPED_TRACE(testing::Message() << n << " nodes, " << parts << " parts, " << bends);
                Graph g;
                for (int i = 0; i < n; ++i) g.node(3);
                for (int i = 0; i + 1 < n; ++i) {
                    g.edge({i, i + 1});
                    if (bends && i + 2 < n) g.edge({i, i + 1, i + 2});
                }
                splitter.split(g.view(), {parts}, p);
                expect_split(g, p);
                // A fifth may be missing: 13 nodes give 7 parts of at most two, not 8.
                EXPECT_GE(5 * used(), 4 * std::min(parts, std::max(1, n - 2)));
                if (n >= 6 * parts) {
                    EXPECT_LE(p.imbalance(), 1.25);
                }
                partitioner.read(g.view());
                partitioner.separate({parts}, p);
                expect_separated(g, p);
                ASSERT_EQ(p.cost.size(), at(parts));
                const int most = std::min(parts, std::max(1, n / graph::Partitioner::kMinNodes));
                EXPECT_GE(5 * used(), 4 * most);
                if (HasFailure()) return;
            }
}

/// The weights determine the position of a cut. Three otherwise equal wires differ only in them.
TEST(Partition, CutsSlideToTheLowestWeight) {
    Graph g;
    const int a = g.node(6), b = g.node(6);
    const std::vector<int> wire = g.wire(a, 100, b);
    std::fill(g.edge_weight.begin(), g.edge_weight.end(), 100);
    graph::Splitter splitter;
    Partition p;
    splitter.split(g.view(), {2}, p);
    const auto cut_at = [&] {
        for (std::size_t i = 0; i + 1 < wire.size(); ++i)
            if (p.part[at(wire[i])] != p.part[at(wire[i + 1])]) return static_cast<int>(i);
        return -1;
    };
    const int even = cut_at();
    ASSERT_GT(even, 40);
    ASSERT_LT(even, 60);
    // Three cheap rows (two bends and a stretch), two nodes further.
    const int cheap = even + 2;
    for (int e = 0; e < g.view().edges(); ++e) {
        int low = 1000, high = -1;
        for (const std::int32_t v : g.view().edge(e))
            for (std::size_t i = 0; i < wire.size(); ++i)
                if (wire[i] == v) {
                    low = std::min(low, static_cast<int>(i));
                    high = std::max(high, static_cast<int>(i));
                }
        if (low <= cheap && high > cheap) g.edge_weight[at(e)] = 10;
    }
    splitter.split_from_previous(g.view(), {2}, p);
    EXPECT_EQ(cut_at(), cheap);
    // More expensive now, but still by far the cheapest cut: it does not move.
    g.node_weight[at(wire[at(cheap)])] = 100;
    const auto kept = p.part;
    splitter.split_from_previous(g.view(), {2}, p);
    EXPECT_EQ(p.part, kept);
}

TEST(Partition, AnyGraphSplits) {
    graph::Splitter splitter;
    Partition p;
    std::size_t cuts = 0;
    const auto all = seeds(1, kSanitized ? 20 : 200, kSanitized ? 60 : 800, 16'000);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph g = any_graph(random);
        // A group is one part, so that edges that must not be cut may not join two groups.
        const bool groups = random.chance(0.3);
        for (std::size_t e = 0; groups && e < g.edge_weight.size(); ++e)
            g.edge_weight[e] = std::min(g.edge_weight[e], 100);
        if (!groups) std::fill(g.group.begin(), g.group.end(), -1);
        PartitionOptions options{random.integer(1, 9)};
        splitter.split(g.view(), options, p);
        expect_split(g, p);
        for (std::size_t v = 0; v < g.size.size(); ++v) {
            if (g.group[v] < 0 || g.size[v] == 0) continue;
            ASSERT_EQ(p.part[v], g.group[v]);
        }
        if (HasFatalFailure()) return;
        cuts += p.cut.size();
        graph::Splitter other;
        Partition q;
        other.split(g.view(), options, q);
        EXPECT_EQ(p.part, q.part);
        // The next steps: weights change, new contacts may appear.
        for (int step = 0; step < 3; ++step) {
            for (std::int32_t& w : g.edge_weight)
                if (w != kNeverCut) w = random.integer(0, 100);
            if (!groups && random.chance(0.5)) {
                const int last = static_cast<int>(g.size.size()) - 1;
                g.edge({random.integer(0, last), random.integer(0, last)}, kNeverCut);
            }
            splitter.split_from_previous(g.view(), options, p);
            expect_split(g, p);
            if (HasFatalFailure()) return;
        }
    }
    if (all.size() > 1) {
        EXPECT_GT(cuts, all.size());
    }
}

/// Make two hulls with four wires between them, and four wires that hang free.
Graph fleet() {
    Graph g;
    const int a = g.node(6), b = g.node(6);
    for (int i = 0; i < 4; ++i) g.wire(a, 100, b);
    for (int i = 0; i < 4; ++i) g.wire(i % 2 == 0 ? a : b, 100, -1);
    return g;
}

TEST(Partition, WiresAreCutWhereTheyBalance) {
    const Graph g = fleet();
    graph::Partitioner partitioner;
    Partition p;
    partitioner.read(g.view());
    partitioner.separate({4}, p);
    expect_separated(g, p);
    EXPECT_LT(p.imbalance(), 1.1);
    // Both hulls, and at most two nodes of a wire for each of three cuts.
    EXPECT_LE(p.separator.size(), 8U);

    graph::Splitter splitter;
    splitter.split(g.view(), {4}, p);
    expect_split(g, p);
    EXPECT_LT(p.imbalance(), 1.1);
    // A cut wire loses one stretch and two bends.
    EXPECT_LE(p.cut.size(), 3U * 12U);
}

TEST(Partition, IslandsThatFitStayWhole) {
    Graph g;
    for (int i = 0; i < 8; ++i) g.wire(-1, 50, -1);
    graph::Partitioner partitioner;
    Partition p;
    partitioner.read(g.view());
    partitioner.separate({4}, p);
    EXPECT_TRUE(p.separator.empty());
    EXPECT_EQ(p.imbalance(), 1.0);
    graph::Splitter splitter;
    splitter.split(g.view(), {4}, p);
    EXPECT_TRUE(p.cut.empty());
    EXPECT_EQ(p.imbalance(), 1.0);
}

TEST(Partition, CostIsThePapersFormula) {
    // A ring of five and a pendant: n_b = 2 except for one 3 and one 1, one loop of five.
    Graph g;
    for (int i = 0; i < 6; ++i) g.node(3);
    for (int i = 0; i < 5; ++i) g.edge({i, (i + 1) % 5});
    g.edge({2, 5});
    graph::Partitioner partitioner;
    partitioner.read(g.view());
    ASSERT_EQ(partitioner.cost.islands(), 1);
    EXPECT_EQ(partitioner.cost.paper[0], 4 * 4 + 9 + 1 + 5);

    // Bending over three neighbours closes no loop.
    Graph w;
    w.wire(-1, 10, -1);
    partitioner.read(w.view());
    std::int64_t squares = 0;
    for (const std::int32_t n : partitioner.neighbours.edges) squares += n * n;
    EXPECT_EQ(partitioner.cost.paper[0], squares);
}

/// Wires numbered from end to end are found by their numbers, others by following edges.
TEST(Partition, WiresAreTheSameForAnyNumbering) {
    constexpr int kWires = 6, kLinks = 20, kNodes = 1 + kWires * kLinks;
    const auto wires_of = [](const std::vector<std::int32_t>& number) {
        Graph g;
        for (int v = 0; v < kNodes; ++v) g.node(v == number[0] ? 6 : 3);
        for (int w = 0; w < kWires; ++w)
            for (int i = 0; i < kLinks; ++i) {
                const auto link = [&](int k) {
                    return k < 0 ? number[0] : number[static_cast<std::size_t>(1 + w * kLinks + k)];
                };
                g.edge({link(i - 1), link(i)});
                if (i > 0) g.edge({link(i - 2), link(i - 1), link(i)});
                g.edge({number[0], link(i)});  // makes it a hub
            }
        graph::Partitioner partitioner;
        partitioner.read(g.view());
        std::vector<std::int32_t> original(number.size());
        for (std::size_t v = 0; v < number.size(); ++v)
            original[static_cast<std::size_t>(number[v])] = static_cast<std::int32_t>(v);
        std::vector<std::vector<std::int32_t>> wires;
        for (std::int32_t u = 0; u < partitioner.units.wires; ++u) {
            wires.emplace_back();
            for (const std::int32_t v : partitioner.units.nodes_of(u))
                wires.back().push_back(original[static_cast<std::size_t>(v)]);
            if (wires.back().front() > wires.back().back())
                std::reverse(wires.back().begin(), wires.back().end());
        }
        std::sort(wires.begin(), wires.end());
        return wires;
    };
    std::vector<std::int32_t> number(kNodes);
    std::iota(number.begin(), number.end(), 0);
    const auto wires = wires_of(number);
    ASSERT_EQ(wires.size(), kWires);
    for (const auto& wire : wires) {
        EXPECT_EQ(wire.size(), kLinks);
        EXPECT_TRUE(std::is_sorted(wire.begin(), wire.end()));
    }
    Random random(first_seed(5));
    const int rounds = by_tier(20, 100, 1000);
    for (int round = 0; round < rounds; ++round) {
        for (int v = kNodes - 1; v > 0; --v)
            std::swap(number[static_cast<std::size_t>(v)],
                      number[static_cast<std::size_t>(random.integer(0, v))]);
        EXPECT_EQ(wires_of(number), wires) << round;
    }
}

TEST(Partition, LongestFirstSharesOut) {
    const std::vector<std::int64_t> cost{3, 7, 5, 5, 4, 6};
    std::vector<std::int32_t> lane(cost.size()), order;
    std::vector<std::int64_t> load(3, 0);
    graph::distribute(cost, lane, load, order);
    EXPECT_EQ(load, (std::vector<std::int64_t>{10, 10, 10}));
}

}  // namespace
}  // namespace hawser::test
