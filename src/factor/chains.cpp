// SPDX-License-Identifier: Apache-2.0
#include "factor/chains.h"

#include "base/index.h"
#include "factor/body_graph.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace hawser::factor {
namespace {

constexpr int kLanes = 8;
constexpr std::int32_t kShortestPiece = 4;  ///< Units of a chain worth a lane.

/// A wire: consecutive bodies that nothing but hubs and its own neighbours touch.
struct Stretch {
    std::int32_t begin, end;  ///< Range in Wires::bodies.
    std::int32_t reach;
    double unit;          ///< Scalars of a unit, rows included, on average.
    std::int32_t start;   ///< Boundary scalars that the chain must carry from its freer end on.
    std::int32_t across;  ///< Boundary scalars that touch the whole wire (a deck under it).
    double beside;        ///< Boundary scalars a body that touch the wire here and there.
};

/// Cycles of one step of eight lanes: p pivots over q rows. An estimate from counts of vector
/// operations and the latency of a pivot, not a fit; only ratios matter.
double step_cost(double p, double q) {
    const double n = p + q;
    return 250.0 + 0.5 * (p * p * p / 3.0 + p * p * q + p * q * q) + 3.0 * n * p;
}
/// Cycles of the fronts that one separator body costs, its part in fronts of hubs included: about
/// three times kFrontCost, since it touches two chains.
constexpr double kSeparatorCost = 1500.0;
/// Cycles of a unit eliminated in a front of its own, from a profile of a chain of rigid links.
constexpr double kFrontCost = 500.0;

struct Segment {
    std::int32_t run, from, to;  ///< Bodies [from, to) of the run, relative.
};

/// Cut every run into pieces of about `target` bodies with `reach` bodies between them.
std::vector<Segment> cut(const std::vector<Stretch>& runs, std::int32_t target) {
    std::vector<Segment> pieces;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::int32_t n = runs[r].end - runs[r].begin, w = runs[r].reach;
        std::int32_t parts = std::max(1, (n + w + (target + w) / 2) / (target + w));
        while (parts > 1 && (n - (parts - 1) * w) / parts < kShortestPiece) --parts;
        const std::int32_t inside = n - (parts - 1) * w;
        std::int32_t from = 0;
        for (std::int32_t k = 0; k < parts; ++k) {
            const std::int32_t length = inside / parts + (k < inside % parts ? 1 : 0);
            pieces.push_back({static_cast<std::int32_t>(r), from, from + length});
            from += length + w;
        }
    }
    return pieces;
}

/// Model of the time of all steps of all batches, and of the longest one.
double plan_cost(const std::vector<Stretch>& runs, const std::vector<Segment>& pieces, int size) {
    struct Shape {
        double q, p;
        std::int32_t length;
    };
    std::vector<Shape> shapes;
    double total = 0.0, longest = 0.0;
    for (const Segment& piece : pieces) {
        const Stretch& run = runs[at(piece.run)];
        const std::int32_t n = run.end - run.begin, w = run.reach * size;
        const bool first = piece.from == 0, last = piece.to == n;
        // From its freer end: a separator there is carried along, a hub at the wire's own end
        // only by the piece that begins there.
        std::int32_t start = first ? run.start : w;
        if (first && !last) start = 0;  // turned round when the wire's end is the less free one
        if (last && !first) start = run.start > 0 ? w : 0;
        shapes.push_back({w + start + run.across + run.beside * (piece.to - piece.from), run.unit,
                          piece.to - piece.from});
        if (!last) total += kSeparatorCost * run.reach;
    }
    std::stable_sort(shapes.begin(), shapes.end(), [](const Shape& a, const Shape& b) {
        return a.q != b.q ? a.q > b.q : a.length > b.length;
    });
    for (std::size_t k = 0; k < shapes.size(); k += kLanes) {
        std::int32_t length = 0;
        for (std::size_t i = k; i < std::min(k + kLanes, shapes.size()); ++i)
            length = std::max(length, shapes[i].length);
        const double cost = length * step_cost(shapes[k].p, shapes[k].q);
        total += cost;
        longest = std::max(longest, cost);
    }
    // Half the longest batch stands for what other threads wait for it.
    return total + 0.5 * longest;
}

