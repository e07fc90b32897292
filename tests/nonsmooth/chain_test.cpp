// SPDX-License-Identifier: Apache-2.0
// Problems along a wire: complementarity of elements, and block tridiagonal systems, against dense
// references.
#include "nonsmooth/block_chain.h"
#include "nonsmooth/tridiagonal.h"
#include "support/dense_reference.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace hawser::nonsmooth {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::by_tier;
using test::first_seed;
using test::Random;

/// The problem in dense arrays.
struct DenseChain {
    MatrixXd m;
    VectorXd residual, start;
    std::vector<bool> fixed;

    [[nodiscard]] VectorXd complement(const VectorXd& z) const {
        return residual + m * (z - start);
    }
};

DenseChain dense_of(const std::vector<ChainRow>& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    DenseChain d{MatrixXd::Zero(n, n), VectorXd(n), VectorXd(n), {}};
    for (Eigen::Index i = 0; i < n; ++i) {
        const ChainRow& row = rows[static_cast<std::size_t>(i)];
        d.m(i, i) = row.diagonal;
        if (i + 1 < n) d.m(i, i + 1) = d.m(i + 1, i) = row.next;
        d.residual[i] = row.residual;
        d.start[i] = row.start;
        d.fixed.push_back(row.fixed);
    }
    return d;
}

/// Make M = Σ + G A⁻¹ Gᵀ of a wire whose elements turn by at most `bend`; positive definite.
std::vector<ChainRow> random_chain(Random& random, std::size_t n, double bend) {
    std::vector<ChainRow> rows(n, ChainRow{});
    double before = random.uniform(0.02, 0.1);  // mobility of the previous node
    for (std::size_t i = 0; i < n; ++i) {
        const double behind = random.uniform(0.02, 0.1);
        rows[i].diagonal = std::pow(10.0, random.uniform(-5, -2)) + before + behind;
        rows[i].next = -behind * std::cos(random.uniform(0.0, bend));
        rows[i].residual = random.uniform(-1, 1);
        rows[i].start = random.chance(0.5) ? random.uniform(0, 20) : 0.0;
        rows[i].active = random.chance(0.5);
        rows[i].fixed = random.chance(0.1);
        before = behind;
    }
    return rows;
}

/// Find the solution by trying all sets of active rows.
std::optional<VectorXd> try_all_sets(const DenseChain& d) {
    const auto n = d.m.rows();
    for (int set = 0; set < 1 << n; ++set) {
        std::vector<Eigen::Index> active;
        bool allowed = true;
        for (Eigen::Index i = 0; i < n; ++i) {
            if ((set >> i & 1) == 0) continue;
            active.push_back(i);
            allowed = allowed && !d.fixed[static_cast<std::size_t>(i)];
        }
        if (!allowed) continue;
        const auto count = static_cast<Eigen::Index>(active.size());
        MatrixXd part(count, count);
        VectorXd right(count);
        const VectorXd at_start = d.m * d.start - d.residual;
        for (Eigen::Index i = 0; i < count; ++i) {
            right[i] = at_start[active[static_cast<std::size_t>(i)]];
            for (Eigen::Index j = 0; j < count; ++j)
                part(i, j) =
                    d.m(active[static_cast<std::size_t>(i)], active[static_cast<std::size_t>(j)]);
        }
        VectorXd z = VectorXd::Zero(n);
        if (count > 0) {
            const VectorXd solved = test::solve_dense(part, right);
            for (Eigen::Index i = 0; i < count; ++i)
                z[active[static_cast<std::size_t>(i)]] = solved[i];
        }
        const VectorXd w = d.complement(z);
        bool good = z.minCoeff() >= 0.0;
        for (Eigen::Index i = 0; i < n; ++i)
            good = good &&
                   (d.fixed[static_cast<std::size_t>(i)] || (set >> i & 1) != 0 || w[i] >= 0.0);
        if (good) return z;
    }
    return std::nullopt;
}

VectorXd solution_of(const std::vector<ChainRow>& rows) {
    VectorXd z(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) z[static_cast<Eigen::Index>(i)] = rows[i].z;
    return z;
}

