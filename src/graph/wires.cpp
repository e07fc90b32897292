// SPDX-License-Identifier: Apache-2.0
#include "graph/wires.h"

#include <algorithm>

namespace hawser::graph {

void Units::find_ends(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    hub.resize(n);
    open_.resize(n);
    like_.assign(n, 0);
    bends_.assign(n, 0);
    std::uint8_t *is_hub = hub.data(), *bends = bends_.data();
    const std::int32_t *start = neighbours.start.data(), *end = neighbours.end.data();
    std::int32_t *open = open_.data(), *like = like_.data();
    // Hubs are few: what is beside them is counted from their side.
    for (std::size_t v = 0; v < n; ++v) {
        is_hub[v] = end[v] - start[v] > kHubDegree;
        if (is_hub[v] == 0) continue;
        for (std::int32_t k = start[v]; k < end[v]; ++k) ++like[neighbours.adjacent[at(k)]];
    }
    for (std::size_t v = 0; v < n; ++v) {
        open[v] =
            (graph.size[v] != 0) & (is_hub[v] == 0) & (end[v] - start[v] - like[v] <= 2 * kReach);
        like[v] = 0;
    }
    for (const Pair p : neighbours.pairs()) {
        like[p.a] += open[p.b];
        like[p.b] += open[p.a];
    }
    for (const Pair p : neighbours.near_pairs())
        bends[p.a] |= static_cast<std::uint8_t>(p.b - p.a == 1);
    for (const Pair p : neighbours.far_pairs())
        bends[p.a] |= static_cast<std::uint8_t>((p.b - p.a == 2) << 1);
    for (std::vector<std::int32_t>& list : end_) list.clear();
    for (std::size_t v = 0; v < n; ++v)
        if (open[v] != 0) end_[at(like[v])].push_back(static_cast<std::int32_t>(v));
}

/// The one unvisited neighbour that may be in a wire; −1: none, −2: several.
std::int32_t Units::next(const Neighbours& neighbours, std::int32_t v) const noexcept {
    std::int32_t count = 0, sum = 0;
    const std::int32_t* open = open_.data();
    for (const std::int32_t u : neighbours.of(v)) {
        count += open[u];
        sum += u & -open[u];
    }
    return count == 1 ? sum : count == 0 ? -1 : -2;
}

void Units::walk(const Hypergraph& graph, const Neighbours& neighbours, std::int32_t end) {
    std::int32_t before = -1, now = end;
    while (now >= 0) {
        place_[at(now)] = static_cast<std::int32_t>(walked_.size());
        open_[at(now)] = 0;
        walked_.push_back(now);
        // Where bending couples a node to the next but one, the node before has one neighbour left,
        // and that is the next. At an end it is the one with fewer neighbours.
        std::int32_t to = before < 0 ? -1 : next(neighbours, before);
        if (to == -1) to = next(neighbours, now);
        if (to == -2 && before < 0) {
            std::int32_t least = 127;
            for (const std::int32_t u : neighbours.near(now)) {
                if (open_[at(u)] == 0) continue;
                if (like_[at(u)] < least) to = u;
                least = std::min(least, like_[at(u)]);
            }
        }
        before = now;
        now = to;
        if (now < 0 || graph.size[at(now)] != graph.size[at(before)]) return;
        bool joined = false;
        for (const std::int32_t u : neighbours.of(before)) joined |= u == now;
        if (!joined) return;
    }
}

/// What is too short for a wire falls apart; the other gets its number.
void Units::close() noexcept {
    const auto size = static_cast<std::int32_t>(nodes.size());
    if (size - begin.back() < kShortestWire) {
        nodes.resize(at(begin.back()));
        return;
    }
    for (std::int32_t k = begin.back(); k < size; ++k) unit[at(nodes[at(k)])] = count();
    begin.push_back(size);
}

/// Nodes beside another wire, or beside their own farther away than kReach, are taken out.
void Units::keep_whole(const Neighbours& neighbours) {
    std::int32_t* place = place_.data();
    walk_.resize(walked_.size());
    for (std::size_t w = 0; w + 1 < from_.size(); ++w) {
        const bool brief = from_[w + 1] - from_[w] < kShortestWire;
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k) {
            walk_[at(k)] = static_cast<std::int32_t>(w);
            if (brief) place[walked_[at(k)]] = -1;
        }
    }
    apart_.assign(walked_.size() + 1, 1);  // the first one is for nodes in no sequence
    for (const Pair p : neighbours.pairs()) {
        const std::int32_t a = place[p.a], b = place[p.b];
        if ((a | b) < 0) continue;
        const bool mine = walk_[at(a)] == walk_[at(b)] && a - b <= kReach && b - a <= kReach;
        apart_[at(a)] &= mine ? 1 : 0;
        apart_[at(b)] &= mine ? 1 : 0;
    }
    for (std::size_t w = 0; w + 1 < from_.size(); ++w) {
        if (from_[w + 1] - from_[w] < kShortestWire) continue;
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k) {
            if (apart_[at(k)] != 0)
                nodes.push_back(walked_[at(k)]);
            else
                close();
        }
        close();
    }
}

/// All that is in no wire. Nodes that follow each other by number and bend together are links of
/// one, though something else touches them: lumps of a few. The others stand alone.
void Units::add_lumps(const Hypergraph& graph) {
    const auto n = static_cast<std::int32_t>(graph.size.size());
    std::int32_t last = -1, room = 0;  // node before in the unit, nodes that it may still take
    for (std::int32_t v = 0; v < n; ++v) {
        if (graph.size[at(v)] == 0 || unit[at(v)] >= 0) continue;
        // Bent with the next two, or with the next one and the one before.
        const bool joins = room > 0 && last == v - 1 && hub[at(v)] == 0 &&
                           (bends_[at(last)] & 1) != 0 &&
                           graph.size[at(v)] == graph.size[at(last)] &&
                           (bends_[at(last)] == 3 || (last > 0 && bends_[at(last) - 1] == 3));
        if (!joins) {
            begin.push_back(begin.back());
            room = hub[at(v)] != 0 ? 0 : kLump;
        }
        unit[at(v)] = count() - 1;
        nodes.push_back(v);
        ++begin.back();
        last = v;
        --room;
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
    for (const std::vector<std::int32_t>& list : end_)
        for (const std::int32_t v : list) {
            if (open_[at(v)] == 0) continue;
            walk(graph, neighbours, v);
            from_.push_back(static_cast<std::int32_t>(walked_.size()));
        }
    nodes.clear();
    nodes.reserve(n + 1);
    begin.assign(1, 0);
    begin.reserve(n + 2);
    unit.assign(n, -1);
    keep_whole(neighbours);
    wires = count();
    add_lumps(graph);
}

}  // namespace hawser::graph