/// Facts about a run that its neighbourhood determines.
Stretch describe(const Pattern& pattern, const BodyGraph& graph, const Wires& wires,
                 std::int32_t begin, std::int32_t end) {
    Stretch run{begin, end, 1, 0.0, 0, 0, 0.0};
    std::vector<std::int32_t> hubs, first, count;
    double scalars = 0.0;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t b = wires.bodies[at(k)];
        scalars += pattern.size[at(b)];
        for (std::int32_t r : pattern.neighbours(b))
            if (pattern.sign[at(r)] < 0)
                scalars += 0.5 * pattern.size[at(r)];  // most rows have two bodies
        for (std::int32_t u : graph.neighbours(b)) {
            const std::int32_t place = wires.place[at(u)];
            if (place >= begin && place < end) {
                run.reach = std::max(run.reach, std::abs(place - k));
                continue;
            }
            const auto found = std::find(hubs.begin(), hubs.end(), u);
            if (found == hubs.end()) {
                hubs.push_back(u);
                first.push_back(k - begin);
                count.push_back(1);
            } else {
                ++count[static_cast<std::size_t>(found - hubs.begin())];
            }
        }
    }
    run.unit = scalars / (end - begin);
    std::int32_t left = 0, right = 0;
    for (std::size_t i = 0; i < hubs.size(); ++i) {
        const std::int32_t size = pattern.size[at(hubs[i])];
        if (count[i] > 4)
            run.across += size;
        else if (first[i] > 2 && first[i] < end - begin - 2)
            run.beside += static_cast<double>(size) / (end - begin);
        else
            (2 * first[i] < end - begin ? left : right) += size;
    }
    run.start = std::min(left, right);
    return run;
}

/// Append one chain, its units in the better direction.
void append(const Pattern& pattern, const BodyGraph& graph, const Wires& wires, const Stretch& run,
            const Segment& piece, Chains& out) {
    const std::int32_t from = run.begin + piece.from, to = run.begin + piece.to;
    // Boundary scalars times the units that carry them, for either direction.
    std::int64_t forward = 0, backward = 0;
    std::vector<std::int32_t> seen;
    auto visit = [&](std::int32_t k, std::int64_t& area, std::int32_t rest) {
        for (std::int32_t u : graph.neighbours(wires.bodies[at(k)])) {
            const std::int32_t place = wires.place[at(u)];
            if ((place >= from && place < to) ||
                std::find(seen.begin(), seen.end(), u) != seen.end())
                continue;
            seen.push_back(u);
            area += static_cast<std::int64_t>(rest) * pattern.size[at(u)];
        }
    };
    for (std::int32_t k = from; k < to; ++k) visit(k, forward, to - k);
    seen.clear();
    for (std::int32_t k = to; k-- > from;) visit(k, backward, k - from + 1);
    const bool turn = backward < forward;

    for (std::int32_t i = 0; i < to - from; ++i) {
        const std::int32_t k = turn ? to - 1 - i : from + i;
        const std::int32_t b = wires.bodies[at(k)];
        out.nodes.push_back(b);
        for (std::int32_t r : pattern.neighbours(b)) {
            if (pattern.sign[at(r)] > 0) continue;
            bool earlier = false;  // a body of the row has been eliminated before this one
            for (std::int32_t u : pattern.neighbours(r)) {
                const std::int32_t place = wires.place[at(u)];
                earlier |= place >= from && place < to && (turn ? place > k : place < k);
            }
            if (!earlier) out.nodes.push_back(r);
        }
        out.unit_begin.push_back(static_cast<std::int32_t>(out.nodes.size()));
    }
    out.begin.push_back(static_cast<std::int32_t>(out.unit_begin.size()) - 1);
    out.body_size.push_back(pattern.size[at(wires.bodies[at(from)])]);
    out.reach.push_back(static_cast<std::int8_t>(run.reach));
}

}  // namespace

