// SPDX-License-Identifier: Apache-2.0
#include "factor/repair.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <numeric>

namespace hawser::factor {
namespace {

void invert(std::span<const std::int32_t> order, std::vector<std::int32_t>& position) {
    position.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[at(order[k])] = static_cast<std::int32_t>(k);
}

/// Copy one chain to the end of another set.
void append(const Chains& from, std::int32_t chain, Chains& to) {
    for (std::int32_t u = from.begin[at(chain)]; u < from.begin[at(chain) + 1]; ++u) {
        const auto unit = from.unit(u);
        to.nodes.insert(to.nodes.end(), unit.begin(), unit.end());
        to.unit_begin.push_back(static_cast<std::int32_t>(to.nodes.size()));
    }
    to.begin.push_back(static_cast<std::int32_t>(to.unit_begin.size()) - 1);
    to.body_size.push_back(from.body_size[at(chain)]);
    to.reach.push_back(from.reach[at(chain)]);
}

}  // namespace

void Analysis::plan(const Pattern& pattern) {
    if (planner_) {
        plan(pattern, planner_(pattern));
        return;
    }
    pattern_ = pattern;
    orderer_.plan(pattern_, symbolic_.order, chains_);
    analyse_order();
}

void Analysis::plan(const Pattern& pattern, Elimination elimination) {
    pattern_ = pattern;
    chains_ = std::move(elimination.chains);
    symbolic_.order = std::move(elimination.order);
    analyse_order();
}

void Analysis::analyse_order() {
    invert(symbolic_.order, symbolic_.position);
    columns_.build(pattern_, symbolic_.order, symbolic_.position);
    layout_.run(pattern_, columns_, chains_, symbolic_, {}, executor_);
    at_branch_meeting_.assign(symbolic_.order.size(), 0);
    planned_flops_ = symbolic_.flops;
    stale_ = false;
}

bool Analysis::resume(const Pattern& pattern, const AnalysisState& state) {
    const std::size_t n = pattern.size.size();
    const std::vector<std::int32_t>& order = state.elimination.order;
    std::vector<std::int32_t> position(n, -1);
    bool fits = order.size() == n && state.at_branch_meeting.size() == n;
    for (std::size_t k = 0; fits && k < n; ++k) {
        fits = order[k] >= 0 && at(order[k]) < n && position[at(order[k])] < 0;
        if (fits) position[at(order[k])] = static_cast<std::int32_t>(k);
    }
    if (!fits || !chains_fit(pattern, state.elimination.chains, position)) {
        plan(pattern);
        return false;
    }
    plan(pattern, state.elimination);
    at_branch_meeting_ = state.at_branch_meeting;
    planned_flops_ = state.planned_flops;
    return true;
}

RepairReport Analysis::update(const Pattern& next, std::span<const std::int32_t> old_of_new) {
    rebuild_derived_data();
    const bool same_numbers = find_changed_nodes(next, old_of_new);
    const double nodes = next.nodes(), changes = static_cast<double>(changes_.size());
    RepairReport report;
    if (!planner_ && !order_fixed_ && next.nodes() <= MinimumDegree::kMaximum &&
        changes > kMaxEditedFraction * nodes) {
        report.replanned = true;
    } else {
        report = follow(next, same_numbers);
        report.replanned = static_cast<double>(symbolic_.flops) >
                           kReplanGrowth * static_cast<double>(planned_flops_);
    }
    if (report.replanned) {
        plan(next);
        report.columns = next.nodes();
    }
    return report;
}

RepairReport Analysis::repair(const Pattern& next, std::span<const std::int32_t> old_of_new) {
    rebuild_derived_data();
    return follow(next, find_changed_nodes(next, old_of_new));
}

/// Find the changed nodes by their new indices.
/// @return true if all nodes have their old indices.
bool Analysis::find_changed_nodes(const Pattern& next, std::span<const std::int32_t> old_of_new) {
    const bool same_numbers = match_nodes(next, old_of_new);
    if (!same_numbers) columns_.renumber(old_of_new_, pattern_.nodes());
    find_changes(next, same_numbers);
    return same_numbers;
}

RepairReport Analysis::follow(const Pattern& next, bool same_numbers) {
    RepairReport report;
    keep_unchanged_chains(next, report);
    choose_moves(next);
    collect_nodes_outside_chains(next);
    for (const std::int32_t v : placed_)
        if (next.sign[at(v)] > 0) place_body(next, v);
    for (const std::int32_t v : placed_)
        if (next.sign[at(v)] < 0) place_rows(next, v);
    emit_order();
    report.placed = static_cast<std::int32_t>(placed_.size());
    columns_.repair(next, symbolic_.order, symbolic_.position);
    report.columns = columns_.columns_computed();
    pattern_ = next;
    std::optional<std::span<const std::int32_t>> edited;
    if (same_numbers && report.dissolved == 0) edited = changes_;
    layout_.run(pattern_, columns_, chains_, symbolic_, edited, executor_);
    report.same = layout_.same();
    return report;
}

/// Set old_of_new_ and its inverse.
/// @return true if every node keeps its index and none was removed.
bool Analysis::match_nodes(const Pattern& next, std::span<const std::int32_t> old_of_new) {
    const std::int32_t n = next.nodes(), before = pattern_.nodes();
    if (old_of_new.empty() && next.size == pattern_.size && next.sign == pattern_.sign) {
        old_of_new_.resize(at(n));
        std::iota(old_of_new_.begin(), old_of_new_.end(), 0);
        new_of_old_ = old_of_new_;
        return true;
    }
    old_of_new_.resize(at(n));
    new_of_old_.assign(at(before), -1);
    bool same = n == before;
    for (std::int32_t v = 0; v < n; ++v) {
        std::int32_t old = old_of_new.empty() ? (v < before ? v : -1) : old_of_new[at(v)];
        if (old >= 0 && (pattern_.size[at(old)] != next.size[at(v)] ||
                         pattern_.sign[at(old)] != next.sign[at(v)]))
            old = -1;
        old_of_new_[at(v)] = old;
        if (old >= 0) new_of_old_[at(old)] = v;
        same &= old == v;
    }
    return same;
}

/// Find the nodes that are new or have other neighbours.
void Analysis::find_changes(const Pattern& next, bool same_numbers) {
    const std::int32_t n = next.nodes();
    changed_.resize(at(n));
    mark_.assign(at(n), -1);
    if (same_numbers) {
        compare_lists(next);
    } else {
        for (std::int32_t v = 0; v < n; ++v) {
            const std::int32_t old = old_of_new_[at(v)];
            const auto now = next.neighbours(v);
            bool same = old >= 0;
            if (same) {
                const auto then = pattern_.neighbours(old);
                same = then.size() == now.size();
                for (const std::int32_t u : then)
                    if (const std::int32_t w = new_of_old_[at(u)]; w >= 0) mark_[at(w)] = v;
                for (const std::int32_t u : now) same &= mark_[at(u)] == v;
            }
            changed_[at(v)] = same ? 0 : 1;
        }
    }
    changes_.clear();
    for_each_marked(changed_, [&](std::int32_t v) {
        changes_.push_back(v);
        columns_.mark_stale(v);
    });
}

/// Perform find_changes() for nodes that keep their indices. A fixed number of neighbours is
/// compared at a time, and masks select the valid entries.
void Analysis::compare_lists(const Pattern& next) {
    constexpr std::int32_t kCopyWidth = 8;
    static constexpr std::int32_t kFirst[2 * kCopyWidth] = {-1, -1, -1, -1, -1, -1, -1, -1};
    const std::int32_t n = next.nodes();
    const std::int32_t *const now = next.adjacent.data(), *const then = pattern_.adjacent.data();
    const std::int32_t *const begin = next.start.data(), *const began = pattern_.start.data();
    const std::int32_t end = begin[n] - kCopyWidth, ended = began[n] - kCopyWidth;
    for (std::int32_t v = 0; v < n; ++v) {
        const std::int32_t length = begin[v + 1] - begin[v];
        const std::int32_t *a = now + begin[v], *b = then + began[v];
        std::int32_t differs = length ^ (began[v + 1] - began[v]);
        if (begin[v] <= end && began[v] <= ended) {
            const std::int32_t* first = kFirst + kCopyWidth - std::min(length, kCopyWidth);
            for (std::int32_t i = 0; i < kCopyWidth; ++i) differs |= (a[i] ^ b[i]) & first[i];
            if (length > kCopyWidth && differs == 0)
                differs = std::equal(a + kCopyWidth, a + length, b + kCopyWidth) ? 0 : 1;
        } else if (differs == 0) {
            differs = std::equal(a, a + length, b) ? 0 : 1;
        }
        changed_[at(v)] = differs != 0 ? 1 : 0;
    }
}

void Analysis::keep_unchanged_chains(const Pattern& next, RepairReport& report) {
    chain_of_.assign(changed_.size(), -1);
    if (chains_.count() == 0) return;
    for (std::int32_t& v : chains_.nodes) v = new_of_old_[at(v)];
    for (int c = 0; c < chains_.count(); ++c)
        for (std::int32_t u = chains_.begin[at(c)]; u < chains_.begin[at(c) + 1]; ++u)
            for (const std::int32_t v : chains_.unit(u))
                if (v >= 0) chain_of_[at(v)] = c;
    intact_chains_.clear();
    for (int c = 0; c < chains_.count(); ++c) {
        if (chain_is_unchanged(next, c)) {
            append(chains_, c, intact_chains_);
            continue;
        }
        ++report.dissolved;
        for (std::int32_t u = chains_.begin[at(c)]; u < chains_.begin[at(c) + 1]; ++u)
            for (const std::int32_t v : chains_.unit(u))
                if (v >= 0) chain_of_[at(v)] = -1;
    }
    std::swap(chains_, intact_chains_);
}

/// True if the nodes of a chain have no changed neighbours inside the chain and none in another
/// chain. Its boundary may have changed.
bool Analysis::chain_is_unchanged(const Pattern& next, std::int32_t chain) {
    for (std::int32_t u = chains_.begin[at(chain)]; u < chains_.begin[at(chain) + 1]; ++u)
        for (const std::int32_t v : chains_.unit(u)) {
            if (v < 0) return false;
            if (!changed_[at(v)]) continue;
            std::int32_t inside = 0, inside_before = 0;
            const std::int32_t n = next.nodes();
            for (const std::int32_t w : pattern_.neighbours(old_of_new_[at(v)])) {
                const std::int32_t now = new_of_old_[at(w)];
                if (now < 0 || chain_of_[at(now)] != chain) continue;
                mark_[at(now)] = n + v;  // distinct from the marks of find_changes()
                ++inside_before;
            }
            for (const std::int32_t w : next.neighbours(v)) {
                if (chain_of_[at(w)] < 0) continue;
                if (chain_of_[at(w)] != chain || mark_[at(w)] != n + v) return false;
                ++inside;
            }
            if (inside != inside_before) return false;
        }
    return true;
}

void Analysis::emit_order() {
    std::vector<std::int32_t>& order = symbolic_.order;
    order.assign(chains_.nodes.begin(), chains_.nodes.end());
    auto rows_behind = [&](std::size_t place) {
        for (std::int32_t r = rows_behind_[place]; r >= 0; r = next_[at(r)]) order.push_back(r);
    };
    rows_behind(changed_.size());
    for (std::size_t k = 0; k <= nodes_outside_chains_.size(); ++k) {
        for (std::int32_t v = bodies_before_[k]; v >= 0; v = next_[at(v)]) {
            order.push_back(v);
            rows_behind(at(v));
        }
        if (k == nodes_outside_chains_.size()) break;
        order.push_back(nodes_outside_chains_[k]);
        rows_behind(at(nodes_outside_chains_[k]));
    }
    invert(order, symbolic_.position);
}

std::size_t Analysis::bytes() const noexcept {
    std::size_t sum = orderer_.bytes() + columns_.bytes() + layout_.bytes() + symbolic_.bytes();
    for (const auto* v : {&old_of_new_, &new_of_old_, &changes_, &chain_of_, &mark_,
                          &nodes_outside_chains_, &placed_, &bodies_before_, &rows_behind_, &next_,
                          &anchor_, &pattern_.start, &pattern_.adjacent})
        sum += base::bytes(*v);
    return sum + base::bytes(key_) + base::bytes(changed_) + base::bytes(placing_) +
           base::bytes(at_branch_meeting_) + base::bytes(spare_);
}

}  // namespace hawser::factor
