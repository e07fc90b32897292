// SPDX-License-Identifier: Apache-2.0
// Kinematics in single precision (marine/fast_waves.h) against dense sums by the standard library.
#include <hawser/sea.h>

#include "base/isa.h"
#include "marine/fast_waves.h"
#include "marine/field.h"
#include "marine/spectra.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace hawser::test {
namespace {

struct Motion {
    double elevation = 0.0, pressure = 0.0;  ///< Pressure: of waves [Pa].
    Vec3 velocity{0.0, 0.0, 0.0}, acceleration{0.0, 0.0, 0.0};
};

/// Sum all components at every depth, in double precision.
Motion dense(const Sea& sea, const SeaMoment& now, const marine::FieldPoint& at) {
    Motion out;
    out.elevation = now.level;
    std::vector<double> theta;
    for (std::size_t i = 0; i < sea.components().size(); ++i) {
        const WaveComponent& w = sea.components()[i];
        theta.push_back(w.wave_number *
                            (std::cos(w.direction) * at.x + std::sin(w.direction) * at.y) +
                        marine::kTwoPi * now.phase[i]);
        out.elevation += now.waves * w.amplitude * std::cos(theta[i]);
    }
    const double d = sea.depth(), z = std::clamp(at.z, -d, out.elevation);
    const double still = d * (z + d) / (d + out.elevation) - d;
    for (std::size_t i = 0; i < sea.components().size(); ++i) {
        const WaveComponent& w = sea.components()[i];
        const double k = w.wave_number, o = w.frequency;
        const double part = now.waves * w.amplitude * o / -std::expm1(-2.0 * k * d);
        const double up = std::exp(k * still), down = std::exp(-k * (still + 2.0 * d));
        const double c = part * (up + down), s = part * (up - down);
        const Vec3 along(std::cos(w.direction), std::sin(w.direction), 0.0);
        out.velocity += c * std::cos(theta[i]) * along + Vec3(0, 0, s * std::sin(theta[i]));
        out.acceleration +=
            o * (c * std::sin(theta[i]) * along - Vec3(0, 0, s * std::cos(theta[i])));
        out.pressure += sea.density() * o / k * c * std::cos(theta[i]);
    }
    return out;
}

/// Make a random sea: depth from 8 to 3,000 m, one or two spectra, with and without spreading.
SeaDef random_sea(std::mt19937& dice) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    SeaDef def{.depth = 8.0 * std::pow(375.0, unit(dice))};
    const int spectra = unit(dice) < 0.3 ? 2 : 1;
    for (int i = 0; i < spectra; ++i) {
        WaveDef wave{.kind = unit(dice) < 0.5 ? WaveKind::jonswap : WaveKind::pierson_moskowitz};
        wave.height = 0.3 + 0.1 * def.depth * unit(dice) / spectra;
        wave.height = std::min(wave.height, 12.0);
        wave.period = 3.0 + 15.0 * unit(dice);
        wave.direction = 6.0 * unit(dice);
        wave.spreading = unit(dice) < 0.3 ? 0.0 : 1.0 + 30.0 * unit(dice);
        wave.components = 20 + static_cast<int>(180.0 * unit(dice));
        wave.seed = dice();
        wave.highest = 2.0 + 3.0 * unit(dice);
        def.waves.push_back(wave);
    }
    if (unit(dice) < 0.5) def.level = {{0.0, 0.1 * def.depth * (unit(dice) - 0.5)}};
    return def;
}

/// Make points within `wide` of each other horizontally, from above the surface to the bottom.
std::vector<marine::FieldPoint> random_points(std::mt19937& dice, const Sea& sea, double wide) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<marine::FieldPoint> out;
    const Vec3 middle(4000.0 * (unit(dice) - 0.5), 4000.0 * (unit(dice) - 0.5), 0.0);
    const auto count = 1 + static_cast<std::size_t>(63.0 * unit(dice));
    for (std::size_t i = 0; i < count; ++i) {
        const double deep = unit(dice) < 0.5 ? std::min(sea.depth(), 15.0) : sea.depth();
        const Vec3 at = middle + Vec3(wide * (unit(dice) - 0.5), wide * (unit(dice) - 0.5),
                                      3.0 - (deep + 3.0) * unit(dice));
        out.emplace_back(at, at.z() + 4.0 * unit(dice));
    }
    return out;
}

