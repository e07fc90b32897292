// SPDX-License-Identifier: Apache-2.0
#include "marine/radiation.h"

#include "marine/memory_sums.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::marine {
namespace {

constexpr double kPi = std::numbers::pi;

Matrix6 symmetric(const Matrix6& m) { return 0.5 * (m + m.transpose()); }

/// sin(x)/x.
double sinc(double x) noexcept { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

DampingNodes damping_nodes(const WaveCoefficients& c) {
    DampingNodes out;
    out.frequency.push_back(0.0);
    out.damping.emplace_back(Matrix6::Zero());
    for (std::size_t i = 0; i < c.damping.size(); ++i) {
        out.frequency.push_back(c.frequency[i]);
        out.damping.push_back(symmetric(c.damping[i]));
    }
    if (c.damping.empty()) return out;
    const double last = c.frequency.back();
    for (int i = 1; i <= 12; ++i) {
        const double ratio = std::pow(4.0, i / 12.0);
        out.frequency.push_back(last * ratio);
        out.damping.push_back(symmetric(c.damping.back()) / (ratio * ratio * ratio));
    }
    out.frequency.push_back(5.0 * last);
    out.damping.emplace_back(Matrix6::Zero());
    return out;
}

Matrix6 retardation_of(const DampingNodes& nodes, double t) {
    // ∫ of a linear piece by parts: its ends' B sin ωt/t cancel, as B is continuous and 0 at both
    // ends of all; what is left is slope × (cos ω₁t − cos ω₀t)/t².
    Matrix6 sum = Matrix6::Zero();
    for (std::size_t i = 1; i < nodes.frequency.size(); ++i) {
        const double wide = nodes.frequency[i] - nodes.frequency[i - 1];
        const double mid = 0.5 * (nodes.frequency[i] + nodes.frequency[i - 1]);
        // −2 sin(mid t) sin(wide t/2)/(t² wide), finite at t = 0.
        const double weight = -mid * sinc(mid * t) * sinc(0.5 * wide * t);
        sum += weight * (nodes.damping[i] - nodes.damping[i - 1]);
    }
    return 2.0 / kPi * sum;
}

double memory_window(double t, double memory) noexcept {
    const double x = std::clamp((t / memory - 0.8) / 0.2, 0.0, 1.0);
    const double c = std::cos(0.5 * kPi * x);
    return c * c;
}

Vec6 memory_scale(const Matrix6& first) noexcept {
    Vec6 s;
    for (int i = 0; i < 6; ++i) s[i] = first(i, i) > 0.0 ? std::sqrt(first(i, i)) : 1.0;
    return s;
}

namespace {

/// What damping of a frequency lacks to be positive semi-definite, at most, entries scaled.
double deficit(const Matrix6& damping, const Vec6& scale) {
    Matrix6 m = symmetric(damping);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) m(i, j) /= scale[i] * scale[j];
    return std::max(
        0.0, -Eigen::SelfAdjointEigenSolver<Matrix6>(m, Eigen::EigenvaluesOnly).eigenvalues()(0));
}

Matrix6 scaled_damping(double amount, const Matrix6& first) {
    Matrix6 out = Matrix6::Zero();
    for (int i = 0; i < 6; ++i) out(i, i) = amount * std::max(first(i, i), 0.0);
    return out;
}

}  // namespace

Retardation sampled_retardation(const WaveCoefficients& c, double step, double memory) {
    const DampingNodes nodes = damping_nodes(c);
    Retardation out;
    out.step = step;
    out.first = retardation_of(nodes, 0.0);
    const auto count = static_cast<std::size_t>(std::ceil(memory / step)) - 1;
    out.later.reserve(count);
    for (std::size_t m = 1; m <= count; ++m) {
        const double t = static_cast<double>(m) * step;
        out.later.push_back(memory_window(t, memory) * retardation_of(nodes, t));
    }
    // Its damping at frequencies as fine as the memory tells apart, by a turning phasor.
    const Vec6 scale = memory_scale(out.first);
    const double top = std::min(kPi / step, nodes.frequency.back());
    const int points = std::clamp(static_cast<int>(2.0 * top * memory / kPi), 32, 400);
    double lack = 0.0;
    for (int p = 0; p <= points; ++p) {
        const double omega = top * p / points;
        const double c1 = std::cos(omega * step), s1 = std::sin(omega * step);
        double x = 1.0, y = 0.0;
        Matrix6 sum = 0.5 * out.first;
        for (const Matrix6& k : out.later) {
            const double next = x * c1 - y * s1;
            y = x * s1 + y * c1;
            x = next;
            sum += x * k;
        }
        lack = std::max(lack, deficit(step * sum, scale));
    }
    out.added = scaled_damping(lack, out.first);
    return out;
}

// ---- states -------------------------------------------------------------------------------------

Matrix6 MemoryModel::at(double t) const {
    Matrix6 out = Matrix6::Zero();
    std::size_t s = 0;
    for (const Block& block : blocks) {
        const double e = std::exp(block.decay * t);
        const auto add = [&](std::size_t to, std::size_t from, double w) {
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < 6; ++j)
                    out(i, j) += w * c[to][static_cast<std::size_t>(i)] *
                                 b[from][static_cast<std::size_t>(j)];
        };
        if (block.turn == 0.0) {
            add(s, s, e);
            s += 1;
            continue;
        }
        const double x = e * std::cos(block.turn * t), y = e * std::sin(block.turn * t);
        add(s, s, x);
        add(s, s + 1, y);
        add(s + 1, s, -y);
        add(s + 1, s + 1, x);
        s += 2;
    }
    return out;
}

