// SPDX-License-Identifier: Apache-2.0
/// Invariants of every partition, on degenerate graphs:
/// - no nodes, no edges, fixed nodes;
/// - edges of one node, of many nodes, from a node to itself, and repeated ones;
/// - many islands, more parts than nodes;
/// - sizes, weights and costs at their limits.
/// A build with sanitizers also detects reads out of bounds and overflows of sums.
#include "assembly/parts.h"
#include "graph/follow.h"
#include "graph/random_graph.h"
#include "graph/split.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

namespace hawser::test {
namespace {

struct Hostile {
    Graph graph;
    std::vector<std::int64_t> cost;
    PartitionOptions options;
    [[nodiscard]] Hypergraph view() const {
        Hypergraph g = graph.view();
        g.cost = cost;
        return g;
    }
};

std::int32_t hostile_weight(Random& random) {
    constexpr std::int32_t kMaximum = std::numeric_limits<std::int32_t>::max();
    switch (random.integer(0, 5)) {
        case 0:
            return 0;
        case 1:
            return kNeverCut;
        case 2:
            return kMaximum - 1;
        case 3:
            return -1;
        case 4:
            return std::numeric_limits<std::int32_t>::min();
        default:
            return random.integer(0, 1000);
    }
}

Hostile hostile_graph(Random& random) {
    Hostile h;
    Graph& g = h.graph;
    const int nodes = random.chance(0.1) ? 0 : random.integer(1, 120);
    const int kind = random.integer(0, 3);
    for (int v = 0; v < nodes; ++v)
        g.node(kind == 0 ? 0 : kind == 1 ? 255 : random.chance(0.2) ? 0 : random.integer(1, 6));
    const auto pick = [&] { return random.integer(0, nodes - 1); };
    const int edges = nodes == 0 ? random.integer(0, 3) : random.integer(0, 4 * nodes);
    // Islands: edges stay within blocks of this number of nodes.
    const int block = random.integer(1, std::max(1, nodes));
    for (int e = 0; e < edges; ++e) {
        std::vector<int> members;
        const int count = random.chance(0.1)   ? 0
                          : random.chance(0.1) ? random.integer(5, 40)
                                               : random.integer(1, 3);
        const int from = nodes == 0 ? 0 : pick() / block * block;
        for (int k = 0; k < count && nodes > 0; ++k)
            members.push_back(std::min(nodes - 1, from + random.integer(0, block - 1)));
        for (int again = random.chance(0.2) ? random.integer(1, 5) : 1; again > 0; --again)
            g.edge(members, hostile_weight(random));
    }
    for (std::int32_t& w : g.node_weight) w = hostile_weight(random);
    // Sums of costs must fit: hypergraph.h.
    if (random.chance(0.5))
        for (int v = 0; v < nodes; ++v)
            h.cost.push_back(random.chance(0.3)   ? 0
                             : random.chance(0.3) ? (std::int64_t{1} << 61) / nodes
                                                  : random.integer(1, 1000));
    h.options.parts = random.chance(0.1) ? random.integer(100, 300) : random.integer(1, 9);
    return h;
}

/// Call check(graph, random) for degenerate graphs until one fails.
template <class Check>
void for_hostile_graphs(Check&& check) {
    for (const std::uint32_t seed :
         seeds(77, kSanitized ? 50 : 500, kSanitized ? 150 : 2000, 40'000)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Hostile h = hostile_graph(random);
        check(h, random);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(PartitionFuzz, EveryBodyIsInOnePartOrBetweenAndSeparatorsSeparate) {
    graph::Partitioner partitioner;
    Partition p;
    for_hostile_graphs([&](Hostile& h, Random&) {
        partitioner.read(h.view());
        partitioner.separate(h.options, p);
        expect_separated(h.graph, p);
        expect_sums(h.graph, p, partitioner.cost.node);
    });
}

TEST(PartitionFuzz, NoInteractionIsLost) {
    graph::Splitter splitter;
    Partition p;
    for_hostile_graphs([&](Hostile& h, Random& random) {
        splitter.split(h.view(), h.options, p);
        // Each edge is inside a part or in the list of cuts, once. Edges that must not be cut are
        // inside a part.
        expect_split(h.graph, p);
        for (std::int32_t& w : h.graph.node_weight) w = hostile_weight(random);
        splitter.split_from_previous(h.view(), h.options, p);
        expect_split(h.graph, p);
    });
}

TEST(PartitionFuzz, EditsKeepSeparatorsApart) {
    graph::Partitioner partitioner;
    Partition p;
    for_hostile_graphs([&](Hostile& h, Random& random) {
        const int last = static_cast<int>(h.graph.size.size()) - 1;
        partitioner.read(h.view());
        partitioner.separate(h.options, p);
        graph::Follower follower;
        follower.start(h.view(), partitioner.cost.node, p);
        for (int k = 0; k < 20 && h.view().edges() > 0 && last >= 0; ++k) {
            const int e = random.integer(0, h.view().edges() - 1);
            std::vector<std::int32_t> members(h.view().edge(e).begin(), h.view().edge(e).end());
            if (members.size() > graph::Follower::kMaxMembers) continue;
            for (std::int32_t& v : members) v = random.integer(0, last);
            std::copy(members.begin(), members.end(),
                      h.graph.members.begin() + h.graph.begin[at(e)]);
            follower.change(e, members);
        }
        follower.copy_to(p);
        expect_separated(h.graph, p);
    });
}

/// One thread makes a partition; several threads that make it simultaneously get the same.
TEST(PartitionFuzz, SameResultOnAnyNumberOfThreads) {
    for (const std::uint32_t seed : seeds(77, kSanitized ? 4 : 30, kSanitized ? 8 : 100, 2000)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Hostile h = hostile_graph(random);
        std::vector<std::int32_t> first_parts, first_cuts;
        for (const std::size_t threads : {1U, 2U, 4U}) {
            std::vector<Partition> parts(threads), cuts(threads);
            std::vector<std::thread> pool;
            for (std::size_t t = 0; t < threads; ++t)
                pool.emplace_back([&, t] {
                    graph::Partitioner partitioner;
                    partitioner.read(h.view());
                    partitioner.separate(h.options, parts[t]);
                    graph::Splitter().split(h.view(), h.options, cuts[t]);
                });
            for (std::thread& t : pool) t.join();
            if (threads == 1) {
                first_parts = parts[0].part;
                first_cuts = cuts[0].part;
            }
            for (std::size_t t = 0; t < threads; ++t) {
                ASSERT_EQ(parts[t].part, first_parts);
                ASSERT_EQ(cuts[t].part, first_cuts);
            }
        }
    }
}

TEST(PartitionFuzz, WeightsOfWhatIsNoNumber) {
    using assembly::thousandths;
    EXPECT_EQ(thousandths(0.0), 0);
    EXPECT_EQ(thousandths(1.5), 1500);
    EXPECT_EQ(thousandths(-1.0), 0);
    EXPECT_EQ(thousandths(1e300), 1'000'000);
    EXPECT_EQ(thousandths(std::numeric_limits<double>::infinity()), 1'000'000);
    EXPECT_EQ(thousandths(-std::numeric_limits<double>::infinity()), 0);
    EXPECT_EQ(thousandths(std::nan("")), 1'000'000);
}

}  // namespace
}  // namespace hawser::test
