// SPDX-License-Identifier: Apache-2.0
#include "factor/symbolic.h"

#include "factor/tree.h"

#include <algorithm>

namespace hawser::factor {
namespace {

constexpr std::int32_t round8(std::int32_t n) { return (n + 7) & ~7; }

/// Fill in sizes, addresses, update rows and the maps into parents.
void lay_out_fronts(const Pattern& pattern, const Supernodes& sn,
                    const std::vector<std::int32_t>& chain_of, Symbolic& s) {
    const std::size_t count = sn.begin.size() - 1;
    s.fronts.resize(count);
    s.node_front.resize(s.order.size());
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        front.node_begin = sn.begin[f];
        front.node_end = sn.begin[f + 1];
        front.parent = sn.parent[f];
        front.offset = s.node_offset[static_cast<std::size_t>(
            s.order[static_cast<std::size_t>(front.node_begin)])];
        front.rows = static_cast<std::int64_t>(s.rows.size());
        for (std::int32_t k = front.node_begin; k < front.node_end; ++k) {
            const auto node = static_cast<std::size_t>(s.order[static_cast<std::size_t>(k)]);
            front.p += pattern.size[node];
            s.node_front[node] = static_cast<std::int32_t>(f);
        }
        for (std::int32_t i = sn.row_begin[f]; i < sn.row_begin[f + 1]; ++i) {
            const auto node = static_cast<std::size_t>(
                s.order[static_cast<std::size_t>(sn.rows[static_cast<std::size_t>(i)])]);
            for (int c = 0; c < pattern.size[node]; ++c) s.rows.push_back(s.node_offset[node] + c);
            front.q += pattern.size[node];
        }
        front.ld = round8(front.p + front.q);
        front.ldu = round8(front.q);
        if (chain_of[static_cast<std::size_t>(
                s.order[static_cast<std::size_t>(front.node_begin)])] >= 0) {
            front.batch = 0;  // lay_out_batches() gives the right one, and the panel
            continue;
        }
        front.panel = s.panel_size;
        s.panel_size += static_cast<std::int64_t>(front.ld) * front.p;
        // Vector loads of the update rows then end behind the last column: into a gap, not into
        // the next panel, which another task may be writing.
        if (front.p + front.ldu > front.ld) s.panel_size += 8;
        s.max_front = std::max(s.max_front, front.ld);
        s.factor_nnz += static_cast<std::int64_t>(front.p) * (front.p + 1) / 2 +
                        static_cast<std::int64_t>(front.p) * front.q;
        s.flops += front_flops(front.p, front.q);
    }
    s.panel_size += 64;  // vector loads may read past the last column
}

/// Local row of a permuted scalar in a front.
std::int32_t local_row(const Symbolic& s, const Front& front, std::int32_t scalar) {
    if (scalar < front.offset + front.p) return scalar - front.offset;
    const auto* first = s.rows.data() + front.rows;
    return front.p +
           static_cast<std::int32_t>(std::lower_bound(first, first + front.q, scalar) - first);
}

void link_children(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    std::vector<std::int32_t> begin(count + 1, 0);
    for (const Front& f : s.fronts)
        if (f.parent >= 0) ++begin[static_cast<std::size_t>(f.parent) + 1];
    for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
    s.children.resize(static_cast<std::size_t>(begin[count]));
    std::vector<std::int32_t> cursor(begin.begin(), begin.end() - 1);
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        front.child_begin = begin[f];
        front.child_end = begin[f + 1];
        if (front.parent < 0) continue;
        auto& c = cursor[static_cast<std::size_t>(front.parent)];
        s.children[static_cast<std::size_t>(c++)] = static_cast<std::int32_t>(f);
    }
    for (Front& front : s.fronts) {
        front.run_begin = front.run_end = static_cast<std::int32_t>(s.runs.size());
        if (front.parent < 0) continue;
        const Front& parent = s.fronts[static_cast<std::size_t>(front.parent)];
        for (std::int32_t i = 0; i < front.q; ++i) {
            const std::int32_t to =
                local_row(s, parent, s.rows[static_cast<std::size_t>(front.rows + i)]);
            // A run stays on one side of the parent's pivot boundary: its columns then lie
            // wholly in the panel or wholly in the update matrix.
            if (static_cast<std::int32_t>(s.runs.size()) > front.run_begin && to != parent.p &&
                s.runs.back().to + s.runs.back().length == to)
                ++s.runs.back().length;
            else
                s.runs.push_back({i, to, 1});
        }
        front.run_end = static_cast<std::int32_t>(s.runs.size());
    }
}

