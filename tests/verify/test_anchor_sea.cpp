// SPDX-License-Identifier: Apache-2.0
// Sizes of the frozen scene anchor_sea, and the first 20 s of the shipped scene. Tests of bench
// check for all scenes that hashes do not depend on threads or restores.
#include <hawser/scene.h>
#include <hawser/sea_accuracy.h>

#include "support/sanitizer.h"
#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr const char* kScene = "scenes/anchor_sea.json";

// Compare the frozen copy with its original counts and hash (CONTRIBUTING.md).
TEST(AnchorSea, IsFrozen) {
    scene::Scene scene = scene::load_file("bench/scenes/frozen/anchor_sea.json");
    EXPECT_EQ(scene.hash, 0xb3acf07d23fe3d65U);
    EXPECT_EQ(scene.world.body_count(), 1002);
    ASSERT_EQ(scene.world.step(), Status::ok);
    const StepStats& stats = scene.world.stats();
    EXPECT_EQ(stats.interactions, 1949);
    EXPECT_EQ(stats.equations, 6090);
    EXPECT_EQ(stats.islands, 1);
}

TEST(AnchorSea, SeparateCodeAgrees) {
    scene::Scene scene = scene::load_file(kScene);
    verify::Verifier verifier(scene.world);
    for (int i = 0; i < (test::kSanitized ? 3 : 12); ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(scene.world), "") << "step " << i;
    }
    std::printf("loads of the sea differ by %.2g\n", verifier.result().sea);
    EXPECT_GT(verifier.result().sea, 0.0) << "some load was compared";
    // Tolerance of kinematics in single precision (docs/theory/waves.md), of which loads contain a
    // part.
    EXPECT_LT(verifier.result().sea, 1e-5);
}

/// Clusters of points belong to the state: they are equal on any threads and after any restore.
TEST(AnchorSea, HasTheSameBitsOnAnyThreadsAndAfterRestoring) {
    const auto world_of = [](int threads) {
        scene::Options options;
        options.threads = threads;
        return scene::load_file(kScene, options);
    };
    constexpr int kSteps = 6;
    std::vector<std::uint64_t> hashes;
    std::vector<std::byte> saved;
    scene::Scene one = world_of(1);
    for (int i = 0; i < kSteps; ++i) {
        if (i == kSteps / 2) saved = one.world.state().save();
        ASSERT_EQ(one.world.step(), Status::ok);
        hashes.push_back(one.world.state().hash());
    }
    for (const int threads : {2, 3}) {
        scene::Scene other = world_of(threads);
        for (int i = 0; i < kSteps; ++i) {
            ASSERT_EQ(other.world.step(), Status::ok);
            EXPECT_EQ(other.world.state().hash(), hashes[static_cast<std::size_t>(i)]) << threads;
        }
        other.world.state().restore(saved);
        for (int i = kSteps / 2; i < kSteps; ++i) {
            ASSERT_EQ(other.world.step(), Status::ok);
            EXPECT_EQ(other.world.state().hash(), hashes[static_cast<std::size_t>(i)])
                << "restored, " << threads;
        }
    }
}

/// The report of a run states an error, below the tolerance.
TEST(AnchorSea, ReportsTheErrorOfItsKinematics) {
    scene::Scene scene = scene::load_file(kScene);
    EXPECT_EQ(sea_accuracy(scene.world).points, 0) << "before the first step";
    ASSERT_EQ(scene.world.step(), Status::ok);
    const SeaAccuracy sea = sea_accuracy(scene.world);
    EXPECT_GT(sea.points, 1000);
    // 2 √(m₀) of the velocity of JONSWAP with Hs 2.5 m and Tp 9 s, by the spectrum.
    double square = 0.0;
    const Sea alone(*find_sea(scene.world), scene.world.settings().gravity.norm());
    for (const WaveComponent& w : alone.components())
        square += std::pow(w.amplitude * w.frequency / std::tanh(w.wave_number * alone.depth()), 2);
    EXPECT_NEAR(sea.significant, std::sqrt(2.0 * square), 1e-12);
    EXPECT_EQ(sea.tolerance, 1e-5);
    EXPECT_GT(sea.error, 0.0);
    EXPECT_LT(sea.error, sea.tolerance);
}

/// Mean and standard deviation of samples from 5 s to 20 s.
struct Series {
    const char* what;
    std::function<double()> now;
    double mean, deviation;  ///< Values when this test was written.
    std::vector<double> values{};

    [[nodiscard]] double mean_of() const {
        double sum = 0.0;
        for (const double v : values) sum += v;
        return sum / static_cast<double>(values.size());
    }
    [[nodiscard]] double deviation_of() const {
        double sum = 0.0;
        const double middle = mean_of();
        for (const double v : values) sum += (v - middle) * (v - middle);
        return std::sqrt(sum / static_cast<double>(values.size()));
    }
};

TEST(AnchorSea, MovesAndPullsAsItDid) {
    if (test::kSanitized) GTEST_SKIP() << "1,200 steps";
    scene::Scene scene = scene::load_file(kScene);
    World& world = scene.world;
    const auto pull = [&](const std::string& name) {
        for (const scene::Cable& cable : scene.cables)
            if (cable.name == name)
                return [&world, id = cable.stretch[cable.stretch.size() / 2]] {
                    return -world.force(id)[0];
                };
        throw std::runtime_error("no cable " + name);
    };
    const auto height = [&](const char* body) {
        return [&world, id = world.find_body(body)] { return world.pose(id).position.z(); };
    };
    const auto roll = [&](const char* body) {
        return [&world, id = world.find_body(body)] {
            const Mat3 r = world.pose(id).orientation.toRotationMatrix();
            return std::atan2(r(2, 1), r(2, 2));
        };
    };
    Series all[] = {
        {"mooring1 [N]", pull("mooring1"), 936073.545312, 30817.8581941},
        {"mooring5 [N]", pull("mooring5"), 1188422.53177, 50025.1747399},
        {"tow1 [N]", pull("tow1"), 393244.622714, 81476.0226346},
        {"work2 [N]", pull("work2"), 645568.32969, 28915.1144234},
        {"rig, heave [m]", height("rig"), -0.974647235776, 0.219562660246},
        {"ahts1, heave [m]", height("ahts1/hull"), 1.08223567165, 0.511131292429},
        {"ahts1, roll [rad]", roll("ahts1/hull"), -0.00560999049527, 0.0301522459167},
        {"ahts2, roll [rad]", roll("ahts2/hull"), -0.00293159211373, 0.0164956807852},
    };
    for (int i = 0; i < 1'200; ++i) {
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        if (i >= 300)
            for (Series& s : all) s.values.push_back(s.now());
    }
    // The numbers are from waves summed in double precision. Kinematics of single precision have a
    // tolerance of 1e-5 (docs/theory/waves.md); the scene is not chaotic within 20 s.
    constexpr double kKinematics = 1e-5;
    for (const Series& s : all) {
        std::printf("        {\"%s\", %.12g, %.12g}\n", s.what, s.mean_of(), s.deviation_of());
        EXPECT_NEAR(s.mean_of(), s.mean, kKinematics * s.deviation) << s.what;
        EXPECT_NEAR(s.deviation_of(), s.deviation, kKinematics * s.deviation) << s.what;
    }
}

}  // namespace
}  // namespace hawser
