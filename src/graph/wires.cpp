// SPDX-License-Identifier: Apache-2.0
#include "graph/wires.h"

#include "base/memory.h"

#include <algorithm>

namespace hawser::graph {

/// Find hubs, the nodes that may belong to a wire, and the couplings of nodes with consecutive
/// indices.
void Units::classify_nodes(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    hub.resize(n);
    open_.resize(n);
    like_.assign(n, 0);
    bends_.assign(n, 0);
    std::uint8_t *is_hub = hub.data(), *bends = bends_.data();
    const std::int32_t *start = neighbours.start.data(), *end = neighbours.end.data();
    std::int32_t *open = open_.data(), *like = like_.data();
    // Hubs are few, so their neighbours are counted from the hub.
    for (std::size_t v = 0; v < n; ++v) {
        is_hub[v] = end[v] - start[v] > kHubDegree;
        if (is_hub[v] == 0) continue;
        for (std::int32_t k = start[v]; k < end[v]; ++k) ++like[neighbours.adjacent[at(k)]];
    }
    for (std::size_t v = 0; v < n; ++v)
        open[v] = (graph.size[v] != 0) & (is_hub[v] == 0) &
                  (end[v] - start[v] - like[v] <= 2 * kBendingReach);
    for_each_pair(neighbours.near_pairs(),
                  [=](Pair p) { bends[p.a] |= static_cast<std::uint8_t>(p.b - p.a == 1); });
    for_each_pair(neighbours.distant_pairs(),
                  [=](Pair p) { bends[p.a] |= static_cast<std::uint8_t>((p.b - p.a == 2) << 1); });
}

/// End a sequence at `size`. If the sequence is too short for a wire, it is discarded and its nodes
/// may belong to another sequence.
std::int32_t Units::end_sequence(std::int32_t size) {
    const std::int32_t from = from_.back();
    if (size - from < kShortestWire) return from;
    for (std::int32_t k = from; k < size; ++k) {
        open_[at(walked_[at(k)])] = 0;
        walk_index_[at(walked_[at(k)])] = k + 1;
    }
    from_.push_back(size);
    return size;
}

/// Find the wires whose nodes have consecutive indices. Most wires are found without a walk along
/// neighbours.
void Units::find_consecutive_wires(const Hypergraph& graph) {
    const std::size_t n = graph.size.size();
    walked_.resize(n + 1);
    std::int32_t size = 0;
    for (std::size_t v = 0; v < n; ++v) {
        const bool joined = v > 0 && (open_[v] & (bends_[v - 1] & 1)) != 0 &&
                            graph.size[v] == graph.size[v - 1] && size > from_.back();
        if (!joined && size > from_.back()) size = end_sequence(size);
        walked_[at(size)] = static_cast<std::int32_t>(v);
        size += open_[v];
    }
    walked_.resize(at(end_sequence(size)));
}

/// Sort the nodes outside sequences by their number of open neighbours.
void Units::find_ends(const Neighbours& neighbours) {
    for (std::vector<std::int32_t>& list : end_) list.clear();
    for (std::size_t v = 0; v < open_.size(); ++v) {
        if (open_[v] == 0) continue;
        std::int32_t like = 0;
        for (const std::int32_t u : neighbours.of(static_cast<std::int32_t>(v)))
            like += open_[at(u)];
        like_[v] = like;
        end_[at(like)].push_back(static_cast<std::int32_t>(v));
    }
}

/// Return the only open neighbour of a node; −1: none, −2: several.
std::int32_t Units::next_open_neighbour(const Neighbours& neighbours,
                                        std::int32_t v) const noexcept {
    std::int32_t count = 0, sum = 0;
    const std::int32_t* open = open_.data();
    for (const std::int32_t u : neighbours.of(v)) {
        count += open[u];
        sum += u & -open[u];
    }
    return count == 1 ? sum : count == 0 ? -1 : -2;
}

void Units::walk_wire(const Hypergraph& graph, const Neighbours& neighbours, std::int32_t end) {
    std::int32_t before = -1, now = end;
    while (now >= 0) {
        open_[at(now)] = 0;
        walked_.push_back(now);
        walk_index_[at(now)] = static_cast<std::int32_t>(walked_.size());
        // If bending couples a node to the next but one, the previous node has one open neighbour
        // left, which is the next node. At an end the next node is the one with fewer open
        // neighbours.
        std::int32_t to = before < 0 ? -1 : next_open_neighbour(neighbours, before);
        if (to == -1) to = next_open_neighbour(neighbours, now);
        if (to == -2 && before < 0) {
            std::int32_t least = 127;
            for (const std::int32_t u : neighbours.near_neighbours(now)) {
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

/// Close the current wire: discard it if it is too short, else assign its unit index.
void Units::close() noexcept {
    const auto size = static_cast<std::int32_t>(nodes.size());
    if (size - begin.back() < kShortestWire) {
        nodes.resize(at(begin.back()));
        return;
    }
    for (std::int32_t k = begin.back(); k < size; ++k) unit[at(nodes[at(k)])] = count();
    begin.push_back(size);
}

/// Remove nodes from wires if they have a neighbour in another wire, or in their own wire at a
/// distance above kBendingReach.
void Units::remove_nodes_beside_wires(const Neighbours& neighbours) {
    walk_.assign(walked_.size() + 1, -1);
    for (std::size_t w = 0; w + 1 < from_.size(); ++w) {
        const bool brief = from_[w + 1] - from_[w] < kShortestWire;
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k) {
            walk_[at(k) + 1] = static_cast<std::int32_t>(w);
            if (brief) walk_index_[at(walked_[at(k)])] = 0;
        }
    }
    leaves_wire_.assign(walk_index_.size(), 0);
    std::int32_t *separation = leaves_wire_.data(), *place = walk_index_.data(),
                 *walk = walk_.data();
    // Loop without branches; position 0 is for nodes in no sequence.
    for_each_pair(neighbours.pairs(), [=](Pair p) {
        const std::int32_t a = place[p.a], b = place[p.b];
        const auto off = static_cast<std::uint32_t>(a - b + kBendingReach);
        const int other =
            static_cast<int>(walk[a] != walk[b]) | static_cast<int>(off > 2 * kBendingReach);
        const int parts = other & static_cast<int>(a != 0) & static_cast<int>(b != 0);
        separation[p.a] |= parts;
        separation[p.b] |= parts;
    });
    for (std::size_t w = 0; w + 1 < from_.size(); ++w) {
        if (from_[w + 1] - from_[w] < kShortestWire) continue;
        base::reserve_more(begin, at(from_[w + 1] - from_[w]) + 1);  // close() does not throw
        for (std::int32_t k = from_[w]; k < from_[w + 1]; ++k) {
            if (separation[walked_[at(k)]] == 0)
                nodes.push_back(walked_[at(k)]);
            else
                close();
        }
        close();
    }
}

/// Collect all nodes outside wires. Up to kMaxContractedNodes consecutive nodes with common bends
/// form one unit, even if they have contacts with other bodies. Each other node is a unit of its
/// own.
void Units::add_free_nodes(const Hypergraph& graph) {
    const std::size_t n = graph.size.size();
    begin.resize(n + 2);
    nodes.resize(n + 1);
    std::int32_t size = begin[at(wires)], last = wires - 1, room = 0;
    bool before = false;  // true if the previous node is in no wire
    for (std::size_t v = 0; v < n; ++v) {
        if (graph.size[v] == 0 || unit[v] >= 0) {
            before = false;
            continue;
        }
        // Bent with the next two nodes, or with the next and the previous one.
        const bool bent = before && (bends_[v - 1] == 3 ||
                                     (v > 1 && (bends_[v - 1] & (bends_[v - 2] >> 1)) == 1));
        const bool joins = bent && room > 0 && hub[v] == 0 && graph.size[v] == graph.size[v - 1];
        last += joins ? 0 : 1;
        room = joins ? room - 1 : hub[v] != 0 ? 0 : kMaxContractedNodes - 1;
        unit[v] = last;
        nodes[at(size)] = static_cast<std::int32_t>(v);
        begin[at(last) + 1] = ++size;
        before = true;
    }
    begin.resize(at(last) + 2);
    nodes.resize(at(size));
}

void Units::build(const Hypergraph& graph, const Neighbours& neighbours) {
    const std::size_t n = graph.size.size();
    classify_nodes(graph, neighbours);
    walk_index_.assign(n, 0);
    from_.assign(1, 0);
    walked_.reserve(n + 1);
    find_consecutive_wires(graph);
    find_ends(neighbours);
    // Start at ends: nodes with one open neighbour, or two if wires bend. The remaining nodes form
    // rings.
    for (const std::vector<std::int32_t>& list : end_)
        for (const std::int32_t v : list) {
            if (open_[at(v)] == 0) continue;
            walk_wire(graph, neighbours, v);
            from_.push_back(static_cast<std::int32_t>(walked_.size()));
        }
    nodes.clear();
    nodes.reserve(n + 1);
    begin.assign(1, 0);
    begin.reserve(n + 2);
    unit.assign(n, -1);
    remove_nodes_beside_wires(neighbours);
    wires = count();
    add_free_nodes(graph);
}

}  // namespace hawser::graph
