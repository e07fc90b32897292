// SPDX-License-Identifier: Apache-2.0
#include "factor/chains.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <utility>

namespace hawser::factor {
namespace {

constexpr int kLanes = 8;
constexpr std::int32_t kShortestPiece = 4;  ///< Fewest units of a chain that uses a lane.

/// Estimate the cycles of one batch step of eight lanes with p pivots and q rows. The figures are
/// counts of vector operations and the latency of a pivot, not a fit. Only their ratios are used.
double step_cost(double p, double q) {
    const double n = p + q;
    return 250.0 + 0.5 * (p * p * p / 3.0 + p * p * q + p * q * q) + 3.0 * n * p;
}
/// Cycles of the fronts that one separator body costs, its part of the fronts of hubs included.
/// About three times kFrontCost, because it touches two chains.
constexpr double kSeparatorCost = 1500.0;
/// Cycles to eliminate a unit in a front of its own, from a profile of a chain of rigid links.
constexpr double kFrontCost = 500.0;

}  // namespace

void Chains::clear() {
    nodes.clear();
    unit_begin.assign(1, 0);
    begin.assign(1, 0);
    body_size.clear();
    reach.clear();
}

std::size_t Chains::bytes() const noexcept {
    return base::bytes(nodes) + base::bytes(unit_begin) + base::bytes(begin) +
           base::bytes(body_size) + base::bytes(reach);
}

/// Cut every run into pieces of about `target` bodies with `reach` bodies between them.
void ChainFinder::cut_runs(std::int32_t target) {
    pieces_.clear();
    for (std::size_t r = 0; r < runs_.size(); ++r) {
        const std::int32_t n = runs_[r].end - runs_[r].begin, w = runs_[r].reach;
        std::int32_t parts = std::max(1, (n + w + (target + w) / 2) / (target + w));
        while (parts > 1 && (n - (parts - 1) * w) / parts < kShortestPiece) --parts;
        const std::int32_t inside = n - (parts - 1) * w;
        std::int32_t from = 0;
        for (std::int32_t k = 0; k < parts; ++k) {
            const std::int32_t length = inside / parts + (k < inside % parts ? 1 : 0);
            pieces_.push_back({static_cast<std::int32_t>(r), from, from + length});
            from += length + w;
        }
    }
}

/// Estimate the time of all steps of all batches plus half the longest batch.
/// @param most  Bound: a larger cost may be returned early.
double ChainFinder::plan_cost(int size, double most) {
    shapes_.clear();
    double total = 0.0, longest = 0.0;
    for (const Segment& piece : pieces_) {
        const Stretch& run = runs_[at(piece.run)];
        const std::int32_t n = run.end - run.begin, w = run.reach * size;
        const bool first = piece.from == 0, last = piece.to == n;
        // The piece starts at its freer end. It carries a separator there to its end; only the
        // piece at the end of the wire carries the hub there.
        std::int32_t start = first ? run.start : w;
        if (first && !last) start = 0;  // reversed if the end of the wire is less free
        if (last && !first) start = run.start > 0 ? w : 0;
        shapes_.push_back(
            {w + start + run.common_touch_rows + run.single_touch_rows * (piece.to - piece.from),
             run.unit, piece.to - piece.from, static_cast<std::int32_t>(shapes_.size())});
        if (!last) total += kSeparatorCost * run.reach;
    }
    if (total >= most) return total;
    std::sort(shapes_.begin(), shapes_.end(), [](const Shape& a, const Shape& b) {
        if (a.q != b.q) return a.q > b.q;
        return a.length != b.length ? a.length > b.length : a.number < b.number;
    });
    for (std::size_t k = 0; k < shapes_.size(); k += kLanes) {
        std::int32_t length = 0;
        for (std::size_t i = k; i < std::min(k + kLanes, shapes_.size()); ++i)
            length = std::max(length, shapes_[i].length);
        const double cost = length * step_cost(shapes_[k].p, shapes_[k].q);
        total += cost;
        longest = std::max(longest, cost);
    }
    // Add half the longest batch for the time that other threads wait for it.
    return total + 0.5 * longest;
}

/// Compute the properties of a run of wire bodies that determine the cost of its elimination:
/// distance of coupled bodies (`reach`), scalars per body (`unit`), and rows of the neighbours
/// outside of the run (hubs).
ChainFinder::Stretch ChainFinder::describe(const Pattern& pattern, const BodyGraph& graph,
                                           const Wires& wires, std::int32_t begin,
                                           std::int32_t end) {
    Stretch run{begin, end, 1, 0.0, 0, 0, 0.0};
    hubs_.clear();
    double scalars = 0.0;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t b = wires.bodies[at(k)];
        scalars += pattern.size[at(b)];
        for (const std::int32_t r : pattern.neighbours(b))
            if (pattern.sign[at(r)] < 0)
                scalars += 0.5 * pattern.size[at(r)];  // most rows have two bodies
        for (const std::int32_t u : graph.neighbours(b)) {
            const std::int32_t place = wires.place[at(u)];
            if (place >= begin && place < end) {
                run.reach = std::max(run.reach, std::abs(place - k));
                continue;
            }
            const auto found = std::find_if(hubs_.begin(), hubs_.end(),
                                            [&](const Neighbour& hub) { return hub.node == u; });
            if (found == hubs_.end())
                hubs_.push_back({u, k - begin, 1});
            else
                ++found->count;
        }
    }
    run.unit = scalars / (end - begin);
    std::int32_t left = 0, right = 0;
    for (const Neighbour& hub : hubs_) {
        const std::int32_t size = pattern.size[at(hub.node)];
        if (hub.count > 4)
            run.common_touch_rows += size;
        else if (hub.first > 2 && hub.first < end - begin - 2)
            run.single_touch_rows += static_cast<double>(size) / (end - begin);
        else
            (2 * hub.first < end - begin ? left : right) += size;
    }
    run.start = std::min(left, right);
    return run;
}

