// SPDX-License-Identifier: Apache-2.0
/// Functions for friction along the axis of a guide: position at which a wire comes to rest, and
/// lengths that its parts exchange.
#include "wire/sideways.h"

#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

/// Compare the root of the law with bisection. @param inside  Check that friction holds there.
void expect_at_bound(test::Random& random, bool inside) {
    const wire::Crossing c{{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)},
                           {random.uniform(0.1, 20.0), random.uniform(0.1, 20.0)}};
    const double bound = random.chance(0.2) ? 0.0 : random.uniform(0.0, 0.5);
    const double now = wire::sideways_balance(c, 0.0), way = wire::sideways_displacement(c, bound);
    if (std::abs(now) <= bound) {
        EXPECT_EQ(way, 0.0);
        return;
    }
    double low = -1e3, high = 1e3;  // f increases from −∞ to ∞
    for (int i = 0; i < 200; ++i) {
        const double s = 0.5 * (low + high);
        (wire::sideways_balance(c, s) > (now > 0.0 ? bound : -bound) ? high : low) = s;
    }
    const double most = 0.25 * std::min(c.across[0], c.across[1]);
    // Within a billionth of the distance, which keeps it inside the bound; smaller moves are not
    // made.
    const double wanted = std::clamp(low, -most, most);
    if (std::abs(wanted) < 1e-7) return;
    EXPECT_NEAR(way, wanted, 1e-7 + 2e-9 * (5.0 + std::abs(wanted)));
    if (inside && std::abs(way) < most) {
        EXPECT_LE(std::abs(wire::sideways_balance(c, way)), bound + 1e-12) << "to rounding";
    }
}

/// The solver ends within 1e-13 of both parts, which may exceed the bound by more than rounding;
/// cases of the fixed seed do not.
TEST(Sideways, GoToTheBoundOfFriction) {
    test::Random fixed(7), fresh(test::first_seed(8));
    for (int k = 0; k < 2000; ++k) expect_at_bound(fixed, true);
    const int cases = test::by_tier(0, 8000, 80'000);
    for (int k = 0; k < cases; ++k) expect_at_bound(fresh, false);
}

TEST(Sideways, KeepTheRatioOfTensions) {
    const auto strain = [](double path, double rest) { return (path - rest) / rest; };
    wire::Parts p{{5.0, 3.0}, {0.01, 0.003}, {0.2, -0.203}};
    const double fed = wire::length_to_feed(p);
    const double path[2] = {5.01 + 0.2, 3.003 - 0.203};
    EXPECT_NEAR(strain(path[0], 5.0 + fed) / strain(path[1], 3.0 - fed), 2.0, 1e-9);
    EXPECT_LT(strain(path[0], 5.0 + fed), 2e-3);
    // If they become too short to be taut, both are slack by equal fractions.
    p.changes[1] = -0.3;
    const double slack = wire::length_to_feed(p);
    EXPECT_NEAR(strain(5.21, 5.0 + slack), strain(2.703, 3.0 - slack), 1e-12);
    EXPECT_LT(strain(5.21, 5.0 + slack), 0.0);
}

}  // namespace
}  // namespace hawser
