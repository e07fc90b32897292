// SPDX-License-Identifier: Apache-2.0
#include "factor/body_graph.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace hawser::factor {
namespace {

constexpr std::int32_t kMaxWireNeighbours = 2;  ///< Most neighbours of a wire's body on each side.
constexpr std::int32_t kMinWireBodies = 6;      ///< Fewest bodies of a wire.
constexpr std::int32_t kMinHubDegree = 8;       ///< Nodes with more neighbours are hubs.
/// Number of degrees of bodies in wires: 0 to 4.
constexpr std::uint8_t kDegreeClasses = 2 * kMaxWireNeighbours + 1;

}  // namespace

BodyGraph WireFinder::graph(const Pattern& pattern) {
    const std::size_t n = pattern.size.size();
    if (std::find(pattern.sign.begin(), pattern.sign.end(), -1) == pattern.sign.end())
        return {pattern.start.data(), pattern.adjacent.data()};
    start_.resize(n + 1);
    start_[0] = 0;
    neighbours_.clear();
    mark_.assign(n, -1);
    for (std::size_t v = 0; v < n; ++v) {
        const auto id = static_cast<std::int32_t>(v);
        const auto first = static_cast<std::ptrdiff_t>(neighbours_.size());
        auto take = [&](std::int32_t u) {
            if (u == id || pattern.sign[at(u)] < 0 || mark_[at(u)] == id) return;
            mark_[at(u)] = id;
            neighbours_.push_back(u);
        };
        if (pattern.sign[v] > 0)
            for (const std::int32_t u : pattern.neighbours(id)) {
                take(u);
                if (pattern.sign[at(u)] < 0)
                    for (const std::int32_t w : pattern.neighbours(u)) take(w);
            }
        std::sort(neighbours_.begin() + first, neighbours_.end());
        start_[v + 1] = static_cast<std::int32_t>(neighbours_.size());
    }
    return {start_.data(), neighbours_.data()};
}

/// Compute prefix sums of the node values `of` over all neighbour lists. The sum over the
/// neighbours of one node is then a difference of two entries.
void WireFinder::compute_prefix_sums(const BodyGraph& graph, std::size_t nodes,
                                     const std::vector<std::uint8_t>& of) {
    const std::size_t edges = at(graph.start[nodes]);
    sum_.resize(edges + 1);
    sum_[0] = 0;
    std::int32_t sum = 0;
    for (std::size_t e = 0; e < edges; ++e) sum_[e + 1] = sum += of[at(graph.adjacent[e])];
}

/// Find the nodes that may belong to a wire: nodes with few neighbours, hubs not counted.
void WireFinder::find_wire_like(const Pattern& pattern, const BodyGraph& graph) {
    const std::size_t n = pattern.size.size();
    hub_.resize(n);
    like_.resize(n);
    for (std::size_t v = 0; v < n; ++v)
        hub_[v] = graph.start[v + 1] - graph.start[v] > kMinHubDegree ? 1 : 0;
    compute_prefix_sums(graph, n, hub_);
    bool any_rows = false;
    for (std::size_t v = 0; v < n; ++v) {
        const std::int32_t begin = graph.start[v], end = graph.start[v + 1];
        const std::int32_t degree = end - begin - (sum_[at(end)] - sum_[at(begin)]);
        const int size = pattern.size[v];
        any_rows |= pattern.sign[v] < 0;
        like_[v] = static_cast<std::uint8_t>(pattern.sign[v] > 0) & (hub_[v] ^ 1U) &
                   static_cast<std::uint8_t>((size == 3) | (size == 6)) &
                   static_cast<std::uint8_t>(degree <= 2 * kMaxWireNeighbours);
    }
    if (!any_rows) return;
    // Exclude bodies beside rows that couple to rows (no mechanical system has such rows).
    for (std::size_t v = 0; v < n; ++v) {
        if (pattern.sign[v] > 0) continue;
        bool odd = false;
        for (const std::int32_t u : pattern.neighbours(static_cast<int>(v)))
            odd |= pattern.sign[at(u)] < 0;
        if (!odd) continue;
        for (const std::int32_t u : pattern.neighbours(static_cast<int>(v))) like_[at(u)] = 0;
    }
}

void WireFinder::sort_by_degree(const BodyGraph& graph) {
    const std::size_t n = like_.size();
    compute_prefix_sums(graph, n, like_);
    degree_.resize(n);
    std::int32_t cursor[kDegreeClasses + 1] = {};
    for (std::size_t v = 0; v < n; ++v) {
        const std::int32_t degree = sum_[at(graph.start[v + 1])] - sum_[at(graph.start[v])];
        // Sort all other nodes behind the candidates.
        degree_[v] = like_[v] != 0 ? static_cast<std::uint8_t>(degree) : kDegreeClasses;
        ++cursor[degree_[v]];
    }
    std::exclusive_scan(cursor, cursor + kDegreeClasses + 1, cursor, 0);
    const auto count = static_cast<std::size_t>(cursor[kDegreeClasses]);
    candidates_.resize(n);
    for (std::size_t v = 0; v < n; ++v)
        candidates_[at(cursor[degree_[v]]++)] = static_cast<std::int32_t>(v);
    candidates_.resize(count);
}

