// SPDX-License-Identifier: Apache-2.0
/// Orders by degrees in scalars: their fill in L, counted by sets of nodes.
#include "factor/approximate_degree.h"
#include "factor/matrices.h"
#include "factor/minimum_degree.h"
#include "factor/ordering.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

using factor::Pattern;
using Order = std::vector<std::int32_t>;

/// Return entries of L and products of the elimination, by sets of nodes.
std::pair<double, double> fill_of(const Pattern& p, const Order& order) {
    std::vector<std::set<int>> adjacent(p.size.size());
    for (int v = 0; v < p.nodes(); ++v)
        adjacent[static_cast<std::size_t>(v)] = {p.neighbours(v).begin(), p.neighbours(v).end()};
    double entries = 0, products = 0;
    for (const std::int32_t v : order) {
        const std::set<int> around = adjacent[static_cast<std::size_t>(v)];
        double q = 0;
        for (const int u : around) q += p.size[static_cast<std::size_t>(u)];
        const double size = p.size[static_cast<std::size_t>(v)];
        entries += size * (q + (size + 1) / 2);
        products += size * q * q;
        for (const int u : around) {
            std::set<int>& other = adjacent[static_cast<std::size_t>(u)];
            other.insert(around.begin(), around.end());
            other.erase(u);
            other.erase(v);
        }
    }
    return {entries, products};
}

/// Make a square net of strings: rows of one scalar between knots of three.
Pattern net(int side) {
    std::vector<std::int8_t> size(static_cast<std::size_t>(side * side), 3), sign(size.size(), 1);
    std::vector<std::int32_t> from, to;
    auto string = [&](int a, int b) {
        for (const int knot : {a, b}) {
            from.push_back(static_cast<std::int32_t>(size.size()));
            to.push_back(knot);
        }
        size.push_back(1);
        sign.push_back(-1);
    };
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            if (j + 1 < side) string(side * i + j, side * i + j + 1);
            if (i + 1 < side) string(side * i + j, side * (i + 1) + j);
        }
    return factor::make_pattern(size, sign, from, to);
}

/// Bounds of degrees instead of exact ones: a valid order of about the same cost.
TEST(Degrees, AreBoundsForLargeGraphs) {
    Random random(first_seed(7));
    factor::ApproximateDegree large;
    factor::MinimumDegree small;
    double approximate = 0, exact = 0;
    const int most = by_tier(kSanitized ? 40 : 100, kSanitized ? 40 : 400, 4000);
    for (int trial = 0; trial < most; ++trial) {
        const int nodes = random.integer(0, 150);
        const Pattern p =
            random.chance(0.4)
                ? wires(random, 12, 40).pattern
                : random_quasi_definite(random, nodes, random.uniform(0.0, 4.0 / (nodes + 1)))
                      .pattern;
        Order order, other;
        large.run(p, order);
        Order sorted = order;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t v = 0; v < p.size.size(); ++v)
            ASSERT_EQ(sorted[v], static_cast<std::int32_t>(v)) << trial;
        small.run(p, other);
        const double cost = fill_of(p, order).second, least = fill_of(p, other).second;
        // For a single graph the order depends on ties.
        EXPECT_LE(cost, 2.0 * least + 1000.0) << trial;
        approximate += cost;
        exact += least;
    }
    // Amestoy, Davis, Duff 1996, table 4: within a few per cent of minimum degree in the sum of
    // all.
    EXPECT_LE(approximate, 1.1 * exact);
}

/// Knots precede strings: a knot has two rows left, not three scalars. Counted in nodes, strings
/// come first and leave the matrix of the knots.
TEST(Degrees, CountScalars) {
    for (const int side :
         {12, 30, 40}) {  // the last two have more than MinimumDegree::kMaximum nodes
        const Pattern p = net(side);
        factor::Orderer orderer;
        Order scalars, nodes;
        orderer.order(p, scalars);
        orderer.order_by_amd(p, nodes);
        const auto by_scalars = fill_of(p, scalars), by_nodes = fill_of(p, nodes);
        EXPECT_LT(by_scalars.first, 0.75 * by_nodes.first) << side;
        EXPECT_LT(by_scalars.second, 0.5 * by_nodes.second) << side;
    }
}

}  // namespace
}  // namespace hawser::test