// ---- one hull -----------------------------------------------------------------------------------

HullMemorySums::HullMemorySums(const WaterHull& def, double step) : step_(step) {
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
                if (!(most > 1e-12 * scale[i] * scale[j])) continue;
                pairs_.push_back({i, j});
                for (const Matrix6& m : k.later) kernel_.push_back(step * m(i, j));
            }
        past_.assign(static_cast<std::size_t>(6 * count_), 0.0);
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
    damping_ = 0.5 * step * first_ + added_;
}

void HullMemorySums::push(const Vec6& velocity) noexcept {
    if (kind_ == RadiationKind::none) return;
    const Vec6 mean = 0.5 * (last_ + velocity);
    const bool known = begun_ != 0;
    last_ = velocity;
    begun_ = 1;
    if (!known) return;
    if (kind_ == RadiationKind::convolution) {
        newest_ = newest_ == 0 ? count_ - 1 : newest_ - 1;
        for (int i = 0; i < 6; ++i) past_[static_cast<std::size_t>(i * count_ + newest_)] = mean[i];
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

Vec6 HullMemorySums::force() const noexcept {
    Vec6 out = Vec6::Zero();
    if (kind_ == RadiationKind::convolution) {
        static_assert(sizeof(Pair) == 2 * sizeof(int));
        double sum[6] = {};
        const MemoryKernels& by = memory_kernels();
        const int* const pairs = &pairs_.data()->i;
        const auto n = static_cast<int>(pairs_.size());
        const std::int64_t behind = count_ - newest_;
        by.sums(kernel_.data(), past_.data() + newest_, count_, behind, pairs, n, sum);
        by.sums(kernel_.data() + behind, past_.data(), count_, newest_, pairs, n, sum);
        for (int i = 0; i < 6; ++i) out[i] = -sum[i];
    } else {
        for (std::size_t s = 0; s < states_.size(); ++s)
            for (std::size_t i = 0; i < 6; ++i)
                out[static_cast<Eigen::Index>(i)] -= model_.c[s][i] * states_[s];
    }
    return out;
}

void HullMemorySums::visit_state(StateVisitor& v) {
    if (kind_ == RadiationKind::none) return;
    v.visit(newest_);
    v.visit(begun_);
    v.visit(std::span<double>(last_.data(), 6));
    v.visit(std::span<double>(states_));
    if (!v.around_step()) return v.visit(std::span<double>(past_));
    // A step writes the sample before the newest alone.
    if (count_ == 0) return;
    const std::int64_t next = newest_ == 0 ? count_ - 1 : newest_ - 1;
    for (int i = 0; i < 6; ++i) v.visit(past_[static_cast<std::size_t>(i * count_ + next)]);
}

void HullMemorySums::tell(HullMemory& out) const {
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
            row[static_cast<std::size_t>(i)] =
                past_[static_cast<std::size_t>(i * count_ + (newest_ + m) % count_)];
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
