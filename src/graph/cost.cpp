// SPDX-License-Identifier: Apache-2.0
#include "graph/cost.h"

#include <algorithm>
#include <utility>

namespace hawser::graph {
namespace {

/// Divisor of n_b² s³ in the flops of a node; fitted, see docs/partition.md.
constexpr std::int64_t kStarPart = 8;  // n_b² has weight 1/8
/// Limits of the edges and loops counted at a hub: its neighbours are eliminated before the hub.
constexpr std::int32_t kMaxEdges = 16, kMaxLoops = 8;

}  // namespace

/// Search breadth first from the root. The loop has no branches, because a CPU cannot predict if a
/// neighbour is new. Only near neighbours are followed, because far neighbours are reached through
/// them.
void Cost::search(const Neighbours& neighbours, std::int32_t root) {
    const std::int32_t label = islands();
    std::int32_t *line = order.data(), *parent = parent_.data(), *of = island.data();
    const std::int32_t *start = neighbours.start.data(), *middle = neighbours.middle.data();
    const std::int32_t* adjacent = neighbours.adjacent.data();
    std::int32_t next = found_, tail = found_;
    of[root] = label;
    line[tail] = root;
    parent[tail] = tail;
    ++tail;
    for (; next < tail; ++next) {
        const std::int32_t v = line[next], end = middle[v];
        for (std::int32_t k = start[v]; k < end; ++k) {
            const std::int32_t u = adjacent[k];
            line[tail] = u;
            parent[tail] = next;
            tail += of[u] < 0 ? 1 : 0;
            of[u] = label;
        }
    }
    found_ = tail;
    begin.push_back(tail);
}

/// Search all islands from roots. Nodes with many edges are used as roots first, so that each
/// search starts near the heaviest node of its island.
void Cost::search_all(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    island.assign(n, -1);
    parent_.resize(n + 1);
    order.resize(n + 1);  // one spare slot for writes that are not kept
    begin.assign(1, 0);
    found_ = 0;
    std::int32_t most = 0, moving = 0;
    for (std::size_t v = 0; v < n; ++v) {
        most = std::max(most, graph.size[v] > 0 ? neighbours.edges[v] : 0);
        moving += graph.size[v] > 0 ? 1 : 0;
    }
    for (const std::int32_t least : {most, (most + 1) / 2, (most + 3) / 4, 0})
        for (std::size_t v = 0; v < n && found_ < moving; ++v)
            if (graph.size[v] > 0 && island[v] < 0 && neighbours.edges[v] >= least)
                search(neighbours, static_cast<std::int32_t>(v));
    order.resize(at(moving));
}

std::int32_t Cost::common_ancestor(std::int32_t u, std::int32_t v) const noexcept {
    const std::int32_t *depth = depth_.data(), *jump = jump_.data(), *parent = parent_.data();
    if (depth[u] < depth[v]) std::swap(u, v);
    while (depth[u] > depth[v]) u = depth[jump[u]] >= depth[v] ? jump[u] : parent[u];
    while (u != v) {
        const bool far = jump[u] != jump[v];
        u = far ? jump[u] : parent[u];
        v = far ? jump[v] : parent[v];
    }
    return u;
}

/// Compute depths and jump pointers by rank, and list the edges outside the spanning tree, which
/// close loops.
void Cost::find_loops(const Neighbours& neighbours) {
    const auto count = static_cast<std::int32_t>(order.size());
    jump_.resize(order.size());
    depth_.resize(order.size());
    rank_.resize(island.size());
    std::int32_t *depth = depth_.data(), *jump = jump_.data(), *rank = rank_.data();
    const std::int32_t *parent = parent_.data(), *line = order.data();
    for (std::int32_t k = 0; k < count; ++k) {
        rank[line[k]] = k;
        const std::int32_t up = parent[k];
        if (up == k) {
            depth[k] = 0;
            jump[k] = k;
            continue;
        }
        const std::int32_t j = jump[up], height = depth[j];
        depth[k] = depth[up] + 1;
        jump[k] = depth[up] - height == height - depth[jump[j]] ? jump[j] : up;
    }
    const std::span<const Pair> pairs = neighbours.near_pairs();
    if (loop_.size() <= pairs.size()) loop_.resize(pairs.size() + 1);
    Loop* loop = loop_.data();
    std::size_t found = 0;
    for (const Pair p : pairs) {
        const std::int32_t a = rank[p.a], b = rank[p.b];
        loop[found] = {a, b};
        found += static_cast<std::size_t>((parent[a] != b) & (parent[b] != a));
    }
    loop_count_ = found;
}

/// Count the loops of the graph that pass through each node. Each edge outside the spanning tree
/// closes one loop: it adds 1 at both of its ends, and subtracts 1 at their lowest common ancestor
/// and at the parent of that node. Sums over subtrees then give the counts.
void Cost::close_loops() noexcept {
    through_.assign(order.size(), 0);
    for (std::size_t i = 0; i < loop_count_; ++i) {
        const Loop l = loop_[i];
        const std::int32_t top = common_ancestor(l.u, l.v);
        ++through_[at(l.u)];
        ++through_[at(l.v)];
        --through_[at(top)];
        if (parent_[at(top)] != top) --through_[at(parent_[at(top)])];
    }
    for (auto k = static_cast<std::int32_t>(order.size()); k-- > 0;) {
        if (parent_[at(k)] != k) through_[at(parent_[at(k)])] += through_[at(k)];
        loops[at(order[at(k)])] = through_[at(k)];
    }
}

void Cost::build(const Hypergraph& graph, const Neighbours& neighbours) {
    search_all(graph, neighbours);
    loops.assign(graph.size.size(), 0);
    find_loops(neighbours);
    through_.reserve(order.size());  // close_loops() does not throw
    close_loops();
    paper.resize(at(islands()));
    for (std::int32_t i = 0; i < islands(); ++i) {
        std::int64_t sum = 0;
        for (std::int32_t k = begin[at(i)]; k < begin[at(i) + 1]; ++k) {
            const std::size_t v = at(order[at(k)]);
            const std::int64_t edges = neighbours.edges[v];
            sum += edges * edges + loops[v];
        }
        paper[at(i)] = sum;
    }
    if (!graph.cost.empty()) {
        copy_costs(graph);
        return;
    }
    node.assign(graph.size.size(), 0);
    for (const std::int32_t v : order) {
        const std::int64_t edges = std::min(neighbours.edges[at(v)], kMaxEdges);
        const std::int64_t through = std::min(loops[at(v)], kMaxLoops), s = graph.size[at(v)];
        node[at(v)] = s * s * s * (7 + 12 * through + 3 * edges * edges / kStarPart) / 3;
    }
}

void Cost::copy_costs(const Hypergraph& graph) {
    node.assign(graph.size.size(), 0);
    for (const std::int32_t v : order) node[at(v)] = graph.cost[at(v)];
}

void Cost::find_islands(const Hypergraph& graph, const Neighbours& neighbours) {
    search_all(graph, neighbours);
    loops.clear();
    paper.clear();
    copy_costs(graph);
}

}  // namespace hawser::graph
