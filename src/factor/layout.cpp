// SPDX-License-Identifier: Apache-2.0
#include "factor/layout.h"

#include "base/index.h"
#include "factor/partial.h"

#include <algorithm>
#include <exception>

namespace hawser::factor {
namespace {

constexpr std::int32_t round8(std::int32_t n) { return (n + 7) & ~7; }

/// Clear a structure and keep the capacity of every array. Arrays that are overwritten entry by
/// entry keep their entries, because clearing them would write zeros first.
void reset(Symbolic& s) {
    s.tasks.clear();
    s.top.clear();
    s.top_tasks.clear();
    s.batches.clear();
    s.batch_steps.clear();
    s.slot_sign.clear();
    s.slot_index.clear();
    s.tail_slot.clear();
    s.node_step.clear();
    s.node_slot.clear();
    s.batch_scratch = s.panel_size = s.work_size = s.stack_begin = 0;
    s.scalars = s.max_front = 0;
    s.matrix_nnz = s.factor_nnz = s.flops = s.critical_flops = 0;
}

/// Run a and b, in parallel if there is a second thread.
template <class A, class B>
void run_both(base::Executor* team, A&& a, B&& b) {
    if (team == nullptr || team->threads() == 1) {
        a();
        b();
        return;
    }
    std::exception_ptr thrown[2];
    auto one = [&](int i, int) noexcept {
        try {
            i == 0 ? a() : b();
        } catch (...) {
            thrown[i] = std::current_exception();
        }
    };
    team->for_each(2, one);
    for (const std::exception_ptr& e : thrown)
        if (e) std::rethrow_exception(e);
}

}  // namespace

void Layout::assign_node_columns(const Pattern& pattern, Symbolic& s) {
    const std::size_t n = s.order.size();
    s.node_offset.resize(n);
    for (const std::int32_t v : s.order) {
        s.node_offset[at(v)] = s.scalars;
        s.scalars += pattern.size[at(v)];
    }
    s.sign.resize(at(s.scalars + kCopyWidth));
    std::int8_t* sign = s.sign.data();
    for (const std::int32_t v : s.order) {
        for (std::int32_t c = 0; c < kCopyWidth; ++c) sign[c] = pattern.sign[at(v)];
        sign += pattern.size[at(v)];
    }
    s.sign.resize(at(s.scalars));
    s.matrix_nnz = matrix_entries_ / 2;
}

void Layout::count_entries(const Pattern& pattern,
                           std::optional<std::span<const std::int32_t>> edited) {
    const std::int8_t* size = pattern.size.data();
    auto count = [&](std::int32_t v) {
        std::int32_t neighbour_scalars = 0;
        for (const std::int32_t u : pattern.neighbours(v)) neighbour_scalars += size[u];
        entries_[at(v)] = size[v] * (size[v] + 1 + neighbour_scalars);
        matrix_entries_ += entries_[at(v)];
    };
    if (edited) {
        for (const std::int32_t v : *edited) {
            matrix_entries_ -= entries_[at(v)];
            count(v);
        }
        return;
    }
    entries_.resize(pattern.size.size());
    matrix_entries_ = 0;
    for (std::int32_t v = 0; v < pattern.nodes(); ++v) count(v);
}

/// Find the fronts with the same pivots and rows as a front of the last layout.
void Layout::find_unchanged_fronts(const Columns& columns, const Symbolic& s, bool follows) {
    const std::size_t count = supernodes_.parent.size();
    unchanged_front_.assign(count, -1);
    unchanged_count_ = 0;
    if (!follows) return;
    const std::int32_t *const order = s.order.data(), *const then = old_order_.data();
    for (std::size_t f = 0; f < count; ++f) {
        const std::int32_t begin = supernodes_.begin[f], end = supernodes_.begin[f + 1];
        const std::int32_t g = old_node_front_[at(order[begin])];
        const Front& old = old_fronts_[at(g)];
        bool same =
            old.node_end - old.node_begin == end - begin && !columns.column_changed(order[end - 1]);
        for (std::int32_t k = 0; same && k < end - begin; ++k)
            same = order[begin + k] == then[old.node_begin + k];
        if (!same) continue;
        unchanged_front_[f] = g;
        ++unchanged_count_;
    }
}

/// Set sizes, addresses and update rows of all fronts.
void Layout::lay_out_fronts(const Columns& columns, Symbolic& s) {
    const std::size_t count = supernodes_.parent.size();
    s.fronts.resize(count);
    s.node_front.resize(s.order.size());
    flops_.assign(count, 0);
    std::int64_t rows = 0;
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        front = Front{};
        front.node_begin = supernodes_.begin[f];
        front.node_end = supernodes_.begin[f + 1];
        front.parent = supernodes_.parent[f];
        front.p = supernodes_.p[f];
        front.offset = s.node_offset[at(s.order[at(front.node_begin)])];
        for (std::int32_t k = front.node_begin; k < front.node_end; ++k)
            s.node_front[at(s.order[at(k)])] = static_cast<std::int32_t>(f);
        front.q = columns.below(last_node(s, front));
        front.rows = rows;
        rows += front.q;
        front.ld = round8(front.p + front.q);
        front.ldu = round8(front.q);
        if (in_chain(s, front)) {
            front.batch = 0;  // lay_out_batches() sets the batch and the panel
            continue;
        }
        front.panel = s.panel_size;
        s.panel_size += static_cast<std::int64_t>(front.ld) * front.p;
        // Add a gap behind the panel. Vector loads of the update rows then end in the gap behind
        // the last column, not in the next panel, which another task may be writing.
        if (front.p + front.ldu > front.ld) s.panel_size += 8;
        s.max_front = std::max(s.max_front, front.ld);
        s.factor_nnz += static_cast<std::int64_t>(front.p) * (front.p + 1) / 2 +
                        static_cast<std::int64_t>(front.p) * front.q;
        flops_[f] = front_flops(front.p, front.q);
        s.flops += flops_[f];
    }
    s.panel_size += 64;  // vector loads may read past the last column
    s.rows.resize(at(rows));
}