/// Largest errors over the significant amplitude.
struct Errors {
    double elevation = 0.0, velocity = 0.0, acceleration = 0.0, pressure = 0.0;
};

void compare(const Sea& sea, const marine::WaterField& field,
             const std::vector<marine::FieldPoint>& points, Errors& to) {
    const auto count = static_cast<int>(points.size());
    std::vector<WaterPoint> got(points.size());
    std::vector<double> surface(points.size()), rise(points.size());
    field.water(points.data(), count, got.data());
    field.press(points.data(), count, true, surface.data(), rise.data());
    const marine::SignificantMotion& size = field.fast().significant();
    const double factor = std::max(field.now().waves, 1e-300);
    const auto note = [&](double& most, double error) { most = std::max(most, error / factor); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Motion want = dense(sea, field.now(), points[i]);
        // Elevations of water() are exact at heights that a wave trough can uncover.
        const double lowest = field.now().level - factor * field.fast().highest();
        if (!(points[i].top < lowest))
            note(to.elevation, std::abs(got[i].elevation - want.elevation) / size.elevation);
        EXPECT_LE(std::abs(got[i].elevation - field.now().level), factor * field.fast().highest());
        note(to.elevation, std::abs(surface[i] - want.elevation) / size.elevation);
        note(to.velocity, (got[i].velocity - want.velocity).norm() / size.velocity);
        note(to.acceleration, (got[i].acceleration - want.acceleration).norm() / size.acceleration);
        if (points[i].z < want.elevation - 1e-3)
            note(to.pressure, std::abs(rise[i] - want.pressure) / sea.density() / size.pressure);
    }
}

TEST(FastWaves, KinematicsAreWithinTheirTolerance) {
    std::mt19937 dice(first_seed(7));
    const int rounds = by_tier(60, 600, 6000);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Errors worst;
    int fast = 0;
    for (int round = 0; round < rounds; ++round) {
        const SeaDef def = random_sea(dice);
        const Sea sea(def);
        marine::WaterField field(sea, def.current);
        SeaInputs inputs = sea.inputs();
        inputs.waves = unit(dice) < 0.3 ? 1.5 * unit(dice) : 1.0;
        const SeaMoment now = sea.at(2e4 * unit(dice), inputs);
        field.begin(now);
        fast += field.fast().on() ? 1 : 0;
        for (const double wide : {0.0, 10.0, 80.0, 2000.0})
            compare(sea, field, random_points(dice, sea, wide), worst);
    }
    EXPECT_GT(fast, rounds / 2) << "seas of single precision";
    std::printf(
        "%s: elevation %.2e, velocity %.2e, acceleration %.2e, pressure %.2e of significant\n",
        base::to_string(base::isa()), worst.elevation, worst.velocity, worst.acceleration,
        worst.pressure);
    // Bound derived in docs/theory/waves.md.
    const double most = marine::kKinematicTolerance;
    EXPECT_LT(worst.elevation, most);
    EXPECT_LT(worst.velocity, most);
    EXPECT_LT(worst.acceleration, most);
    EXPECT_LT(worst.pressure, most);
    EXPECT_GT(worst.velocity, 1e-10) << "single precision was compared";
}

/// Polynomials of the decay have degrees from 2 to 7 by the width of a group in k times the depth.
/// Depths of each order of size, and groups of few and of many components, use them all.
TEST(FastWaves, DecayIsWithinItsToleranceAtEveryDepth) {
    std::mt19937 dice(first_seed(23));
    Errors worst;
    for (const int components : {17, 40, 200, 400}) {
        SeaDef def{.depth = 400.0};
        def.waves.push_back({.kind = WaveKind::jonswap,
                             .height = 5.0,
                             .period = 11.0,
                             .spreading = 6.0,
                             .components = components,
                             .highest = 5.0});
        const Sea sea(def);
        marine::WaterField field(sea, def.current);
        const SeaMoment now = sea.at(321.0);
        field.begin(now);
        ASSERT_TRUE(field.fast().on());
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        std::vector<marine::FieldPoint> points;
        for (int i = 0; i < marine::WaterField::kMostPoints; ++i) {
            const double depth = 0.01 * std::pow(4e4, i / (marine::WaterField::kMostPoints - 1.0));
            const Vec3 at(5.0 * unit(dice), 5.0 * unit(dice), -depth);
            points.emplace_back(at, at.z());
        }
        compare(sea, field, points, worst);
    }
    for (const double error :
         {worst.elevation, worst.velocity, worst.acceleration, worst.pressure}) {
        EXPECT_LT(error, marine::kKinematicTolerance);
        EXPECT_GT(error, 0.0);
    }
}

