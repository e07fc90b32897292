// SPDX-License-Identifier: Apache-2.0
/// Find separators: choose positions in the line by balance, then collect the nodes that have
/// neighbours across them.
#include "graph/partition.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace hawser::graph {
namespace {

/// Ratio of an island's cost to an even part above which the island is divided.
constexpr double kDivideIslandRatio = 1.05;
/// Half width of the window around an even position in which a position is chosen, in fractions of
/// a part.
constexpr double kHalfWindow = 0.10;
/// Number of iterations of balance: the cost of separators is taken from the parts that held them.
constexpr int kBalanceIterations = 3;

}  // namespace

/// Assign each small island as a whole to a lane (a part of the balanced distribution). Append the
/// nodes of the other islands to line_, island by island.
void Partitioner::assign_islands(const PartitionOptions& options, Partition& out) {
    const std::int32_t islands = cost.islands();
    island_cost_.assign(at(islands), 0);
    std::int64_t total = 0;
    for (std::int32_t i = 0; i < islands; ++i) {
        for (std::int32_t k = cost.begin[at(i)]; k < cost.begin[at(i) + 1]; ++k)
            island_cost_[at(i)] += cost.node[at(cost.order[at(k)])];
        total += island_cost_[at(i)];
    }
    const double share = static_cast<double>(total) / options.parts;
    load_.assign(at(options.parts), 0);
    small_cost_.assign(at(islands), 0);
    line_.clear();
    line_.reserve(graph.size.size());
    island_lane_.resize(at(islands));
    for (std::int32_t i = 0; i < islands; ++i) {
        if (options.parts == 1 ||
            static_cast<double>(island_cost_[at(i)]) <= kDivideIslandRatio * share) {
            small_cost_[at(i)] = island_cost_[at(i)];
            continue;
        }
        island_cost_[at(i)] = -1;  // divided
        line_.insert(line_.end(), lineup.order.begin() + lineup.island_begin[at(i)],
                     lineup.order.begin() + lineup.island_begin[at(i) + 1]);
    }
    distribute(small_cost_, island_lane_, load_, order_);
    out.parts = options.parts;
    out.part.assign(graph.size.size(), kNoPart);
    for (std::int32_t i = 0; i < islands; ++i)
        if (island_cost_[at(i)] >= 0)
            for (std::int32_t k = cost.begin[at(i)]; k < cost.begin[at(i) + 1]; ++k)
                out.part[at(cost.order[at(k)])] = island_lane_[at(i)];
    // Nodes that are not in the line have the position behind its end.
    line_index_.assign(graph.size.size(), static_cast<std::int32_t>(line_.size()));
    cost_.resize(line_.size());
    for (std::size_t k = 0; k < line_.size(); ++k) {
        line_index_[at(line_[k])] = static_cast<std::int32_t>(k);
        cost_[k] = cost.node[at(line_[k])];
    }
}

/// Find the positions of the first and last neighbour of each node, the node included. A neighbour
/// that is a hub counts only for nodes that are hubs.
void Partitioner::find_reach() {
    low_.resize(line_.size() + 1);
    std::iota(low_.begin(), low_.end(), 0);
    high_ = low_;
    std::int32_t *low = low_.data(), *high = high_.data();
    const std::int32_t* place = line_index_.data();
    const std::uint8_t* hub = units.hub.data();
    for_each_pair(neighbours.pairs(), [=](Pair p) {
        const std::int32_t a = place[p.a], b = place[p.b];
        // Update both ends of both nodes, because their order in the line is unpredictable. Hubs
        // are few.
        if (hub[p.a] >= hub[p.b]) {
            low[a] = std::min(low[a], b);
            high[a] = std::max(high[a], b);
        }
        if (hub[p.b] >= hub[p.a]) {
            low[b] = std::min(low[b], a);
            high[b] = std::max(high[b], a);
        }
    });
}

