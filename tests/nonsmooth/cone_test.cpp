// SPDX-License-Identifier: Apache-2.0
// Laws of one contact: projections, natural maps, derivatives against differences.
#include "nonsmooth/cone.h"
#include "nonsmooth/associated.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

using test::by_tier;
using test::first_seed;
using test::Random;

Cone random_cone(Random& random) {
    Cone c{};
    c.sigma_n = std::pow(10.0, random.uniform(-6, -2));
    c.sigma_t = c.sigma_n * random.uniform(0.5, 2.0);
    c.mobility = std::pow(10.0, random.uniform(-4, 0));
    c.friction = random.uniform(0.05, 1.5);
    for (int i = 0; i < 3; ++i) {
        c.b[i] = random.uniform(-1e-2, 1e-2);
        c.u[i] = random.uniform(-1e-1, 1e-1);
        c.lambda[i] = random.uniform(-1.0, 1.0) / c.mobility * 0.05;
    }
    return c;
}

double norm_of(const double* a, const double* b) {
    double s = 0.0;
    for (int i = 0; i < 3; ++i) s += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(s);
}

TEST(Project, GivesTheNearestPointOfTheCone) {
    Random random(first_seed(1));
    const int trials = by_tier(2000, 10'000, 100'000);
    for (int trial = 0; trial < trials; ++trial) {
        const double mu = trial % 10 == 0 ? 0.0 : random.uniform(0.0, 2.0);
        double y[3], p[3], again[3];
        for (double& v : y) v = random.uniform(-3, 3);
        std::copy_n(y, 3, p);
        project(mu, p);
        ASSERT_GE(p[0], 0.0);
        ASSERT_LE(std::hypot(p[1], p[2]), mu * p[0] + 1e-14);
        std::copy_n(p, 3, again);
        project(mu, again);
        ASSERT_LE(norm_of(p, again), 1e-14);
        // Nearest point: ⟨y − p, z − p⟩ ≤ 0 for every z of the cone.
        for (int other = 0; other < 20; ++other) {
            const double n = random.uniform(0, 4), a = random.uniform(0, 6.3),
                         r = mu * n * random.unit();
            const double z[3] = {n, r * std::cos(a), r * std::sin(a)};
            double dot = 0.0;
            for (int i = 0; i < 3; ++i) dot += (y[i] - p[i]) * (z[i] - p[i]);
            ASSERT_LE(dot, 1e-12);
        }
    }
}

/// Without friction and tangential impulse, the cone is a half line and the rest of the line goes
/// to 0.
TEST(Project, RemovesAPullWithoutFriction) {
    Random random(first_seed(9));
    for (int trial = 0; trial < 100; ++trial) {
        const double pull = std::pow(10.0, random.uniform(-16, 6));
        double p[3] = {-pull, 0.0, 0.0}, push[3] = {pull, 0.0, 0.0};
        project(0.0, p);
        ASSERT_EQ(p[0], 0.0);
        project(0.0, push);
        ASSERT_EQ(push[0], pull);
        Cone c = random_cone(random);
        c.friction = c.mobility = 0.0;
        for (int i = 0; i < 3; ++i) c.u[i] = c.lambda[i] = c.b[i] = 0.0;
        c.b[0] = -pull;  // a gap
        ASSERT_EQ(natural_map(c, 1e-9), 0.0) << pull;
        ASSERT_EQ(associated_map(c, 1e-9), 0.0) << pull;
    }
}

/// Draw λ and u that satisfy Coulomb's law exactly, with a given status.
void make_solution(Cone& c, Touch touch, Random& random) {
    const double n = touch == Touch::open ? 0.0 : random.uniform(0.1, 10.0);
    const double angle = random.uniform(0, 6.28), x = std::cos(angle), y = std::sin(angle);
    const double radius = c.friction * n * (touch == Touch::stick ? random.uniform(0, 0.95) : 1.0);
    const double slip = touch == Touch::slip ? random.uniform(1e-3, 1.0) : 0.0;
    const double separation = touch == Touch::open ? random.uniform(1e-3, 1.0) : 0.0;
    c.lambda[0] = n;
    c.lambda[1] = -radius * x;
    c.lambda[2] = -radius * y;
    const double r[3] = {separation, slip * x, slip * y};
    for (int i = 0; i < 3; ++i)
        c.u[i] = r[i] + c.b[i] - (i == 0 ? c.sigma_n : c.sigma_t) * c.lambda[i];
}

