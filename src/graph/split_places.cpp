// SPDX-License-Identifier: Apache-2.0
/// Place the clusters and choose the first cuts of the wires.
#include "graph/split.h"

#include <algorithm>
#include <limits>

namespace hawser::graph {
namespace {

/// Ratio of an island's cost to an even part above which the island is divided.
constexpr double kDivideRatio = 1.05;
/// Least cost of a large cluster, in even parts. kLargePackedCluster: clusters are packed together;
/// kLargeDistributedCluster: distributed.
constexpr double kLargePackedCluster = 0.25, kLargeDistributedCluster = 0.02;
constexpr double kMaxEvenRatio = 1.10;  ///< Ratio to an even part up to which parts count as even.
constexpr double kMaxImbalance = 0.02;  ///< Tolerated imbalance, as a fraction of an even part.

}  // namespace

/// Choose parts in two variants. One packs large clusters together, which saves cuts. The other one
/// distributes them, which improves the balance. The variant with fewer cut edges is used if both
/// are about equally even.
void Splitter::choose_parts() {
    choose_parts(true);
    const std::int64_t longest = *std::max_element(load_.begin(), load_.end());
    const std::int32_t cut = count_cuts();
    other_part_ = part_;
    other_load_ = load_;
    choose_parts(false);
    const std::int64_t longest_now = *std::max_element(load_.begin(), load_.end());
    const auto uneven = [&](std::int64_t load) {
        return std::max(static_cast<double>(load), kMaxEvenRatio * static_cast<double>(mean_load_));
    };
    const double now = uneven(longest_now), before = uneven(longest);
    if (before < now || (before == now && cut <= count_cuts())) {
        part_.swap(other_part_);
        load_.swap(other_load_);
    }
}

std::int32_t Splitter::count_cuts() const noexcept {
    std::int32_t count = 0;
    for (std::size_t e = 0; e + 1 < member_begin_.size(); ++e) {
        bool cut = false;
        for (std::int32_t k = member_begin_[e] + 1; k < member_begin_[e + 1]; ++k)
            cut |= part_[at(members_[at(k)])] != part_[at(members_[at(k - 1)])];
        count += cut ? 1 : 0;
    }
    return count;
}

void Splitter::choose_parts(bool together) {
    part_.assign(at(clusters), -1);
    load_.assign(at(options_.parts), 0);
    std::int64_t total = 0;
    largest_cluster = 0;
    for (std::int32_t c = 0; c < clusters; ++c) {
        total += node_cost_[at(c)];
        largest_cluster = std::max(largest_cluster, node_cost_[at(c)]);
    }
    mean_load_ = total / options_.parts;
    for (std::int32_t c = 0; c < clusters; ++c)
        if (group_part_[at(c)] >= 0) assign_part(c, group_part_[at(c)]);
    assign_islands();
    assign_clusters(together);
    assign_wires();
    balance_parts();
    move_cuts();
}

void Splitter::assign_part(std::int32_t cluster, std::int32_t part) noexcept {
    if (part_[at(cluster)] >= 0) load_[at(part_[at(cluster)])] -= node_cost_[at(cluster)];
    part_[at(cluster)] = part;
    load_[at(part)] += node_cost_[at(cluster)];
}

/// Assign each island that fits into one part to that part as a whole.
void Splitter::assign_islands() {
    const std::int32_t islands = cost_.islands();
    island_cost_.assign(at(islands), 0);
    lane_.assign(at(islands), -1);
    for (const std::int32_t c : cost_.order) {
        const std::int32_t i = cost_.island[at(c)];
        island_cost_[at(i)] += node_cost_[at(c)];
        if (group_part_[at(c)] >= 0) lane_[at(i)] = -2;
    }
    const double most = kDivideRatio * static_cast<double>(mean_load_);
    order_.clear();
    for (std::int32_t i = 0; i < islands; ++i)
        if (lane_[at(i)] != -2 &&
            (options_.parts == 1 || static_cast<double>(island_cost_[at(i)]) <= most))
            order_.push_back(i);
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        const std::int64_t x = island_cost_[at(a)], y = island_cost_[at(b)];
        return x != y ? x > y : a < b;
    });
    for (const std::int32_t i : order_) {
        const auto part =
            static_cast<std::int32_t>(std::min_element(load_.begin(), load_.end()) - load_.begin());
        for (std::int32_t k = cost_.begin[at(i)]; k < cost_.begin[at(i) + 1]; ++k)
            assign_part(cost_.order[at(k)], part);
    }
}

