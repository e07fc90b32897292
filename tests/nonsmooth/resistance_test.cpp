// SPDX-License-Identifier: Apache-2.0
// The law of rolling and torsional resistance: its residuals at solutions, its linearisation
// against differences.
#include "nonsmooth/resistance.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

using test::by_tier;
using test::first_seed;
using test::Random;

struct Pair {
    Cone cone{};
    Resistance turn{};
};

Pair random_pair(Random& random) {
    Pair p;
    Cone& c = p.cone;
    c.sigma_n = std::pow(10.0, random.uniform(-4, -2));
    c.sigma_t = c.sigma_n;
    c.mobility = std::pow(10.0, random.uniform(-4, 0));
    c.friction = 0.5;
    c.coupling = Coupling::exact;
    c.b[0] = random.uniform(-1e-2, 1e-2);
    c.u[0] = random.uniform(-1e-1, 1e-1);
    c.lambda[0] = random.uniform(-0.2, 1.0) / c.mobility * 0.05;
    Resistance& a = p.turn;
    a.sigma = std::pow(10.0, random.uniform(-4, -2));
    a.mobility = std::pow(10.0, random.uniform(-3, 1));
    a.rolling = random.uniform(0.01, 0.3);
    a.torsional = random.uniform(0.01, 0.3);
    for (int i = 0; i < 3; ++i) {
        a.b[i] = random.uniform(-1e-1, 1e-1);
        a.u[i] = random.uniform(-1, 1);
        a.lambda[i] = random.uniform(-1.0, 1.0) * 0.3 * std::fabs(c.lambda[0]);
    }
    return p;
}

/// Draw u and λ that satisfy the law. @param which  Bits: 1 it rolls, 2 it spins.
void make_solution(Pair& p, int which, Random& random) {
    Cone& c = p.cone;
    Resistance& a = p.turn;
    const double n = c.lambda[0] = random.uniform(0.1, 10.0);
    c.u[0] = c.b[0] - c.sigma_n * n;
    const double angle = random.uniform(0, 6.28);
    const double rim = (which & 1) != 0 ? 1.0 : random.uniform(0, 0.95);
    const double end = (which & 2) != 0 ? 1.0 : random.uniform(0, 0.95);
    a.lambda[0] = -end * a.torsional * n;
    a.lambda[1] = -rim * a.rolling * n * std::cos(angle);
    a.lambda[2] = -rim * a.rolling * n * std::sin(angle);
    const double roll = (which & 1) != 0 ? random.uniform(1e-3, 1.0) : 0.0;
    const double r[3] = {(which & 2) != 0 ? random.uniform(1e-3, 1.0) : 0.0, roll * std::cos(angle),
                         roll * std::sin(angle)};
    for (int i = 0; i < 3; ++i) a.u[i] = r[i] + a.b[i] - a.sigma * a.lambda[i];
}

TEST(Resistance, ResidualsVanishExactlyWhereTheLawHolds) {
    Random random(first_seed(1));
    const int trials = by_tier(4000, 20'000, 200'000);
    for (int trial = 0; trial < trials; ++trial) {
        Pair p = random_pair(random);
        make_solution(p, trial % 4, random);
        double e[3];
        residual(p.turn, p.cone, p.cone.u[0], p.cone.lambda[0], p.turn.u, p.turn.lambda, e);
        // Rounding of ρ r, relative to the impulses.
        const double size = p.cone.lambda[0];
        ASSERT_LE(std::hypot(e[0], e[1], e[2]), 1e-12 * (1.0 + size)) << trial;
        ASSERT_LE(natural_map(p.turn, p.cone, 1e-9), 1e-11) << trial;
        // A torque beyond its bound is detected in each part.
        for (int i = 0; i < 3; ++i) {
            Pair q = p;
            Resistance& a = q.turn;
            const double bound = (i == 0 ? a.torsional : a.rolling) * size;
            a.lambda[i] += 3.0 * bound;  // from −bound on: exceeds the other bound by at least one
                                         // bound
            double whole = 0.0, free = 0.0;
            for (int k = 0; k < 3; ++k) {
                whole = std::hypot(whole, a.lambda[k]);
                free = std::hypot(
                    free, (a.u[k] - a.b[k] - a.mobility * a.lambda[k]) / (a.sigma + a.mobility));
            }
            ASSERT_GE(natural_map(a, q.cone, 1e-9), 0.999 * bound / std::max(whole, free))
                << trial << " part " << i;
        }
    }
}

