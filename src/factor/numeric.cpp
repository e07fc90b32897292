// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"

#include "factor/grow.h"

#include <algorithm>
#include <numeric>

namespace hawser::factor {

void SymmetricNumeric::reserve_buffers(const Symbolic& symbolic, int threads, int sides) {
    const std::int64_t work = work_size(symbolic, threads);
    const auto carried = static_cast<std::int64_t>(symbolic.rows.size());
    // Arrays of a structure that follows a pattern become too small one after another, so they grow
    // together.
    const bool follows = is_too_small(panel_, symbolic.panel_size) || is_too_small(work_, work) ||
                         is_too_small(carry_, carried);
    auto room = [&](std::int64_t size) { return follows ? size + size / 8 : size; };
    grow_discarding(panel_, room(symbolic.panel_size), symbolic.updates_kept);
    grow_discarding(pivot_, symbolic.scalars);
    grow_discarding(work_, room(work), symbolic.updates_kept);
    grow_discarding(carry_, room(carried));
    const auto slots = kLaneCount * static_cast<std::int64_t>(symbolic.slot_sign.size());
    grow_discarding(slot_pivot_, slots);
    grow_discarding(slot_y_, slots);
    grow_discarding(wrong_pivots_, symbolic.graph.nodes());
    queue_.reserve(symbolic.graph, threads);
    const std::int64_t need =
        sides * std::max(scratch_size(symbolic.max_front), symbolic.batch_scratch);
    const std::int64_t stride = (need + 63) & ~std::int64_t{63};
    scratch_stride_ = std::max(scratch_stride_, stride);
    grow_discarding(scratch_, scratch_stride_ * threads);
}

constexpr std::int64_t kCoreCacheBytes = 1'048'576;  // bytes of a core's own cache

FactorView SymmetricNumeric::view(const Symbolic& s, int thread) noexcept {
    double* stack = work_.data() + thread * (s.work_size - s.stack_begin);
    const std::int64_t bytes = s.panel_size * static_cast<std::int64_t>(sizeof(double));
    FactorView v{s.fronts.data(),    s.children.data(),   s.rows.data(),
                 s.runs.data(),      s.sign.data(),       panel_.data(),
                 pivot_.data(),      work_.data(),        stack,
                 s.stack_begin,      carry_.data(),       s.batch_steps.data(),
                 s.slot_sign.data(), s.slot_index.data(), s.tail_slot.data(),
                 slot_pivot_.data(), slot_y_.data(),      bytes > kCoreCacheBytes};
    if (!unsymmetric_) return v;
    v.unsymmetric = kind_.data();
    v.upper = upper_.data();
    v.upper_work = upper_work_.data();
    v.upper_stack = v.upper_work + (stack - work_.data());
    v.wrong = wrong_pivot_mark_.data();
    return v;
}

void SymmetricNumeric::clear(const Symbolic& symbolic, base::Executor& executor) noexcept {
    constexpr std::int64_t kChunk = 65'536;
    const auto chunks = static_cast<int>((symbolic.panel_size + kChunk - 1) / kChunk);
    auto zero = [&](int i, int) noexcept {
        const std::int64_t from = i * kChunk, to = std::min(from + kChunk, symbolic.panel_size);
        std::fill(panel_.begin() + from, panel_.begin() + to, double{0});
    };
    executor.for_each(chunks, zero);
}

/// Call on_batch(batch, node, thread) for all batches and on_fronts(begin, end, node, thread) for
/// all ranges of fronts. A node's ranges are processed in ascending order, or in descending order
/// in a backward pass.
template <class Batches, class Fronts>
void SymmetricNumeric::run_tasks(const Symbolic& s, TaskPass pass, base::Executor& executor,
                                 Batches&& on_batch, Fronts&& on_fronts) noexcept {
    const bool up = pass != TaskPass::backward;
    const std::size_t batches = s.batches.size(), below = batches + s.tasks.size();
    auto node = [&](int i, int thread) noexcept {
        const auto n = static_cast<std::size_t>(i);
        if (executor.stopping()) return;
        if (n < batches) {
            on_batch(s.batches[n], n, thread);
        } else if (n < below) {
            const TaskRange& t = s.tasks[n - batches];
            on_fronts(t.begin, t.end, n, thread);
        } else {
            const TaskRange& t = s.top_tasks[n - below];
            for (std::int32_t k = 0; k < t.end - t.begin; ++k) {
                const std::int32_t f =
                    s.top[static_cast<std::size_t>(up ? t.begin + k : t.end - 1 - k)];
                on_fronts(f, f + 1, n, thread);
            }
        }
    };
    queue_.run(s.graph, pass, executor, node);
}

int SymmetricNumeric::count_wrong_pivots(const Symbolic& symbolic) const noexcept {
    return std::accumulate(wrong_pivots_.begin(), wrong_pivots_.begin() + symbolic.graph.nodes(),
                           0);
}

int SymmetricNumeric::factor(const Symbolic& symbolic, base::Executor& executor) noexcept {
    const Kernels& kernels = factor_kernels();
    std::fill_n(wrong_pivots_.begin(), symbolic.graph.nodes(), 0);
    run_tasks(
        symbolic, TaskPass::factor, executor,
        [&](const Batch& batch, std::size_t node, int thread) noexcept {
            wrong_pivots_[node] = kernels.factor_batch(
                view(symbolic, thread), batch, batch.step_begin, batch.step_end, scratch(thread));
        },
        [&](std::int32_t begin, std::int32_t end, std::size_t node, int thread) noexcept {
            wrong_pivots_[node] +=
                kernels.factor(view(symbolic, thread), begin, end, scratch(thread));
        });
    return count_wrong_pivots(symbolic);
}

void SymmetricNumeric::solve(const Symbolic& symbolic, double* x,
                             base::Executor& executor) noexcept {
    const FactorView v = view(symbolic, 0);
    const Kernels& kernels = factor_kernels();
    run_tasks(
        symbolic, TaskPass::forward, executor,
        [&](const Batch& batch, std::size_t, int thread) noexcept {
            kernels.forward_batch(v, batch, batch.step_begin, batch.step_end, x, scratch(thread));
        },
        [&](std::int32_t begin, std::int32_t end, std::size_t, int thread) noexcept {
            kernels.forward(v, begin, end, x, scratch(thread));
        });
    backward(symbolic, x, executor);
}

void SymmetricNumeric::backward(const Symbolic& symbolic, double* x,
                                base::Executor& executor) noexcept {
    const FactorView v = view(symbolic, 0);
    const Kernels& kernels = factor_kernels();
    run_tasks(
        symbolic, TaskPass::backward, executor,
        [&](const Batch& batch, std::size_t, int thread) noexcept {
            kernels.backward_batch(v, batch, x, scratch(thread));
        },
        [&](std::int32_t begin, std::int32_t end, std::size_t, int thread) noexcept {
            kernels.backward(v, begin, end, x, scratch(thread));
        });
}

std::size_t SymmetricNumeric::bytes() const noexcept {
    return base::bytes(panel_) + base::bytes(pivot_) + base::bytes(work_) + base::bytes(carry_) +
           base::bytes(slot_pivot_) + base::bytes(slot_y_) + base::bytes(scratch_) +
           base::bytes(wrong_pivots_) + queue_.bytes();
}

}  // namespace hawser::factor
