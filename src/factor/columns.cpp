// SPDX-License-Identifier: Apache-2.0
#include "factor/columns.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <bit>

namespace hawser::factor {
namespace {

/// Permute an array to new node indices: v[new] = old v[old_of_new[new]], and `none` for new nodes.
/// @param carried  Scratch.
template <class T>
void carry_over(std::vector<T>& v, std::span<const std::int32_t> old_of_new, T none,
                std::vector<T>& carried) {
    carried.assign(old_of_new.size(), none);
    for (std::size_t k = 0; k < old_of_new.size(); ++k)
        if (old_of_new[k] >= 0) carried[k] = v[at(old_of_new[k])];
    v.swap(carried);
}

}  // namespace

void Columns::resize(std::size_t nodes) {
    parent_.resize(nodes, -1);
    count_.resize(nodes, 0);
    below_.resize(nodes, 0);
    begin_.resize(nodes, 0);
    stale_.resize(nodes, 0);
    moved_.resize(nodes, 0);
}

/// Build the columns row by row. A row of L has an entry in each column on the paths from its
/// earlier neighbours up the tree (Liu 1990), so columns come out sorted.
void Columns::build(const Pattern& pattern, std::span<const std::int32_t> order,
                    std::span<const std::int32_t> position) {
    const std::size_t n = order.size();
    resize(n);
    // Indexed by position while rows are found: parents, entries and their scalars, marks.
    head_.assign(n, -1);
    next_.assign(n, 0);
    rows_.assign(n, 0);
    mark_.resize(n);
    row_end_.resize(n);
    if (spare_.size() < n) spare_.resize(n);
    std::int32_t *const parent = head_.data(), *const mark = mark_.data();
    std::int32_t* found = spare_.data();
    std::size_t used = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto own = static_cast<std::int32_t>(i);
        const std::int32_t size = pattern.size[at(order[i])];
        if (spare_.size() - used < i) {  // a row has at most i entries
            spare_.resize(2 * spare_.size() + i);
            found = spare_.data();
        }
        mark[i] = own;
        for (const std::int32_t u : pattern.neighbours(order[i])) {
            // A later neighbour counts as the row itself, whose mark ends the path.
            std::int32_t k = std::min(position[at(u)], own);
            while (mark[k] != own) {
                mark[k] = own;
                found[used++] = k;
                ++next_[at(k)];
                rows_[at(k)] += size;
                if (parent[k] < 0) parent[k] = own;
                k = parent[k];
            }
        }
        row_end_[i] = used;
    }
    rows_in_use_ = static_cast<std::int64_t>(used);
    pool_.resize(used);
    cursor_.resize(n);
    std::int64_t begin = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t v = at(order[k]);
        parent_[v] = head_[k] < 0 ? -1 : order[at(head_[k])];
        count_[v] = next_[k];
        below_[v] = rows_[k];
        begin_[v] = begin;
        cursor_[k] = begin;
        begin += count_[v];
    }
    for (std::size_t i = 0, e = 0; i < n; ++i)
        for (; e < row_end_[i]; ++e) pool_[at(cursor_[at(found[e])]++)] = order[i];
    std::fill(stale_.begin(), stale_.end(), std::uint8_t{0});
    std::fill(moved_.begin(), moved_.end(), std::uint8_t{0});
    changed_.assign(n, 1);
    stale_list_.clear();
    moved_list_.clear();
    linked_ = false;
    computed_ = static_cast<std::int32_t>(n);
}

