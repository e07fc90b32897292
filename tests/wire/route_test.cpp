// SPDX-License-Identifier: Apache-2.0
/// Lines over bollards and sheaves: Euler's ratio for any number of places, bits, rejected
/// definitions.
#include "support/post.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace hawser {
namespace {

using test::Post;

class Posts : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Slots, Posts, testing::Values(1, 2, 8, 64));

TEST_P(Posts, SlideAtEulersRatio) {
    for (const double turns : {0.5, 1.5, 3.0}) {
        Post p(GetParam(), turns, 1.1);
        for (int i = 0; i < 240; ++i) {
            ASSERT_EQ(p.w.step(), Status::ok);
            EXPECT_LE(p.w.stats().factorisations, 8) << turns << " step " << i;
            EXPECT_EQ(p.w.stats().flips_left, 0) << turns << " step " << i;
        }
        // Slides have a millionth of the lightest mass, and up to 64 of them are accelerated.
        EXPECT_NEAR(p.tensions() / p.ratio, 1.0, 1e-5) << turns;
        EXPECT_EQ(p.w.verdict().grade, Grade::good) << turns;
        const double before = p.w.velocity(p.second).linear.z();
        ASSERT_EQ(p.w.step(), Status::ok);
        const double a = (before - p.w.velocity(p.second).linear.z()) * 60.0;
        EXPECT_NEAR(a, 9.81 * 0.1 / 2.1, 1e-3 * a) << turns;
    }
}

TEST_P(Posts, HoldBelowItWithoutCreeping) {
    Post p(GetParam(), 1.5, 0.99);
    for (int i = 0; i < 1200; ++i) ASSERT_EQ(p.w.step(), Status::ok);
    const double start = p.slid();
    for (int i = 0; i < 1200; ++i) ASSERT_EQ(p.w.step(), Status::ok);
    EXPECT_NEAR(p.slid(), start, 1e-10);
    EXPECT_LT(p.tensions(), p.ratio);
}

TEST(Routes, TensionsPointTheWayTheyHaveTo) {
    // Hauled in either direction, friction opposes the motion.
    for (const double v : {0.5, -0.5}) {
        World w;
        const BodyId top = w.add_body({.kind = BodyKind::fixed});
        const BodyId load =
            w.add_body({.kind = BodyKind::lump, .position = {0, 0, -10}, .mass = 1000.0});
        const BodyId hand =
            w.add_body({.kind = BodyKind::kinematic, .position = {5, 0, 0}, .velocity = {v, 0, 0}});
        const Route r = w.add(RouteDef{.EA = 1e8,
                                       .first = {.body = load},
                                       .places = {{.body = top, .efficiency = 0.9}},
                                       .last = {.body = hand},
                                       .tension = 9810.0,
                                       .damping_time = 0.1});
        for (int i = 0; i < 300; ++i) ASSERT_EQ(w.step(), Status::ok);
        const double weight = -w.force(r.parts[0])[0], pull = -w.force(r.parts[1])[0];
        EXPECT_NEAR(pull / weight, v > 0.0 ? 1.0 / 0.9 : 0.9, 1e-5);
        EXPECT_NEAR(w.pose(load).position.z(), -10.0 + v * 5.0, 0.02);
    }
}

TEST(Routes, AWheelIsAWheelWhereverItTurns) {
    // A weight swings on a line that rolls on and off a cylinder: its energy is conserved.
    World w(WorldDef{.step = 1.0 / 960.0});
    const BodyId post = w.add_body({.kind = BodyKind::fixed});
    const BodyId bob = w.add_body({.kind = BodyKind::lump,
                                   .position = {0.5, 0, -4.0},
                                   .velocity = {3.0, 0, 0},
                                   .mass = 10.0});
    const BodyId made_fast = w.add_body({.kind = BodyKind::fixed, .position = {-0.5, 0, -4.0}});
    const Route r = w.add(RouteDef{.EA = 1e7,
                                   .first = {.body = made_fast},
                                   .places = {{.body = post, .radius = 0.5, .friction = 0.5}},
                                   .last = {.body = bob},
                                   .tension = 98.1});
    EXPECT_NEAR(r.angles.front(), std::numbers::pi, 1e-9);
    const double start = 0.5 * 10.0 * 9.0;
    double widest = 0.0;
    for (int i = 0; i < 4 * 960; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const Vec3 x = w.pose(bob).position;
        widest = std::max(widest, std::abs(x.x() - 0.5));
        // Straight length and arc: l + R φ = l₀ without sliding. φ is the angle at which the line
        // leaves.
        const double d = std::hypot(x.x(), x.z());
        const double straight = std::sqrt(d * d - 0.25);
        const double at = std::atan2(-x.z(), x.x()) - std::atan2(straight, 0.5);
        EXPECT_NEAR(straight + 0.5 * at, 4.0, 2e-3) << i;
        const double energy =
            0.5 * 10.0 * w.velocity(bob).linear.squaredNorm() + 98.1 * (x.z() + 4.0);
        EXPECT_NEAR(energy, start, 0.02 * start) << i;
    }
    EXPECT_GT(widest, 1.5);
}

