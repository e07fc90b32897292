// SPDX-License-Identifier: Apache-2.0
/// turn_between() against its definition.
#include <hawser/math.h>

#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

void expect_turns(const Vec3& from, const Vec3& to) {
    const double open = 1.0 + from.normalized().dot(to.normalized());
    // Rounding of a dozen operations on numbers of order one. The formula for most rotations
    // divides by 1 + cosine, which has up to three rounding errors of 2e-16.
    const double tolerance = 4e-15 + (open > 1e-6 ? 6e-16 / open : 0.0);
    const Quat q = turn_between(from, to);
    EXPECT_NEAR(q.norm(), 1.0, tolerance);
    EXPECT_LT((q * from.normalized() - to.normalized()).norm(), tolerance)
        << from.transpose() << " to " << to.transpose();
    // The smallest rotation: its axis is perpendicular to both.
    EXPECT_NEAR(q.vec().dot(from.normalized()), 0.0, tolerance);
    EXPECT_NEAR(q.vec().dot(to.normalized()), 0.0, tolerance);
}

/// The next test has nearly opposite directions, with a fixed seed.
TEST(TurnBetween, TakesOneDirectionToTheOther) {
    Random random(first_seed(5));
    const int cases = by_tier(200, 1000, 10'000);
    for (int i = 0; i < cases; ++i) {
        const Vec3 from = random.vector(3.0), to = random.vector(0.1);
        if (from.normalized().dot(to.normalized()) > -0.9) expect_turns(from, to);
    }
}

TEST(TurnBetween, TurnsByHalfATurnBetweenOpposites) {
    Random random(6);
    for (int k = 0; k < 3; ++k)
        for (const double sign : {-1.0, 1.0})
            expect_turns(sign * Vec3::Unit(k), -sign * Vec3::Unit(k));
    for (int i = 0; i < 200; ++i) {
        const Vec3 v = random.vector(1.0);
        expect_turns(v, -2.5 * v);
        expect_turns(v, -2.5 * v + random.vector(std::pow(10.0, -i % 12)));
    }
}

TEST(TurnBetween, IsNothingBetweenTheSame) {
    const Quat q = turn_between({0.3, -2.0, 1.0}, {0.6, -4.0, 2.0});
    EXPECT_LT(q.vec().norm(), 1e-15);
}

}  // namespace
}  // namespace hawser::test
