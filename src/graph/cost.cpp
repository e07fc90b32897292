// SPDX-License-Identifier: Apache-2.0
#include "graph/cost.h"

#include <algorithm>
#include <utility>

namespace hawser::graph {
namespace {

/// Share of n_b² s³ in the flops of a node; fitted, see docs/partition.md.
constexpr std::int64_t kStarPart = 8;  // n_b² counts an eighth

}  // namespace

void Cost::search(const Neighbours& neighbours, std::int32_t root) {
    const std::int32_t label = islands();
    std::size_t next = order.size();
    auto reach = [&](std::int32_t v, std::int32_t from) {
        island[at(v)] = label;
        parent_[at(v)] = from;
        depth_[at(v)] = depth_[at(from)] + (v == from ? 0 : 1);
        const std::int32_t j = jump_[at(from)];
        const bool skip =
            depth_[at(from)] - depth_[at(j)] == depth_[at(j)] - depth_[at(jump_[at(j)])];
        jump_[at(v)] = skip ? jump_[at(j)] : from;
        order.push_back(v);
    };
    depth_[at(root)] = 0;
    jump_[at(root)] = root;
    reach(root, root);
    // Far neighbours are reached through near ones.
    for (; next < order.size(); ++next) {
        const std::int32_t v = order[next];
        scanned_[at(v)] = 1;
        for (const Neighbour n : neighbours.of(v)) {
            if (!n.near()) continue;
            const std::int32_t u = n.node();
            if (island[at(u)] < 0)
                reach(u, v);
            else if (scanned_[at(u)] && u != parent_[at(v)])
                close_loop(u, v);
        }
    }
}

std::int32_t Cost::meet(std::int32_t u, std::int32_t v) const noexcept {
    if (depth_[at(u)] < depth_[at(v)]) std::swap(u, v);
    while (depth_[at(u)] > depth_[at(v)])
        u = depth_[at(jump_[at(u)])] >= depth_[at(v)] ? jump_[at(u)] : parent_[at(u)];
    while (u != v) {
        const bool far = jump_[at(u)] != jump_[at(v)];
        u = far ? jump_[at(u)] : parent_[at(u)];
        v = far ? jump_[at(v)] : parent_[at(v)];
    }
    return u;
}

/// One at both ends of a loop, taken back above where they meet; sums over subtrees follow.
void Cost::close_loop(std::int32_t u, std::int32_t v) noexcept {
    const std::int32_t top = meet(u, v);
    ++loops[at(u)];
    ++loops[at(v)];
    --loops[at(top)];
    if (parent_[at(top)] != top) --loops[at(parent_[at(top)])];
}

void Cost::sum_loops() noexcept {
    for (std::size_t k = order.size(); k-- > 0;) {
        const std::int32_t v = order[k];
        if (parent_[at(v)] != v) loops[at(parent_[at(v)])] += loops[at(v)];
    }
}

void Cost::build(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    island.assign(n, -1);
    loops.assign(n, 0);
    node.assign(n, 0);
    scanned_.assign(n, 0);
    parent_.resize(n);
    jump_.resize(n);
    depth_.resize(n);
    order.clear();
    order.reserve(n);
    begin.assign(1, 0);
    // The heaviest node of each island comes first: try wide ones with many edges before others.
    std::int32_t most = 0;
    for (std::size_t v = 0; v < n; ++v)
        if (graph.size[v] > 0) most = std::max(most, neighbours.edges[v]);
    for (const std::int32_t least : {most, (most + 1) / 2, (most + 3) / 4, 0})
        for (std::size_t v = 0; v < n; ++v)
            if (graph.size[v] > 0 && island[v] < 0 && neighbours.edges[v] >= least) {
                search(neighbours, static_cast<std::int32_t>(v));
                begin.push_back(static_cast<std::int32_t>(order.size()));
            }
    sum_loops();
    paper.assign(at(islands()), 0);
    for (const std::int32_t v : order) {
        const std::int64_t edges = neighbours.edges[at(v)], s = graph.size[at(v)];
        paper[at(island[at(v)])] += edges * edges + loops[at(v)];
        node[at(v)] = graph.cost.empty()
                          ? s * s * s * (7 + 12 * loops[at(v)] + 3 * edges * edges / kStarPart) / 3
                          : graph.cost[at(v)];
    }
}

}  // namespace hawser::graph
