// SPDX-License-Identifier: Apache-2.0
#include "factor/body_graph.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::factor {
namespace {

constexpr std::int32_t kReach = 2;     ///< A wire's body couples to at most so many on each side.
constexpr std::int32_t kShortest = 6;  ///< Bodies of a wire worth the name.
constexpr std::int32_t kHub = 8;       ///< More neighbours than a wire beside a hub can have.

/// Which nodes may lie in a wire: few neighbours, hubs not counted.
std::vector<std::uint8_t> wire_like(const Pattern& pattern, const BodyGraph& graph) {
    const auto n = static_cast<std::size_t>(pattern.nodes());
    std::vector<std::uint8_t> hub(n, 0), like(n, 0);
    for (std::size_t v = 0; v < n; ++v) {
        const auto id = static_cast<std::int32_t>(v);
        hub[v] = static_cast<std::int32_t>(graph.neighbours(id).size()) > kHub ? 1 : 0;
    }
    for (std::size_t v = 0; v < n; ++v) {
        if (pattern.sign[v] < 0 || hub[v] || (pattern.size[v] != 3 && pattern.size[v] != 6))
            continue;
        const auto id = static_cast<std::int32_t>(v);
        std::int32_t degree = 0;
        for (std::int32_t u : graph.neighbours(id)) degree += hub[at(u)] ? 0 : 1;
        like[v] = degree <= 2 * kReach ? 1 : 0;
    }
    // Rows that couple to rows are no wire's (no mechanical system has them).
    for (std::size_t v = 0; v < n; ++v) {
        if (pattern.sign[v] > 0) continue;
        bool odd = false;
        for (std::int32_t u : pattern.neighbours(static_cast<int>(v)))
            odd |= pattern.sign[at(u)] < 0;
        if (!odd) continue;
        for (std::int32_t u : pattern.neighbours(static_cast<int>(v))) like[at(u)] = 0;
    }
    return like;
}

/// Walks from one end of a wire to the other.
class Walker {
  public:
    Walker(const Pattern& pattern, const BodyGraph& graph, const std::vector<std::uint8_t>& like)
        : pattern_(pattern), graph_(graph), like_(like), visited_(like.size(), 0) {}

    [[nodiscard]] bool visited(std::int32_t v) const { return visited_[at(v)] != 0; }
    [[nodiscard]] std::int32_t degree(std::int32_t v) const {
        std::int32_t n = 0;
        for (std::int32_t u : graph_.neighbours(v)) n += like_[at(u)];
        return n;
    }

    void walk(std::int32_t seed, std::vector<std::int32_t>& out) {
        std::int32_t before = -1, now = seed;
        while (now >= 0) {
            visited_[at(now)] = 1;
            out.push_back(now);
            const std::int32_t next = successor(before, now);
            before = now;
            now = next;
        }
    }

  private:
    /// The one unvisited neighbour, −1: none, −2: several (then `smallest` has fewest of its own).
    std::int32_t only(std::int32_t v, std::int32_t& smallest) const {
        std::int32_t found = -1;
        smallest = -1;
        for (std::int32_t u : graph_.neighbours(v)) {
            if (!like_[at(u)] || visited_[at(u)]) continue;
            found = found == -1 ? u : -2;
            if (smallest < 0 || degree(u) < degree(smallest)) smallest = u;
        }
        return found;
    }

    /// Where three-body bending couples i to i + 2, the body before the last one still has one
    /// unvisited neighbour, and that is the next; else the last one has.
    std::int32_t successor(std::int32_t before, std::int32_t now) const {
        std::int32_t smallest = -1;
        std::int32_t next = before < 0 ? -1 : only(before, smallest);
        if (next == -1) {
            next = only(now, smallest);
            if (next == -2 && before < 0) next = smallest;
        }
        if (next < 0 || pattern_.size[at(next)] != pattern_.size[at(now)]) return -1;
        const auto near = graph_.neighbours(now);
        return std::find(near.begin(), near.end(), next) != near.end() ? next : -1;
    }

