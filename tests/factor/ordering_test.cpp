// SPDX-License-Identifier: Apache-2.0
/// Fast methods give the orders of the slow ones that are written here.
#include "factor/ordering.h"
#include "factor/matrices.h"
#include "factor/repair.h"
#include "support/sanitizer.h"
#include "support/tier.h"

extern "C" {
#include <amd.h>
}

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <list>
#include <set>
#include <vector>

namespace hawser::test {
namespace {

using factor::Pattern;
using Order = std::vector<std::int32_t>;

/// Draw a pattern: bodies only, bodies and rows, or wires.
Pattern draw(Random& random) {
    if (random.chance(0.4)) return wires(random, 12, 40).pattern;
    const int nodes = random.integer(0, 150);
    Pattern p =
        random_quasi_definite(random, nodes, random.uniform(0.0, 4.0 / (nodes + 1))).pattern;
    if (random.chance(0.5)) std::fill(p.sign.begin(), p.sign.end(), std::int8_t{1});
    return p;
}

/// Put rows after the first of their bodies, by sorting all positions.
Order with_rows_placed(const Pattern& p, const Order& order) {
    std::vector<std::int64_t> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[static_cast<std::size_t>(order[k])] = static_cast<std::int64_t>(k);
    std::vector<std::pair<std::int64_t, std::int32_t>> keys;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::int32_t v = order[k];
        std::int64_t first = -1;
        if (p.sign[static_cast<std::size_t>(v)] < 0)
            for (const std::int32_t u : p.neighbours(v)) {
                const auto n = static_cast<std::size_t>(u);
                if (p.sign[n] > 0 && (first < 0 || position[n] < first)) first = position[n];
            }
        const auto own = static_cast<std::int64_t>(k);
        keys.emplace_back(first > own ? 2 * first + 1 : 2 * own, v);
    }
    std::stable_sort(keys.begin(), keys.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Order placed;
    for (const auto& [key, v] : keys) placed.push_back(v);
    return placed;
}

/// Compute the minimum degree order in scalars by sets: closed neighbourhoods; nodes with equal
/// ones are merged into the first.
Order least_degree_first(const Pattern& p) {
    const std::size_t n = p.size.size();
    std::size_t scalars = 0;
    for (const std::int8_t size : p.size) scalars += static_cast<std::size_t>(size);
    auto weight = [&](const auto& nodes) {
        std::size_t sum = 0;
        for (const int v : nodes)
            sum += static_cast<std::size_t>(p.size[static_cast<std::size_t>(v)]);
        return sum;
    };
    std::vector<std::set<int>> closed(n);
    std::vector<Order> twins(n);
    std::vector<std::list<int>> by_degree(scalars + 1);
    std::vector<bool> head(n, true);
    auto insert = [&](int v) {
        const auto i = static_cast<std::size_t>(v);
        by_degree[weight(closed[i]) - weight(twins[i])].push_front(v);
    };
    for (int v = p.nodes(); v-- > 0;) {
        const auto i = static_cast<std::size_t>(v);
        closed[i] = {v};
        closed[i].insert(p.neighbours(v).begin(), p.neighbours(v).end());
        twins[i] = {v};
        insert(v);
    }
    Order order;
    auto finish = [&](int v) {
        for (const int u : twins[static_cast<std::size_t>(v)]) {
            order.push_back(u);
            for (std::set<int>& s : closed) s.erase(u);
        }
        head[static_cast<std::size_t>(v)] = false;
    };
    while (order.size() < n) {
        const auto least = std::find_if(by_degree.begin(), by_degree.end(),
                                        [](const auto& list) { return !list.empty(); });
        const int pivot = least->front();
        least->pop_front();
        const std::set<int> own = closed[static_cast<std::size_t>(pivot)];
        finish(pivot);
        Order touched;
        std::set<int> clique;
        for (const int u : own)
            if (std::find(order.begin(), order.end(), u) == order.end()) {
                clique.insert(u);
                if (head[static_cast<std::size_t>(u)]) touched.push_back(u);
            }
        for (const int u : touched) {
            for (auto& list : by_degree) list.remove(u);
            closed[static_cast<std::size_t>(u)].insert(clique.begin(), clique.end());
        }
        Order gone, kept;
        for (const int u : touched)
            (closed[static_cast<std::size_t>(u)] == clique ? gone : kept).push_back(u);
        for (const int u : gone) finish(u);
        for (const int u : kept)
            for (const int v : kept) {
                const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
                if (u >= v || !head[i] || !head[j] || closed[i] != closed[j]) continue;
                twins[i].insert(twins[i].end(), twins[j].begin(), twins[j].end());
                head[j] = false;
            }
        for (std::size_t k = kept.size(); k-- > 0;)
            if (head[static_cast<std::size_t>(kept[k])]) insert(kept[k]);
    }
    return with_rows_placed(p, order);
}

Order order_of_the_library(const Pattern& p) {
    Order order(p.size.size());
    if (order.empty()) return order;
    double control[AMD_CONTROL];
    amd_defaults(control);
    control[AMD_DENSE] = 100.0;
    std::vector<std::int32_t> adjacent = p.adjacent;
    adjacent.push_back(-1);  // never read: gives an empty list an address
    EXPECT_EQ(amd_order(p.nodes(), p.start.data(), adjacent.data(), order.data(), control, nullptr),
              AMD_OK);
    return with_rows_placed(p, order);
}

/// Plan the graph that chains leave, as a list of edges: those of the pattern, and all pairs of
/// each boundary.
Order long_plan(const Pattern& p, const factor::Chains& chains) {
    std::vector<std::int32_t> chain_of(p.size.size(), -1), rest_of(p.size.size(), -1), from, to;
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[static_cast<std::size_t>(c)];
             u < chains.begin[static_cast<std::size_t>(c) + 1]; ++u)
            for (const std::int32_t v : chains.unit(u)) chain_of[static_cast<std::size_t>(v)] = c;
    Order rest;
    std::vector<std::int8_t> size, sign;
    for (std::size_t v = 0; v < p.size.size(); ++v) {
        if (chain_of[v] >= 0) continue;
        rest_of[v] = static_cast<std::int32_t>(rest.size());
        rest.push_back(static_cast<std::int32_t>(v));
        size.push_back(p.size[v]);
        sign.push_back(p.sign[v]);
    }
    std::vector<Order> boundary(static_cast<std::size_t>(chains.count()));
    for (int v = 0; v < p.nodes(); ++v)
        for (const std::int32_t u : p.neighbours(v)) {
            const std::int32_t chain = chain_of[static_cast<std::size_t>(v)],
                               end = rest_of[static_cast<std::size_t>(u)];
            if (end < 0) continue;
            if (chain >= 0) {
                boundary[static_cast<std::size_t>(chain)].push_back(end);
            } else {
                from.push_back(rest_of[static_cast<std::size_t>(v)]);
                to.push_back(end);
            }
        }
    for (const Order& nodes : boundary)
        for (const std::int32_t a : nodes)
            for (const std::int32_t b : nodes) {
                from.push_back(a);
                to.push_back(b);
            }
    Order order = chains.nodes;
    for (const std::int32_t k : least_degree_first(factor::make_pattern(size, sign, from, to)))
        order.push_back(rest[static_cast<std::size_t>(k)]);
    return order;
}

int trials() { return by_tier(kSanitized ? 40 : 100, kSanitized ? 40 : 400, 4000); }

/// Use one orderer for all: it keeps no data of one pattern for the next.
TEST(Ordering, IsThatOfTheLibrary) {
    Random random(first_seed(1));
    factor::Orderer orderer;
    int moved = 0;
    const int most = trials();
    for (int trial = 0; trial < most; ++trial) {
        const Pattern p = draw(random);
        Order order;
        orderer.order_by_amd(p, order);
        ASSERT_EQ(order, order_of_the_library(p)) << trial;
        random.shuffle(order);
        const Order expected = with_rows_placed(p, order);
        moved += order != expected ? 1 : 0;
        orderer.place_rows(p, order);
        ASSERT_EQ(order, expected) << trial;
    }
    EXPECT_GT(moved, most / 10);
}

/// Rows of one, two and more vectors; nodes of many neighbours, which have twins.
TEST(Ordering, HasTheLeastDegreeFirst) {
    Random random(first_seed(5));
    factor::Orderer orderer;
    Order order;
    const int most = trials();
    for (int trial = 0; trial < most; ++trial) {
        const Pattern p = draw(random);
        orderer.order(p, order);
        ASSERT_EQ(order, least_degree_first(p)) << trial;
    }
    for (const int nodes : {511, 512, 513, 1100, 1500, factor::MinimumDegree::kMaximum}) {
        if (kSanitized && nodes > 600) continue;
        std::vector<std::int32_t> from, to;
        for (int v = 1; v < nodes; ++v) {
            from.push_back(v);
            to.push_back(v - 1);
            if (!random.chance(0.3)) continue;
            from.push_back(v);
            to.push_back(random.chance(0.2) ? random.integer(0, 3)
                                            : std::max(0, v - random.integer(2, 20)));
        }
        const auto n = static_cast<std::size_t>(nodes);
        const Pattern p = factor::make_pattern(std::vector<std::int8_t>(n, 3),
                                               std::vector<std::int8_t>(n, 1), from, to);
        orderer.order(p, order);
        ASSERT_EQ(order, least_degree_first(p)) << nodes;
    }
    const Pattern large =
        factor::make_pattern(std::vector<std::int8_t>(factor::MinimumDegree::kMaximum + 1, 3),
                             std::vector<std::int8_t>(factor::MinimumDegree::kMaximum + 1, 1),
                             std::vector<std::int32_t>{5}, std::vector<std::int32_t>{7});
    orderer.order(large, order);
    ASSERT_EQ(order, order_of_the_library(large));
}

TEST(Ordering, OfWhatChainsLeaveHasTheirBoundariesAsCliques) {
    Random random(first_seed(2));
    factor::Orderer orderer;
    int with_chains = 0;
    const int most = trials();
    for (int trial = 0; trial < most; ++trial) {
        const Pattern p = draw(random);
        Order order;
        factor::Chains chains;
        orderer.plan(p, order, chains);
        ASSERT_EQ(chains, factor::find_chains(p)) << trial;
        ASSERT_EQ(order, long_plan(p, chains)) << trial;
        with_chains += chains.count() > 0 ? 1 : 0;
    }
    EXPECT_GT(with_chains, most / 8);
}

/// Compute a postorder that keeps the sequence of children.
Order long_postorder(const factor::Columns& columns, const Order& order) {
    std::vector<Order> children(order.size() + 1);
    for (const std::int32_t v : order) {
        const std::int32_t up = columns.parent(v);
        children[up < 0 ? order.size() : static_cast<std::size_t>(up)].push_back(v);
    }
    Order post;
    auto walk = [&](auto& self, std::size_t node) -> void {
        for (const std::int32_t c : children[node]) {
            self(self, static_cast<std::size_t>(c));
            post.push_back(c);
        }
    };
    walk(walk, order.size());
    return post;
}

/// Columns by merging sets, one after another.
TEST(Ordering, ColumnsAndPostorderAreThoseOfTheDefinition) {
    Random random(first_seed(3));
    factor::Columns columns;
    factor::TreeBuilder tree;
    const int most = trials();
    for (int trial = 0; trial < most; ++trial) {
        const Pattern p = draw(random);
        Order order = factor::order_nodes(p);
        if (random.chance(0.3)) random.shuffle(order);
        const std::size_t n = order.size();
        Order position(n);
        for (std::size_t k = 0; k < n; ++k)
            position[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
        columns.build(p, order, position);
        std::vector<std::vector<bool>> below(n, std::vector<bool>(n, false));
        for (std::size_t k = 0; k < n; ++k) {
            for (const std::int32_t u : p.neighbours(order[k])) {
                const auto i = static_cast<std::size_t>(position[static_cast<std::size_t>(u)]);
                if (i > k) below[k][i] = true;
            }
            Order rows;
            std::int32_t scalars = 0;
            for (std::size_t i = k + 1; i < n; ++i) {
                if (!below[k][i]) continue;
                if (!rows.empty())
                    below[static_cast<std::size_t>(position[static_cast<std::size_t>(rows[0])])]
                         [i] = true;
                rows.push_back(order[i]);
                scalars += p.size[static_cast<std::size_t>(order[i])];
            }
            const auto found = columns.rows(order[k]);
            ASSERT_EQ(rows, Order(found.begin(), found.end())) << trial;
            ASSERT_EQ(columns.below(order[k]), scalars);
            ASSERT_EQ(columns.parent(order[k]), rows.empty() ? -1 : rows[0]);
        }
        const Order post = long_postorder(columns, order);
        tree.postorder(columns, order, position);
        ASSERT_EQ(order, post) << trial;
        for (std::size_t k = 0; k < n; ++k)
            ASSERT_EQ(position[static_cast<std::size_t>(order[k])], static_cast<std::int32_t>(k));
    }
}

/// A used analysis keeps no data of the earlier pattern.
TEST(Ordering, PlansAgainAsIfForTheFirstTime) {
    Random random(first_seed(4));
    factor::Analysis used;
    used.plan(Pattern{});  // pattern of a world without moving bodies
    EXPECT_TRUE(used.symbolic().order.empty());
    const int most = trials() / 2;
    for (int trial = 0; trial < most; ++trial) {
        const Pattern p = draw(random);
        used.plan(p);
        ASSERT_TRUE(used.symbolic() == factor::analyse(p, factor::plan_elimination(p))) << trial;
    }
}

}  // namespace
}  // namespace hawser::test
