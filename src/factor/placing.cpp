// SPDX-License-Identifier: Apache-2.0
/// Positions of new and moved nodes in a kept order (list in repair.h).
#include "base/index.h"
#include "factor/repair.h"

#include <algorithm>
#include <tuple>

namespace hawser::factor {
namespace {

constexpr std::uint8_t kMovedNode = 1, kAddedNode = 2;  // values of placing_
constexpr std::int32_t kUnknown = -2;                   // value of anchor_; −1: behind all trees

/// Number of neighbours above which a body keeps its position: most of the tree hangs below a hull.
constexpr std::size_t kFewNeighbours = 16;

}  // namespace

/// Common data of the branches of a node's neighbours.
struct Analysis::Meeting {
    /// Lowest front of one branch, or the front in which several meet.
    std::int32_t front = kUnknown;
    bool has_several = false;
    std::int64_t first = -1;       ///< Least key of the nodes with a key.
    std::int32_t first_node = -1;  ///< First node eliminated.
};

/// Return the first common ancestor of two fronts, −1: none. Parents have higher indices.
std::int32_t Analysis::common_ancestor(std::int32_t a, std::int32_t b) const noexcept {
    while (a != b) {
        if (a < 0 || b < 0) return -1;
        std::int32_t& lower = a < b ? a : b;
        lower = symbolic_.fronts[at(lower)].parent;
    }
    return a;
}

/// Return the front that represents the position of a node, kUnknown if it has none yet.
std::int32_t Analysis::front_of_node(std::int32_t node) const noexcept {
    if (anchor_[at(node)] != kUnknown || placing_[at(node)] != 0) return anchor_[at(node)];
    return symbolic_.node_front[at(old_of_new_[at(node)])];
}

void Analysis::visit(Meeting& m, std::int32_t node) const noexcept {
    const std::int32_t front = front_of_node(node);
    if (front == kUnknown) return;
    const std::int64_t key = key_[at(node)];
    if (key >= 0 && (m.first < 0 || key < m.first)) m.first = key;
    if (m.first_node < 0 || key < key_[at(m.first_node)]) m.first_node = node;
    if (m.front == kUnknown) {
        m.front = front;
        return;
    }
    const std::int32_t common = common_ancestor(m.front, front);
    if (common == front) return;  // above
    if (common != m.front) {
        m.front = common;
        m.has_several = true;
    } else if (!m.has_several) {
        m.front = front;  // below
    }
}

/// Find the bodies that need another position in the order of elimination, and the rows that must
/// remain behind them.
void Analysis::choose_moves(const Pattern& next) {
    const std::int32_t n = next.nodes();
    placing_.assign(at(n), 0);
    anchor_.assign(at(n), kUnknown);
    for (const std::int32_t v : changes_) {
        const std::int32_t old = old_of_new_[at(v)];
        if (old < 0)
            placing_[at(v)] = kAddedNode;
        else if (chain_of_[at(v)] < 0 &&
                 (next.sign[at(v)] < 0 || (at_branch_meeting_[at(old)] != 0 &&
                                           next.neighbours(v).size() <= kFewNeighbours)))
            placing_[at(v)] = kAddedNode;
    }
    for (const std::int32_t v : changes_) {
        if (placing_[at(v)] == kAddedNode) continue;
        for (const std::int32_t w : pattern_.neighbours(old_of_new_[at(v)]))
            if (const std::int32_t now = new_of_old_[at(w)]; now >= 0)
                mark_[at(now)] = 2 * n + v;  // distinct from the marks of the steps before
        for (const std::int32_t u : next.neighbours(v))
            if (u > v && placing_[at(u)] != kAddedNode && mark_[at(u)] != 2 * n + v)
                join(next, v, u);
    }
    for (const std::int32_t v : changes_) {  // every node to place counts as changed
        if (placing_[at(v)] == 0 || next.sign[at(v)] < 0) continue;
        for (const std::int32_t r : next.neighbours(v))
            if (next.sign[at(r)] < 0 && chain_of_[at(r)] < 0) placing_[at(r)] = kAddedNode;
    }
}

/// Process a new edge between two nodes that keep their positions. If they lie in different
/// branches of the tree, one of them moves to the front at which the branches meet.
void Analysis::join(const Pattern& next, std::int32_t a, std::int32_t b) {
    const std::int32_t front_a = front_of_node(a), front_b = front_of_node(b);
    const std::int32_t common = common_ancestor(front_a, front_b);
    if (common == front_a || common == front_b) return;
    auto can_move = [&](std::int32_t v) { return next.sign[at(v)] > 0 && chain_of_[at(v)] < 0; };
    auto burden = [&](std::int32_t v) { return std::pair(next.size[at(v)], columns_.below(v)); };
    if (!can_move(a) && !can_move(b)) return;
    const bool first = can_move(a) && (!can_move(b) || burden(a) <= burden(b));
    const std::int32_t moved = first ? a : b;
    placing_[at(moved)] = kMovedNode;
    anchor_[at(moved)] = common;
}

/// Collect the nodes outside chains: first those that keep their position, in order, then those
/// that need one.
void Analysis::collect_nodes_outside_chains(const Pattern& next) {
    const std::size_t n = changed_.size();
    placed_.clear();
    for_each_marked(placing_, [&](std::int32_t v) {
        placed_.push_back(v);
        if (old_of_new_[at(v)] >= 0) columns_.mark_moved(next, v);
    });
    key_.assign(n, -1);  // chains come first
    nodes_outside_chains_.resize(symbolic_.order.size());
    std::size_t kept = 0;
    for (const std::int32_t old : symbolic_.order) {
        const std::int32_t v = new_of_old_[at(old)];
        if (v < 0 || chain_of_[at(v)] >= 0) continue;
        // Only entries that stay advance the count.
        const bool stays = placing_[at(v)] == 0;
        if (stays) key_[at(v)] = 2 * static_cast<std::int64_t>(kept) + 1;
        nodes_outside_chains_[kept] = v;
        kept += stays ? 1 : 0;
    }
    nodes_outside_chains_.resize(kept);
    bodies_before_.assign(nodes_outside_chains_.size() + 1, -1);
    rows_behind_.assign(n + 1, -1);  // the last list: behind all chains
    next_.resize(n);
    spare_.assign(n, 0);
    for (std::size_t v = 0; v < n; ++v)
        if (old_of_new_[v] >= 0 && placing_[v] != kAddedNode)
            spare_[v] = at_branch_meeting_[at(old_of_new_[v])];
    at_branch_meeting_.swap(spare_);
}

/// Return the sort key that places a node before the first pivot of a front that keeps its
/// position.
std::int64_t Analysis::key_before_front(std::int32_t front) const noexcept {
    for (; front >= 0; front = symbolic_.fronts[at(front)].parent) {
        const Front& f = symbolic_.fronts[at(front)];
        for (std::int32_t k = f.node_begin; k < f.node_end; ++k) {
            const std::int32_t v = new_of_old_[at(symbolic_.order[at(k)])];
            if (v >= 0 && placing_[at(v)] == 0 && key_[at(v)] >= 0) return key_[at(v)] - 1;
        }
    }
    return 2 * static_cast<std::int64_t>(nodes_outside_chains_.size());
}

void Analysis::place_body(const Pattern& next, std::int32_t v) {
    if (placing_[at(v)] == kMovedNode) {
        at_branch_meeting_[at(v)] = 1;
        key_[at(v)] = key_before_front(anchor_[at(v)]);
    } else {
        Meeting m;
        for (const std::int32_t u : next.neighbours(v)) {
            if (next.sign[at(u)] > 0) {
                visit(m, u);
                continue;
            }
            for (const std::int32_t w : next.neighbours(u))
                if (w != v && next.sign[at(w)] > 0) visit(m, w);
        }
        anchor_[at(v)] = m.front == kUnknown ? -1 : m.front;
        at_branch_meeting_[at(v)] = m.has_several ? 1 : 0;
        // A node that is isolated or adjacent to chains only goes directly behind them.
        key_[at(v)] =
            m.has_several ? key_before_front(m.front) : std::max<std::int64_t>(m.first, 0) / 2 * 2;
    }
    prepend_node(bodies_before_, static_cast<std::size_t>(key_[at(v)] / 2), v);
}

void Analysis::place_rows(const Pattern& next, std::int32_t v) {
    Meeting m;
    for (const std::int32_t u : next.neighbours(v))
        if (next.sign[at(u)] > 0) visit(m, u);
    if (m.has_several)
        prepend_node(bodies_before_, static_cast<std::size_t>(key_before_front(m.front) / 2), v);
    else if (m.first_node < 0 || key_[at(m.first_node)] < 0)
        prepend_node(rows_behind_, changed_.size(), v);
    else
        prepend_node(rows_behind_, at(m.first_node), v);
}

/// Prepend a node to the list of a position.
void Analysis::prepend_node(std::vector<std::int32_t>& heads, std::size_t place,
                            std::int32_t node) {
    next_[at(node)] = heads[place];
    heads[place] = node;
}

}  // namespace hawser::factor
