// SPDX-License-Identifier: Apache-2.0
// Laws iterated on small dense problems, against solutions found by trying every active set.
//
// The problem: u = W λ + q with W = J M⁻¹ Jᵀ dense, and a law for each contact.
#include "nonsmooth/associated.h"
#include "nonsmooth/box.h"
#include "nonsmooth/cone.h"
#include "nonsmooth/pivot.h"
#include "nonsmooth/relax.h"
#include "support/dense_reference.h"
#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::nonsmooth {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::by_tier;
using test::first_seed;
using test::kSanitized;
using test::Random;

struct Problem {
    MatrixXd w;
    VectorXd q;
    std::vector<Cone> cones;

    /// Compute u and λ with the law p − S u of every contact.
    void solve(const std::vector<Law>& laws) {
        const auto n = q.size();
        MatrixXd s = MatrixXd::Zero(n, n);
        VectorXd p(n);
        for (std::size_t k = 0; k < laws.size(); ++k)
            for (int i = 0; i < 3; ++i) {
                const auto row = static_cast<Eigen::Index>(3 * k) + i;
                p[row] = laws[k].p[i];
                for (int j = 0; j < 3; ++j)
                    s(row, static_cast<Eigen::Index>(3 * k) + j) = laws[k].s[3 * i + j];
            }
        const VectorXd u = (MatrixXd::Identity(n, n) + w * s).partialPivLu().solve(w * p + q);
        set(u, p - s * u);
    }
    void set(const VectorXd& u, const VectorXd& lambda) {
        for (std::size_t k = 0; k < cones.size(); ++k)
            for (int i = 0; i < 3; ++i) {
                cones[k].u[i] = u[static_cast<Eigen::Index>(3 * k) + i];
                cones[k].lambda[i] = lambda[static_cast<Eigen::Index>(3 * k) + i];
            }
    }
    [[nodiscard]] VectorXd lambda() const {
        VectorXd l(q.size());
        for (std::size_t k = 0; k < cones.size(); ++k)
            for (int i = 0; i < 3; ++i)
                l[static_cast<Eigen::Index>(3 * k) + i] = cones[k].lambda[i];
        return l;
    }
};

Problem random_problem(Random& random, int contacts) {
    const int n = 3 * contacts, bodies = 6 * contacts;  // makes W regular and contacts coupled
    MatrixXd j(n, bodies);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < bodies; ++k) j(i, k) = random.uniform(-1, 1);
    Problem p{j * j.transpose() / bodies, VectorXd(n), {}};
    for (int i = 0; i < n; ++i) p.q[i] = random.uniform(-1, 1);
    for (int k = 0; k < contacts; ++k) {
        p.q[3 * k] -= 0.5;
        Cone c{};
        c.sigma_n = c.sigma_t = 0.01;
        c.friction = random.uniform(0.1, 0.8);
        c.mobility = p.w.block<3, 3>(3 * k, 3 * k).trace() / 3.0;
        p.cones.push_back(c);
    }
    return p;
}

/// Solve the box problem by trying every combination of free, low and high rows.
VectorXd brute_force(const Problem& p, const std::vector<double>& limit, int& solutions) {
    const auto n = static_cast<int>(p.q.size());
    int combinations = 1;
    for (int i = 0; i < n; ++i) combinations *= 3;
    VectorXd found;
    solutions = 0;
    for (int code = 0; code < combinations; ++code) {
        VectorXd lambda(n);
        std::vector<int> free;
        bool skip = false;
        for (int i = 0, rest = code; i < n; ++i, rest /= 3) {
            const int status = rest % 3;
            const bool normal = i % 3 == 0;
            const double bound = limit[static_cast<std::size_t>(i / 3)];
            skip = skip || (normal && status == 2);
            lambda[i] = status == 0 ? 0.0 : normal ? 0.0 : status == 1 ? -bound : bound;
            if (status == 0) free.push_back(i);
        }
        if (skip) continue;
        const auto m = static_cast<int>(free.size());
        const VectorXd at_bounds = p.w * lambda + p.q;
        MatrixXd a(m, m);
        VectorXd b(m);
        for (int i = 0; i < m; ++i) {
            for (int j = 0; j < m; ++j)
                a(i, j) =
                    p.w(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]) +
                    (i == j ? 0.01 : 0.0);
            b[i] = -at_bounds[free[static_cast<std::size_t>(i)]];
        }
        if (m > 0) {
            const VectorXd x = test::solve_dense(a, b);
            for (int i = 0; i < m; ++i) lambda[free[static_cast<std::size_t>(i)]] = x[i];
        }
        const VectorXd r = p.w * lambda + p.q + 0.01 * lambda;
        bool good = true;
        for (int i = 0, rest = code; i < n; ++i, rest /= 3) {
            const double bound = limit[static_cast<std::size_t>(i / 3)];
            const double low = i % 3 == 0 ? 0.0 : -bound, high = i % 3 == 0 ? 1e30 : bound;
            if (rest % 3 == 0) good = good && lambda[i] >= low && lambda[i] <= high;
            if (rest % 3 == 1) good = good && r[i] >= 0.0;
            if (rest % 3 == 2) good = good && r[i] <= 0.0;
        }
        if (!good) continue;
        found = lambda;
        ++solutions;
    }
    return found;
}

