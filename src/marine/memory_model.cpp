// SPDX-License-Identifier: Apache-2.0
/// Fit the states of a memory by Kung's method. The matrix H of blocks K((i + j) δ) is O·S,
/// observability times controllability, from its singular values. Multiplying O by e^{Aδ} shifts it
/// by one block. H is symmetric, like K: σ = |λ| and u = sign(λ) v of its eigenvalues. The poles of
/// A are kept, with B in their basis. C is then fitted by least squares over all of K.
#include <hawser/def.h>

#include "base/dense.h"
#include "marine/radiation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

namespace hawser::marine {
namespace {

using Eigen::MatrixXd;

constexpr int kKernelSamples = 400;  ///< Number of samples of K, for C and the error of the fit.
constexpr int kBlockRows = 240;      ///< Maximum number of rows of H.

/// Motions that radiate, and K between them, scaled to ones at 0.
class Scaled {
  public:
    Scaled(const DampingNodes& nodes, double memory) : nodes_(nodes), memory_(memory) {
        const Matrix6 first = retardation_of(nodes, 0.0);
        scale = memory_scale(first);
        const double largest = first.diagonal().cwiseAbs().maxCoeff();
        for (int i = 0; i < 6; ++i)
            if (first(i, i) > 1e-12 * largest) motions.push_back(i);
    }
    [[nodiscard]] MatrixXd operator()(double t) const {
        const Matrix6 k = memory_window(t, memory_) * retardation_of(nodes_, t);
        const auto n = static_cast<Eigen::Index>(motions.size());
        MatrixXd out(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j) {
                const int a = motions[static_cast<std::size_t>(i)];
                const int b = motions[static_cast<std::size_t>(j)];
                out(i, j) = k(a, b) / (scale[a] * scale[b]);
            }
        return out;
    }
    /// Return the time after which K is small.
    [[nodiscard]] double end() const {
        const double all = (*this)(0.0).norm();
        double last = memory_ / kKernelSamples;
        for (int i = 1; i < kKernelSamples; ++i) {
            const double t = memory_ * i / kKernelSamples;
            if ((*this)(t).norm() > 2e-3 * all) last = t;
        }
        return std::min(1.2 * last, memory_);
    }
    Vec6 scale;
    std::vector<int> motions;