/// A block of 2 t under a wheel, both of radius R, on two falls of length L.
struct TwoFalls {
    static constexpr double kRadius = 0.4, kFalls = 10.0, kInertia = 300.0;
    World w;
    BodyId block{};
    explicit TwoFalls(double yaw) : w(WorldDef{.step = 1.0 / 240.0}) {
        const BodyId boom = w.add_body({.kind = BodyKind::fixed}),
                     mast = w.add_body({.kind = BodyKind::fixed});
        block = w.add_body({.position = {0, 0, -kFalls},
                            .orientation = Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())),
                            .mass = 2000.0,
                            .inertia = kInertia * Mat3::Identity()});
        w.add(
            RouteDef{.EA = 1e8,
                     .first = {.body = boom, .point = {-kRadius, 0, 0}},
                     .places = {{.body = block, .radius = -kRadius},
                                {.body = boom, .point = {2.0 * kRadius, 0, 0}, .radius = kRadius}},
                     .last = {.body = mast, .point = {3.0 * kRadius, 0, -5.0}},
                     .tension = 2000.0 * 9.81 / 2.0,
                     .damping_time = 0.1});
    }
    [[nodiscard]] double yaw() const {
        const Quat q = w.pose(block).orientation;
        return 2.0 * std::atan2(q.z(), q.w());
    }
};

TEST(Routes, TwoFallsOverWheelsHoldABlockInItsPlane) {
    // Each fall at R from the axis leans by R θ/L, so that both rotate the block back by W R² θ/L.
    // This includes the fall between two wheels, whose axes are then not parallel.
    constexpr double kYaw = 0.05;
    TwoFalls t(kYaw);
    const double rate = 2000.0 * 9.81 * TwoFalls::kRadius * TwoFalls::kRadius /
                        (TwoFalls::kFalls * TwoFalls::kInertia);
    const double period = 2.0 * std::numbers::pi / std::sqrt(rate);
    double before = kYaw, first = 0.0;
    for (int i = 1; first == 0.0 && i < 4 * 240; ++i) {
        ASSERT_EQ(t.w.step(), Status::ok);
        const double now = t.yaw();
        if (now <= 0.0) first = (i - now / (now - before)) / 240.0;
        before = now;
    }
    // A quarter of a period. The block rises by R² θ²/L as it rotates, and tilts: errors of 1e-3.
    EXPECT_NEAR(first, 0.25 * period, 0.01 * period);
}

std::string hash_of(Post& p, int steps) {
    for (int i = 0; i < steps; ++i)
        if (p.w.step() != Status::ok) return "";
    return std::to_string(p.w.state().hash());
}