/// Assign large clusters to parts in order of decreasing cost, then the other clusters by their
/// position in the order of units.
void Splitter::assign_clusters(bool together) {
    const double big = together ? kLargePackedCluster : kLargeDistributedCluster;
    order_.clear();
    is_open_.assign(at(clusters), 0);
    std::int64_t left = 0;
    for (std::int32_t c = 0; c < clusters; ++c) {
        if (part_[at(c)] >= 0) continue;
        is_open_[at(c)] = 1;
        left += node_cost_[at(c)];
        if (units_.unit[at(c)] >= units_.wires &&
            static_cast<double>(node_cost_[at(c)]) > big * static_cast<double>(mean_load_))
            order_.push_back(c);
    }
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        const std::int64_t x = node_cost_[at(a)], y = node_cost_[at(b)];
        return x != y ? x > y : a < b;
    });
    std::int64_t capacities = 0;
    free_capacity_.resize(load_.size());
    for (std::size_t p = 0; p < load_.size(); ++p)
        capacities += free_capacity_[p] = std::max<std::int64_t>(0, mean_load_ - load_[p]);
    for (const std::int32_t c : order_) {
        // Packed: use the fullest part with enough capacity, or the emptiest part if there is none.
        std::int32_t best = -1, emptiest = 0;
        for (std::int32_t p = 0; p < options_.parts; ++p) {
            if (load_[at(p)] < load_[at(emptiest)]) emptiest = p;
            const bool fits = together && load_[at(p)] + node_cost_[at(c)] <= mean_load_;
            if (fits && (best < 0 || load_[at(p)] > load_[at(best)])) best = p;
        }
        assign_part(c, best < 0 ? emptiest : best);
    }
    std::int64_t passed = 0;
    const double most = kDivideRatio * static_cast<double>(mean_load_);
    for (const std::int32_t c : lineup_.order) {
        if (!is_open_[at(c)]) continue;
        const std::int64_t middle = passed + node_cost_[at(c)] / 2;
        passed += node_cost_[at(c)];
        if (part_[at(c)] >= 0 || units_.unit[at(c)] < units_.wires) continue;
        // Place the cluster with a neighbour if capacity allows; wires have no part yet.
        const std::int32_t neighbour_part = neighbouring_part(c, -1);
        if (neighbour_part >= 0 &&
            static_cast<double>(load_[at(neighbour_part)] + node_cost_[at(c)]) <= most) {
            assign_part(c, neighbour_part);
            continue;
        }
        // Use the part that the cluster's fraction of the total capacity falls into.
        const double capacity_position = static_cast<double>(middle) /
                                         static_cast<double>(std::max<std::int64_t>(1, left)) *
                                         static_cast<double>(capacities);
        double sum = 0.0;
        std::int32_t part = 0;
        for (std::size_t p = 0; p < free_capacity_.size(); ++p) {
            if (free_capacity_[p] > 0) part = static_cast<std::int32_t>(p);
            sum += static_cast<double>(free_capacity_[p]);
            if (sum >= capacity_position) break;
        }
        assign_part(c, part);
    }
}

std::int32_t Splitter::neighbouring_part(std::int32_t cluster, std::int32_t wire) const noexcept {
    for (const std::int32_t u : neighbours_.of(cluster))
        if (units_.unit[at(u)] != wire && part_[at(u)] >= 0) return part_[at(u)];
    return -1;
}

/// Assign each wire to the part of the bodies at its ends. If these belong to two parts, the wire
/// is cut in the ratio of their free capacities.
void Splitter::assign_wires() {
    for (std::int32_t w = 0; w < units_.wires; ++w) {
        const auto nodes = units_.nodes_of(w);
        std::int32_t a = neighbouring_part(nodes.front(), w),
                     b = neighbouring_part(nodes.back(), w);
        if (a < 0) a = b;
        if (a < 0)
            a = static_cast<std::int32_t>(std::min_element(load_.begin(), load_.end()) -
                                          load_.begin());
        if (b < 0) b = a;
        std::int64_t sum = 0;
        for (const std::int32_t c : nodes) sum += part_[at(c)] < 0 ? node_cost_[at(c)] : 0;
        const double capacity_a =
            static_cast<double>(std::max<std::int64_t>(1, mean_load_ - load_[at(a)]));
        const double capacity_b =
            static_cast<double>(std::max<std::int64_t>(1, mean_load_ - load_[at(b)]));
        const auto first = static_cast<std::int64_t>(static_cast<double>(sum) * capacity_a /
                                                     (capacity_a + capacity_b));
        std::int64_t passed = 0;
        for (const std::int32_t c : nodes) {
            if (part_[at(c)] >= 0) continue;
            passed += node_cost_[at(c)];
            assign_part(c, a == b || passed <= first ? a : b);
        }
    }
}