void Columns::renumber(std::span<const std::int32_t> old_of_new, std::int32_t old_nodes) {
    std::vector<std::int32_t>& new_of_old = new_of_old_;
    new_of_old.assign(at(old_nodes), -1);
    for (std::size_t k = 0; k < old_of_new.size(); ++k)
        if (old_of_new[k] >= 0) new_of_old[at(old_of_new[k])] = static_cast<std::int32_t>(k);
    for (std::size_t v = 0; v < new_of_old.size(); ++v) {
        if (new_of_old[v] >= 0) continue;
        if (parent_[v] >= 0) mark_stale(parent_[v]);
        rows_in_use_ -= count_[v];
    }
    carry_over(parent_, old_of_new, std::int32_t{-1}, carried_);
    carry_over(count_, old_of_new, 0, carried_);
    carry_over(below_, old_of_new, 0, carried_);
    carry_over(begin_, old_of_new, std::int64_t{0}, carried_begin_);
    carry_over(stale_, old_of_new, std::uint8_t{0}, carried_stale_);
    moved_.assign(old_of_new.size(), 0);
    std::erase_if(stale_list_, [&](std::int32_t v) { return new_of_old[at(v)] < 0; });
    for (std::int32_t& v : stale_list_) v = new_of_old[at(v)];
    linked_ = false;
    for (std::int32_t& p : parent_)
        if (p >= 0) p = new_of_old[at(p)];
    // A removed node leaves −1 in the columns that contained it. All these columns are found stale.
    for (std::size_t v = 0; v < count_.size(); ++v)
        for (std::int32_t i = 0; i < count_[v]; ++i) {
            std::int32_t& u = pool_[static_cast<std::size_t>(begin_[v] + i)];
            if (u >= 0) u = new_of_old[at(u)];
        }
}

void Columns::mark_moved(const Pattern& pattern, std::int32_t node) {
    moved_[at(node)] = 1;
    moved_list_.push_back(node);
    mark_stale(node);
    if (parent_[at(node)] >= 0) mark_stale(parent_[at(node)]);
    for (const std::int32_t u : pattern.neighbours(node)) mark_stale(u);
}

void Columns::link(std::int32_t node) noexcept {
    const std::int32_t p = parent_[at(node)];
    if (p < 0) return;
    const std::int32_t first = head_[at(p)];
    next_[at(node)] = first;
    prev_[at(node)] = -1;
    if (first >= 0) prev_[at(first)] = node;
    head_[at(p)] = node;
}

void Columns::unlink(std::int32_t node) noexcept {
    const std::int32_t p = parent_[at(node)];
    if (p < 0) return;
    const std::int32_t before = prev_[at(node)], after = next_[at(node)];
    if (after >= 0) prev_[at(after)] = before;
    (before >= 0 ? next_[at(before)] : head_[at(p)]) = after;
}

void Columns::link_all() {
    head_.assign(parent_.size(), -1);
    next_.resize(parent_.size());
    prev_.resize(parent_.size());
    for (std::size_t v = 0; v < parent_.size(); ++v) link(static_cast<std::int32_t>(v));
    linked_ = true;
}

void Columns::repair(const Pattern& pattern, std::span<const std::int32_t> order,
                     std::span<const std::int32_t> position) {
    if (!linked_) link_all();
    mark_.assign(order.size(), -1);
    found_rows_.resize(order.size());
    todo_.assign(order.size() / 64 + 1, 0);
    changed_.assign(order.size(), 0);
    computed_ = 0;
    for (const std::int32_t v : stale_list_) {
        stale_[at(v)] = 0;
        queue_position(position[at(v)]);
    }
    stale_list_.clear();
    for (std::size_t w = 0; w < todo_.size(); ++w)
        while (todo_[w] != 0) {  // newly stale columns lie behind
            const std::size_t k = 64 * w + at(std::countr_zero(todo_[w]));
            todo_[w] &= todo_[w] - 1;
            compute(pattern, order, position, order[k]);
        }
    for (const std::int32_t v : moved_list_) moved_[at(v)] = 0;
    moved_list_.clear();
    if (static_cast<std::int64_t>(pool_.size()) > 2 * rows_in_use_ + 1024) compact_pool();
}

