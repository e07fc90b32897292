// SPDX-License-Identifier: Apache-2.0
#include "graph/bridges.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>

namespace hawser::graph {
namespace {

constexpr std::int32_t kNotVisited = -1;

}  // namespace

void LoopFinder::begin_visit(std::int32_t node, std::int32_t edge) {
    visit_time_[at(node)] = low_link_[at(node)] = time_++;
    path_.push_back({node, edge});
}

/// Visit every node reachable from the root, depth first. The search is not recursive, because
/// chains may have millions of nodes.
void LoopFinder::search(std::int32_t root) {
    begin_visit(root, -1);
    while (!path_.empty()) {
        const Visit top = path_.back();
        if (next_[at(top.node)] < begin_[at(top.node) + 1]) {
            const std::int32_t e = ends_[at(next_[at(top.node)]++)];
            const auto& [a, b] = edges_[at(e)];
            const std::int32_t other = a == top.node ? b : a;
            if (e == top.edge) continue;
            if (visit_time_[at(other)] == kNotVisited)
                begin_visit(other, e);
            else
                low_link_[at(top.node)] = std::min(low_link_[at(top.node)], visit_time_[at(other)]);
            continue;
        }
        path_.pop_back();
        if (path_.empty()) break;
        const std::int32_t above = path_.back().node;
        low_link_[at(above)] = std::min(low_link_[at(above)], low_link_[at(top.node)]);
        if (low_link_[at(top.node)] > visit_time_[at(above)]) on_loop_[at(top.edge)] = 0;
    }
}

std::span<const std::uint8_t> LoopFinder::find(
    std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges) {
    edges_ = edges;
    begin_.assign(at(nodes) + 1, 0);
    visit_time_.assign(at(nodes), kNotVisited);
    low_link_.assign(at(nodes), 0);
    on_loop_.assign(edges.size(), 1);
    time_ = 0;
    for (const auto& [a, b] : edges) {
        ++begin_[at(a) + 1];
        ++begin_[at(b) + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    ends_.resize(2 * edges.size());
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        ends_[at(next_[at(edges[e].first)]++)] = static_cast<std::int32_t>(e);
        ends_[at(next_[at(edges[e].second)]++)] = static_cast<std::int32_t>(e);
    }
    next_.assign(begin_.begin(), begin_.end() - 1);
    // Skip nodes without edges: they lie on no loop.
    for (std::int32_t root = 0; root < nodes; ++root)
        if (visit_time_[at(root)] == kNotVisited && begin_[at(root)] < begin_[at(root) + 1])
            search(root);
    return on_loop_;
}

std::size_t LoopFinder::bytes() const noexcept {
    using base::bytes;
    return bytes(begin_) + bytes(ends_) + bytes(next_) + bytes(visit_time_) + bytes(low_link_) +
           bytes(on_loop_) + bytes(path_);
}

std::vector<std::uint8_t> edges_on_loops(
    std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges) {
    LoopFinder finder;
    const std::span<const std::uint8_t> looped = finder.find(nodes, edges);
    return {looped.begin(), looped.end()};
}

}  // namespace hawser::graph