/// With few components the bits equal those of Sea::water().
TEST(FastWaves, FewComponentsStayInDoublePrecision) {
    SeaDef def{.depth = 40.0};
    def.waves.push_back({.kind = WaveKind::jonswap,
                         .height = 2.0,
                         .period = 7.0,
                         .spreading = 4.0,
                         .components = marine::FastWaves::kFewComponents});
    const Sea sea(def);
    marine::WaterField field(sea, def.current);
    const SeaMoment now = sea.at(12.5);
    field.begin(now);
    EXPECT_FALSE(field.fast().on());
    const Vec3 at(13.0, -7.0, -2.5);
    const marine::FieldPoint point(at, at.z());
    WaterPoint got;
    field.water(&point, 1, &got);
    const WaterPoint want = sea.water(now, at);
    EXPECT_EQ(got.elevation, want.elevation);
    EXPECT_EQ(got.velocity, want.velocity);
    EXPECT_EQ(got.acceleration, want.acceleration);
}

/// Groups are left out at depth; none is left out at the surface.
TEST(FastWaves, DeepPointsTakeFewGroups) {
    SeaDef def{.depth = 150.0};
    def.waves.push_back(
        {.kind = WaveKind::jonswap, .height = 2.5, .period = 9.0, .spreading = 10.0});
    const Sea sea(def);
    const marine::FastWaves fast(sea.components(), def.depth);
    ASSERT_TRUE(fast.on());
    EXPECT_EQ(fast.extent(0.0).groups, fast.groups());
    EXPECT_LT(fast.extent(100.0).groups, fast.groups() / 2);
    EXPECT_LE(fast.extent(149.9).groups, fast.extent(100.0).groups);
    // Kinematics use phases of the groups that the elevation includes.
    for (double depth = 0.0; depth < 160.0; depth += 0.37)
        EXPECT_GE(fast.extent(depth).stretching, fast.extent(depth).groups) << depth;
    // Sums of long waves only have smaller rounding errors: their clusters are wider.
    for (int g = 1; g <= fast.groups(); ++g) EXPECT_LE(fast.reach(g), fast.reach(g - 1)) << g;
    EXPECT_GT(fast.reach(), 5.0) << "a cluster is wider than a node's element";
    std::printf("reach %.3g m; groups at 0, 10, 50, 150 m: %d %d %d %d of %d\n", fast.reach(),
                fast.extent(0.0).groups, fast.extent(10.0).groups, fast.extent(50.0).groups,
                fast.extent(150.0).groups, fast.groups());
}

/// Another cluster around a point changes its value by at most twice the tolerance.
TEST(FastWaves, NeighboursHardlyMatter) {
    std::mt19937 dice(first_seed(11));
    for (int round = 0; round < 20; ++round) {
        const SeaDef def = random_sea(dice);
        const Sea sea(def);
        marine::WaterField field(sea, def.current);
        const SeaMoment now = sea.at(100.0 * round);
        field.begin(now);
        std::vector<marine::FieldPoint> points = random_points(dice, sea, 20.0);
        std::vector<WaterPoint> all(points.size());
        field.water(points.data(), static_cast<int>(points.size()), all.data());
        const marine::SignificantMotion& size = field.fast().significant();
        for (std::size_t i = 0; i < points.size() && field.fast().on(); ++i) {
            WaterPoint alone;
            field.water(&points[i], 1, &alone);
            EXPECT_LE((alone.velocity - all[i].velocity).norm(),
                      2.0 * marine::kKinematicTolerance * size.velocity);
        }
    }
}

}  // namespace
}  // namespace hawser::test