/// Solve by pivoting from all rows free. @return iterations; 300: not solved.
int pivot_all(Problem& p, const std::vector<double>& limit, PivotProgress progress) {
    std::vector<Bound> bounds(3 * p.cones.size(), Bound::free);
    for (int rounds = 1; rounds < 300; ++rounds) {
        std::vector<Law> laws;
        for (std::size_t k = 0; k < p.cones.size(); ++k)
            laws.push_back(box_law(p.cones[k], &bounds[3 * k], limit[k]));
        p.solve(laws);
        if (pivot(p.cones, bounds, limit, 1e-9, progress) == 0) return rounds;
    }
    return 300;
}

TEST(Box, PivotingFindsTheSolutionThatTryingEverythingFinds) {
    Random random(first_seed(1));
    const int trials = by_tier(12, kSanitized ? 12 : 60, 600);
    int together = 0, singly = 0;
    for (int trial = 0; trial < trials; ++trial) {
        Problem p = random_problem(random, 1 + trial % 3);  // up to 9 rows: 19,683 sets
        std::vector<double> limit;
        for (std::size_t k = 0; k < p.cones.size(); ++k) limit.push_back(random.uniform(0.0, 0.5));
        int solutions = 0;
        const VectorXd exact = brute_force(p, limit, solutions);
        ASSERT_EQ(solutions, 1) << "a P-matrix has one solution";
        // First like the stepper, then by the fallback alone.
        for (const PivotProgress& start : {PivotProgress{}, PivotProgress{0, 0}}) {
            const int rounds = pivot_all(p, limit, start);
            ASSERT_LT(rounds, 300);
            (start.trials > 0 ? together : singly) += rounds;
            EXPECT_LE((p.lambda() - exact).norm(), 1e-7 * (1.0 + exact.norm())) << trial;
        }
    }
    EXPECT_LT(together, singly);  // purpose of changing them together
}

/// Iterations without progress: all rows change until the trials are used up, then only the last
/// one, until fewer are infeasible. (A search of 10⁴ random problems found no cycle of changing
/// all.)
TEST(Box, PivotingChangesRowsSinglyWhenItDoesNotGetOn) {
    Cone pulled{};  // λ outside all of its bounds
    pulled.sigma_n = pulled.sigma_t = 0.01;
    pulled.mobility = 1.0;
    for (double& l : pulled.lambda) l = -1.0;
    const std::vector<Cone> three(3, pulled), two(2, pulled);
    const std::vector<double> limit(3, 0.5);
    PivotProgress progress;
    const auto changed = [&](const std::vector<Cone>& cones) {
        std::vector<Bound> rows(9, Bound::free);
        EXPECT_EQ(pivot(cones, rows, limit, 1e-9, progress), static_cast<int>(3 * cones.size()));
        const auto count = 9 - std::count(rows.begin(), rows.end(), Bound::free);
        EXPECT_TRUE(count != 1 || rows[3 * cones.size() - 1] == Bound::low) << "the last one";
        return count;
    };
    for (int i = 0; i <= kPivotTrials; ++i) EXPECT_EQ(changed(three), 9) << i;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(changed(three), 1) << i;
    EXPECT_EQ(changed(two), 1);  // fewer infeasible rows: the next call changes all again
    for (int i = 0; i < kPivotTrials; ++i) EXPECT_EQ(changed(two), 6) << i;
    EXPECT_EQ(changed(two), 1);
}

double merit(const Problem& p) {
    double sum = 0.0;
    for (const Cone& c : p.cones) {
        double e[3];
        residual(c, c.u, c.lambda, e);
        sum += (c.mobility + c.sigma_n) * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    }
    return sum;
}

