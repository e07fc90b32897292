// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/gmres.h"

#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace hawser::nonsmooth {
namespace {

/// Solve to `tolerance`. @return iterations.
int solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double tolerance,
          Eigen::VectorXd& x) {
    const auto n = static_cast<std::size_t>(b.size());
    Gmres gmres;
    gmres.reserve(n, static_cast<int>(n));
    gmres.start(n, b.data());
    double left = gmres.start_norm() > 0.0 ? 1.0 : 0.0;
    while (left > tolerance && gmres.count() < static_cast<int>(n)) {
        Eigen::Map<Eigen::VectorXd>(gmres.image(), b.size()) =
            a * Eigen::Map<const Eigen::VectorXd>(gmres.direction(), b.size());
        left = gmres.take();
    }
    x.resize(b.size());
    gmres.solution(x.data());
    // take() returns the residual over ‖b‖.
    EXPECT_NEAR((b - a * x).norm(), left * b.norm(), 1e-10 * b.norm());
    return gmres.count();
}

TEST(Gmres, SolvesUnsymmetricSystems) {
    for (const std::uint32_t seed : test::seeds(1, 5, 20, 200)) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        for (const int n : {1, 2, 5, 12, 40}) {
            Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n) * 3.0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) a(i, j) += random.uniform(-1, 1) / n;
            Eigen::VectorXd b(n), x;
            for (int i = 0; i < n; ++i) b[i] = random.uniform(-1, 1);
            (void)solve(a, b, 1e-12, x);
            EXPECT_LE((a * x - b).norm(), 1e-11 * b.norm());
        }
    }
}

TEST(Gmres, EndsAfterAsManyIterationsAsDirectionsDiffer) {
    // Identity plus rank 3: at most 4 directions.
    test::Random random(2);
    const int n = 60;
    Eigen::MatrixXd u(n, 3), v(n, 3);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 3; ++j) {
            u(i, j) = random.uniform(-1, 1);
            v(i, j) = random.uniform(-1, 1);
        }
    const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n) + u * v.transpose() / n;
    Eigen::VectorXd b(n), x;
    for (int i = 0; i < n; ++i) b[i] = random.uniform(-1, 1);
    EXPECT_LE(solve(a, b, 1e-12, x), 4);
    EXPECT_LE((a * x - b).norm(), 1e-11 * b.norm());
}

TEST(Gmres, OfNothingIsNothing) {
    Eigen::VectorXd x;
    EXPECT_EQ(solve(Eigen::MatrixXd::Identity(5, 5), Eigen::VectorXd::Zero(5), 1e-12, x), 0);
    EXPECT_EQ(x.norm(), 0.0);
}

}  // namespace
}  // namespace hawser::nonsmooth