Chains find_chains(const Pattern& pattern) {
    Chains chains;
    const BodyGraph graph = body_graph(pattern);
    const Wires wires = find_wires(pattern, graph);
    // Wires of one shape are cut by one plan, so that their pieces fill whole batches.
    for (const int size : {3, 6}) {
        for (const int reach : {1, 2}) {
            std::vector<Stretch> runs;
            std::int32_t bodies = 0, longest = 0;
            for (std::size_t w = 0; w + 1 < wires.begin.size(); ++w) {
                const std::int32_t begin = wires.begin[w], end = wires.begin[w + 1];
                if (pattern.size[at(wires.bodies[at(begin)])] != size) continue;
                const Stretch run = describe(pattern, graph, wires, begin, end);
                if (run.reach != reach) continue;
                runs.push_back(run);
                bodies += end - begin;
                longest = std::max(longest, end - begin);
            }
            if (runs.empty()) continue;
            std::vector<Segment> best;
            double best_cost = kFrontCost * bodies;
            auto consider = [&](std::int32_t target) {
                std::vector<Segment> pieces = cut(runs, std::max(target, kShortestPiece));
                const double cost = plan_cost(runs, pieces, size);
                if (cost >= best_cost) return;
                best_cost = cost;
                best = std::move(pieces);
            };
            consider(longest);
            for (std::int32_t batches = 1; batches <= 64 && bodies / (kLanes * batches) > 0;
                 batches *= 2)
                consider((bodies + kLanes * batches - 1) / (kLanes * batches));
            for (const Segment& piece : best)
                append(pattern, graph, wires, runs[at(piece.run)], piece, chains);
        }
    }
    return chains;
}

bool chains_fit(const Pattern& pattern, const Chains& chains,
                std::span<const std::int32_t> position) {
    auto ascends = [](const std::vector<std::int32_t>& begin, std::size_t end) {
        return !begin.empty() && begin.front() == 0 && at(begin.back()) == end &&
               std::adjacent_find(begin.begin(), begin.end(), std::greater_equal<>()) ==
                   begin.end();
    };
    const auto count = static_cast<std::size_t>(chains.count());
    if (!ascends(chains.unit_begin, chains.nodes.size()) ||
        !ascends(chains.begin, chains.unit_begin.size() - 1) || chains.body_size.size() != count ||
        chains.reach.size() != count)
        return false;
    const std::size_t n = pattern.size.size();
    std::vector<std::int32_t> unit_of(n, -1), chain_of(n, -1);
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[at(c)]; u < chains.begin[at(c) + 1]; ++u)
            for (const std::int32_t v : chains.unit(u)) {
                if (v < 0 || at(v) >= n || unit_of[at(v)] >= 0) return false;
                unit_of[at(v)] = u;
                chain_of[at(v)] = c;
            }
    for (int c = 0; c < chains.count(); ++c) {
        const std::int32_t begin = chains.begin[at(c)], end = chains.begin[at(c) + 1];
        const std::int32_t last = position[at(chains.unit(end - 1).back())];
        const int size = chains.body_size[at(c)], reach = chains.reach[at(c)];
        if ((size != 3 && size != 6) || (reach != 1 && reach != 2)) return false;
        std::int32_t before = -1;
        for (std::int32_t u = begin; u < end; ++u) {
            bool joined = u + 1 == end;
            for (const std::int32_t v : chains.unit(u)) {
                const bool body = v == chains.unit(u).front();
                if (pattern.sign[at(v)] != (body ? 1 : -1) || position[at(v)] < before ||
                    (body && pattern.size[at(v)] != size))
                    return false;
                before = position[at(v)];
                for (const std::int32_t w : pattern.neighbours(v)) {
                    const bool inside = chain_of[at(w)] == c;
                    if (inside ? std::abs(unit_of[at(w)] - u) > reach
                               : chain_of[at(w)] >= 0 || position[at(w)] < last)
                        return false;
                    joined |= inside && unit_of[at(w)] == u + 1;
                }
            }
            if (!joined) return false;
        }
    }
    return true;
}

}  // namespace hawser::factor
