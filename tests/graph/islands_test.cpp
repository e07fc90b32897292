// SPDX-License-Identifier: Apache-2.0
#include "graph/islands.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <hawser/inspect.h>

#include <gtest/gtest.h>

#include <map>

namespace hawser::test {
namespace {

/// Find islands by repeated flooding, numbered by their first node.
std::vector<int> flooded(const std::vector<std::uint8_t>& include,
                         const std::vector<std::vector<int>>& edges) {
    std::vector<int> label(include.size(), -1);
    int count = 0;
    for (std::size_t start = 0; start < include.size(); ++start) {
        if (!include[start] || label[start] >= 0) continue;
        label[start] = count;
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& e : edges) {
                bool touches = false;
                for (int n : e)
                    touches = touches || (include[static_cast<std::size_t>(n)] &&
                                          label[static_cast<std::size_t>(n)] == count);
                for (int n : e)
                    if (touches && include[static_cast<std::size_t>(n)] &&
                        label[static_cast<std::size_t>(n)] != count) {
                        label[static_cast<std::size_t>(n)] = count;
                        changed = true;
                    }
            }
        }
        ++count;
    }
    return label;
}

TEST(Islands, AgreeWithFloodingAndAreNumberedByTheirFirstNode) {
    for (const std::uint32_t seed : seeds(1, 200, 1000, 10'000)) {
        Random random(seed);
        const int nodes = random.integer(0, 30), count = random.integer(0, 30);
        std::vector<std::uint8_t> include;
        for (int i = 0; i < nodes; ++i) include.push_back(random.chance(0.85) ? 1 : 0);
        std::vector<std::vector<int>> edges;
        std::vector<std::int32_t> begin{0}, members;
        for (int e = 0; e < count && nodes > 0; ++e) {
            edges.emplace_back();
            for (int k = random.integer(1, 3); k > 0; --k) {
                edges.back().push_back(random.integer(0, nodes - 1));
                members.push_back(edges.back().back());
            }
            begin.push_back(static_cast<std::int32_t>(members.size()));
        }
        const graph::Islands got = graph::find_islands(include, begin, members);
        const std::vector<int> want = flooded(include, edges);
        ASSERT_EQ(std::vector<int>(got.label.begin(), got.label.end()), want) << "seed " << seed;
        int most = -1;
        for (int l : want) most = std::max(most, l);
        EXPECT_EQ(got.count, most + 1);
    }
}

TEST(Islands, BodiesThatDoNotMoveJoinNothing) {
    Recipe r;
    const BodyId g = r.ground();
    const BodyId a = r.lump({1, 0, 0}, 1.0), b = r.lump({2, 0, 0}, 1.0), c = r.lump({9, 0, 0}, 1.0);
    r.add(between(InteractionKind::Distance, {g, a}));
    r.add(between(InteractionKind::Distance, {g, b}));
    World w = r.make();
    w.prepare();
    const SystemView v = w.solver().matrix();
    EXPECT_EQ(w.stats().islands, 3);
    EXPECT_EQ(v.body_island, (std::vector<std::int32_t>{-1, 0, 1, 2}));
    (void)c;
}

/// A wire between two carriers is one island; its numbers follow the order of the bodies.
TEST(Islands, AThirdBodyJoinsThem) {
    Recipe r;
    const BodyId a = r.lump({0, 0, 0}, 1.0), b = r.lump({1, 0, 0}, 1.0), drum = r.scalar(0, 1.0);
    InteractionDef d = between(InteractionKind::WinchStretch, {a, b, drum});
    r.add(d.set("radius", 0.1).set("EA", 1e4));
    World w = r.make();
    w.prepare();
    EXPECT_EQ(w.stats().islands, 1);
    EXPECT_EQ(w.solver().matrix().body_island, (std::vector<std::int32_t>{0, 0, 0}));
}

}  // namespace
}  // namespace hawser::test
