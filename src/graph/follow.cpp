// SPDX-License-Identifier: Apache-2.0
#include "graph/follow.h"

#include <algorithm>

namespace hawser::graph {

void Follower::start(const Hypergraph& graph, std::span<const std::int64_t> node_cost,
                     const Partition& partition) {
    const auto edges = at(graph.edges());
    size_.assign(graph.size.begin(), graph.size.end());
    node_cost_.assign(node_cost.begin(), node_cost.end());
    part_ = partition.part;
    load_ = partition.cost;
    separator_cost_ = partition.separator_cost;
    makespan_ = makespan();
    head_.assign(graph.size.size(), -1);
    stays_.assign(graph.size.size(), 0);
    count_.assign(edges, 0);
    member_.assign(kMaxMembers * edges, -1);
    next_.assign(kMaxMembers * edges, -1);
    previous_.assign(kMaxMembers * edges, -1);
    for (std::int32_t e = 0; e < graph.edges(); ++e) {
        const auto members = graph.edge(e);
        if (members.size() > kMaxMembers) {
            for (const std::int32_t v : members) stays_[at(v)] = 1;
            continue;
        }
        count_[at(e)] = static_cast<std::uint8_t>(members.size());
        for (std::size_t i = 0; i < members.size(); ++i) {
            const std::int32_t slot = kMaxMembers * e + static_cast<std::int32_t>(i);
            member_[at(slot)] = members[i];
            link(slot);
        }
    }
}

void Follower::link(std::int32_t slot) noexcept {
    std::int32_t& head = head_[at(member_[at(slot)])];
    previous_[at(slot)] = -1;
    next_[at(slot)] = head;
    if (head >= 0) previous_[at(head)] = slot;
    head = slot;
}

void Follower::unlink(std::int32_t slot) noexcept {
    const std::int32_t p = previous_[at(slot)], n = next_[at(slot)];
    (p < 0 ? head_[at(member_[at(slot)])] : next_[at(p)]) = n;
    if (n >= 0) previous_[at(n)] = p;
}

void Follower::set_part(std::int32_t node, std::int32_t part) noexcept {
    const std::int64_t cost = node_cost_[at(node)];
    (part_[at(node)] >= 0 ? load_[at(part_[at(node)])] : separator_cost_) -= cost;
    (part >= 0 ? load_[at(part)] : separator_cost_) += cost;
    part_[at(node)] = part;
}

/// Turn nodes of the edge into separators until its other nodes belong to one part. The part with
/// most scalars in the edge stays; if two are equal, the one with the lower index.
void Follower::separate_parts_of_edge(std::int32_t e) noexcept {
    const std::int32_t first = kMaxMembers * e;
    std::int32_t stays = -1, most = -1;
    for (std::int32_t i = 0; i < count_[at(e)]; ++i) {
        const std::int32_t part = part_[at(member_[at(first + i)])];
        if (part < 0) continue;
        std::int32_t scalars = 0;
        for (std::int32_t j = 0; j < count_[at(e)]; ++j) {
            const std::int32_t v = member_[at(first + j)];
            if (part_[at(v)] == part) scalars += size_[at(v)];
        }
        if (scalars < most || (scalars == most && part > stays)) continue;
        most = scalars;
        stays = part;
    }
    for (std::int32_t i = 0; i < count_[at(e)]; ++i) {
        const std::int32_t v = member_[at(first + i)];
        if (part_[at(v)] >= 0 && part_[at(v)] != stays) set_part(v, kSeparator);
    }
}

void Follower::absorb_separator(std::int32_t node) noexcept {
    if (stays_[at(node)] != 0) return;
    std::int32_t only = -1;
    for (std::int32_t slot = head_[at(node)]; slot >= 0; slot = next_[at(slot)]) {
        const std::int32_t e = slot / kMaxMembers;
        for (std::int32_t i = 0; i < count_[at(e)]; ++i) {
            const std::int32_t part = part_[at(member_[at(kMaxMembers * e + i)])];
            if (part < 0 || part == only) continue;
            if (only >= 0) return;
            only = part;
        }
    }
    if (only >= 0) set_part(node, only);
}

void Follower::change(std::int32_t e, std::span<const std::int32_t> members) noexcept {
    const std::int32_t first = kMaxMembers * e;
    std::int32_t old[kMaxMembers];
    const std::int32_t before = count_[at(e)];
    for (std::int32_t i = 0; i < before; ++i) {
        old[i] = member_[at(first + i)];
        unlink(first + i);
    }
    const auto now = static_cast<std::int32_t>(std::min<std::size_t>(members.size(), kMaxMembers));
    count_[at(e)] = static_cast<std::uint8_t>(now);
    for (std::int32_t i = 0; i < now; ++i) {
        member_[at(first + i)] = members[static_cast<std::size_t>(i)];
        link(first + i);
    }
    separate_parts_of_edge(e);
    for (std::int32_t i = 0; i < before; ++i)
        if (part_[at(old[i])] == kSeparator) absorb_separator(old[i]);
}

std::int64_t Follower::makespan() const noexcept {
    return separator_cost_ + (load_.empty() ? 0 : *std::max_element(load_.begin(), load_.end()));
}

bool Follower::needs_new_partition() const noexcept {
    return static_cast<double>(makespan()) > kReplanRatio * static_cast<double>(makespan_);
}

void Follower::copy_to(Partition& out) const {
    out.parts = static_cast<std::int32_t>(load_.size());
    out.part = part_;
    out.cost = load_;
    out.separator_cost = separator_cost_;
    out.cut.clear();
    out.separator.clear();
    for (std::size_t v = 0; v < part_.size(); ++v)
        if (part_[v] == kSeparator) out.separator.push_back(static_cast<std::int32_t>(v));
}

}  // namespace hawser::graph
