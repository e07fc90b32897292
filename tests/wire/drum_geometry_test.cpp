// SPDX-License-Identifier: Apache-2.0
/// Wire on a drum against sums over its turns.
#include "wire/drum_geometry.h"
#include "wire/band_brake.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

using wire::DrumGeometry;

/// Drum of an anchor handler: 31 turns per layer.
constexpr DrumGeometry kDrum{.core_radius = 0.6,
                             .width = 2.4,
                             .wire_diameter = 0.076,
                             .layer_pitch = 0.076,
                             .flange_radius = 1.4};

/// Lengths beyond any drum end in a numbered layer without a long loop: a state from bytes may
/// contain any length.
TEST(DrumGeometry, AnyLengthEndsInALayer) {
    const double none = std::nan(""), inf = HUGE_VAL;
    for (const double length :
         {1e308, inf, 1e12, 1e7, 0.0, -0.0, -1.0, -1e308, -inf, none, 5e-324}) {
        const DrumGeometry::Place at = kDrum.wire_end(length);
        EXPECT_GE(at.layer, 1) << length;
        EXPECT_LE(at.layer, DrumGeometry::kMaxLayers) << length;
        EXPECT_TRUE(std::isfinite(at.radius) && at.radius >= kDrum.radius(1)) << length;
        EXPECT_TRUE(std::isfinite(at.wraps) && std::isfinite(at.across)) << length;
        (void)kDrum.inertia(length, 25.0);
        (void)kDrum.leaving_radius(length);
        (void)kDrum.length(length);
    }
    DrumGeometry huge = kDrum;
    huge.width = 1e30;
    huge.flange_radius = 1e30;
    EXPECT_EQ(huge.wraps_a_layer(), DrumGeometry::kMaxLayers);
    EXPECT_EQ(huge.layers(), DrumGeometry::kMaxLayers);
}

TEST(DrumGeometry, CountsLayersAsASumWrapByWrap) {
    // One turn after another, to the end of the wire.
    const double length = 1500.0;
    double left = length, inertia = 0.0;
    int layer = 1, wraps = 0;
    for (;; ++wraps) {
        if (wraps == 31 * layer) ++layer;
        const double r = 0.638 + 0.076 * (layer - 1), turn = 2.0 * M_PI * r;
        const double here = std::min(left, turn);
        inertia += 25.0 * here * (r * r + 0.75 * 0.038 * 0.038);
        left -= here;
        if (left <= 0.0) break;
    }
    const DrumGeometry::Place at = kDrum.wire_end(length);
    EXPECT_EQ(layer, 9);
    EXPECT_EQ(at.layer, layer);
    EXPECT_EQ(kDrum.wraps_a_layer(), 31);
    EXPECT_EQ(static_cast<int>(at.wraps), wraps);
    EXPECT_NEAR(at.radius, 0.638 + 8.0 * 0.076, 1e-12);
    EXPECT_NEAR(kDrum.inertia(length, 25.0) / inertia, 1.0, 1e-12);
    EXPECT_NEAR(kDrum.length_in_layers(9), 2.0 * M_PI * 31.0 * (9.0 * 0.638 + 0.076 * 36.0), 1e-9);
    EXPECT_EQ(kDrum.layers(), 10);
}

TEST(DrumGeometry, AnglesAndLengthsAreEachOthersInverse) {
    for (double l = 0.0; l < 1800.0; l += 0.37)
        ASSERT_NEAR(kDrum.length(kDrum.angle(l)), l, 1e-9 * (1.0 + l));
    // Along the wire the angle increases by 1/r.
    for (double l = 1.0; l < 1700.0; l += 7.3) {
        const double d = 1e-6, r = kDrum.wire_end(l).radius;
        if (kDrum.wire_end(l + d).layer != kDrum.wire_end(l).layer) continue;
        ASSERT_NEAR((kDrum.angle(l + d) - kDrum.angle(l)) / d * r, 1.0, 1e-5);
    }
}

TEST(DrumGeometry, LayersEndWhereTheyAreFull) {
    for (int k = 1; k <= 10; ++k) {
        const double full = kDrum.length_in_layers(k);
        EXPECT_EQ(kDrum.wire_end(full * (1.0 - 1e-12)).layer, k);
        EXPECT_EQ(kDrum.wire_end(full * (1.0 + 1e-12)).layer, k + 1);
        // Back and forth: the first layer ends at one flange, the second at the other.
        EXPECT_NEAR(kDrum.wire_end(full * (1.0 - 1e-12)).across, k % 2 == 1 ? 1.162 : -1.162, 1e-6);
    }
    EXPECT_EQ(kDrum.wire_end(0.0).layer, 1);
    EXPECT_EQ(kDrum.wire_end(-3.0).wraps, 0.0);
    EXPECT_EQ(kDrum.inertia(0.0, 25.0), 0.0);
}

TEST(DrumGeometry, NothingFitsBelowAFlangeThatIsTooLow) {
    DrumGeometry low = kDrum;
    low.flange_radius = 0.6 + 0.0759;
    EXPECT_EQ(low.layers(), 0);
    low.flange_radius = 0.676;
    EXPECT_EQ(low.layers(), 1);
    EXPECT_GT(low.capacity(), 0.0);
}

/// Tension along a band divided into pieces, each in balance with its friction.
TEST(BandBrake, RatioIsThatOfTheTensionAlongTheBand) {
    const double mu = 0.35, angle = 4.7;
    double tension = 1.0;
    const int pieces = 100'000;
    for (int i = 0; i < pieces; ++i) tension *= 1.0 + mu * angle / pieces;
    const double pulled = tension - 1.0, slackened = 1.0 - 1.0 / tension;
    EXPECT_NEAR(wire::band_ratio(mu, angle), slackened / pulled, 1e-5);
    EXPECT_NEAR(wire::tension_behind_wraps(1e6, 0.1, 5.0), 1e6 * std::exp(-M_PI), 1e-6);
    EXPECT_EQ(wire::tension_behind_wraps(1e6, 0.1, -1.0), 1e6);
}

}  // namespace
}  // namespace hawser::test