/// Return true if a chain costs less when eliminated backwards.
bool ChainFinder::is_cheaper_backwards(const Pattern& pattern, const BodyGraph& graph,
                                       const Wires& wires, std::int32_t from, std::int32_t to) {
    // Boundary scalars times the units that carry them, for both directions.
    std::int64_t forward = 0, backward = 0;
    auto visit = [&](std::int32_t k, std::int64_t& area, std::int32_t rest) {
        for (const std::int32_t u : graph.neighbours(wires.bodies[at(k)])) {
            const std::int32_t place = wires.place[at(u)];
            if ((place >= from && place < to) ||
                std::find(seen_bodies_.begin(), seen_bodies_.end(), u) != seen_bodies_.end())
                continue;
            seen_bodies_.push_back(u);
            area += static_cast<std::int64_t>(rest) * pattern.size[at(u)];
        }
    };
    seen_bodies_.clear();
    for (std::int32_t k = from; k < to; ++k) visit(k, forward, to - k);
    seen_bodies_.clear();
    for (std::int32_t k = to; k-- > from;) visit(k, backward, k - from + 1);
    return backward < forward;
}

/// Append one chain with its units in the cheaper direction.
void ChainFinder::append(const Pattern& pattern, const BodyGraph& graph, const Wires& wires,
                         const Stretch& run, const Segment& piece, Chains& out) {
    const std::int32_t from = run.begin + piece.from, to = run.begin + piece.to;
    const bool turn = is_cheaper_backwards(pattern, graph, wires, from, to);
    for (std::int32_t i = 0; i < to - from; ++i) {
        const std::int32_t k = turn ? to - 1 - i : from + i;
        const std::int32_t b = wires.bodies[at(k)];
        out.nodes.push_back(b);
        for (const std::int32_t r : pattern.neighbours(b)) {
            if (pattern.sign[at(r)] > 0) continue;
            bool earlier = false;  // true if a body of the row has been eliminated before this one
            for (const std::int32_t u : pattern.neighbours(r)) {
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

/// Divide the runs of wire bodies into chains with the least total cost. No chains are formed if
/// ordinary fronts cost less.
void ChainFinder::choose_chains(std::int32_t bodies, std::int32_t longest, int size) {
    best_cut_.clear();
    double best_cost = kFrontCost * bodies;
    std::size_t before = 0;
    auto consider = [&](std::int32_t target) {
        cut_runs(std::max(target, kShortestPiece));
        // A smaller target never gives fewer pieces, so an equal number means equal pieces.
        if (std::exchange(before, pieces_.size()) == pieces_.size()) return;
        const double cost = plan_cost(size, best_cost);
        if (cost >= best_cost) return;
        best_cost = cost;
        best_cut_.swap(pieces_);
    };
    consider(longest);
    for (std::int32_t batches = 1; batches <= 64 && bodies / (kLanes * batches) > 0; batches *= 2)
        consider((bodies + kLanes * batches - 1) / (kLanes * batches));
}

void ChainFinder::find(const Pattern& pattern, Chains& out) {
    out.clear();
    if (pattern.nodes() == 0) return;
    const BodyGraph graph = wires_.graph(pattern);
    const Wires& wires = wires_.find(pattern, graph);
    all_stretches_.clear();
    for (std::size_t w = 0; w + 1 < wires.begin.size(); ++w)
        all_stretches_.push_back(
            describe(pattern, graph, wires, wires.begin[w], wires.begin[w + 1]));
    // Wires of one shape are cut by one plan, so that their pieces fill whole batches.
    for (const int size : {3, 6}) {
        for (const int reach : {1, 2}) {
            runs_.clear();
            std::int32_t bodies = 0, longest = 0;
            for (const Stretch& run : all_stretches_) {
                if (run.reach != reach || pattern.size[at(wires.bodies[at(run.begin)])] != size)
                    continue;
                runs_.push_back(run);
                bodies += run.end - run.begin;
                longest = std::max(longest, run.end - run.begin);
            }
            if (runs_.empty()) continue;
            choose_chains(bodies, longest, size);
            for (const Segment& piece : best_cut_)
                append(pattern, graph, wires, runs_[at(piece.run)], piece, out);
        }
    }
}

std::size_t ChainFinder::bytes() const noexcept {
    return wires_.bytes() + base::bytes(all_stretches_) + base::bytes(runs_) +
           base::bytes(pieces_) + base::bytes(best_cut_) + base::bytes(shapes_) +
           base::bytes(hubs_) + base::bytes(seen_bodies_);
}

Chains find_chains(const Pattern& pattern) {
    Chains chains;
    ChainFinder().find(pattern, chains);
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
        // A row of three bodies belongs to its first one and joins the units of the other two.
        bool spans = false;
        for (std::int32_t u = begin; u < end; ++u) {
            bool joined = u + 1 == end || spans;
            spans = false;
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
                    spans |= inside && unit_of[at(w)] == u + 2;
                }
            }
            if (!joined) return false;
        }
    }
    return true;
}

}  // namespace hawser::factor