void Columns::compute(const Pattern& pattern, std::span<const std::int32_t> order,
                      std::span<const std::int32_t> position, std::int32_t node) {
    ++computed_;
    std::int32_t *const found = found_rows_.data(), *const mark = mark_.data();
    std::size_t count = 0;
    std::int32_t below = 0;
    const std::int32_t own = position[at(node)];
    auto take = [&](std::int32_t u) {
        const std::int32_t p = position[at(u)];
        if (p <= own || mark[u] == node) return;
        mark[u] = node;
        found[count++] = p;
        below += pattern.size[at(u)];
    };
    // Children first: the rows of a single child are already sorted. Skip children that have moved
    // behind this node, because their parent is recomputed.
    for (std::int32_t c = head_[at(node)]; c >= 0; c = next_[at(c)])
        if (position[at(c)] < own)
            for (const std::int32_t u : rows(c)) take(u);
    for (const std::int32_t u : pattern.neighbours(node)) take(u);
    below_[at(node)] = below;
    if (is_unchanged(node, count)) return;
    if (!std::is_sorted(found, found + count)) std::sort(found, found + count);
    for (std::size_t i = 0; i < count; ++i) found[i] = order[at(found[i])];
    changed_[at(node)] = 1;
    const std::int32_t before = parent_[at(node)], up = count == 0 ? -1 : found[0];
    if (before >= 0 && position[at(before)] > own) queue_position(position[at(before)]);
    if (up >= 0) queue_position(position[at(up)]);
    if (up != before) {
        if (before >= 0) changed_[at(before)] = 1;
        unlink(node);
        parent_[at(node)] = up;
        link(node);
    }
    store_column(node, count);
}

/// Return true if a column still has exactly the marked rows and none of them has moved. A row that
/// has moved may have another position in the parent, even if the sequence is unchanged.
bool Columns::is_unchanged(std::int32_t node, std::size_t found) const noexcept {
    const std::span<const std::int32_t> old = rows(node);
    if (moved_[at(node)] != 0 || old.size() != found) return false;
    bool same = true;
    for (const std::int32_t u : old) same &= u >= 0 && mark_[at(u)] == node && moved_[at(u)] == 0;
    return same;
}

void Columns::store_column(std::int32_t node, std::size_t found) {
    const auto count = static_cast<std::int32_t>(found);
    const auto end = found_rows_.begin() + count;
    rows_in_use_ += count - count_[at(node)];
    if (count > count_[at(node)]) {
        begin_[at(node)] = static_cast<std::int64_t>(pool_.size());
        pool_.insert(pool_.end(), found_rows_.begin(), end);
    } else {
        std::copy(found_rows_.begin(), end, pool_.begin() + begin_[at(node)]);
    }
    count_[at(node)] = count;
}

void Columns::compact_pool() {
    spare_.clear();
    for (std::size_t v = 0; v < count_.size(); ++v) {
        const auto first = pool_.begin() + begin_[v];
        begin_[v] = static_cast<std::int64_t>(spare_.size());
        spare_.insert(spare_.end(), first, first + count_[v]);
    }
    pool_.swap(spare_);
}

std::size_t Columns::bytes() const noexcept {
    return base::bytes(parent_) + base::bytes(count_) + base::bytes(below_) + base::bytes(begin_) +
           base::bytes(pool_) + base::bytes(spare_) + base::bytes(found_rows_) +
           base::bytes(head_) + base::bytes(next_) + base::bytes(mark_) + base::bytes(rows_) +
           base::bytes(row_end_) + base::bytes(cursor_) + base::bytes(stale_) +
           base::bytes(moved_) + base::bytes(prev_) + base::bytes(todo_) +
           base::bytes(stale_list_) + base::bytes(moved_list_) + base::bytes(changed_) +
           base::bytes(new_of_old_) + base::bytes(carried_) + base::bytes(carried_begin_) +
           base::bytes(carried_stale_);
}

}  // namespace hawser::factor