/// Flops of the steps that a chain takes part in.
std::int64_t chain_flops(const Symbolic& s, const Front& front) {
    const Batch& batch = s.batches[static_cast<std::size_t>(front.batch)];
    std::int64_t flops = 0;
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k) {
        const BatchStep& step = s.batch_steps[static_cast<std::size_t>(k)];
        flops += front_flops(step.p, step.q);
    }
    return flops;
}

/// Split the tree into parallel tasks and a serial top. Targets depend on the tree alone.
void choose_tasks(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    std::vector<std::int64_t> subtree(count), path(count);
    std::vector<std::int32_t> first(count);
    for (std::size_t f = 0; f < count; ++f) {
        const Front& front = s.fronts[f];
        std::int64_t longest = 0;
        // The constant stands for the work per front that flops do not show. A chain's work is
        // done before the tasks.
        const std::int64_t own = front.batch < 0 ? front_flops(front.p, front.q) : 0;
        subtree[f] = own + (front.batch < 0 ? 600 : 0);
        first[f] = static_cast<std::int32_t>(f);
        for (std::int32_t c = front.child_begin; c < front.child_end; ++c) {
            const auto child = static_cast<std::size_t>(s.children[static_cast<std::size_t>(c)]);
            subtree[f] += subtree[child];
            longest = std::max(longest, path[child]);
            first[f] = std::min(first[f], first[child]);
        }
        path[f] = longest + (front.batch < 0 ? own : chain_flops(s, front));
        s.critical_flops = std::max(s.critical_flops, path[f]);
    }
    std::int64_t total = 0;
    for (std::size_t f = 0; f < count; ++f)
        if (s.fronts[f].parent < 0) total += subtree[f];
    constexpr std::int64_t kParts = 48, kSmallest = 40'000;
    const std::int64_t target = std::max(total / kParts, kSmallest);
    // Top: every front whose subtree is larger than the target.
    std::int32_t begin = 0;
    std::int64_t work = 0;
    auto close = [&](std::int32_t end) {
        if (end > begin) s.tasks.push_back({begin, end, work});
        begin = end;
        work = 0;
    };
    for (std::size_t f = 0; f < count; ++f) {
        const auto id = static_cast<std::int32_t>(f);
        if (subtree[f] > target) {
            close(id);
            s.top.push_back(id);
            begin = id + 1;
        } else if (s.fronts[f].parent < 0 ||
                   subtree[static_cast<std::size_t>(s.fronts[f].parent)] > target) {
            work += subtree[f];
            if (work >= target / 2) close(id + 1);
        }
    }
    close(static_cast<std::int32_t>(count));
}

/// Addresses of the update matrices: two stacks for each task, by parity of depth.
void place_updates(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    std::vector<std::int32_t> task(count, -1);
    for (std::size_t t = 0; t < s.tasks.size(); ++t)
        for (std::int32_t f = s.tasks[t].begin; f < s.tasks[t].end; ++f)
            task[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(t);
    std::vector<std::uint8_t> parity(count, 0);
    for (std::size_t f = count; f-- > 0;)
        if (s.fronts[f].parent >= 0)
            parity[f] = parity[static_cast<std::size_t>(s.fronts[f].parent)] ^ 1;
    const std::size_t stacks = 2 * (s.tasks.size() + 1);
    std::vector<std::int64_t> height(stacks, 0), peak(stacks, 0);
    auto stack_of = [&](std::size_t f) {
        const auto t = static_cast<std::size_t>(task[f]) + 1;  // −1 + 1: 0 is the top
        return 2 * t + parity[f];
    };
    std::int64_t shared = 0;  // updates handed from a task to the top
    std::vector<bool> crosses(count, false);
    auto size_of = [&](const Front& f) { return static_cast<std::int64_t>(f.ldu) * f.q; };
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        for (std::int32_t c = front.child_begin; c < front.child_end; ++c) {
            const auto child = static_cast<std::size_t>(s.children[static_cast<std::size_t>(c)]);
            if (!crosses[child]) height[stack_of(child)] -= size_of(s.fronts[child]);
        }
        // All chains are done before any task: their updates wait outside the stacks.
        crosses[f] = front.parent >= 0 &&
                     (front.batch >= 0 || task[static_cast<std::size_t>(front.parent)] != task[f]);
        if (crosses[f]) {
            front.update = shared;
            shared += size_of(front);
            continue;
        }
        const std::size_t k = stack_of(f);
        front.update = height[k];
        if (front.parent >= 0) height[k] += size_of(front);
        peak[k] = std::max(peak[k], front.update + size_of(front));
    }
    std::vector<std::int64_t> base(stacks);
    std::int64_t at = shared;
    for (std::size_t k = 0; k < stacks; ++k) {
        base[k] = at;
        // At least one vector between stacks, for the same reason.
        at += (peak[k] + 8 + 63) & ~std::int64_t{63};
    }
    for (std::size_t f = 0; f < count; ++f)
        if (!crosses[f]) s.fronts[f].update += base[stack_of(f)];
    s.work_size = at + 64;
}

}  // namespace