TEST(Resistance, OpenContactsAndFreePartsCarryNothing) {
    Random random(2);
    Pair p = random_pair(random);
    p.cone.lambda[0] = 0.0;
    p.cone.u[0] = p.cone.b[0] + 1.0;
    Touch spins{}, rolls{};
    ResistanceLaw law = linearise(p.turn, p.cone, spins, rolls);
    EXPECT_EQ(spins, Touch::open);
    EXPECT_EQ(rolls, Touch::open);
    for (const double x : law.s) EXPECT_EQ(x, 0.0);
    for (const double x : law.p) EXPECT_EQ(x, 0.0);
    make_solution(p, 0, random);
    p.turn.rolling = 0.0;
    law = linearise(p.turn, p.cone, spins, rolls);
    EXPECT_EQ(spins, Touch::stick);
    EXPECT_EQ(rolls, Touch::open);
    for (const int i : {4, 5, 7, 8}) EXPECT_EQ(law.s[i], 0.0);
    EXPECT_EQ(law.p[1], 0.0);
}

/// Compute P(λ − ρ r) at an iterate, with the ρ of linearise().
void projected(const Pair& p, double out[3]) {
    const double rho = 1.0 / (p.turn.sigma + p.turn.mobility);
    for (int i = 0; i < 3; ++i)
        out[i] =
            p.turn.lambda[i] - rho * (p.turn.u[i] + p.turn.sigma * p.turn.lambda[i] - p.turn.b[i]);
    const double r = p.cone.u[0] + p.cone.sigma_n * p.cone.lambda[0] - p.cone.b[0];
    limit(p.turn, p.cone.lambda[0] - r / (p.cone.sigma_n + p.cone.mobility), out);
}

/// Along every direction in (u_n, u) allowed by the linear laws of the normal and of the
/// resistance, λ − P changes by its present value to first order: Newton's equation.
TEST(Resistance, LinearLawSolvesNewtonsEquation) {
    Random random(first_seed(3));
    const int trials = by_tier(4000, 20'000, 200'000);
    int seen[3][3] = {};
    for (int trial = 0; trial < trials; ++trial) {
        Pair p = random_pair(random);
        Touch spins{}, rolls{};
        const ResistanceLaw law = linearise(p.turn, p.cone, spins, rolls);
        if (spins == Touch::open) continue;
        // End of the Newton step for some new velocities: λ by the linear laws.
        Pair end = p;
        end.cone.u[0] += random.uniform(-1, 1) * 1e-2;
        end.cone.lambda[0] = (end.cone.b[0] - end.cone.u[0]) / end.cone.sigma_n;
        for (int i = 0; i < 3; ++i) end.turn.u[i] += random.uniform(-1, 1) * 1e-1;
        for (int i = 0; i < 3; ++i) {
            end.turn.lambda[i] = law.p[i] - law.column[i] * end.cone.u[0];
            for (int k = 0; k < 3; ++k) end.turn.lambda[i] -= law.s[3 * i + k] * end.turn.u[k];
        }
        bool same = true;  // True if all are on one side of every kink.
        const auto defect = [&](double t, double out[3]) {
            Pair now = p;
            const auto mix = [&](double& x, double to) { x += t * (to - x); };
            mix(now.cone.u[0], end.cone.u[0]);
            mix(now.cone.lambda[0], end.cone.lambda[0]);
            for (int i = 0; i < 3; ++i) {
                mix(now.turn.u[i], end.turn.u[i]);
                mix(now.turn.lambda[i], end.turn.lambda[i]);
            }
            Touch other_spins{}, other_rolls{};
            (void)linearise(now.turn, now.cone, other_spins, other_rolls);
            same = same && other_spins == spins && other_rolls == rolls;
            projected(now, out);
            for (int i = 0; i < 3; ++i) out[i] = now.turn.lambda[i] - out[i];
        };
        double at[3], after[3], before[3];
        const double t = 1e-6;
        defect(0.0, at);
        defect(t, after);
        defect(-t, before);
        if (!same) continue;
        double scale = std::fabs(p.cone.lambda[0]);
        for (int i = 0; i < 3; ++i)
            scale = std::max({scale, std::fabs(at[i]), std::fabs(end.turn.lambda[i])});
        for (int i = 0; i < 3; ++i)
            // Differences of second order; P has curvature at the scale of λ.
            ASSERT_NEAR((after[i] - before[i]) / (2.0 * t), -at[i], 1e-4 * scale)
                << trial << " part " << i << " status " << static_cast<int>(spins)
                << static_cast<int>(rolls);
        ++seen[static_cast<int>(spins)][static_cast<int>(rolls)];
    }
    for (const Touch s : {Touch::stick, Touch::slip})
        for (const Touch r : {Touch::stick, Touch::slip})
            EXPECT_GT(seen[static_cast<int>(s)][static_cast<int>(r)], trials / 200);
}

}  // namespace
}  // namespace hawser::nonsmooth