TEST(Routes, BitsDoNotDependOnThreadsOrRestoring) {
    std::vector<std::string> hashes;
    for (const int threads : {1, 2, 4}) {
        WorldDef def;
        def.threads = threads;
        Post p(8, 1.5, 1.1, def);
        hashes.push_back(hash_of(p, 200));
    }
    for (const int at : {1, 37, 120}) {
        Post p(8, 1.5, 1.1);
        (void)hash_of(p, at);
        const std::vector<std::byte> saved = p.w.state().save();
        (void)hash_of(p, 50);
        p.w.state().restore(saved);
        hashes.push_back(hash_of(p, 200 - at));
    }
    for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(Routes, ThatAreWrongAreRefusedAndLeaveNothing) {
    World w;
    const BodyId a = w.add_body({.kind = BodyKind::fixed, .position = {-1, 0, 0}});
    const BodyId b = w.add_body({.kind = BodyKind::lump, .position = {1, 0, 0}, .mass = 1.0});
    const BodyId post = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, 1}});
    const BodyId spool = w.add_body({.kind = BodyKind::scalar, .mass = 1.0});
    const RouteDef good{.EA = 1e7,
                        .first = {.body = a},
                        .places = {{.body = post, .radius = 0.2}},
                        .last = {.body = b}};
    const auto refused = [&](auto change) {
        RouteDef def = good;
        change(def);
        const int bodies = w.body_count(), interactions = w.interaction_count();
        try {
            (void)w.add(def);
        } catch (const DefError& error) {
            EXPECT_EQ(w.bodies().size(), 4u);
            EXPECT_EQ(w.interactions().size(), 0u) << bodies << interactions;
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(refused([](RouteDef& d) { d.EA = 0.0; }).find("EA"), std::string::npos);
    EXPECT_NE(refused([](RouteDef& d) { d.places[0].efficiency = 1.1; }).find("places/0"),
              std::string::npos);
    EXPECT_NE(refused([](RouteDef& d) { d.places[0].efficiency = 0.0; }).find("efficiency"),
              std::string::npos);
    EXPECT_NE(refused([](RouteDef& d) { d.places[0].body = BodyId{99}; }).find("not there"),
              std::string::npos);
    EXPECT_NE(refused([&](RouteDef& d) { d.last.body = spool; }).find("drum"), std::string::npos);
    EXPECT_NE(refused([](RouteDef& d) { d.places[0].radius = 5.0; }).find("radii"),
              std::string::npos);
    const std::string tight = refused([](RouteDef& d) { d.length = 0.5; });
    EXPECT_NE(tight.find(" m long, but it has 0.5"), std::string::npos) << tight;
    EXPECT_NE(refused([](RouteDef& d) { d.places.clear(); }).find("places"), std::string::npos);
    EXPECT_NE(refused([](RouteDef& d) { d.places[0].inertia = -1.0; }).find("inertia"),
              std::string::npos);
    EXPECT_NE(refused([&](RouteDef& d) { d.places[0].body = b; }).find("point mass"),
              std::string::npos);
    EXPECT_EQ(w.add(good).parts.size(), 2u);
}

/// The light side is pulled up to its eye and stops there. The heavy side then hangs still with its
/// weight on the line, never lower than the line allows.
TEST(Routes, EndsStopAtTheirEye) {
    for (const std::uint32_t seed : test::seeds(3, 6, 60, 600)) {
        std::mt19937 random(seed);
        const auto draw = [&](double a, double b) {
            return std::uniform_real_distribution<double>(a, b)(random);
        };
        const double light = draw(0.5, 50.0), heavy = light * draw(1.5, 20.0);
        const double left = draw(0.5, 6.0), right = draw(0.5, 6.0), separation = draw(0.5, 4.0);
        World w;
        const BodyId top = w.add_body({.kind = BodyKind::fixed});
        const auto lump = [&](double x, double z, double mass) {
            return w.add_body({.kind = BodyKind::lump,
                               .position = {x, 0, -z},
                               .mass = mass,
                               .linear_damping = Vec3::Constant(0.2 * mass)});
        };
        const BodyId a = lump(0.0, left, light), b = lump(separation, right, heavy);
        const Route r =
            w.add(RouteDef{.name = "rope",
                           .EA = 1e6,
                           .first = {.body = a},
                           .places = {{.body = top}, {.body = top, .point = {separation, 0, 0}}},
                           .last = {.body = b},
                           .damping_time = 0.05});
        const double length = left + right;
        for (int i = 0; i < 2400; ++i) {
            ASSERT_EQ(w.step(), Status::ok) << seed << " step " << i;
            // 3 %: 1 % of the part is left, and the impact stretches the line.
            ASSERT_GE(w.pose(b).position.z(), -1.03 * length - 0.05) << seed << " step " << i;
        }
        EXPECT_GE(w.events().extremes(EventKind::hauled_in).count, 1) << seed;
        EXPECT_EQ(w.events().extremes(EventKind::energy_created).count, 0) << seed;
        EXPECT_LE(w.pose(a).position.norm(), 0.03 * left + 0.02) << seed;
        EXPECT_NEAR(-w.force(r.parts.back())[0], 9.81 * heavy, 0.02 * 9.81 * heavy) << seed;
        // 1e-3 m/s: rest of the oscillation after 40 s.
        EXPECT_LE(std::abs(w.velocity(b).linear.z()), 1e-3) << seed;
    }
}

/// e^{μδ} of 10⁵ to 10⁹: a bollard that can hold a load does not lift it.
TEST(Routes, MuchFrictionLiftsNothing) {
    for (const std::uint32_t seed : test::seeds(5, 6, 60, 600)) {
        std::mt19937 random(seed);
        const auto draw = [&](double a, double b) {
            return std::uniform_real_distribution<double>(a, b)(random);
        };
        const int turns = 3 + static_cast<int>(random() % 6);
        const double exponent = draw(std::log(1e5), std::log(1e9));
        const double friction = exponent / (std::numbers::pi * (2.0 * turns + 1.0));
        const double light = draw(0.05, 5.0), heavy = light * std::exp(exponent) * draw(0.5, 1.0);
        World w;
        const BodyId post = w.add_body({.kind = BodyKind::fixed});
        const auto lump = [&](double x, double mass) {
            return w.add_body({.kind = BodyKind::lump,
                               .position = {x, 0, -5.0},
                               .mass = mass,
                               .linear_damping = Vec3::Constant(0.3 * mass)});
        };
        const BodyId a = lump(-0.5, light), b = lump(0.5, heavy);
        w.add(RouteDef{
            .EA = heavy * 9.81 * draw(100.0, 400.0),
            .first = {.body = a},
            .places = {{.body = post, .radius = 0.5, .friction = friction, .turns = turns}},
            .last = {.body = b},
            .tension = 9.81 * light,
            .damping_time = 0.3});
        for (int i = 0; i < 900; ++i) ASSERT_EQ(w.step(), Status::ok) << seed;
        const double before = w.pose(b).position.z();
        for (int i = 0; i < 900; ++i) ASSERT_EQ(w.step(), Status::ok) << seed;
        // 1e-4 m in 15 s: a fault of rounding moved loads by 0.2 m.
        EXPECT_LE(w.pose(b).position.z(), before + 1e-4) << seed;
    }
}

}  // namespace
}  // namespace hawser
