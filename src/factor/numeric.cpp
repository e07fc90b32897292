// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Contents are not kept. Structures that follow a changing pattern (repair.h) grow again and
/// again: from the second time on with room to spare.
template <class T>
void grow(base::Array<T>& array, std::int64_t size) {
    if (static_cast<std::int64_t>(array.size()) >= size) return;
    const std::int64_t room = array.empty() ? size : size + size / 4;
    base::Array<T>().swap(array);
    array.resize(static_cast<std::size_t>(room));
}

}  // namespace

void Numeric::reserve(const Symbolic& symbolic, int threads) {
    grow(panel_, symbolic.panel_size);
    grow(pivot_, symbolic.scalars);
    grow(work_, symbolic.work_size);
    grow(carry_, static_cast<std::int64_t>(symbolic.rows.size()));
    const auto slots = kLaneCount * static_cast<std::int64_t>(symbolic.slot_sign.size());
    grow(slot_pivot_, slots);
    grow(slot_y_, slots);
    grow(wrong_, static_cast<std::int64_t>(symbolic.batches.size() + symbolic.tasks.size()));
    const std::int64_t need = std::max(scratch_size(symbolic.max_front), symbolic.batch_scratch);
    const std::int64_t stride = (need + 63) & ~std::int64_t{63};
    scratch_stride_ = std::max(scratch_stride_, stride);
    grow(scratch_, scratch_stride_ * threads);
}

FactorView Numeric::view(const Symbolic& s) noexcept {
    return {s.fronts.data(),    s.children.data(),    s.rows.data(),      s.runs.data(),
            s.sign.data(),      panel_.data(),        pivot_.data(),      work_.data(),
            carry_.data(),      s.batch_steps.data(), s.slot_sign.data(), s.slot_index.data(),
            s.tail_slot.data(), slot_pivot_.data(),   slot_y_.data()};
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

int Numeric::factor(const Symbolic& symbolic, base::Executor& executor) noexcept {
    const FactorView v = view(symbolic);
    const FactorKernels& kernels = factor_kernels();
    const std::size_t batches = symbolic.batches.size(), tasks = symbolic.tasks.size();
    auto batch = [&](int i, int thread) noexcept {
        const auto k = static_cast<std::size_t>(i);
        wrong_[k] = kernels.factor_batch(v, symbolic.batches[k], scratch(thread));
    };
    auto subtree = [&](int i, int thread) noexcept {
        const TaskRange& t = symbolic.tasks[static_cast<std::size_t>(i)];
        wrong_[batches + static_cast<std::size_t>(i)] =
            kernels.factor(v, t.begin, t.end, scratch(thread));
    };
    executor.for_each(static_cast<int>(batches), batch);
    executor.for_each(static_cast<int>(tasks), subtree);
    int wrong = 0;
    for (std::size_t i = 0; i < batches + tasks; ++i) wrong += wrong_[i];
    for (std::int32_t f : symbolic.top) wrong += kernels.factor(v, f, f + 1, scratch(0));
    return wrong;
}

void Numeric::solve(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept {
    const FactorView v = view(symbolic);
    const FactorKernels& kernels = factor_kernels();
    const int tasks = static_cast<int>(symbolic.tasks.size());
    auto forward = [&](int i, int thread) noexcept {
        const TaskRange& t = symbolic.tasks[static_cast<std::size_t>(i)];
        kernels.forward(v, t.begin, t.end, x, scratch(thread));
    };
    auto backward = [&](int i, int thread) noexcept {
        const TaskRange& t = symbolic.tasks[static_cast<std::size_t>(i)];
        kernels.backward(v, t.begin, t.end, x, scratch(thread));
    };
    const int batches = static_cast<int>(symbolic.batches.size());
    auto forward_batch = [&](int i, int thread) noexcept {
        kernels.forward_batch(v, symbolic.batches[static_cast<std::size_t>(i)], x, scratch(thread));
    };
    auto backward_batch = [&](int i, int thread) noexcept {
        kernels.backward_batch(v, symbolic.batches[static_cast<std::size_t>(i)], x,
                               scratch(thread));
    };
    executor.for_each(batches, forward_batch);
    executor.for_each(tasks, forward);
    for (std::int32_t f : symbolic.top) kernels.forward(v, f, f + 1, x, scratch(0));
    for (std::size_t k = symbolic.top.size(); k-- > 0;)
        kernels.backward(v, symbolic.top[k], symbolic.top[k] + 1, x, scratch(0));
    executor.for_each(tasks, backward);
    executor.for_each(batches, backward_batch);
}

std::size_t Numeric::bytes() const noexcept {
    return base::bytes(panel_) + base::bytes(pivot_) + base::bytes(work_) + base::bytes(carry_) +
           base::bytes(slot_pivot_) + base::bytes(slot_y_) + base::bytes(scratch_) +
           base::bytes(wrong_);
}

}  // namespace hawser::factor