  private:
    const DampingNodes& nodes_;
    double memory_;
};

/// Return the responses e^{At} B of the state-space model's blocks at time t, one row per state.
MatrixXd run(const std::vector<MemoryModel::Block>& blocks, const MatrixXd& b, double t) {
    MatrixXd out(b.rows(), b.cols());
    Eigen::Index s = 0;
    for (const MemoryModel::Block& block : blocks) {
        const double e = std::exp(block.decay * t);
        if (block.turn == 0.0) {
            out.row(s) = e * b.row(s);
            s += 1;
            continue;
        }
        const double x = e * std::cos(block.turn * t), y = e * std::sin(block.turn * t);
        out.row(s) = x * b.row(s) + y * b.row(s + 1);
        out.row(s + 1) = x * b.row(s + 1) - y * b.row(s);
        s += 2;
    }
    return out;
}

/// Compute the blocks and B of the state-space model from the first `order` singular values of the
/// Hankel matrix H.
void fit_state_space(const Scaled& k, double end, int order,
                     std::vector<MemoryModel::Block>& blocks, MatrixXd& b) {
    const auto n = static_cast<Eigen::Index>(k.motions.size());
    const Eigen::Index q = std::min<Eigen::Index>(60, kBlockRows / n);
    const double delta = end / static_cast<double>(2 * q);
    MatrixXd h(n * q, n * q);
    for (Eigen::Index d = 0; d < 2 * q - 1; ++d) {
        const MatrixXd sample = k(static_cast<double>(d) * delta);
        for (Eigen::Index i = std::max<Eigen::Index>(0, d - q + 1); i <= std::min(d, q - 1); ++i)
            h.block(i * n, (d - i) * n, n, n) = sample;
    }
    const auto spectrum = base::symmetric_eigen(h);
    const Eigen::VectorXd& lambda = spectrum.values;
    std::vector<Eigen::Index> largest(static_cast<std::size_t>(lambda.size()));
    std::iota(largest.begin(), largest.end(), Eigen::Index{0});
    std::sort(largest.begin(), largest.end(), [&](Eigen::Index i, Eigen::Index j) {
        return std::abs(lambda(i)) > std::abs(lambda(j));
    });
    Eigen::Index r = 0;
    while (r < order && r < lambda.size() &&
           std::abs(lambda(largest[static_cast<std::size_t>(r)])) >
               1e-9 * std::abs(lambda(largest[0])))
        ++r;
    MatrixXd o(h.rows(), r), s(r, h.cols());
    for (Eigen::Index i = 0; i < r; ++i) {
        const Eigen::Index at = largest[static_cast<std::size_t>(i)];
        const double root = std::sqrt(std::abs(lambda(at)));
        o.col(i) = root * spectrum.vectors.col(at);
        s.row(i) = std::copysign(root, lambda(at)) * spectrum.vectors.col(at).transpose();
    }
    const MatrixXd step = base::least_squares(o.topRows(n * (q - 1)), o.bottomRows(n * (q - 1)));
    const base::GeneralEigen eigen = base::general_eigen(step);
    MatrixXd basis(r, r);
    for (Eigen::Index i = 0; i < r; ++i) {
        const std::complex<double> at = eigen.values(i);
        // Reflect growing poles: they decay at the same rate.
        double size = std::clamp(std::abs(at), 1e-12, 1e12);
        if (size > 1.0) size = 1.0 / size;
        const double decay = std::min(std::log(size) / delta, -1e-3 / end);
        basis.col(i) = eigen.vectors.col(i).real();
        if (at.imag() == 0.0 || i + 1 == r) {
            blocks.push_back({decay, 0.0});
            continue;
        }
        basis.col(i + 1) = eigen.vectors.col(i).imag();
        blocks.push_back({decay, std::arg(at) / delta});
        ++i;
    }
    b = base::least_squares(basis, s.leftCols(n));
}

/// Return the largest deficit of passivity of C (iω − A)⁻¹ B over frequencies, with scaled entries.
/// The Hermitian part P + iQ has the eigenvalues of the symmetric (P, −Q; Q, P), each twice.
double passivity_deficit(const std::vector<MemoryModel::Block>& blocks, const MatrixXd& b,
                         const MatrixXd& c, double top) {
    using std::complex;
    const Eigen::Index n = c.rows();
    double largest_deficit = 0.0;
    MatrixXd real(b.rows(), b.cols()), imaginary(b.rows(), b.cols()), both(2 * n, 2 * n);
    for (int p = 0; p <= 600; ++p) {
        const complex<double> s(0.0, top * p / 600.0);
        Eigen::Index k = 0;
        for (const MemoryModel::Block& block : blocks) {
            const complex<double> d = s - block.decay;
            if (block.turn == 0.0) {
                real.row(k) = (1.0 / d).real() * b.row(k);
                imaginary.row(k) = (1.0 / d).imag() * b.row(k);
                k += 1;
                continue;
            }
            // (d, −ω; ω, d)⁻¹.
            const complex<double> det = d * d + block.turn * block.turn;
            const complex<double> diagonal = d / det, off_diagonal = block.turn / det;
            real.row(k) = diagonal.real() * b.row(k) + off_diagonal.real() * b.row(k + 1);
            imaginary.row(k) = diagonal.imag() * b.row(k) + off_diagonal.imag() * b.row(k + 1);
            real.row(k + 1) = diagonal.real() * b.row(k + 1) - off_diagonal.real() * b.row(k);
            imaginary.row(k + 1) = diagonal.imag() * b.row(k + 1) - off_diagonal.imag() * b.row(k);
            k += 2;
        }
        const MatrixXd y = c * real, z = c * imaginary;
        both.topLeftCorner(n, n) = both.bottomRightCorner(n, n) = 0.5 * (y + y.transpose());
        both.bottomLeftCorner(n, n) = 0.5 * (z - z.transpose());
        both.topRightCorner(n, n) = both.bottomLeftCorner(n, n).transpose();
        largest_deficit = std::max(largest_deficit, -base::symmetric_eigenvalues(both)(0));
    }
    return largest_deficit;
}

}  // namespace

MemoryModel memory_model(const WaveCoefficients& coefficients, int order, double memory) {
    const DampingNodes nodes = damping_nodes(coefficients);
    const Scaled k(nodes, memory);
    MemoryModel out;
    if (k.motions.empty()) return out;
    const double end = k.end();
    MatrixXd b;
    fit_state_space(k, end, order, out.blocks, b);
    const auto n = static_cast<Eigen::Index>(k.motions.size());
    MatrixXd left(kKernelSamples * n, b.rows()), right(kKernelSamples * n, n);
    for (int i = 0; i < kKernelSamples; ++i) {
        const double t = end * i / kKernelSamples;
        left.middleRows(i * n, n) = run(out.blocks, b, t).transpose();
        right.middleRows(i * n, n) = k(t).transpose();
    }
    const MatrixXd c = base::least_squares(left, right).transpose();
    const double all = k(0.0).norm();
    for (int i = 0; i < kKernelSamples; ++i)
        out.fit_error = std::max(
            out.fit_error,
            (left.middleRows(i * n, n) * c.transpose() - right.middleRows(i * n, n)).norm() / all);
    const double largest_deficit = passivity_deficit(out.blocks, b, c, nodes.frequency.back());
    for (Eigen::Index s = 0; s < b.rows(); ++s) {
        std::array<double, 6> row{}, column{};
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto motion = static_cast<std::size_t>(k.motions[static_cast<std::size_t>(i)]);
            const double scale = k.scale[static_cast<Eigen::Index>(motion)];
            row[motion] = scale * b(s, i);
            column[motion] = scale * c(i, s);
        }
        out.b.push_back(row);
        out.c.push_back(column);
    }
    const Matrix6 first = out.at(0.0);
    out.first = without_negative(first);
    for (const int i : k.motions)
        out.added(i, i) = std::max(largest_deficit, 0.0) * k.scale[i] * k.scale[i];
    return out;
}

}  // namespace hawser::marine
