// SPDX-License-Identifier: Apache-2.0
#include "base/index.h"
#include "factor/layout.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Return the flops of all batch steps that contain a chain.
std::int64_t chain_flops(const Symbolic& s, const Front& front) {
    const Batch& batch = s.batches[at(front.batch)];
    std::int64_t flops = 0;
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k)
        flops += front_flops(s.batch_steps[at(k)].p, s.batch_steps[at(k)].q);
    return flops;
}

}  // namespace

/// Split the tree into subtrees and the paths above them. Targets depend on the tree alone.
void Layout::choose_tasks(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    subtree_flops_.assign(count, 0);
    path_.assign(count, 0);
    std::int64_t total = 0;
    for (std::size_t f = 0; f < count; ++f) {
        const Front& front = s.fronts[f];
        // The constant stands for work per front that flops do not show. The work of a chain is
        // done before the tasks.
        const bool chain = front.batch >= 0;
        const std::int64_t own = flops_[f];
        subtree_flops_[f] += own + (chain ? 0 : 600);
        path_[f] += chain ? chain_flops(s, front) : own;
        s.critical_flops = std::max(s.critical_flops, path_[f]);
        if (front.parent < 0) {
            total += subtree_flops_[f];
            continue;
        }
        subtree_flops_[at(front.parent)] += subtree_flops_[f];
        path_[at(front.parent)] = std::max(path_[at(front.parent)], path_[f]);
    }
    constexpr std::int64_t kTargetTasks = 48, kMinTaskFlops = 40'000;
    const std::int64_t target = std::max(total / kTargetTasks, kMinTaskFlops);
    // Top: every front whose subtree exceeds the target.
    std::int32_t begin = 0;
    std::int64_t work = 0;
    auto close = [&](std::int32_t end) {
        if (end > begin) s.tasks.push_back({begin, end, work});
        begin = end;
        work = 0;
    };
    task_of_front_.assign(count, -1);
    for (std::size_t f = 0; f < count; ++f) {
        const auto id = static_cast<std::int32_t>(f);
        if (subtree_flops_[f] > target) {
            close(id);
            s.top.push_back(id);
            begin = id + 1;
        } else if (s.fronts[f].parent < 0 || subtree_flops_[at(s.fronts[f].parent)] > target) {
            work += subtree_flops_[f];
            if (work >= target / 2) close(id + 1);
        }
    }
    close(static_cast<std::int32_t>(count));
    for (std::size_t t = 0; t < s.tasks.size(); ++t)
        std::fill(task_of_front_.begin() + s.tasks[t].begin,
                  task_of_front_.begin() + s.tasks[t].end, static_cast<std::int32_t>(t));
    choose_top_tasks(s, target);
}

/// Form tasks of the fronts above the subtrees (the top). If a front has only one child in the top,
/// it must wait for this child and belongs to the same task. A task ends when its work reaches that
/// of a subtree, because other predecessors of its last front may be late.
void Layout::choose_top_tasks(Symbolic& s, std::int64_t target) {
    const auto below = static_cast<std::int32_t>(s.tasks.size());
    for (const std::int32_t f : s.top) {
        const Front& front = s.fronts[at(f)];
        std::int32_t before = -1, children = 0;
        for (std::int32_t c = front.child_begin; c < front.child_end; ++c) {
            const std::int32_t owner = task_of_front_[at(s.children[at(c)])];
            if (owner < below) continue;
            before = owner;
            ++children;
        }
        const std::int64_t work = flops_[at(f)] + 600;
        if (children == 1 && s.top_tasks[at(before - below)].flops + work <= target) {
            task_of_front_[at(f)] = before;
            s.top_tasks[at(before - below)].flops += work;
        } else {
            task_of_front_[at(f)] = below + static_cast<std::int32_t>(s.top_tasks.size());
            s.top_tasks.push_back({0, 0, work});
        }
    }
    std::sort(s.top.begin(), s.top.end(), [&](std::int32_t a, std::int32_t b) {
        return task_of_front_[at(a)] != task_of_front_[at(b)]
                   ? task_of_front_[at(a)] < task_of_front_[at(b)]
                   : a < b;
    });
    for (std::size_t k = 0; k < s.top.size(); ++k) {
        TaskRange& task = s.top_tasks[at(task_of_front_[at(s.top[k])] - below)];
        if (task.end == 0) task.begin = static_cast<std::int32_t>(k);
        task.end = static_cast<std::int32_t>(k) + 1;
    }
}

