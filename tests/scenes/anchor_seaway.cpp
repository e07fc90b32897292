// SPDX-License-Identifier: Apache-2.0
// Counts and first seconds of the scene anchor_seaway.

#include <hawser/scene.h>
#include <hawser/sea.h>

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hawser {
namespace {

constexpr const char* kSeaway = "scenes/anchor_seaway.json";

TEST(AnchorSeaway, HasWhatTouchesAndASea) {
    scene::Scene scene = scene::load_file(kSeaway);
    const scene::Scene contact = scene::load_file("scenes/anchor_contact.json");
    EXPECT_EQ(scene.world.body_count(), contact.world.body_count());
    EXPECT_EQ(scene.world.shape_count(), contact.world.shape_count());
    EXPECT_EQ(scene.cables.size(), contact.cables.size());
    const SeaDef* sea = find_sea(scene.world);
    ASSERT_NE(sea, nullptr);
    ASSERT_EQ(sea->hulls.size(), 4U) << "rig, two anchor handlers, barge";
    for (const WaterHull& hull : sea->hulls) {
        ASSERT_NE(hull.coefficients, nullptr);
        EXPECT_EQ(hull.radiation, RadiationKind::convolution);
        EXPECT_FALSE(hull.mesh.triangles.empty());
    }
    EXPECT_EQ(sea->bodies.size(), 10U) << "anchors in the water";
    int fed = 0;
    for (const scene::Cable& cable : scene.cables) fed += cable.drum_element > 0.0 ? 1 : 0;
    EXPECT_EQ(fed, 18) << "eight moorings, six lines of the vessels, four cranes";
}

/// A(ω) − A(∞) = 2/π ∫ (B(x) − B(ω))/(x² − ω²) dx (R. Kronig, 1926; H. A. Kramers, 1927), by the
/// trapezium rule over the table. Beyond it, B decreases with the square of the frequency.
TEST(AnchorSeaway, RadiationIsCausal) {
    const scene::Scene scene = scene::load_file(kSeaway);
    for (const WaterHull& hull : find_sea(scene.world)->hulls) {
        const WaveCoefficients& c = *hull.coefficients;
        const std::vector<double>& w = c.frequency;
        for (const int mode : {2, 3, 4}) {
            const auto b = [&](std::size_t i) { return c.damping[i](mode, mode); };
            double scale = 0.0;
            for (const Matrix6& a : c.added_mass) scale = std::max(scale, std::abs(a(mode, mode)));
            for (std::size_t i = 2; w[i] < 0.2 * w.back(); ++i) {
                const auto part = [&](std::size_t j) {
                    return j == i ? 0.0 : (b(j) - b(i)) / (w[j] * w[j] - w[i] * w[i]);
                };
                // At ω itself, the mean of its neighbours; from 0, the first entry's value.
                const auto value = [&](std::size_t j) {
                    return j == i ? 0.5 * (part(i - 1) + part(i + 1)) : part(j);
                };
                double sum = b(i) / (w[i] * w[i]) * 0.5 * w[0] + 0.5 * w[0] * value(0);
                for (std::size_t j = 0; j + 1 < w.size(); ++j)
                    sum += 0.5 * (value(j) + value(j + 1)) * (w[j + 1] - w[j]);
                const double end = w.back();
                sum += b(w.size() - 1) / (3.0 * end) -
                       b(i) / (2.0 * w[i]) * std::log((end + w[i]) / (end - w[i]));
                const double added = 2.0 / std::numbers::pi * sum;
                // The trapezium rule on steps of a tenth of the peak.
                EXPECT_NEAR(c.added_mass[i](mode, mode), added, 0.02 * scale)
                    << hull.body.index << " " << mode << " " << w[i];
            }
        }
    }
}

TEST(AnchorSeaway, StartsAfloatAndCertified) {
    scene::Scene scene = scene::load_file(kSeaway);
    World& world = scene.world;
    struct Hull {
        const char* name;
        double height;
    };
    std::vector<Hull> hulls{{"rig", 0}, {"ahts1/hull", 0}, {"ahts2/hull", 0}, {"barge", 0}};
    for (Hull& hull : hulls) hull.height = world.pose(world.find_body(hull.name)).position.z();
    int least = 1 << 30;
    for (int i = 0; i < (test::kSanitized ? 20 : 120); ++i) {
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        least = std::min(least, world.stats().contacts);
        EXPECT_LE(world.stats().natural_map, 1e-6) << "step " << i;
    }
    EXPECT_GE(least, 1000);
    // Waves of Hs 2.5 m raise a hull by at most 2.5 m; one out of balance falls 5 m in two seconds.
    for (const Hull& hull : hulls)
        EXPECT_NEAR(world.pose(world.find_body(hull.name)).position.z(), hull.height, 2.5)
            << hull.name;
}

}  // namespace
}  // namespace hawser
