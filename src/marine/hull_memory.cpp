// SPDX-License-Identifier: Apache-2.0
/// Store the memory of one hull: past velocities, or states.
#include "marine/memory_sums.h"
#include "marine/radiation.h"

#include <algorithm>
#include <cmath>

namespace hawser::marine {

HullMemorySums::HullMemorySums(const WaterHull& def, double step)
    : step_(step), follows_(def.coriolis) {
    if (!def.coefficients || def.coefficients->damping.empty()) return;
    if (def.radiation == RadiationKind::convolution) {
        kind_ = def.radiation;
        const Retardation k = sampled_retardation(*def.coefficients, step, def.memory);
        first_ = k.first;
        added_ = k.added;
        count_ = static_cast<std::int64_t>(k.later.size());
        const Vec6 scale = memory_scale(first_);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j <= i; ++j) {
                double most = 0.0;
                for (const Matrix6& m : k.later) most = std::max(most, std::abs(m(i, j)));
                if (most > 1e-12 * scale[i] * scale[j]) pairs_.push_back({i, j});
            }
        kernel_.assign(pairs_.size() * static_cast<std::size_t>(memory_padded(count_)), 0.0);
        for (std::size_t m = 0; m < k.later.size(); ++m)
            for (std::size_t p = 0; p < pairs_.size(); ++p)
                kernel_[(m / kMemoryBlock * pairs_.size() + p) * kMemoryBlock + m % kMemoryBlock] =
                    step * k.later[m](pairs_[p].i, pairs_[p].j);
        past_.assign(static_cast<std::size_t>(6 * memory_stride(count_)), 0.0);
    } else if (def.radiation == RadiationKind::state_space) {
        kind_ = def.radiation;
        model_ = memory_model(*def.coefficients, def.order, def.memory);
        first_ = model_.first;
        added_ = model_.added;
        states_.assign(model_.b.size(), 0.0);
        for (const MemoryModel::Block& block : model_.blocks) {
            const double e = std::exp(block.decay * step);
            turn_.push_back({e * std::cos(block.turn * step), e * std::sin(block.turn * step),
                             block.turn == 0.0 ? 1.0 : 2.0});
        }
    }
    damping_ = without_negative(0.5 * step * first_ + added_);
}

void HullMemorySums::push(const Vec6& velocity) noexcept {
    if (!follows()) return;
    const Vec6 mean = 0.5 * (last_ + velocity);
    const bool known = begun_ != 0;
    last_ = velocity;
    begun_ = 1;
    if (!known || !any()) return;
    if (kind_ == RadiationKind::convolution) {
        newest_ = newest_ == 0 ? count_ - 1 : newest_ - 1;
        for (int i = 0; i < 6; ++i) past_[place(i, newest_)] = mean[i];
        go_on_behind();
        return;
    }
    // x ← e^{Ah} (x + h B ν̄).
    std::size_t s = 0;
    const auto driven = [&](std::size_t k) {
        double sum = states_[k];
        for (std::size_t j = 0; j < 6; ++j)
            sum += step_ * model_.b[k][j] * mean[static_cast<Eigen::Index>(j)];
        return sum;
    };
    for (const auto& [x, y, size] : turn_) {
        const double p = driven(s);
        if (size == 1.0) {
            states_[s++] = x * p;
            continue;
        }
        const double q = driven(s + 1);
        states_[s] = x * p + y * q;
        states_[s + 1] = x * q - y * p;
        s += 2;
    }
}

void HullMemorySums::go_on_behind() noexcept {
    for (int i = 0; i < 6; ++i)
        for (std::int64_t m = 0; m < kMemoryBlock; ++m)
            past_[place(i, count_ + m)] = past_[place(i, m % count_)];
}

Vec6 HullMemorySums::force() const noexcept {
    Vec6 out = Vec6::Zero();
    if (kind_ == RadiationKind::convolution) {
        static_assert(sizeof(Pair) == 2 * sizeof(int));
        double sum[6] = {};
        const MemoryKernels& by = memory_kernels();
        const int* const pairs = &pairs_.data()->i;
        const auto n = static_cast<int>(pairs_.size());
        by.sums(kernel_.data(), past_.data(), count_, newest_, pairs, n, sum);
        for (int i = 0; i < 6; ++i) out[i] = -sum[i];
    } else {
        for (std::size_t s = 0; s < states_.size(); ++s)
            for (std::size_t i = 0; i < 6; ++i)
                out[static_cast<Eigen::Index>(i)] -= model_.c[s][i] * states_[s];
    }
    return out;
}

void HullMemorySums::visit_state(StateVisitor& v) {
    if (!follows()) return;
    v.visit(newest_);
    v.visit(begun_);
    v.visit(std::span<double>(last_.data(), 6));
    v.visit(std::span<double>(states_));
    if (count_ == 0) return;
    // A step writes the sample before the newest alone.
    const std::int64_t next = newest_ == 0 ? count_ - 1 : newest_ - 1;
    for (int i = 0; i < 6; ++i)
        if (v.around_step())
            v.visit(past_[place(i, next)]);
        else
            v.visit(std::span<double>(&past_[place(i, 0)], static_cast<std::size_t>(count_)));
    go_on_behind();
}

void HullMemorySums::check_state(StateRules& rules) const {
    if (!follows()) return;
    constexpr double kMostSpeed = 1e15;  // as velocities of bodies [m/s, rad/s]
    rules.require(newest_ >= 0 && newest_ < std::max<std::int64_t>(count_, 1),
                  "a sample of a hull's memory has an invalid index");
    rules.require(begun_ == 0 || begun_ == 1, "whether a hull's memory has begun is no flag");
    rules.require(last_.cwiseAbs().maxCoeff() <= kMostSpeed, "the speed of a hull is out of range");
    for (int i = 0; i < 6; ++i)
        for (std::int64_t m = 0; m < count_; ++m)
            rules.range(past_[place(i, m)], -kMostSpeed, kMostSpeed,
                        "the memory of a hull is out of range");
}

void HullMemorySums::write_memory(HullMemory& out) const {
    out.kind = kind_;
    out.step = step_;
    out.first = first_;
    out.added = added_;
    out.begun = begun_ != 0;
    for (int i = 0; i < 6; ++i) out.last[static_cast<std::size_t>(i)] = last_[i];
    out.past.clear();
    for (std::int64_t m = 0; m < count_; ++m) {
        std::array<double, 6> row{};
        for (int i = 0; i < 6; ++i)
            row[static_cast<std::size_t>(i)] = past_[place(i, (newest_ + m) % count_)];
        out.past.push_back(row);
    }
    out.states = states_;
    const std::size_t n = states_.size();
    out.a.assign(n * n, 0.0);
    out.b.clear();
    out.c.assign(6 * n, 0.0);
    std::size_t s = 0;
    for (const MemoryModel::Block& block : model_.blocks) {
        out.a[s * n + s] = block.decay;
        if (block.turn != 0.0) {
            out.a[(s + 1) * n + s + 1] = block.decay;
            out.a[s * n + s + 1] = block.turn;
            out.a[(s + 1) * n + s] = -block.turn;
        }
        s += block.turn == 0.0 ? 1 : 2;
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < 6; ++i) {
            out.b.push_back(model_.b[k][i]);
            out.c[i * n + k] = model_.c[k][i];
        }
    out.fit_error = model_.fit_error;
}

}  // namespace hawser::marine