/// Run Newton's method with the line search of the stepper. @return largest natural map.
double newton(Problem& p, int iterations) {
    double left = 1.0;
    for (int it = 0; it < iterations && left > 1e-11; ++it) {
        std::vector<Law> laws;
        for (Cone& c : p.cones) {
            c.coupling = Coupling::exact;
            laws.push_back(linearise(c, c.touch));
        }
        const std::vector<Cone> from = p.cones;
        const double before = merit(p);
        p.solve(laws);
        const std::vector<Cone> to = p.cones;
        double best = merit(p), best_t = 1.0;
        auto go = [&](double t) {
            for (std::size_t k = 0; k < from.size(); ++k)
                for (int i = 0; i < 3; ++i) {
                    p.cones[k].u[i] = from[k].u[i] + t * (to[k].u[i] - from[k].u[i]);
                    p.cones[k].lambda[i] =
                        from[k].lambda[i] + t * (to[k].lambda[i] - from[k].lambda[i]);
                }
        };
        double now = best;
        for (double t = 0.5; it > 0 && t > 0.2 && now > before; t *= 0.5) {
            go(t);
            now = merit(p);
            if (now < best) {
                best = now;
                best_t = t;
            }
        }
        go(best_t);
        left = 0.0;
        for (const Cone& c : p.cones) left = std::max(left, natural_map(c, 1e-9));
    }
    return left;
}

TEST(Cone, NewtonAndSweepsFindTheSameImpulses) {
    Random random(first_seed(2));
    const int trials = by_tier(kSanitized ? 10 : 30, kSanitized ? 20 : 100, 1000);
    int solved = 0;
    for (int trial = 0; trial < trials; ++trial) {
        Problem p = random_problem(random, 1 + trial % 4);
        if (newton(p, 100) > 1e-11) continue;
        ++solved;
        const VectorXd newton = p.lambda();
        // Sweeps: another method for the same law, contact by contact.
        VectorXd lambda = VectorXd::Zero(p.q.size());
        for (int sweep = 0; sweep < 2000; ++sweep)
            for (std::size_t k = 0; k < p.cones.size(); ++k) {
                const auto row = static_cast<Eigen::Index>(3 * k);
                p.set(p.w * lambda + p.q, lambda);
                lambda[row] = relax_normal(p.cones[k], p.w(row, row));
                p.set(p.w * lambda + p.q, lambda);
                double t[2];
                const MatrixXd block = p.w.block<2, 2>(row + 1, row + 1);
                relax_tangents(p.cones[k], block.trace(), t);
                lambda[row + 1] = t[0];
                lambda[row + 2] = t[1];
            }
        p.set(p.w * lambda + p.q, lambda);
        double swept = 0.0;
        for (const Cone& c : p.cones) swept = std::max(swept, natural_map(c, 1e-9));
        if (swept > 1e-10) continue;  // sweeps need not converge for Coulomb's law
        EXPECT_LE((newton - lambda).norm(), 1e-6 * (1.0 + lambda.norm())) << trial;
    }
    EXPECT_GE(solved, trials * 9 / 10);
}

TEST(Associated, NewtonFindsTheMinimum) {
    Random random(first_seed(3));
    const int trials = by_tier(30, 100, 1000);
    for (int trial = 0; trial < trials; ++trial) {
        Problem p = random_problem(random, 1 + trial % 4);
        for (int it = 0; it < 60; ++it) {
            std::vector<Law> laws;
            for (Cone& c : p.cones) laws.push_back(linearise_associated(c, c.touch));
            p.solve(laws);
        }
        double left = 0.0;
        for (const Cone& c : p.cones) left = std::max(left, associated_map(c, 1e-9));
        if (left > 1e-9) continue;  // this test has no line search
        // ½ λᵀ(W + Σ)λ + qᵀλ is convex on the cones: no feasible point is lower.
        const VectorXd lambda = p.lambda();
        auto value = [&](const VectorXd& l) {
            return 0.5 * l.dot(p.w * l) + 0.005 * l.squaredNorm() + p.q.dot(l);
        };
        for (int other = 0; other < 100; ++other) {
            VectorXd z = lambda;
            for (Eigen::Index i = 0; i < z.size(); ++i) z[i] += random.uniform(-1, 1) * 0.3;
            for (std::size_t k = 0; k < p.cones.size(); ++k)
                project(p.cones[k].friction, z.data() + 3 * k);
            ASSERT_LE(value(lambda), value(z) + 1e-9);
        }
    }
}

/// A block of mass m on a plane, pushed by f along it and by w downwards, for a step h: closed
/// form.
TEST(Cone, ABlockSlidesWithTheDifference) {
    for (const double push : {0.3, 0.8, 2.0}) {
        Problem p{MatrixXd::Identity(3, 3), VectorXd(3), {}};
        p.q << -1.0, push, 0.0;
        Cone c{};
        c.sigma_n = c.sigma_t = 1e-9;
        c.friction = 0.5;
        c.mobility = 1.0;
        p.cones.push_back(c);
        EXPECT_LE(newton(p, 60), 1e-11);
        EXPECT_NEAR(p.cones[0].lambda[0], 1.0, 1e-8);
        EXPECT_NEAR(p.cones[0].u[1], std::max(0.0, push - 0.5), 1e-8);
        EXPECT_EQ(p.cones[0].touch, push > 0.5 ? Touch::slip : Touch::stick);
    }
}

}  // namespace
}  // namespace hawser::nonsmooth
