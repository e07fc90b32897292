// SPDX-License-Identifier: Apache-2.0
#include "graph/neighbours.h"

namespace hawser::graph {

/// Add each pair of moving members of an interaction to the lists of neighbours. Near neighbours
/// are written from the front of a node's range, far neighbours from its back.
void Neighbours::link_all(std::span<const std::int32_t> members) {
    for (std::size_t i = 0; i < members.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::int32_t a = members[i], b = members[j];
            if (a == b) continue;
            const bool near = i - j == 1;
            adjacent[at(near ? end[at(a)]++ : --tail_[at(a)])] = b;
            adjacent[at(near ? end[at(b)]++ : --tail_[at(b)])] = a;
        }
}

void Neighbours::fill(const Hypergraph& graph) {
    const std::int32_t count = graph.edges();
    const std::int32_t* begin = graph.member_begin.data();
    const std::int32_t* all = graph.members.data();
    const std::uint8_t* size = graph.size.data();
    std::int32_t *to = adjacent.data(), *head = end.data(), *tail = tail_.data();
    for (std::int32_t e = 0; e < count; ++e) {
        const std::int32_t* m = all + begin[e];
        const std::int32_t members = begin[e + 1] - begin[e];
        // Nearly all edges join two bodies, or three if they bend.
        if (members == 2) {
            const std::int32_t a = m[0], b = m[1];
            if (size[a] == 0 || size[b] == 0 || a == b) continue;
            to[head[a]++] = b;
            to[head[b]++] = a;
            continue;
        }
        if (members == 3 && size[m[0]] != 0 && size[m[1]] != 0 && size[m[2]] != 0 && m[0] != m[1] &&
            m[1] != m[2] && m[0] != m[2]) {
            const std::int32_t a = m[0], b = m[1], c = m[2];
            to[head[a]++] = b;
            to[head[b]++] = a;
            to[head[b]++] = c;
            to[head[c]++] = b;
            to[--tail[a]] = c;
            to[--tail[c]] = a;
            continue;
        }
        moving_.clear();
        for (std::int32_t i = 0; i < members; ++i)
            if (size[m[i]] != 0) moving_.push_back(m[i]);
        link_all(moving_);
    }
}

void Neighbours::build(const Hypergraph& graph) {
    const std::size_t n = graph.size.size();
    count_.assign(n, 0);
    const std::int32_t count = graph.edges();
    for (std::int32_t e = 0; e < count; ++e) {
        const auto members = graph.edge(e);
        const std::int64_t more = (static_cast<std::int64_t>(members.size() - 1) << 32) + 1;
        for (const std::int32_t b : members) count_[at(b)] += more;
    }
    start.resize(n + 1);
    end.resize(n);
    middle.resize(n);
    tail_.resize(n);
    edges.resize(n);
    start[0] = 0;
    for (std::size_t b = 0; b < n; ++b) {
        end[b] = start[b];
        tail_[b] = start[b + 1] = start[b] + static_cast<std::int32_t>(count_[b] >> 32);
        edges[b] = static_cast<std::int32_t>(count_[b]);
    }
    adjacent.resize(at(start[n]));
    fill(graph);
    // Remove duplicates. If a neighbour is both near and far, the near entry stays. The loop has no
    // branches, because a CPU cannot predict duplicates. Ranges are compacted, so that consecutive
    // nodes have contiguous ranges.
    mark_.assign(n, -1);
    std::int32_t *all = adjacent.data(), *mark = mark_.data();
    std::int32_t to = 0;
    for (std::size_t b = 0; b < n; ++b) {
        const std::int32_t from = start[b];
        const auto id = static_cast<std::int32_t>(b);
        const auto keep = [&](std::int32_t k) {
            const std::int32_t u = all[k];
            all[to] = u;
            to += mark[u] != id ? 1 : 0;
            mark[u] = id;
        };
        start[b] = to;
        for (std::int32_t k = from; k < end[b]; ++k) keep(k);
        middle[b] = to;
        for (std::int32_t k = tail_[b]; k < start[b + 1]; ++k) keep(k);
        end[b] = to;
    }
    start[n] = to;
    list_pairs();
}

void Neighbours::list_pairs() {
    if (pair_.size() <= adjacent.size()) pair_.resize(adjacent.size() + 1);
    const std::int32_t* all = adjacent.data();
    Pair* pair = pair_.data();
    std::size_t found = 0;
    const auto take = [&](std::int32_t a, std::int32_t from, std::int32_t to) {
        for (std::int32_t k = from; k < to; ++k) {
            pair[found] = {a, all[k]};
            found += a < all[k] ? 1 : 0;
        }
    };
    const auto n = static_cast<std::int32_t>(end.size());
    for (std::int32_t b = 0; b < n; ++b) take(b, start[at(b)], middle[at(b)]);
    near_pairs_ = found;
    for (std::int32_t b = 0; b < n; ++b) take(b, middle[at(b)], end[at(b)]);
    pairs_ = found;
}

}  // namespace hawser::graph