TEST(NaturalMap, VanishesExactlyWhereTheLawHolds) {
    Random random(first_seed(2));
    const int trials = by_tier(3000, 15'000, 150'000);
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        make_solution(c, static_cast<Touch>(trial % 3), random);
        double e[3];
        residual(c, c.u, c.lambda, e);
        ASSERT_LE(natural_map(c, 1e-9), 1e-11) << trial;
        ASSERT_LE(std::hypot(e[0], e[1], e[2]), 1e-11 * (1.0 + c.lambda[0])) << trial;
        // The residual vanishes only there: an impulse with an error of a tenth is detected.
        if (trial % 3 == 0) continue;
        const double change = 0.1 * c.lambda[0];
        c.lambda[trial % 2] += change;
        c.u[trial % 2] += c.mobility * change;  // velocity change of the point due to the impulse
        // Relative to λ or the impulse that would stop the point, whichever is larger.
        const double rho = 1.0 / (c.mobility + std::max(c.sigma_n, c.sigma_t));
        double size = std::hypot(c.lambda[0], c.lambda[1], c.lambda[2]), q[3];
        for (int i = 0; i < 3; ++i) q[i] = rho * (c.u[i] - c.b[i] - c.mobility * c.lambda[i]);
        size = std::max(size, std::hypot(q[0], q[1], q[2]));
        ASSERT_GE(natural_map(c, 1e-9), 0.1 * change / size) << trial;
    }
}

TEST(NaturalMap, DoesNotDependOnUnits) {
    Random random(first_seed(3));
    const int trials = by_tier(500, 2500, 25'000);
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random), d = c;
        const double mass = 1e5, speed = 1e-2;  // λ scales with both, Σ and W with 1/mass
        d.sigma_n /= mass;
        d.sigma_t /= mass;
        d.mobility /= mass;
        for (int i = 0; i < 3; ++i) {
            d.b[i] *= speed;
            d.u[i] *= speed;
            d.lambda[i] *= mass * speed;
        }
        ASSERT_NEAR(natural_map(c, 1e-12), natural_map(d, 1e-12 * mass * speed), 1e-12);
    }
}

/// The linear law is tangent to the nonlinear one: P(y(u, λ)) − (p − S u) has the tangent of
/// Newton's equation. With W = 0, P depends on u alone, so −S is its derivative.
TEST(Linearise, IsTheDerivativeByVelocity) {
    Random random(first_seed(4));
    const int trials = by_tier(3000, 15'000, 150'000);
    int seen[3] = {};
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        c.coupling = Coupling::exact;
        c.mobility = 0.0;
        Touch touch{}, other{};
        const Law law = linearise(c, touch);
        const double step = 1e-7;
        for (int j = 0; j < 3; ++j) {
            double value[2][3];
            bool same = true;
            for (int side = 0; side < 2; ++side) {
                Cone d = c;
                d.u[j] += side == 0 ? -step : step;
                const Law at = linearise(d, other);
                same = same && other == touch;
                for (int i = 0; i < 3; ++i) {
                    value[side][i] = at.p[i];
                    for (int k = 0; k < 3; ++k) value[side][i] -= at.s[3 * i + k] * d.u[k];
                }
            }
            if (!same) continue;
            ++seen[static_cast<int>(touch)];
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR((value[1][i] - value[0][i]) / (2 * step), -law.s[3 * i + j],
                            1e-4 / c.sigma_t)
                    << trial << " row " << i << " column " << j;
        }
    }
    for (const int count : seen) EXPECT_GT(count, trials / 30);
}

/// Newton's direction belongs to the residual: along it, every component of λ − P(y) decreases as 1
/// − t. This fails if residual and law differ in ρ.
TEST(Linearise, IsNewtonsStepOfTheResidual) {
    Random random(first_seed(7));
    const int trials = by_tier(3000, 15'000, 150'000);
    int seen[3] = {};
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        c.coupling = Coupling::exact;
        Touch touch{}, other{};
        const Law law = linearise(c, touch);
        constexpr double kShare = 1e-6;
        double u[3], lambda[3], before[3], after[3], size = 0.0;
        for (int i = 0; i < 3; ++i) u[i] = c.u[i] + random.uniform(-1e-2, 1e-2);
        for (int i = 0; i < 3; ++i) {
            double end = law.p[i];
            for (int j = 0; j < 3; ++j) end -= law.s[3 * i + j] * u[j];
            lambda[i] = c.lambda[i] + kShare * (end - c.lambda[i]);
            size += std::fabs(end) + std::fabs(c.lambda[i]);
        }
        for (int i = 0; i < 3; ++i) u[i] = c.u[i] + kShare * (u[i] - c.u[i]);
        residual(c, c.u, c.lambda, before);
        residual(c, u, lambda, after);
        Cone there = c;
        std::copy_n(u, 3, there.u);
        std::copy_n(lambda, 3, there.lambda);
        (void)linearise(there, other);
        if (other != touch) continue;
        ++seen[static_cast<int>(touch)];
        for (int i = 0; i < 3; ++i)
            // Second order in the step fraction, and rounding of differences over the fraction.
            ASSERT_NEAR((after[i] - before[i]) / kShare, -before[i], 1e-3 * size)
                << trial << " row " << i;
    }
    for (const int count : seen) EXPECT_GT(count, trials / 100);
}

