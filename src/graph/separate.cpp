// SPDX-License-Identifier: Apache-2.0
/// Separators: places of the line by balance, then the nodes that reach across them.
#include "graph/partition.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace hawser::graph {
namespace {

/// An island that costs this much more than a part's share is divided.
constexpr double kSlack = 1.05;
/// Places are chosen within this share of a part on both sides of an even one.
constexpr double kWindow = 0.10;
/// Rounds of balance: costs of separators leave the parts that they were in.
constexpr int kRounds = 3;

}  // namespace

/// Small islands go to lanes whole; the others stand one after the other in line_.
void Partitioner::place_islands(const PartitionOptions& options, Partition& out) {
    const std::int32_t islands = cost.islands();
    island_cost_.assign(at(islands), 0);
    std::int64_t total = 0;
    for (const std::int32_t v : cost.order) {
        island_cost_[at(cost.island[at(v)])] += cost.node[at(v)];
        total += cost.node[at(v)];
    }
    const double share = static_cast<double>(total) / options.parts;
    load_.assign(at(options.parts), 0);
    small_cost_.assign(at(islands), 0);
    line_.clear();
    line_.reserve(graph.size.size());
    place_.assign(graph.size.size(), -1);
    island_lane_.resize(at(islands));
    for (std::int32_t i = 0; i < islands; ++i) {
        if (options.parts == 1 || static_cast<double>(island_cost_[at(i)]) <= kSlack * share) {
            small_cost_[at(i)] = island_cost_[at(i)];
            continue;
        }
        for (std::int32_t k = lineup.island_begin[at(i)]; k < lineup.island_begin[at(i) + 1]; ++k) {
            place_[at(lineup.order[at(k)])] = static_cast<std::int32_t>(line_.size());
            line_.push_back(lineup.order[at(k)]);
        }
    }
    share_out(small_cost_, island_lane_, load_, order_);
    out.parts = options.parts;
    out.part.assign(graph.size.size(), kNoPart);
    for (const std::int32_t v : cost.order) out.part[at(v)] = island_lane_[at(cost.island[at(v)])];
}

/// Scalars that reach across each place of the line: of nodes behind it with a neighbour ahead of
/// it, of nodes ahead of it with one behind, and of hubs with both.
void Partitioner::find_profile() {
    profile_.assign(line_.size() + 2, {0, 0, 0});
    reach_.resize(line_.size());
    for (std::size_t k = 0; k < line_.size(); ++k) {
        const std::int32_t v = line_[k];
        auto low = static_cast<std::int32_t>(k), high = low;
        const bool hub = units.hub[at(v)] != 0;
        for (const Neighbour u : neighbours.of(v)) {
            if (units.hub[at(u.node())] && !hub) continue;
            const std::int32_t p = place_[at(u.node())];
            low = std::min(low, p);
            high = std::max(high, p);
        }
        const std::int32_t size = graph.size[at(v)];
        reach_[k] = {low, high};
        if (hub) {
            profile_[at(low) + 1].hubs += size;
            profile_[at(high) + 1].hubs -= size;
            continue;
        }
        profile_[at(low) + 1].behind += size;
        profile_[k + 1].behind -= size;
        profile_[k + 1].ahead += size;
        profile_[at(high) + 1].ahead -= size;
    }
    for (std::size_t k = 1; k < profile_.size(); ++k) {
        profile_[k].ahead += profile_[k - 1].ahead;
        profile_[k].behind += profile_[k - 1].behind;
        profile_[k].hubs += profile_[k - 1].hubs;
    }
}