/// Move filler nodes from the fullest part to the emptiest, until the parts are about even.
void Splitter::balance_parts() {
    is_stuck_.assign(load_.size(), 0);
    for (std::int32_t round = 0; round < 4 * options_.parts; ++round) {
        std::int32_t from = -1, to = 0;
        for (std::int32_t p = 0; p < options_.parts; ++p) {
            if (!is_stuck_[at(p)] && (from < 0 || load_[at(p)] > load_[at(from)])) from = p;
            if (load_[at(p)] < load_[at(to)]) to = p;
        }
        if (from < 0) return;
        const std::int64_t amount =
            std::min(load_[at(from)] - mean_load_, mean_load_ - load_[at(to)]);
        if (static_cast<double>(amount) <= kMaxImbalance * static_cast<double>(mean_load_)) {
            is_stuck_[at(from)] = 1;
            continue;
        }
        if (!move_filler(from, to, amount)) is_stuck_[at(from)] = 1;
    }
}

/// Move filler nodes of a wire from one part to another. The preferred position is next to a cut
/// between the two parts, then a free end, then the middle.
bool Splitter::move_filler(std::int32_t from, std::int32_t to, std::int64_t amount) {
    struct Choice {
        int kind = 0;
        std::int64_t cost = 0, weight = 0;
        std::int32_t begin = 0, step = 1, end = 0;
    } best;
    for (std::int32_t w = 0; w < units_.wires; ++w) {
        const std::int32_t first = units_.begin[at(w)], last = units_.begin[at(w) + 1] - 1;
        const auto part = [&](std::int32_t k) { return part_[at(units_.nodes[at(k)])]; };
        const auto group = [&](std::int32_t k) { return group_part_[at(units_.nodes[at(k)])]; };
        const auto held = [&](std::int32_t k) {
            return neighbouring_part(units_.nodes[at(k)], w) >= 0;
        };
        for (std::int32_t a = first, b; a <= last; a = b + 1) {
            b = a;
            // Nodes of a group form a run of their own, which stays.
            while (b < last && part(b + 1) == part(a) && group(b + 1) == group(a)) ++b;
            if (part(a) != from || group(a) >= 0) continue;
            const bool left = a > first && part(a - 1) == to, right = b < last && part(b + 1) == to;
            // True at an end of the wire, or at an end that is already cut.
            const bool free_left = a == first ? !held(first) : part(a - 1) != from,
                       free_right = b == last ? !held(last) : part(b + 1) != from;
            // Each end of the run that stays keeps its kStubNodes nodes.
            std::int32_t low = a, high = b;
            const bool at_left = left || (!right && free_left);
            const int kind = left || right ? 3 : free_left || free_right ? 2 : 1;
            if (kind == 1 || !at_left) low = std::min(b + 1, a + kStubNodes);
            if (kind == 1 || at_left) high = std::max(a - 1, b - kStubNodes);
            std::int64_t sum = 0;
            for (std::int32_t k = low; k <= high; ++k) sum += node_cost_[at(units_.nodes[at(k)])];
            sum = std::min(sum, amount);
            if (sum == 0 || kind < best.kind) continue;
            std::int64_t weight = std::numeric_limits<std::int64_t>::max();
            for (std::int32_t k = low; k <= high; ++k) weight = std::min(weight, weight_[at(k)]);
            if (kind == best.kind) {  // more than 10 % more cost, or about equal and cheaper to cut
                const auto ten = std::max(sum, best.cost) / 10;
                if (sum < best.cost - ten) continue;
                if (sum <= best.cost + ten && weight >= best.weight) continue;
            }
            best = {kind,
                    sum,
                    weight,
                    at_left || kind == 1 ? low : high,
                    at_left || kind == 1 ? 1 : -1,
                    at_left || kind == 1 ? high : low};
        }
    }
    if (best.kind == 0 ||
        static_cast<double>(best.cost) < kMaxImbalance * static_cast<double>(mean_load_))
        return false;
    std::int32_t k = best.begin;
    if (best.kind == 1) {  // leave equal costs on both sides
        std::int64_t all = 0, skip = 0;
        for (std::int32_t i = best.begin; i <= best.end; ++i)
            all += node_cost_[at(units_.nodes[at(i)])];
        for (; skip < (all - best.cost) / 2; ++k) skip += node_cost_[at(units_.nodes[at(k)])];
    }
    std::int64_t moved = 0;
    for (;; k += best.step) {
        const std::int32_t c = units_.nodes[at(k)];
        if (moved > 0 && moved + node_cost_[at(c)] / 2 > best.cost) break;
        assign_part(c, to);
        moved += node_cost_[at(c)];
        if (k == best.end) break;
    }
    return true;
}

}  // namespace hawser::graph