/// Return the only unvisited neighbour of a node, −1: none, −2: several.
/// @param smallest  Unvisited neighbour with the smallest degree.
std::int32_t WireFinder::only_unvisited_neighbour(const BodyGraph& graph, std::int32_t node,
                                                  std::int32_t& smallest) const noexcept {
    std::int32_t found = -1;
    smallest = -1;
    for (const std::int32_t u : graph.neighbours(node)) {
        if (!like_[at(u)]) continue;
        found = found == -1 ? u : -2;
        if (smallest < 0 || degree_[at(u)] < degree_[at(smallest)]) smallest = u;
    }
    return found;
}

/// Return the next body of a wire after `now`. If three-body bending couples i to i + 2, it is the
/// unvisited neighbour of `before`. Otherwise it is the unvisited neighbour of `now`.
std::int32_t WireFinder::next_wire_body(const Pattern& pattern, const BodyGraph& graph,
                                        std::int32_t before, std::int32_t now) const noexcept {
    std::int32_t smallest = -1;
    std::int32_t next = before < 0 ? -1 : only_unvisited_neighbour(graph, before, smallest);
    if (next == -1) {
        next = only_unvisited_neighbour(graph, now, smallest);
        if (next == -2 && before < 0) next = smallest;
    }
    if (next < 0 || pattern.size[at(next)] != pattern.size[at(now)]) return -1;
    const auto near = graph.neighbours(now);
    return std::find(near.begin(), near.end(), next) != near.end() ? next : -1;
}

/// Walk along a wire from `seed`, one of its ends, to the other end.
void WireFinder::walk_wire(const Pattern& pattern, const BodyGraph& graph, std::int32_t seed) {
    std::int32_t before = -1, now = seed;
    while (now >= 0) {
        like_[at(now)] = 0;
        walked_bodies_.push_back(now);
        const std::int32_t next = next_wire_body(pattern, graph, before, now);
        before = now;
        now = next;
    }
}

/// Remove each body with a neighbour in another wire, or in its own wire at a distance above
/// kMaxWireNeighbours. Also remove enough bodies behind it that the remaining parts of the wire are
/// not coupled.
void WireFinder::remove_touching_bodies(const BodyGraph& graph) {
    std::vector<std::int32_t>& place = wires_.place;
    for (std::size_t k = 0; k < walked_bodies_.size(); ++k)
        place[at(walked_bodies_[k])] = static_cast<std::int32_t>(k);
    wires_.bodies.clear();
    wires_.begin.assign(1, 0);
    auto close = [&] {
        if (static_cast<std::int32_t>(wires_.bodies.size()) - wires_.begin.back() < kMinWireBodies)
            wires_.bodies.resize(at(wires_.begin.back()));
        else
            wires_.begin.push_back(static_cast<std::int32_t>(wires_.bodies.size()));
    };
    for (std::size_t w = 0; w + 1 < walk_begin_.size(); ++w) {
        const std::int32_t begin = walk_begin_[w], end = walk_begin_[w + 1];
        std::int32_t skip = 0;
        for (std::int32_t k = begin; k < end; ++k) {
            const std::int32_t b = walked_bodies_[at(k)];
            bool isolated = true;
            for (const std::int32_t u : graph.neighbours(b)) {
                const std::int32_t p = place[at(u)];
                isolated &=
                    p < 0 || (p >= begin && p < end && std::abs(p - k) <= kMaxWireNeighbours);
            }
            if (!isolated) skip = kMaxWireNeighbours;
            if (skip > 0) {
                --skip;
                close();
            } else {
                wires_.bodies.push_back(b);
            }
        }
        close();
    }
    for (const std::int32_t b : walked_bodies_) place[at(b)] = -1;
    for (std::size_t k = 0; k < wires_.bodies.size(); ++k)
        place[at(wires_.bodies[k])] = static_cast<std::int32_t>(k);
}

const Wires& WireFinder::find(const Pattern& pattern, const BodyGraph& graph) {
    find_wire_like(pattern, graph);
    sort_by_degree(graph);
    walked_bodies_.clear();
    walk_begin_.assign(1, 0);
    // Start from the ends, by number of neighbours. The remaining wires are rings.
    for (const std::int32_t v : candidates_) {
        if (!like_[at(v)]) continue;
        walk_wire(pattern, graph, v);
        if (static_cast<std::int32_t>(walked_bodies_.size()) - walk_begin_.back() < kMinWireBodies)
            walked_bodies_.resize(at(walk_begin_.back()));
        else
            walk_begin_.push_back(static_cast<std::int32_t>(walked_bodies_.size()));
    }
    wires_.place.assign(like_.size(), -1);
    remove_touching_bodies(graph);
    return wires_;
}

std::size_t WireFinder::bytes() const noexcept {
    return base::bytes(start_) + base::bytes(neighbours_) + base::bytes(mark_) + base::bytes(hub_) +
           base::bytes(like_) + base::bytes(degree_) + base::bytes(candidates_) +
           base::bytes(sum_) + base::bytes(walked_bodies_) + base::bytes(walk_begin_) +
           base::bytes(wires_.bodies) + base::bytes(wires_.begin) + base::bytes(wires_.place);
}

}  // namespace hawser::factor