/// cut_[j] is the first place of the segment after cut j.
void Partitioner::choose_places(const PartitionOptions& options) {
    prefix_.resize(line_.size() + 1);
    prefix_[0] = 0;
    for (std::size_t k = 0; k < line_.size(); ++k) prefix_[k + 1] = prefix_[k] + weight_[k];
    const auto total = static_cast<double>(prefix_.back());
    // Room of the lanes: what small islands leave of an even share.
    double all = total;
    for (const std::int64_t l : load_) all += static_cast<double>(l);
    const double share = all / options.parts;
    lane_of_.clear();
    double rooms = 0.0;
    for (std::int32_t l = 0; l < options.parts; ++l) {
        const double room = share - static_cast<double>(load_[at(l)]);
        if (room < (kSlack - 1.0) * share) continue;
        lane_of_.push_back(l);
        rooms += room;
    }
    cut_.clear();
    double target = 0.0;
    std::int32_t from = 0;
    const auto end = static_cast<std::int32_t>(line_.size());
    for (std::size_t j = 0; j + 1 < lane_of_.size(); ++j) {
        target += total * (share - static_cast<double>(load_[at(lane_of_[j])])) / rooms;
        const auto low = static_cast<std::int64_t>(target - kWindow * share);
        const auto high = static_cast<std::int64_t>(target + kWindow * share);
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

bool Partitioner::is_between(std::int32_t v) const noexcept {
    const std::int32_t p = segment_[at(v)];
    const bool hub = units.hub[at(v)] != 0;
    for (const Neighbour n : neighbours.of(v)) {
        const std::int32_t q = segment_[at(n.node())];
        if (q == p) continue;
        if (hub) return true;
        if (units.hub[at(n.node())]) continue;
        // The last cut between the two decides for both.
        const Profile& at_cut = profile_[at(cut_[at(std::max(p, q)) - 1])];
        if ((p > q) == (at_cut.behind <= at_cut.ahead)) return true;
    }
    return false;
}

/// Segments, separators, and the cost of what is left of the parts.
void Partitioner::assign(Partition& out) {
    segment_.resize(graph.size.size());
    std::size_t j = 0;
    for (std::size_t k = 0; k < line_.size(); ++k) {
        while (j < cut_.size() && static_cast<std::int32_t>(k) >= cut_[j]) ++j;
        segment_[at(line_[k])] = static_cast<std::int32_t>(j);
    }
    out.separator.clear();
    const auto end = static_cast<std::int32_t>(line_.size());
    for (std::size_t k = 0; k < line_.size(); ++k) {
        const std::int32_t v = line_[k], s = segment_[at(v)];
        const std::int32_t low = s == 0 ? 0 : cut_[at(s) - 1];
        const std::int32_t high = at(s) < cut_.size() ? cut_[at(s)] : end;
        const bool reaches = reach_[k].low < low || reach_[k].high >= high;
        const bool between = reaches && is_between(v);
        out.part[at(v)] = between ? kSeparator : lane_of_[at(s)];
        if (between) out.separator.push_back(v);
    }
    join_back(out);
}

/// Separator nodes beside one part only join it.
void Partitioner::join_back(Partition& out) {
    std::size_t kept = 0;
    for (const std::int32_t v : out.separator) {
        std::int32_t only = -1;
        bool several = false;
        for (const Neighbour n : neighbours.of(v)) {
            const std::int32_t p = out.part[at(n.node())];
            if (p < 0 || p == only) continue;
            several |= only >= 0;
            only = p;
        }
        if (several)
            out.separator[kept++] = v;
        else
            out.part[at(v)] = only >= 0 ? only : lane_of_[at(segment_[at(v)])];
    }
    out.separator.resize(kept);
}

void Partitioner::sum_up(Partition& out) {
    out.cost.assign(at(out.parts), 0);
    out.separator_cost = 0;
    for (const std::int32_t v : cost.order)
        (out.part[at(v)] >= 0 ? out.cost[at(out.part[at(v)])] : out.separator_cost) +=
            cost.node[at(v)];
}

void Partitioner::separate(const PartitionOptions& options, Partition& out) {
    place_islands(options, out);
    out.separator.clear();
    out.cut.clear();
    if (!line_.empty()) {
        find_profile();
        weight_.resize(line_.size());
        for (std::size_t k = 0; k < line_.size(); ++k) weight_[k] = cost.node[at(line_[k])];
        for (int round = 0; round < kRounds; ++round) {
            choose_places(options);
            assign(out);
            if (round + 1 == kRounds) break;
            for (std::size_t k = 0; k < line_.size(); ++k)
                weight_[k] = out.part[at(line_[k])] >= 0 ? cost.node[at(line_[k])] : 0;
        }
    }
    sum_up(out);
    std::sort(out.separator.begin(), out.separator.end());
}

}  // namespace hawser::graph
