// SPDX-License-Identifier: Apache-2.0
/// Which shapes the broad phase holds against all others.
#include "collide/broad.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

using collide::Placed;

/// A shape of the given size [m] along x; below 0: one that was removed, and is nowhere.
Placed placed(double x, double size) {
    Placed p{};
    for (int k = 0; k < 3; ++k) {
        const double centre = k == 0 ? x : 0.0, half = 0.5 * (k == 0 ? size : 0.1);
        p.centre[k] = centre;
        p.box.low[k] = p.swept.low[k] = centre - half;
        p.box.high[k] = p.swept.high[k] = centre + half;
    }
    if (size >= 0.0) return p;
    p = {};
    for (int k = 0; k < 3; ++k) {
        p.swept.low[k] = 4e30;
        p.swept.high[k] = -4e30;
    }
    return p;
}

/// A wire that has lost most of its nodes, under a hull: the hull alone is large. Where places of
/// what is gone counted as shapes of no size, every element that is left was large.
TEST(Broad, ShapesThatAreGoneMakeNoneLarge) {
    base::Array<Placed> shapes;
    for (int i = 0; i < 60; ++i) shapes.push_back(placed(5.0 * i, i % 3 == 0 ? 5.0 : -1.0));
    shapes.push_back(placed(50.0, 80.0));
    collide::Broad broad;
    broad.prepare(shapes);
    EXPECT_EQ(broad.large(), 1U);
}

}  // namespace
}  // namespace hawser::test