bool Layout::in_chain(const Symbolic& s, const Front& front) const noexcept {
    return !chain_of_.empty() && chain_of_[at(s.order[at(front.node_begin)])] >= 0;
}

void Layout::link_children(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    for (const Front& f : s.fronts)
        if (f.parent >= 0) ++s.fronts[at(f.parent)].child_end;
    std::int32_t sum = 0;
    cursor_.resize(count);
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        cursor_[f] = front.child_begin = sum;
        sum += front.child_end;
        front.child_end = sum;
    }
    s.children.resize(at(sum));
    for (std::size_t f = 0; f < count; ++f)
        if (const std::int32_t p = s.fronts[f].parent; p >= 0)
            s.children[at(cursor_[at(p)]++)] = static_cast<std::int32_t>(f);
}

void Layout::run(const Pattern& pattern, const Columns& columns, const Chains& chains, Symbolic& s,
                 std::optional<std::span<const std::int32_t>> edited, base::Executor* team) {
    const bool follows = edited.has_value();
    s.fronts.swap(old_fronts_);
    s.runs.swap(old_runs_);
    s.node_front.swap(old_node_front_);
    reset(s);
    chain_of_.clear();
    if (chains.count() > 0) {
        chain_of_.resize(s.order.size(), -1);
        for (int c = 0; c < chains.count(); ++c)
            for (std::int32_t u = chains.begin[at(c)]; u < chains.begin[at(c) + 1]; ++u)
                for (const std::int32_t v : chains.unit(u)) chain_of_[at(v)] = c;
    }
    tree_.postorder(columns, s.order, s.position);
    tree_.grow_fronts(pattern, columns, s.order, s.position, chain_of_, follows, supernodes_);
    find_unchanged_fronts(columns, s, follows);
    count_entries(pattern, edited);
    assign_node_columns(pattern, s);
    lay_out_fronts(columns, s);
    front_of_chain_.clear();
    for (int c = 0; c < chains.count(); ++c)
        front_of_chain_.push_back(s.node_front[at(chains.unit(chains.begin[at(c)])[0])]);
    chain_rows_.clear();
    fill_rows(pattern, columns, true, s);
    link_children(s);
    run_both(
        team,
        [&] {
            fill_rows(pattern, columns, false, s);
            find_all_runs(pattern, columns, s);
        },
        [&] {
            batches_.run(pattern, chains, front_of_chain_, s);
            choose_tasks(s);
            link_tasks(s);
            if (s.updates_kept)
                separate_updates(s);
            else
                assign_update_addresses(s);
        });
    old_order_ = s.order;
}

std::size_t Layout::bytes() const noexcept {
    return tree_.bytes() + base::bytes(supernodes_.begin) + base::bytes(supernodes_.parent) +
           base::bytes(chain_of_) + base::bytes(front_of_chain_) + base::bytes(cursor_) +
           base::bytes(task_of_front_) + base::bytes(flops_) + base::bytes(subtree_flops_) +
           base::bytes(path_) + base::bytes(height_) + base::bytes(parity_) +
           base::bytes(crosses_) + base::bytes(edges_) + base::bytes(entries_) +
           base::bytes(row_of_) + base::bytes(freed_) + base::bytes(chain_rows_) +
           base::bytes(old_fronts_) + base::bytes(old_runs_) + base::bytes(old_order_) +
           base::bytes(old_node_front_) + base::bytes(unchanged_front_) +
           base::bytes(supernodes_.p) + base::bytes(predecessors_left_) + batches_.bytes();
}

}  // namespace hawser::factor