    const Pattern& pattern_;
    const BodyGraph& graph_;
    const std::vector<std::uint8_t>& like_;
    std::vector<std::uint8_t> visited_;
};

}  // namespace

BodyGraph body_graph(const Pattern& pattern) {
    const auto n = static_cast<std::size_t>(pattern.nodes());
    BodyGraph graph;
    graph.start.assign(n + 1, 0);
    std::vector<std::int32_t> mark(n, -1);
    for (std::size_t v = 0; v < n; ++v) {
        const auto id = static_cast<std::int32_t>(v);
        const auto first = static_cast<std::ptrdiff_t>(graph.adjacent.size());
        auto take = [&](std::int32_t u) {
            if (u == id || pattern.sign[at(u)] < 0 || mark[at(u)] == id) return;
            mark[at(u)] = id;
            graph.adjacent.push_back(u);
        };
        if (pattern.sign[v] > 0)
            for (std::int32_t u : pattern.neighbours(id)) {
                take(u);
                if (pattern.sign[at(u)] < 0)
                    for (std::int32_t w : pattern.neighbours(u)) take(w);
            }
        std::sort(graph.adjacent.begin() + first, graph.adjacent.end());
        graph.start[v + 1] = static_cast<std::int32_t>(graph.adjacent.size());
    }
    return graph;
}

Wires find_wires(const Pattern& pattern, const BodyGraph& graph) {
    const auto n = static_cast<std::int32_t>(pattern.nodes());
    std::vector<std::uint8_t> like = wire_like(pattern, graph);
    Walker walker(pattern, graph, like);
    std::vector<std::int32_t> bodies, begin{0};
    // Ends first, by number of neighbours; what is left then are rings.
    for (std::int32_t most = 0; most <= 2 * kReach; ++most)
        for (std::int32_t v = 0; v < n; ++v) {
            if (!like[at(v)] || walker.visited(v) || walker.degree(v) > most) continue;
            walker.walk(v, bodies);
            if (static_cast<std::int32_t>(bodies.size()) - begin.back() < kShortest)
                bodies.resize(at(begin.back()));
            else
                begin.push_back(static_cast<std::int32_t>(bodies.size()));
        }

    std::vector<std::int32_t> place(at(n), -1);
    for (std::size_t k = 0; k < bodies.size(); ++k)
        place[at(bodies[k])] = static_cast<std::int32_t>(k);
    // A body that touches another wire, or its own farther away than kReach, is taken out, and
    // so many behind it that what is left falls apart there.
    Wires wires;
    wires.place.assign(at(n), -1);
    for (std::size_t w = 0; w + 1 < begin.size(); ++w) {
        std::int32_t skip = 0;
        auto close = [&] {
            if (static_cast<std::int32_t>(wires.bodies.size()) - wires.begin.back() < kShortest)
                wires.bodies.resize(at(wires.begin.back()));
            else
                wires.begin.push_back(static_cast<std::int32_t>(wires.bodies.size()));
        };
        for (std::int32_t k = begin[w]; k < begin[w + 1]; ++k) {
            const std::int32_t b = bodies[at(k)];
            bool apart = true;
            for (std::int32_t u : graph.neighbours(b)) {
                const std::int32_t p = place[at(u)];
                apart &= p < 0 || (p >= begin[w] && p < begin[w + 1] && std::abs(p - k) <= kReach);
            }
            if (!apart) skip = kReach;
            if (skip > 0) {
                --skip;
                close();
            } else {
                wires.bodies.push_back(b);
            }
        }
        close();
    }
    for (std::size_t k = 0; k < wires.bodies.size(); ++k)
        wires.place[at(wires.bodies[k])] = static_cast<std::int32_t>(k);
    return wires;
}

}  // namespace hawser::factor
