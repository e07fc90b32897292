// SPDX-License-Identifier: Apache-2.0
#include "graph/wires.h"

#include <cstdlib>

namespace hawser::graph {

void Units::find_ends(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    hub.resize(n);
    like_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
        const auto id = static_cast<std::int32_t>(v);
        hub[v] = neighbours.degree(id) > kHubDegree;
        like_[v] = graph.size[v] == 0 || hub[v] ? -1 : 0;
    }
    for (std::size_t v = 0; v < n; ++v) {
        const auto all = neighbours.of(static_cast<std::int32_t>(v));
        if (like_[v] < 0 || all.size() <= 2 * kReach) continue;
        std::int32_t degree = 0;
        for (const Neighbour u : all) degree += hub[at(u.node())] ? 0 : 1;
        if (degree > 2 * kReach) like_[v] = -1;
    }
    for (std::size_t v = 0; v < n; ++v) {
        if (like_[v] < 0) continue;
        std::int8_t degree = 0;
        for (const Neighbour u : neighbours.of(static_cast<std::int32_t>(v)))
            degree = static_cast<std::int8_t>(degree + (like_[at(u.node())] >= 0 ? 1 : 0));
        like_[v] = degree;
    }
}

/// The one unvisited neighbour that may be in a wire; −1: none, −2: several.
std::int32_t Units::next(const Neighbours& neighbours, std::int32_t v) const noexcept {
    std::int32_t found = -1;
    for (const Neighbour u : neighbours.of(v)) {
        if (like_[at(u.node())] < 0 || place_[at(u.node())] >= 0) continue;
        if (found != -1) return -2;
        found = u.node();
    }
    return found;
}

void Units::walk(const Hypergraph& graph, const Neighbours& neighbours, std::int32_t end) {
    std::int32_t before = -1, now = end;
    while (now >= 0) {
        place_[at(now)] = static_cast<std::int32_t>(walked_.size());
        walked_.push_back(now);
        // Where bending couples a node to the next but one, the node before has one neighbour left,
        // and that is the next. At an end it is the one with fewer neighbours.
        std::int32_t to = before < 0 ? -1 : next(neighbours, before);
        if (to == -1) to = next(neighbours, now);
        if (to == -2 && before < 0) {
            std::int8_t least = 127;
            for (const Neighbour u : neighbours.of(now)) {
                const std::int32_t w = u.node();
                if (!u.near() || like_[at(w)] < 0 || place_[at(w)] >= 0) continue;
                if (like_[at(w)] < least) to = w;
                least = like_[at(w)] < least ? like_[at(w)] : least;
            }
        }
        before = now;
        now = to;
        if (now < 0 || graph.size[at(now)] != graph.size[at(before)]) return;
        bool joined = false;
        for (const Neighbour u : neighbours.of(before)) joined |= u.node() == now;
        if (!joined) return;
    }
}

void Units::close() noexcept {
    const auto size = static_cast<std::int32_t>(nodes.size());
    if (size - begin.back() < kShortestWire)
        nodes.resize(at(begin.back()));
    else
        begin.push_back(size);
}

/// Nodes beside another wire, or beside their own farther away than kReach, are taken out.
void Units::keep_whole(const Neighbours& neighbours) {
    brief_.resize(walked_.size());
    for (std::size_t w = 0; w + 1 < from_.size(); ++w)
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k)
            brief_[at(k)] = from_[w + 1] - from_[w] < kShortestWire;
    for (std::size_t w = 0; w + 1 < from_.size(); ++w) {
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k) {
            const std::int32_t v = walked_[at(k)];
            bool apart = true;
            for (const Neighbour u : neighbours.of(v)) {
                const std::int32_t p = place_[at(u.node())];
                const bool mine = p >= from_[w] && p < from_[w + 1] && std::abs(p - k) <= kReach;
                apart &= mine || p < 0 || brief_[at(p)];
            }
            if (apart)
                nodes.push_back(v);
            else
                close();
        }
        close();
    }
}

void Units::build(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    find_ends(graph, neighbours);
    place_.assign(n, -1);
    walked_.clear();
    walked_.reserve(n);
    from_.assign(1, 0);
    // Ends first: one neighbour, two where wires bend; what is left then are rings.
    for (std::int8_t most = 0; most <= 2 * kReach; ++most)
        for (std::size_t v = 0; v < n; ++v) {
            if (like_[v] < 0 || like_[v] > most || place_[v] >= 0) continue;
            walk(graph, neighbours, static_cast<std::int32_t>(v));
            from_.push_back(static_cast<std::int32_t>(walked_.size()));
        }
    nodes.clear();
    nodes.reserve(n);
    begin.assign(1, 0);
    begin.reserve(n + 1);
    keep_whole(neighbours);
    wires = count();
    unit.assign(n, -1);
    for (std::int32_t w = 0; w < wires; ++w)
        for (const std::int32_t v : nodes_of(w)) unit[at(v)] = w;
    for (std::size_t v = 0; v < n; ++v) {
        if (graph.size[v] == 0 || unit[v] >= 0) continue;
        unit[v] = count();
        nodes.push_back(static_cast<std::int32_t>(v));
        begin.push_back(static_cast<std::int32_t>(nodes.size()));
    }
}

}  // namespace hawser::graph