TEST(Chain, FindsTheSolutionThatTryingEverySetFinds) {
    Random random(first_seed(1));
    const int trials = by_tier(300, 2000, 20'000);
    for (int trial = 0; trial < trials; ++trial) {
        // Includes bends above 90 degrees, for which M is no M-matrix.
        const double bend = trial % 2 == 0 ? 0.0 : 3.0;
        std::vector<ChainRow> rows =
            random_chain(random, 1 + static_cast<std::size_t>(trial) % 8, bend);
        const DenseChain dense = dense_of(rows);
        const std::optional<VectorXd> exact = try_all_sets(dense);
        ASSERT_TRUE(exact) << "a positive definite matrix has one solution";
        ASSERT_TRUE(solve_chain(rows.size(), rows.data())) << trial;
        // Condition numbers of M up to 1e4.
        ASSERT_LE((solution_of(rows) - *exact).norm(), 1e-9 * (1.0 + exact->norm())) << trial;
    }
}

/// A slack wire whose elements come taut one after the other. Newton's method on the whole system
/// needs one iteration per element.
TEST(Chain, SettlesALongWireThatZips) {
    constexpr std::size_t kRows = 100;
    std::vector<ChainRow> rows(kRows, ChainRow{});
    for (std::size_t i = 0; i < kRows; ++i) {
        rows[i].diagonal = 2.0 + 1e-6;
        rows[i].next = -1.0;
        rows[i].residual = i == 0 ? -1.0 : 1e-4 * static_cast<double>(i % 7);
    }
    const DenseChain dense = dense_of(rows);
    ASSERT_TRUE(solve_chain(kRows, rows.data()));
    const VectorXd z = solution_of(rows), w = dense.complement(z);
    const auto taut =
        std::count_if(rows.begin(), rows.end(), [](const ChainRow& r) { return r.active; });
    EXPECT_GT(taut, 10);
    EXPECT_GE(z.minCoeff(), 0.0);
    // Rounding of rows of size 1.
    EXPECT_GE(w.minCoeff(), -1e-12);
    EXPECT_LE(z.cwiseProduct(w).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(BlockChain, SolvesWhatADenseSolverSolves) {
    Random random(first_seed(2));
    const int trials = by_tier(200, 1000, 10'000);
    for (int trial = 0; trial < trials; ++trial) {
        const auto n = 1 + static_cast<std::size_t>(trial) % 12;
        const auto size = static_cast<Eigen::Index>(3 * n);
        std::vector<ChainBlock> rows(n, ChainBlock{});
        MatrixXd k = MatrixXd::Zero(size, size);
        VectorXd b(size);
        const auto fill = [&](double* block, Eigen::Index row, Eigen::Index column, double own) {
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    k(row + i, column + j) = block[3 * i + j] =
                        random.uniform(-1, 1) + (i == j ? own : 0.0);
        };
        for (std::size_t r = 0; r < n; ++r) {
            const auto row = static_cast<Eigen::Index>(3 * r);
            fill(rows[r].diagonal, row, row, 6.0);  // no exchange of pivots is needed
            if (r > 0) fill(rows[r].block_before, row, row - 3, 0.0);
            if (r + 1 < n) fill(rows[r].block_behind, row, row + 3, 0.0);
            for (int i = 0; i < 3; ++i) b[row + i] = rows[r].x[i] = random.uniform(-1, 1);
        }
        ASSERT_TRUE(solve_block_chain(n, rows.data()));
        const VectorXd exact = test::solve_dense(k, b);
        for (std::size_t r = 0; r < n; ++r)
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR(rows[r].x[i], exact[static_cast<Eigen::Index>(3 * r) + i], 1e-12);
    }
}

TEST(BlockChain, RefusesASingularPivot) {
    std::vector<ChainBlock> rows(2, ChainBlock{});
    for (int i = 0; i < 3; ++i) rows[0].diagonal[4 * i] = 1.0;
    EXPECT_FALSE(solve_block_chain(2, rows.data()));
}

}  // namespace
}  // namespace hawser::nonsmooth
