// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"

#include <algorithm>
#include <numeric>

namespace hawser::factor {
namespace {

/// Contents are not kept. Structures that follow a changing pattern (repair.h) grow again and
/// again: with room to spare where that is expected, and from the second time on.
template <class T>
void grow(base::Array<T>& array, std::int64_t size, bool spare = false) {
    if (static_cast<std::int64_t>(array.size()) >= size) return;
    const std::int64_t room = array.empty() && !spare ? size : size + size / 4;
    base::Array<T>().swap(array);
    array.resize(static_cast<std::size_t>(room));
}

/// Whether an array must grow that has been in use.
template <class T>
[[nodiscard]] bool outgrown(const base::Array<T>& array, std::int64_t size) {
    return !array.empty() && static_cast<std::int64_t>(array.size()) < size;
}

}  // namespace

void Numeric::reserve(const Symbolic& symbolic, int threads, bool unsymmetric) {
    const std::int64_t work =
        symbolic.work_size + (threads - 1) * (symbolic.work_size - symbolic.stack_begin);
    const auto carried = static_cast<std::int64_t>(symbolic.rows.size());
    // What follows a pattern outgrows its arrays one after another: they grow together.
    const bool follows =
        outgrown(panel_, symbolic.panel_size) || outgrown(work_, work) || outgrown(carry_, carried);
    auto room = [&](std::int64_t size) { return follows ? size + size / 8 : size; };
    grow(panel_, room(symbolic.panel_size), symbolic.updates_kept);
    grow(pivot_, symbolic.scalars);
    grow(work_, room(work), symbolic.updates_kept);
    grow(carry_, room(carried));
    const auto slots = kLaneCount * static_cast<std::int64_t>(symbolic.slot_sign.size());
    grow(slot_pivot_, slots);
    grow(slot_y_, slots);
    grow(wrong_, symbolic.graph.nodes());
    queue_.reserve(symbolic.graph, threads);
    const std::int64_t need =
        (unsymmetric ? 2 : 1) * std::max(scratch_size(symbolic.max_front), symbolic.batch_scratch);
    const std::int64_t stride = (need + 63) & ~std::int64_t{63};
    scratch_stride_ = std::max(scratch_stride_, stride);
    grow(scratch_, scratch_stride_ * threads);
    cut_pieces(symbolic);
    find_stage(symbolic, threads);
    unsymmetric_ = false;
    wrong_nodes_.clear();
    if (!unsymmetric) return;
    grow(upper_, symbolic.panel_size, symbolic.updates_kept);
    grow(upper_work_, work, symbolic.updates_kept);
    grow(kind_, static_cast<std::int64_t>(symbolic.fronts.size()));
    grow(wrong_mark_, symbolic.scalars);
    wrong_nodes_.reserve(symbolic.order.size());
}

// Doubles: a megabyte, and three. Between them asking ahead for panels of fronts costs more than it
// brings.
constexpr std::int64_t kCached = 131'072, kNear = 393'216;

FactorView Numeric::view(const Symbolic& s, int thread) noexcept {
    double* stack = work_.data() + thread * (s.work_size - s.stack_begin);
    FactorView v{s.fronts.data(),     s.children.data(),   s.rows.data(),
                 s.runs.data(),       s.sign.data(),       panel_.data(),
                 pivot_.data(),       work_.data(),        stack,
                 s.stack_begin,       carry_.data(),       s.batch_steps.data(),
                 s.slot_sign.data(),  s.slot_index.data(), s.tail_slot.data(),
                 slot_pivot_.data(),  slot_y_.data(),      s.panel_size > kCached,
                 s.panel_size > kNear};
    if (!unsymmetric_) return v;
    v.unsymmetric = kind_.data();
    v.upper = upper_.data();
    v.upper_work = upper_work_.data();
    v.upper_stack = v.upper_work + (stack - work_.data());
    v.wrong = wrong_mark_.data();
    return v;
}

void Numeric::clear(const Symbolic& symbolic, base::Executor& executor) noexcept {
    constexpr std::int64_t kChunk = 65'536;
    const auto chunks = static_cast<int>((symbolic.panel_size + kChunk - 1) / kChunk);
    auto zero = [&](int i, int) noexcept {
        const std::int64_t from = i * kChunk, to = std::min(from + kChunk, symbolic.panel_size);
        std::fill(panel_.begin() + from, panel_.begin() + to, 0.0);
    };
    executor.for_each(chunks, zero);
}

/// on_batch(batch, node, thread) or on_fronts(begin, end, node, thread) for all of them, the ranges
/// of a node in their order, going down in the reverse one.
template <class Batches, class Fronts>
void Numeric::run_tasks(const Symbolic& s, TaskPass pass, base::Executor& executor,
                        Batches&& on_batch, Fronts&& on_fronts) noexcept {
    const bool up = pass != TaskPass::backward;
    const std::size_t batches = s.batches.size(), below = batches + s.tasks.size();
    auto node = [&](int i, int thread) noexcept {
        const auto n = static_cast<std::size_t>(i);
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

int Numeric::count_wrong(const Symbolic& symbolic) noexcept {
    const int wrong = std::accumulate(wrong_.begin(), wrong_.begin() + symbolic.graph.nodes(), 0);
    return find_wrong(symbolic, wrong);
}

int Numeric::factor(const Symbolic& symbolic, base::Executor& executor,
                    const Unsymmetric* unsymmetric) noexcept {
    use(symbolic, unsymmetric);
    const FactorKernels& kernels = factor_kernels();
    std::fill_n(wrong_.begin(), symbolic.graph.nodes(), 0);
    run_tasks(
        symbolic, TaskPass::factor, executor,
        [&](const Batch& batch, std::size_t node, int thread) noexcept {
            wrong_[node] = kernels.factor_batch(view(symbolic, thread), batch, batch.step_begin,
                                                batch.step_end, scratch(thread));
        },
        [&](std::int32_t begin, std::int32_t end, std::size_t node, int thread) noexcept {
            wrong_[node] += kernels.factor(view(symbolic, thread), begin, end, scratch(thread));
        });
    return count_wrong(symbolic);
}

void Numeric::cut_batch(const Symbolic& s, std::int32_t batch) {
    const Batch& b = s.batches[static_cast<std::size_t>(batch)];
    Piece p{0, 0, batch, batch, b.step_begin, b.step_begin};
    for (std::int32_t k = b.step_begin; k < b.step_end; ++k) {
        const BatchStep& step = s.batch_steps[static_cast<std::size_t>(k)];
        if (p.step_begin == k) p.panel_begin = step.panel;
        p.panel_end =
            step.panel + static_cast<std::int64_t>(kLaneCount) * step.p * (step.p + step.q);
        p.step_end = k + 1;
        if (p.panel_end - p.panel_begin < piece_size && p.step_end < b.step_end) continue;
        pieces_.push_back(p);
        p.step_begin = k + 1;
    }
}

void Numeric::cut_pieces(const Symbolic& s) {
    pieces_.clear();
    task_piece_.clear();
    for (std::size_t i = 0; i < s.batches.size(); ++i) {
        task_piece_.push_back(static_cast<std::int32_t>(pieces_.size()));
        cut_batch(s, static_cast<std::int32_t>(i));
    }
    auto add_fronts = [&](std::int32_t begin, std::int32_t end) {
        Piece p{0, 0, begin, begin};
        for (std::int32_t f = begin; f < end; ++f) {
            const Front& front = s.fronts[static_cast<std::size_t>(f)];
            p.end = f + 1;
            if (front.batch >= 0) continue;
            if (p.panel_end == 0) p.panel_begin = front.panel;
            p.panel_end = front.panel + static_cast<std::int64_t>(front.ld) * front.p;
            if (p.panel_end - p.panel_begin < piece_size) continue;
            pieces_.push_back(p);
            p = {0, 0, f + 1, f + 1};
        }
        if (p.panel_end > 0) pieces_.push_back(p);
    };
    for (const TaskRange& t : s.tasks) {
        task_piece_.push_back(static_cast<std::int32_t>(pieces_.size()));
        add_fronts(t.begin, t.end);
    }
    for (const TaskRange& t : s.top_tasks) {
        task_piece_.push_back(static_cast<std::int32_t>(pieces_.size()));
        const std::span<const std::int32_t> top(s.top.begin() + t.begin, s.top.begin() + t.end);
        for (std::size_t k = 0, next; k < top.size(); k = next) {
            for (next = k + 1; next < top.size() && top[next] == top[next - 1] + 1;) ++next;
            add_fronts(top[k], top[next - 1] + 1);
        }
    }
    task_piece_.push_back(static_cast<std::int32_t>(pieces_.size()));
}

/// Room for the largest piece of a batch, if they are streamed.
void Numeric::find_stage(const Symbolic& s, int threads) {
    stage_stride_ = 0;
    if (s.panel_size <= streamed_size) return;
    for (const Piece& p : pieces_)
        if (p.begin == p.end) stage_stride_ = std::max(stage_stride_, p.panel_end - p.panel_begin);
    stage_stride_ = (stage_stride_ + 63) & ~std::int64_t{63};
    grow(stage_, stage_stride_ * threads);
}

int Numeric::run_batch_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                             int thread) noexcept {
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    const Batch& batch = symbolic.batches[static_cast<std::size_t>(p.begin)];
    const FactorKernels& kernels = factor_kernels();
    const std::int64_t size = p.panel_end - p.panel_begin;
    // Both go on with the next piece: each has its own share of the scratch.
    double* forward = scratch(thread) + (unsymmetric_ ? 2 : 1) * batch_windows(batch);
    FactorView v = view(symbolic, thread);
    const bool streamed = stage_stride_ > 0 && !unsymmetric_;
    double* made = panel_.data() + p.panel_begin;
    if (streamed) {
        made = stage_.data() + thread * stage_stride_;
        v.panel = made - p.panel_begin;
    }
    std::fill(made, made + size, 0.0);
    fill.write(fill.context, piece, v.panel);
    if (unsymmetric_ && copy_piece(symbolic, p))
        fill.skew(fill.context, piece, panel_.data(), upper_.data());
    const int wrong = kernels.factor_batch(v, batch, p.step_begin, p.step_end, scratch(thread));
    kernels.forward_batch(v, batch, p.step_begin, p.step_end, x, forward);
    if (streamed) kernels.stream(panel_.data() + p.panel_begin, made, size);
    return wrong;
}

int Numeric::run_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                       int thread) noexcept {
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    if (p.begin == p.end) return run_batch_piece(symbolic, piece, fill, x, thread);
    const FactorView v = view(symbolic, thread);
    const FactorKernels& kernels = factor_kernels();
    std::fill(panel_.begin() + p.panel_begin, panel_.begin() + p.panel_end, 0.0);
    fill.write(fill.context, piece, panel_.data());
    if (unsymmetric_ && copy_piece(symbolic, p))
        fill.skew(fill.context, piece, panel_.data(), upper_.data());
    const int wrong = kernels.factor(v, p.begin, p.end, scratch(thread));
    kernels.forward(v, p.begin, p.end, x, scratch(thread));
    return wrong;
}

int Numeric::factor_forward(const Symbolic& symbolic, Fill fill, double* x,
                            base::Executor& executor, const Unsymmetric* unsymmetric) noexcept {
    use(symbolic, unsymmetric);
    auto node = [&](int i, int thread) noexcept {
        const auto n = static_cast<std::size_t>(i);
        int wrong = 0;
        for (std::int32_t p = task_piece_[n]; p < task_piece_[n + 1]; ++p)
            wrong += run_piece(symbolic, p, fill, x, thread);
        wrong_[n] = wrong;
    };
    queue_.run(symbolic.graph, TaskPass::factor, executor, node);
    return count_wrong(symbolic);
}

void Numeric::solve(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept {
    const FactorView v = view(symbolic, 0);
    const FactorKernels& kernels = factor_kernels();
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

void Numeric::backward(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept {
    const FactorView v = view(symbolic, 0);
    const FactorKernels& kernels = factor_kernels();
    run_tasks(
        symbolic, TaskPass::backward, executor,
        [&](const Batch& batch, std::size_t, int thread) noexcept {
            kernels.backward_batch(v, batch, x, scratch(thread));
        },
        [&](std::int32_t begin, std::int32_t end, std::size_t, int thread) noexcept {
            kernels.backward(v, begin, end, x, scratch(thread));
        });
}

std::size_t Numeric::bytes() const noexcept {
    return base::bytes(panel_) + base::bytes(pivot_) + base::bytes(work_) + base::bytes(carry_) +
           base::bytes(slot_pivot_) + base::bytes(slot_y_) + base::bytes(scratch_) +
           base::bytes(stage_) + base::bytes(wrong_) + base::bytes(upper_) +
           base::bytes(upper_work_) + base::bytes(kind_) + base::bytes(wrong_mark_) +
           base::bytes(wrong_nodes_) + queue_.bytes();
}

}  // namespace hawser::factor