std::int64_t front_flops(int p, int q) noexcept {
    std::int64_t flops = 0;
    for (int k = 0; k < p; ++k) {
        const std::int64_t m = p + q - k - 1;
        flops += m * (m + 2);
    }
    return flops;
}

BlockTarget Symbolic::target(std::int32_t row, std::int32_t column) const noexcept {
    const Front& front =
        fronts[static_cast<std::size_t>(node_front[static_cast<std::size_t>(column)])];
    if (front.batch >= 0) {
        const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
        const BatchStep& step = batch_steps[static_cast<std::size_t>(node_step[j])];
        std::int32_t slot = node_slot[i];
        if (node_front[i] != node_front[j])
            slot = step.p + tail_slot[static_cast<std::size_t>(
                                front.rows + local_row(*this, front, node_offset[i]) - front.p)];
        else if (node_step[i] != node_step[j])
            slot = step.p + (node_step[i] - node_step[j] - 1) *
                                batches[static_cast<std::size_t>(front.batch)].body;
        return {step.panel +
                    kLaneCount * (static_cast<std::int64_t>(slot) * step.p + node_slot[j]) +
                    front.lane,
                kLaneCount * step.p, kLaneCount};
    }
    const std::int32_t r = local_row(*this, front, node_offset[static_cast<std::size_t>(row)]);
    const std::int32_t c = node_offset[static_cast<std::size_t>(column)] - front.offset;
    return {front.panel + static_cast<std::int64_t>(c) * front.ld + r, 1, front.ld};
}

std::int64_t Symbolic::column_address(std::int32_t k) const noexcept {
    const auto node = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
    const Front& front = fronts[static_cast<std::size_t>(node_front[node])];
    if (front.batch >= 0) return batch_steps[static_cast<std::size_t>(node_step[node])].panel;
    return front.panel + static_cast<std::int64_t>(node_offset[node] - front.offset) * front.ld;
}

std::size_t Symbolic::bytes() const noexcept {
    return base::bytes(order) + base::bytes(position) + base::bytes(node_offset) +
           base::bytes(node_front) + base::bytes(fronts) + base::bytes(children) +
           base::bytes(rows) + base::bytes(runs) + base::bytes(sign) + base::bytes(tasks) +
           base::bytes(top) + base::bytes(batches) + base::bytes(batch_steps) +
           base::bytes(slot_sign) + base::bytes(slot_index) + base::bytes(tail_slot) +
           base::bytes(node_step) + base::bytes(node_slot);
}

Symbolic analyse(const Pattern& pattern, std::vector<std::int32_t> order) {
    return analyse(pattern, Elimination{std::move(order), {}});
}

Symbolic analyse(const Pattern& pattern, Elimination plan) {
    Symbolic s;
    const Chains& chains = plan.chains;
    std::vector<std::int32_t> chain_of(pattern.size.size(), -1);
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[static_cast<std::size_t>(c)];
             u < chains.begin[static_cast<std::size_t>(c) + 1]; ++u)
            for (std::int32_t v : chains.unit(u)) chain_of[static_cast<std::size_t>(v)] = c;
    const Supernodes sn = build_tree(pattern, plan.order, chain_of);
    s.order = std::move(plan.order);
    const std::size_t n = s.order.size();
    s.position.resize(n);
    s.node_offset.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
        const auto node = static_cast<std::size_t>(s.order[k]);
        s.position[node] = static_cast<std::int32_t>(k);
        s.node_offset[node] = s.scalars;
        s.scalars += pattern.size[node];
        for (int c = 0; c < pattern.size[node]; ++c) s.sign.push_back(pattern.sign[node]);
    }
    for (std::size_t v = 0; v < n; ++v) {
        const auto d = static_cast<std::uint8_t>(pattern.size[v]);
        s.matrix_nnz += d * (d + 1) / 2;
        for (std::int32_t u : pattern.neighbours(static_cast<int>(v)))
            if (u > static_cast<std::int32_t>(v))
                s.matrix_nnz += d * pattern.size[static_cast<std::size_t>(u)];
    }
    lay_out_fronts(pattern, sn, chain_of, s);
    std::vector<std::int32_t> front_of_chain;
    for (int c = 0; c < chains.count(); ++c)
        front_of_chain.push_back(s.node_front[static_cast<std::size_t>(
            chains.unit(chains.begin[static_cast<std::size_t>(c)])[0])]);
    lay_out_batches(pattern, chains, front_of_chain, s);
    link_children(s);
    choose_tasks(s);
    place_updates(s);
    return s;
}

}  // namespace hawser::factor
