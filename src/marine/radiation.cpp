// SPDX-License-Identifier: Apache-2.0
#include "marine/radiation.h"

#include "base/dense.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::marine {
namespace {

constexpr double kPi = std::numbers::pi;

Matrix6 symmetric(const Matrix6& m) { return 0.5 * (m + m.transpose()); }

/// Return sin(x)/x, by its series near 0.
double sinc(double x) noexcept { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

Matrix6 without_negative(const Matrix6& m) {
    Matrix6 s = symmetric(m);
    const double largest = s.diagonal().cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) return Matrix6::Zero();
    Vec6 scale;
    for (int i = 0; i < 6; ++i) scale[i] = std::sqrt(std::max(s(i, i), 1e-12 * largest));
    const Matrix6 scaled =
        scale.cwiseInverse().asDiagonal() * s * scale.cwiseInverse().asDiagonal();
    const auto eigen = base::symmetric_eigen(scaled);
    if (eigen.values(0) >= 0.0) return s;
    // Keep eigenvalues above rounding, so that sums and rotations have no negative pivot.
    const Vec6 kept = eigen.values.cwiseMax(1e-12);
    const Matrix6 back = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
    return symmetric(scale.asDiagonal() * back * scale.asDiagonal());
}

Matrix6 linear_at(const std::vector<double>& w, const std::vector<Matrix6>& m, double omega) {
    const auto after = std::upper_bound(w.begin(), w.end(), omega);
    if (after == w.begin()) return m.front();
    if (after == w.end()) return m.back();
    const auto i = static_cast<std::size_t>(after - w.begin());
    const double fraction = (omega - w[i - 1]) / (w[i] - w[i - 1]);
    return (1.0 - fraction) * m[i - 1] + fraction * m[i];
}

WaveCoefficients without_noise(const WaveCoefficients& c) {
    WaveCoefficients out = c;
    for (Matrix6& m : out.added_mass) m = symmetric(m);
    for (Matrix6& m : out.damping) m = without_negative(m);
    if (!c.has_infinite && !c.added_mass.empty()) {
        out.infinite = infinite_added_mass(c);
        out.has_infinite = true;
    }
    out.infinite = without_negative(out.infinite);
    return out;
}

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
    // Integrate linear pieces by parts. The boundary terms B sin ωt/t cancel, because B is
    // continuous and 0 at both ends. The remainder of a piece is slope × (cos ω₁t − cos ω₀t)/t².
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

/// Return the most negative eigenvalue of a scaled damping matrix, as a positive number; 0 if it is
/// positive semi-definite.
double deficit(const Matrix6& damping, const Vec6& scale) {
    Matrix6 m = symmetric(damping);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) m(i, j) /= scale[i] * scale[j];
    return std::max(0.0, -base::symmetric_eigenvalues(m)(0));
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
    // Sample the damping at frequencies as fine as the memory resolves, by a rotating phasor.
    const Vec6 scale = memory_scale(out.first);
    const double top = std::min(kPi / step, nodes.frequency.back());
    const int points = std::clamp(static_cast<int>(2.0 * top * memory / kPi), 32, 400);
    double largest_deficit = 0.0;
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
        largest_deficit = std::max(largest_deficit, deficit(step * sum, scale));
    }
    out.added = scaled_damping(largest_deficit, out.first);
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

}  // namespace hawser::marine
