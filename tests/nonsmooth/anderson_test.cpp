// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/anderson.h"

#include "support/dense_reference.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hawser::nonsmooth {
namespace {

/// Iterate until x = F(x) to `tolerance`, or `most` times.
template <class F>
int iterate_to(Anderson& a, Eigen::VectorXd& x, F&& f, double tolerance, int most) {
    for (int k = 1; k <= most; ++k) {
        const Eigen::VectorXd image = f(x);
        if ((image - x).cwiseAbs().maxCoeff() <= tolerance * image.cwiseAbs().maxCoeff()) return k;
        std::copy_n(x.data(), x.size(), a.x());
        std::copy_n(image.data(), image.size(), a.image());
        x = Eigen::Map<const Eigen::VectorXd>(a.next(1e-12), x.size());
    }
    return most + 1;
}

/// F(x) = A x + b with a spectral radius of 0.999: n + 1 evaluations find the fixed point, one more
/// detects it.
TEST(AndersonAcceleration, EndsAfterAsManyIterationsAsUnknowns) {
    std::mt19937_64 random(test::first_seed(7));
    const int trials = test::by_tier(20, 100, 1000);
    std::normal_distribution<double> normal;
    for (int n = 1; n <= Anderson::kHistoryDepth; ++n)
        for (int trial = 0; trial < trials; ++trial) {
            Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
            Eigen::VectorXd b(n);
            for (int i = 0; i < n; ++i) {
                b[i] = normal(random);
                // A general matrix up to a rotation of the space (Schur's form) with known
                // eigenvalues; a normal matrix of this size has a radius of √n.
                for (int j = i + 1; j < n; ++j) a(i, j) = normal(random) / std::sqrt(n);
                a(i, i) = std::uniform_real_distribution<>(-0.999, 0.999)(random);
            }
            a(n / 2, n / 2) = trial % 2 == 0 ? 0.999 : -0.999;
            // Every third matrix has a pair of complex eigenvalues of that radius.
            if (trial % 3 == 0 && n > 1) {
                const double angle = std::uniform_real_distribution<>(0.1, 3.0)(random);
                a(0, 0) = a(1, 1) = 0.999 * std::cos(angle);
                a(1, 0) = 0.999 * std::sin(angle);
                a(0, 1) = -a(1, 0);
            }
            Anderson accelerate;
            accelerate.reserve(static_cast<std::size_t>(n));
            Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
            const int taken = iterate_to(
                accelerate, x, [&](const auto& y) { return (a * y + b).eval(); }, 1e-9, 60);
            // One repetition if growth cleared the history in between.
            EXPECT_LE(taken, 2 * n + 4) << n;
            const Eigen::VectorXd exact = test::solve_dense(Eigen::MatrixXd::Identity(n, n) - a, b);
            // 1e-9 over 1 − 0.999, and the part of A that is not normal.
            EXPECT_LT((x - exact).norm(), 1e-4 * exact.norm()) << n;
        }
}

/// A map that is not affine, with kinks like those of bounds.
TEST(AndersonAcceleration, ConvergesThroughKinks) {
    Anderson accelerate;
    accelerate.reserve(2);
    Eigen::VectorXd x = Eigen::VectorXd::Constant(2, 1.0);
    const auto f = [](const Eigen::VectorXd& y) {
        return Eigen::VectorXd{{1.0 + 0.99 * std::fabs(y[1]), 2.0 + 0.98 * std::max(y[0], 3.0)}};
    };
    EXPECT_LE(iterate_to(accelerate, x, f, 1e-12, 60), 20);
    EXPECT_NEAR(x[0], 2.98 / (1.0 - 0.99 * 0.98), 1e-7);
}

TEST(AndersonAcceleration, ForgetsWhatItIsToldTo) {
    const auto affine = [](double slope, const Eigen::VectorXd& y) -> Eigen::VectorXd {
        return slope * y + Eigen::VectorXd::Ones(1);
    };
    Anderson accelerate;
    accelerate.reserve(1);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
    EXPECT_LE(
        iterate_to(accelerate, x, [&](const auto& y) { return affine(0.9, y); }, 1e-12, 60), 4);
    accelerate.restart();
    EXPECT_LE(
        iterate_to(accelerate, x, [&](const auto& y) { return affine(-0.9, y); }, 1e-12, 60), 4);
    EXPECT_NEAR(x[0], 1.0 / 1.9, 1e-12);
}

}  // namespace
}  // namespace hawser::nonsmooth
