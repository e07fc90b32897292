// SPDX-License-Identifier: Apache-2.0
#include "world/block_pattern.h"

#include "base/index.h"
#include "factor/ordering.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hawser {
namespace world {
namespace {

void check(const BlockPattern& p) {
    auto fail = [](const std::string& what) {
        throw std::invalid_argument("block pattern: " + what);
    };
    if (p.size.size() != p.sign.size()) fail("sizes and signs differ in number");
    const auto n = static_cast<std::int32_t>(p.size.size());
    for (std::size_t i = 0; i < p.size.size(); ++i) {
        if (p.size[i] < 1 || p.size[i] > factor::kMaxBlock)
            fail("node " + std::to_string(i) + " has a size that is not 1 to 6");
        if (p.sign[i] != 1 && p.sign[i] != -1)
            fail("node " + std::to_string(i) + " has a sign that is not 1 or -1");
    }
    for (std::size_t e = 0; e < p.edges.size(); ++e) {
        const BlockEdge& edge = p.edges[e];
        if (edge.row < 0 || edge.row >= n || edge.column < 0 || edge.column >= n ||
            edge.row == edge.column)
            fail("edge " + std::to_string(e) + " does not join two of the nodes");
    }
}

}  // namespace

factor::Pattern factor_pattern_of(const BlockPattern& p) {
    check(p);
    std::vector<std::int32_t> from, to;
    from.reserve(p.edges.size());
    to.reserve(p.edges.size());
    for (const BlockEdge& e : p.edges) {
        from.push_back(e.row);
        to.push_back(e.column);
    }
    factor::Pattern graph = factor::make_pattern(p.size, p.sign, from, to);
    if (graph.adjacent.size() != 2 * p.edges.size())
        throw std::invalid_argument("block pattern: two nodes are joined twice");
    return graph;
}

void check_order(const BlockPattern& p, std::span<const std::int32_t> order) {
    std::vector<bool> seen(p.size.size(), false);
    for (const std::int32_t node : order) {
        const bool known = node >= 0 && at(node) < seen.size();
        if (!known || seen[at(node)]) break;
        seen[at(node)] = true;
    }
    if (order.size() != seen.size() || std::find(seen.begin(), seen.end(), false) != seen.end())
        throw std::invalid_argument("elimination order: it must have each node once");
}

}  // namespace world

std::vector<std::int32_t> minimum_degree_order(const BlockPattern& pattern) {
    return factor::order_nodes(world::factor_pattern_of(pattern));
}

void rows_after_bodies(const BlockPattern& pattern, std::vector<std::int32_t>& order) {
    world::check_order(pattern, order);
    factor::place_rows_after_bodies(world::factor_pattern_of(pattern), order);
}

}  // namespace hawser