/// Compute, for each position of the order, the number of scalars of nodes with neighbours across
/// it: 1. Nodes before it with a neighbour behind it. 2. Nodes behind it with a neighbour before
/// it. 3. Hubs with neighbours on both sides.
void Partitioner::find_profile() {
    profile_.assign(line_.size() + 2, {0, 0, 0});
    find_reach();
    Profile* at_slot = profile_.data();
    const auto end = static_cast<std::int32_t>(line_.size());
    for (std::int32_t k = 0; k < end; ++k) {
        const std::int32_t v = line_[at(k)], size = graph.size[at(v)];
        const std::int32_t low = low_[at(k)], high = high_[at(k)];
        if (units.hub[at(v)] != 0) {
            at_slot[low + 1].hubs += size;
            at_slot[high + 1].hubs -= size;
            continue;
        }
        at_slot[low + 1].behind += size;
        at_slot[k + 1].behind -= size;
        at_slot[k + 1].ahead += size;
        at_slot[high + 1].ahead -= size;
    }
    Profile sum{0, 0, 0};
    for (Profile& p : profile_) {
        sum = {sum.ahead + p.ahead, sum.behind + p.behind, sum.hubs + p.hubs};
        p = sum;
    }
}

/// Choose the cuts of the line. cut_[j] is the first position of the segment after cut j.
void Partitioner::choose_cut_positions(const PartitionOptions& options) {
    prefix_.resize(line_.size() + 1);
    prefix_[0] = 0;
    for (std::size_t k = 0; k < line_.size(); ++k) prefix_[k + 1] = prefix_[k] + weight_[k];
    const auto total = static_cast<double>(prefix_.back());
    // Capacity of the lanes: an even share minus the small islands that they hold.
    double all = total;
    for (const std::int64_t l : load_) all += static_cast<double>(l);
    const double share = all / options.parts;
    lane_of_.clear();
    double capacities = 0.0;
    for (std::int32_t l = 0; l < options.parts; ++l) {
        const double room = share - static_cast<double>(load_[at(l)]);
        if (room < (kDivideIslandRatio - 1.0) * share) continue;
        lane_of_.push_back(l);
        capacities += room;
    }
    // No lane has capacity left if small islands fill all of them evenly.
    if (lane_of_.empty())
        lane_of_.push_back(static_cast<std::int32_t>(std::min_element(load_.begin(), load_.end()) -
                                                     load_.begin()));
    cut_.clear();
    double target = 0.0;
    std::int32_t from = 0;
    const auto end = static_cast<std::int32_t>(line_.size());
    for (std::size_t j = 0; j + 1 < lane_of_.size(); ++j) {
        target += total * (share - static_cast<double>(load_[at(lane_of_[j])])) / capacities;
        const auto low = static_cast<std::int64_t>(target - kHalfWindow * share);
        const auto high = static_cast<std::int64_t>(target + kHalfWindow * share);
        auto place = static_cast<std::int32_t>(
            std::lower_bound(prefix_.begin(), prefix_.end(), low) - prefix_.begin());
        place = std::max(place, from);
        std::int32_t best = std::min(place, end);
        double least = std::numeric_limits<double>::max();
        for (; place <= end && prefix_[at(place)] <= high; ++place) {
            const auto width = static_cast<double>(profile_[at(place)].least());
            const double off = std::abs(static_cast<double>(prefix_[at(place)]) - target);
            const double price = off + width * width * width / 3.0;
            if (price >= least) continue;
            least = price;
            best = place;
        }
        cut_.push_back(best);
        from = best;
    }
}

bool Partitioner::separates_parts(std::int32_t place) const noexcept {
    const std::int32_t v = line_[at(place)], p = segment_[at(place)];
    const bool hub = units.hub[at(v)] != 0;
    for (const std::int32_t u : neighbours.of(v)) {
        const std::int32_t q = segment_[at(line_index_[at(u)])];
        if (q == p) continue;
        if (hub) return true;
        if (units.hub[at(u)] != 0) continue;
        // The last cut between the two segments decides for both nodes.
        const Profile& at_cut = profile_[at(cut_[at(std::max(p, q)) - 1])];
        if ((p > q) == (at_cut.behind <= at_cut.ahead)) return true;
    }
    return false;
}