/// Build the dependency graph of tasks: an edge for each update matrix that one task passes to
/// another.
void Layout::link_tasks(Symbolic& s) {
    const auto batches = static_cast<std::int32_t>(s.batches.size());
    s.graph.work.clear();
    for (const Batch& b : s.batches) s.graph.work.push_back(b.flops);
    for (const TaskRange& t : s.tasks) s.graph.work.push_back(t.flops);
    for (const TaskRange& t : s.top_tasks) s.graph.work.push_back(t.flops);
    s.front_task.resize(s.fronts.size());
    for (std::size_t f = 0; f < s.fronts.size(); ++f)
        s.front_task[f] = s.fronts[f].batch >= 0 ? s.fronts[f].batch : batches + task_of_front_[f];
    edges_.clear();
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        if (s.fronts[f].parent < 0) continue;
        const std::int32_t from = s.front_task[f], to = s.front_task[at(s.fronts[f].parent)];
        if (from != to && (edges_.empty() || edges_.back() != std::pair(from, to)))
            edges_.emplace_back(from, to);
    }
    s.graph.build(edges_, predecessors_left_);
}

/// Assign addresses to the update matrices. A task has two stacks, for fronts of even and odd
/// depth. The stacks of all tasks have equal offsets, and each thread has its own memory for them.
/// Update matrices that are passed to another task have separate addresses.
void Layout::assign_update_addresses(Symbolic& s) {
    const std::size_t count = s.fronts.size();
    parity_.assign(count, 0);
    for (std::size_t f = count; f-- > 0;)
        if (s.fronts[f].parent >= 0) parity_[f] = parity_[at(s.fronts[f].parent)] ^ 1;
    const std::size_t stacks = 2 * (s.tasks.size() + s.top_tasks.size());
    height_.assign(stacks, 0);
    auto stack_of = [&](std::size_t f) { return 2 * at(task_of_front_[f]) + parity_[f]; };
    std::int64_t shared = 0, even = 0, odd = 0;  // updates handed on; heights of the stacks
    crosses_.assign(count, 0);
    auto size_of = [&](const Front& f) { return static_cast<std::int64_t>(f.ldu) * f.q; };
    freed_.assign(count, 0);
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        height_[stack_of(f) ^ 1] -= freed_[f];  // its children lie on the other stack
        crosses_[f] = front.parent >= 0 &&
                      (front.batch >= 0 || task_of_front_[at(front.parent)] != task_of_front_[f]);
        if (crosses_[f]) {
            front.update = shared;
            // Vector loads may read one vector past it.
            shared += size_of(front) + 8;
            continue;
        }
        const std::size_t k = stack_of(f);
        front.update = height_[k];
        if (front.parent >= 0) {
            height_[k] += size_of(front);
            freed_[at(front.parent)] += size_of(front);
        }
        std::int64_t& peak = parity_[f] != 0 ? odd : even;
        peak = std::max(peak, front.update + size_of(front));
    }
    // Leave at least one vector between stacks, because of vector loads.
    auto round = [](std::int64_t size) { return (size + 8 + 63) & ~std::int64_t{63}; };
    s.stack_begin = round(shared);
    const std::int64_t base[] = {s.stack_begin, s.stack_begin + round(even)};
    for (std::size_t f = 0; f < count; ++f)
        if (!crosses_[f]) s.fronts[f].update += base[parity_[f]];
    s.work_size = base[1] + round(odd) + 64;
}

}  // namespace hawser::factor