TEST(Linearise, HoldsWhatTurnsRound) {
    Random random(first_seed(8));
    const int trials = by_tier(500, 5000, 50'000);
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        c.coupling = Coupling::exact;
        make_solution(c, Touch::slip, random);
        Touch touch{};
        const Law law = linearise(c, touch);
        // ŷ is the direction of λ_t of a sliding point.
        const double turn = random.uniform(0, 3.14159), cosine = std::cos(turn);
        Cone turned = c;
        const double x = c.lambda[1], y = c.lambda[2], sine = std::sin(turn);
        turned.lambda[1] = cosine * x - sine * y;
        turned.lambda[2] = sine * x + cosine * y;
        for (int i = 1; i < 3; ++i)
            turned.u[i] = c.b[i] - c.sigma_t * turned.lambda[i] - 1e-3 * turned.lambda[i];
        Touch slides{};
        const Law other = linearise(turned, slides);
        ASSERT_EQ(slides, Touch::slip);
        if (std::fabs(cosine) > 1e-6) {
            ASSERT_EQ(sliding_reversed(law, other), cosine < 0.0) << trial;
        }
        // The law in its place requires r = 0.
        const Law held = sticking_law(c);
        ASSERT_FALSE(sliding_reversed(law, held));
        for (int i = 0; i < 3; ++i) {
            const double sigma = i == 0 ? c.sigma_n : c.sigma_t;
            double lambda = held.p[i];
            for (int j = 0; j < 3; ++j) lambda -= held.s[3 * i + j] * c.u[j];
            const double r = c.u[i] + sigma * lambda - c.b[i];
            ASSERT_NEAR(r, 0.0, 1e-12 * (std::fabs(c.u[i]) + std::fabs(c.b[i]))) << trial;
        }
    }
}

TEST(Linearise, KeepsASolution) {
    Random random(first_seed(5));
    const int trials = by_tier(3000, 15'000, 150'000);
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        const Touch wanted = static_cast<Touch>(trial % 3);
        make_solution(c, wanted, random);
        for (const Coupling coupling : {Coupling::exact, Coupling::lagged}) {
            c.coupling = coupling;
            Touch touch{};
            const Law law = linearise(c, touch);
            ASSERT_EQ(touch, wanted);
            for (int i = 0; i < 3; ++i) {
                double lambda = law.p[i], size = std::fabs(law.p[i]) + 1e-3;
                for (int k = 0; k < 3; ++k) {
                    lambda -= law.s[3 * i + k] * c.u[k];
                    size += std::fabs(law.s[3 * i + k] * c.u[k]);
                }
                // Rounding of the terms, which are large if Σ is small.
                ASSERT_NEAR(lambda, c.lambda[i], 1e-12 * size + 1e-12 * c.lambda[0]) << trial;
            }
        }
    }
}

TEST(Associated, DerivativeIsSymmetricPositiveAndRight) {
    Random random(first_seed(6));
    const int trials = by_tier(3000, 15'000, 150'000);
    int seen[3] = {};
    for (int trial = 0; trial < trials; ++trial) {
        Cone c = random_cone(random);
        Touch touch{}, other{};
        const Law law = linearise_associated(c, touch);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                ASSERT_NEAR(law.s[3 * i + j], law.s[3 * j + i], 1e-12 / c.sigma_t);
        double x[3], quadratic = 0.0;
        for (double& v : x) v = random.uniform(-1, 1);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) quadratic += x[i] * law.s[3 * i + j] * x[j];
        ASSERT_GE(quadratic, -1e-10 / c.sigma_t);
        const double step = 1e-7;
        for (int j = 0; j < 3; ++j) {
            double low[3], high[3];
            Cone d = c;
            d.u[j] -= step;
            (void)linearise_associated(d, other);
            if (other != touch) continue;
            associated_impulse(c, d.u, low);
            d.u[j] += 2 * step;
            (void)linearise_associated(d, other);
            if (other != touch) continue;
            associated_impulse(c, d.u, high);
            ++seen[static_cast<int>(touch)];
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR((high[i] - low[i]) / (2 * step), -law.s[3 * i + j], 1e-4 / c.sigma_t);
        }
    }
    for (const int count : seen) EXPECT_GT(count, trials / 30);
}

TEST(Associated, MinimisesItsFunction) {
    Random random(first_seed(7));
    const int trials = by_tier(500, 2500, 25'000);
    for (int trial = 0; trial < trials; ++trial) {
        const Cone c = random_cone(random);
        double lambda[3];
        associated_impulse(c, c.u, lambda);
        auto value = [&](const double* l) {
            double s = 0.0;
            for (int i = 0; i < 3; ++i)
                s +=
                    0.5 * (i == 0 ? c.sigma_n : c.sigma_t) * l[i] * l[i] - l[i] * (c.b[i] - c.u[i]);
            return s;
        };
        const double least = value(lambda);
        const double size = std::fabs(lambda[0]) + 1.0;
        for (int other = 0; other < 50; ++other) {
            double z[3] = {lambda[0] + random.uniform(-1, 1) * size,
                           lambda[1] + random.uniform(-1, 1) * size,
                           lambda[2] + random.uniform(-1, 1) * size};
            project(c.friction, z);
            ASSERT_LE(least, value(z) + 1e-12 * (std::fabs(least) + c.sigma_n * size * size));
        }
    }
}

}  // namespace
}  // namespace hawser::nonsmooth