/// Assign the nodes to segments, and mark the nodes with neighbours outside their segment as
/// separators.
void Partitioner::assign() {
    segment_.resize(line_.size());
    part_.resize(line_.size());
    separator_positions_.resize(line_.size() + 1);
    std::int32_t from = 0;
    std::size_t found = 0;
    for (std::size_t s = 0; s <= cut_.size(); ++s) {
        const auto end = static_cast<std::int32_t>(line_.size());
        const std::int32_t to = s < cut_.size() ? cut_[s] : end;
        std::fill(segment_.begin() + from, segment_.begin() + to, static_cast<std::int32_t>(s));
        std::fill(part_.begin() + from, part_.begin() + to, lane_of_[s]);
        const std::int32_t *low = low_.data(), *high = high_.data();
        for (std::int32_t k = from; k < to; ++k) {
            separator_positions_[found] = k;
            found += static_cast<std::size_t>((low[k] < from) | (high[k] >= to));
        }
        from = to;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found; ++i)
        if (separates_parts(separator_positions_[i]))
            separator_positions_[kept++] = separator_positions_[i];
    separator_positions_.resize(kept);
    for (const std::int32_t k : separator_positions_) part_[at(k)] = kSeparator;
    absorb_separators();
}

/// Move separator nodes with neighbours in one part only to that part.
void Partitioner::absorb_separators() {
    std::size_t kept = 0;
    for (const std::int32_t k : separator_positions_) {
        std::int32_t only = -1;
        bool several = false;
        for (const std::int32_t u : neighbours.of(line_[at(k)])) {
            const std::int32_t p = part_[at(line_index_[at(u)])];
            if (p < 0 || p == only) continue;
            several |= only >= 0;
            only = p;
        }
        if (several)
            separator_positions_[kept++] = k;
        else
            part_[at(k)] = only >= 0 ? only : lane_of_[at(segment_[at(k)])];
    }
    separator_positions_.resize(kept);
}

/// Write the part of each node, the separators in ascending order, and the sums of costs.
void Partitioner::write(Partition& out) {
    // By part, separators first: part − kSeparator is an index.
    sum_.assign(at(out.parts - kSeparator), 0);
    for (std::size_t k = 0; k < line_.size(); ++k) {
        out.part[at(line_[k])] = part_[k];
        sum_[at(part_[k] - kSeparator)] += cost_[k];
    }
    out.separator.clear();
    for (const std::int32_t k : separator_positions_) out.separator.push_back(line_[at(k)]);
    std::sort(out.separator.begin(), out.separator.end());
    out.separator_cost = sum_[0];
    out.cost.assign(load_.begin(), load_.end());
    for (std::size_t p = 0; p < load_.size(); ++p)
        out.cost[p] += sum_[p + static_cast<std::size_t>(-kSeparator)];
}

/// Return the largest useful number of parts. Each part of an island needs kMinNodes nodes. With
/// fewer nodes, most nodes would become separators and return to the only adjacent part.
std::int32_t Partitioner::max_parts() const noexcept {
    std::int32_t most = 0;
    for (std::int32_t i = 0; i < cost.islands(); ++i)
        most += std::max(1, (cost.begin[at(i) + 1] - cost.begin[at(i)]) / kMinNodes);
    return std::max(1, most);
}

void Partitioner::separate(const PartitionOptions& asked, Partition& out) {
    const PartitionOptions options{std::min(asked.parts, max_parts())};
    assign_islands(options, out);
    out.cut.clear();
    separator_positions_.clear();
    if (!line_.empty()) {
        find_profile();
        weight_ = cost_;
        for (int round = 0; round < kBalanceIterations; ++round) {
            for (const std::int32_t k : separator_positions_) weight_[at(k)] = 0;
            choose_cut_positions(options);
            for (const std::int32_t k : separator_positions_) weight_[at(k)] = cost_[at(k)];
            assign();
        }
    }
    write(out);
    out.parts = asked.parts;
    out.cost.resize(at(out.parts), 0);
}

}  // namespace hawser::graph
