// SPDX-License-Identifier: Apache-2.0
/// Panels that are filled, factored and substituted together (numeric.h).
#include "factor/grow.h"
#include "factor/numeric.h"

#include <algorithm>

namespace hawser::factor {

void Numeric::divide_batch(const Symbolic& s, std::int32_t batch) {
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

void Numeric::make_pieces(const Symbolic& s) {
    pieces_.clear();
    task_piece_.clear();
    for (std::size_t i = 0; i < s.batches.size(); ++i) {
        task_piece_.push_back(static_cast<std::int32_t>(pieces_.size()));
        divide_batch(s, static_cast<std::int32_t>(i));
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

/// Reserve memory for the largest piece of a batch, if pieces are copied one after the other
/// (streamed).
void Numeric::find_stage(const Symbolic& s, int threads) {
    stage_stride_ = 0;
    if (s.panel_size <= streamed_size) return;
    for (const Piece& p : pieces_)
        if (p.begin == p.end) stage_stride_ = std::max(stage_stride_, p.panel_end - p.panel_begin);
    stage_stride_ = (stage_stride_ + 63) & ~std::int64_t{63};
    grow_discarding(stage_, stage_stride_ * threads);
}

int Numeric::run_batch_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                             int thread) noexcept {
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    const Batch& batch = symbolic.batches[static_cast<std::size_t>(p.begin)];
    const Kernels& all = factor_kernels();
    const Kernels& kernels = all;
    const std::int64_t size = p.panel_end - p.panel_begin;
    // Factorisation and substitution continue with the next piece, so each has its own part of the
    // scratch.
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
    const int wrong_pivots =
        kernels.factor_batch(v, batch, p.step_begin, p.step_end, scratch(thread));
    kernels.forward_batch(v, batch, p.step_begin, p.step_end, x, forward);
    if (streamed) all.stream(panel_.data() + p.panel_begin, made, size);
    return wrong_pivots;
}

int Numeric::run_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                       int thread) noexcept {
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    if (p.begin == p.end) return run_batch_piece(symbolic, piece, fill, x, thread);
    const FactorView v = view(symbolic, thread);
    const Kernels& kernels = factor_kernels();
    std::fill(panel_.begin() + p.panel_begin, panel_.begin() + p.panel_end, 0.0);
    fill.write(fill.context, piece, panel_.data());
    if (unsymmetric_ && copy_piece(symbolic, p))
        fill.skew(fill.context, piece, panel_.data(), upper_.data());
    const int wrong_pivots = kernels.factor(v, p.begin, p.end, scratch(thread));
    kernels.forward(v, p.begin, p.end, x, scratch(thread));
    return wrong_pivots;
}

int Numeric::factor_forward(const Symbolic& symbolic, Fill fill, double* x,
                            base::Executor& executor, const Unsymmetric* unsymmetric) noexcept {
    use(symbolic, unsymmetric);
    auto node = [&](int i, int thread) noexcept {
        const auto n = static_cast<std::size_t>(i);
        int wrong_pivots = 0;
        for (std::int32_t p = task_piece_[n]; p < task_piece_[n + 1] && !executor.stopping(); ++p)
            wrong_pivots += run_piece(symbolic, p, fill, x, thread);
        wrong_pivots_[n] = wrong_pivots;
    };
    queue_.run(symbolic.graph, TaskPass::factor, executor, node);
    return find_wrong_pivots(symbolic, count_wrong_pivots(symbolic));
}

}  // namespace hawser::factor
