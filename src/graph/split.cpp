// SPDX-License-Identifier: Apache-2.0
#include "graph/split.h"

#include <algorithm>
#include <numeric>

namespace hawser::graph {
namespace {

/// Ratio of makespans, old partition over new, up to which the old one is kept without limit.
constexpr double kMaxCostRatio = 1.15;
/// Number of steps for which an old partition is kept beyond kMaxCostRatio.
constexpr std::int32_t kMaxWorseSteps = 30;

}  // namespace

std::int32_t Splitter::find(std::int32_t v) noexcept {
    while (root_[at(v)] != v) {
        root_[at(v)] = root_[at(root_[at(v)])];
        v = root_[at(v)];
    }
    return v;
}

void Splitter::unite_clusters(std::int32_t a, std::int32_t b) noexcept {
    a = find(a);
    b = find(b);
    if (a != b) root_[at(std::max(a, b))] = std::min(a, b);
}

/// Form clusters: sets of nodes that no cut may divide.
void Splitter::contract() {
    const std::size_t n = graph_.size.size();
    root_.resize(n);
    std::iota(root_.begin(), root_.end(), 0);
    for (std::int32_t e = 0; !graph_.edge_weight.empty() && e < graph_.edges(); ++e) {
        if (graph_.edge_weight[at(e)] != kNeverCut) continue;
        std::int32_t first = -1;
        for (const std::int32_t v : graph_.edge(e)) {
            if (graph_.size[at(v)] == 0) continue;
            if (first >= 0) unite_clusters(first, v);
            first = v;
        }
    }
    lane_.clear();  // here: first node of each group
    for (std::size_t v = 0; !graph_.group.empty() && v < n; ++v) {
        const std::int32_t g = graph_.group[v];
        if (graph_.size[v] == 0 || g < 0) continue;
        if (at(g) >= lane_.size()) lane_.resize(at(g) + 1, -1);
        if (lane_[at(g)] < 0) lane_[at(g)] = static_cast<std::int32_t>(v);
        unite_clusters(lane_[at(g)], static_cast<std::int32_t>(v));
    }
    options_.parts = std::max(options_.parts, static_cast<std::int32_t>(lane_.size()));
    clusters = 0;
    cluster_.assign(n, -1);
    size_.clear();
    node_cost_.clear();
    group_part_.clear();
    for (std::size_t v = 0; v < n; ++v) {
        if (graph_.size[v] == 0) continue;
        const std::int32_t r = find(static_cast<std::int32_t>(v));
        if (cluster_[at(r)] < 0) {
            cluster_[at(r)] = clusters++;
            size_.push_back(0);
            node_cost_.push_back(0);
            group_part_.push_back(-1);
        }
        const auto c = at(cluster_[v] = cluster_[at(r)]);
        size_[c] = static_cast<std::uint8_t>(std::min(255, size_[c] + graph_.size[v]));
        node_cost_[c] += node_cost(v);
        if (!graph_.group.empty() && graph_.group[v] >= 0) group_part_[c] = graph_.group[v];
    }
}

/// Build the graph of clusters, with its wires and its line as for separators.
void Splitter::build_quotient() {
    member_begin_.assign(1, 0);
    members_.clear();
    for (std::int32_t e = 0; e < graph_.edges(); ++e) {
        const std::size_t first = members_.size();
        for (const std::int32_t v : graph_.edge(e)) {
            const std::int32_t c = cluster_[at(v)];
            if (c < 0 || (members_.size() > first && members_.back() == c)) continue;
            members_.push_back(c);
        }
        if (members_.size() - first < 2) members_.resize(first);
        member_begin_.push_back(static_cast<std::int32_t>(members_.size()));
    }
    const Hypergraph quotient{size_, member_begin_, members_, {}, {}, {}, node_cost_};
    neighbours_.build(quotient);
    cost_.find_islands(quotient, neighbours_);
    units_.build(quotient, neighbours_);
    lineup_.build(quotient, neighbours_, cost_, units_);
}

/// Compute the weight of a cut behind each position of a wire: weights of the edges across it and
/// of the nodes on both sides.
void Splitter::compute_cut_weights() {
    weight_.assign(units_.nodes.size(), 0);
    repair_.assign(units_.nodes.size(), 0);
    wire_position_.assign(at(clusters), -1);
    const std::int32_t in_wires = units_.begin[at(units_.wires)];
    for (std::int32_t k = 0; k < in_wires; ++k) wire_position_[at(units_.nodes[at(k)])] = k;
    for (std::int32_t e = 0; !graph_.edge_weight.empty() && e < graph_.edges(); ++e) {
        std::int32_t low = -1, high = -1;
        for (std::int32_t k = member_begin_[at(e)]; k < member_begin_[at(e) + 1]; ++k) {
            const std::int32_t p = wire_position_[at(members_[at(k)])];
            if (p < 0) continue;
            if (low >= 0 &&
                units_.unit[at(members_[at(k)])] != units_.unit[at(units_.nodes[at(low)])])
                continue;
            low = low < 0 ? p : std::min(low, p);
            high = std::max(high, p);
        }
        for (std::int32_t p = low; p >= 0 && p < high; ++p) {
            weight_[at(p)] += graph_.edge_weight[at(e)];
            if (!graph_.repair_weight.empty()) repair_[at(p)] += graph_.repair_weight[at(e)];
        }
    }
    for (std::size_t v = 0; !graph_.node_weight.empty() && v < cluster_.size(); ++v) {
        const std::int32_t p = cluster_[v] < 0 ? -1 : wire_position_[at(cluster_[v])];
        if (p < 0) continue;
        weight_[at(p)] += graph_.node_weight[v];
        if (p > 0 && units_.unit[at(units_.nodes[at(p - 1)])] == units_.unit[at(cluster_[v])])
            weight_[at(p - 1)] += graph_.node_weight[v];
    }
}

void Splitter::write(Partition& out) const {
    out.parts = options_.parts;
    out.separator.clear();
    out.separator_cost = 0;
    out.cut.clear();
    out.cost.assign(at(options_.parts), 0);
    out.part.assign(cluster_.size(), kNoPart);
    for (std::size_t v = 0; v < cluster_.size(); ++v) {
        if (cluster_[v] < 0) continue;
        out.part[v] = part_[at(cluster_[v])];
        out.cost[at(out.part[v])] += node_cost(v);
    }
    for (std::int32_t e = 0; e < graph_.edges(); ++e) {
        std::int32_t first = kNoPart;
        for (const std::int32_t v : graph_.edge(e)) {
            const std::int32_t p = out.part[at(v)];
            if (p < 0) continue;
            if (first >= 0 && p != first) {
                out.cut.push_back(e);
                break;
            }
            first = p;
        }
    }
}

void Splitter::split(const Hypergraph& graph, const PartitionOptions& options, Partition& out) {
    prepare(graph, options);
    choose_parts();
    out.worse_for = 0;
    write(out);
}

void Splitter::prepare(const Hypergraph& graph, const PartitionOptions& options) {
    graph_ = graph;
    options_ = options;
    if (graph_.cost.empty()) {
        full_neighbours_.build(graph_);
        full_cost_.build(graph_, full_neighbours_);
    }
    contract();
    build_quotient();
    compute_cut_weights();
}

/// Start from the partition of the previous step. @return false if the graph does not allow it.
bool Splitter::start_from_previous(const Partition& before) {
    if (before.parts != options_.parts || before.part.size() != cluster_.size()) return false;
    part_.assign(at(clusters), -1);
    for (std::size_t v = 0; v < cluster_.size(); ++v) {
        if (cluster_[v] < 0) continue;
        std::int32_t& part = part_[at(cluster_[v])];
        const std::int32_t previous_part = before.part[v];
        // The partition may come from a caller, so it is checked.
        if (previous_part < 0 || previous_part >= options_.parts ||
            (part >= 0 && part != previous_part))
            return false;
        part = previous_part;
        const std::int32_t group = group_part_[at(cluster_[v])];
        if (group >= 0 && part != group) return false;
    }
    load_.assign(at(options_.parts), 0);
    for (std::int32_t c = 0; c < clusters; ++c) load_[at(part_[at(c)])] += node_cost_[at(c)];
    return true;
}

bool Splitter::split_from_previous(const Hypergraph& graph, const PartitionOptions& options,
                                   Partition& out) {
    prepare(graph, options);
    choose_parts();
    const auto longest = [&] { return *std::max_element(load_.begin(), load_.end()); };
    const auto best = static_cast<double>(longest());
    new_part_ = part_;
    bool goes_on = true;
    if (!start_from_previous(out)) {
        part_ = new_part_;
        out.worse_for = 0;
        goes_on = false;
    } else if (static_cast<double>(longest()) <= kMaxCostRatio * best ||
               ++out.worse_for <= kMaxWorseSteps) {
        if (static_cast<double>(longest()) <= kMaxCostRatio * best) out.worse_for = 0;
        move_best_cut();
    } else {
        part_ = new_part_;
        out.worse_for = 0;
        goes_on = false;
    }
    write(out);
    return goes_on;
}

}  // namespace hawser::graph
