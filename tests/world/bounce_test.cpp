// SPDX-License-Identifier: Apache-2.0
/// Bounces with restitution, compared with closed forms: heights, times and energy
/// (docs/theory/impacts.md).
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kBounceGravity = 9.81, kBallRadius = 0.1;

/// Return a world with a plane, and balls at the given heights above it.
World make_balls(double step, double restitution, const std::vector<Vec3>& positions,
                 const std::vector<Vec3>& velocities, const std::vector<double>& masses,
                 bool floor) {
    World w({.step = step, .gravity = {0, 0, floor ? -kBounceGravity : 0.0}});
    const MaterialId rubber =
        w.add_material({.name = "rubber", .friction = 0.0, .restitution = restitution});
    if (floor) {
        ShapeDef plane{.kind = ShapeKind::plane, .body = w.add_body({.kind = BodyKind::fixed})};
        plane.material = rubber;
        w.add_shape(plane);
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        BodyDef b{.position = positions[i],
                  .mass = masses[i],
                  .inertia = 0.4 * masses[i] * kBallRadius * kBallRadius * Mat3::Identity()};
        b.velocity = velocities[i];
        ShapeDef s{.kind = ShapeKind::sphere, .body = w.add_body(b), .radius = kBallRadius};
        s.material = rubber;
        w.add_shape(s);
    }
    return w;
}

/// Return the height of a ball that falls from `drop` above the floor and bounces.
double bounced_height(double drop, double restitution, double time) {
    double speed = std::sqrt(2.0 * kBounceGravity * drop);
    double left = time - speed / kBounceGravity;
    if (left < 0.0) return drop - 0.5 * kBounceGravity * time * time;
    speed *= restitution;
    while (left > 2.0 * speed / kBounceGravity) {
        left -= 2.0 * speed / kBounceGravity;
        speed *= restitution;
    }
    return speed * left - 0.5 * kBounceGravity * left * left;
}

/// The scheme is exact for constant acceleration, so that bounces are exact to the compliance of
/// the impact stage (1e-6).
TEST(Bounce, HeightsAndTimesAreExact) {
    Random random(first_seed(1));
    for (int i = by_tier(20, 400, 4000); i > 0; --i) {
        const double step = 1.0 / std::pow(2.0, random.uniform(std::log2(30.0), std::log2(240.0)));
        const double drop = random.uniform(0.5, 20.0), e = random.uniform(0.3, 1.0);
        World w = make_balls(step, e, {{0, 0, drop + kBallRadius}}, {Vec3::Zero()}, {1.0}, true);
        SCOPED_TRACE(::testing::Message() << drop << " m, e " << e << ", " << step << " s");
        // Up to the bounces that are slower than the threshold, or that end in the next step.
        double speed = std::sqrt(2.0 * kBounceGravity * drop), end = speed / kBounceGravity;
        int bounces = 0;
        while (bounces < 20 && e * speed > 6.0 * kBounceGravity * step) {
            speed *= e;
            end += 2.0 * speed / kBounceGravity;
            ++bounces;
        }
        for (int k = 1; (k + 1) * step < end; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_NEAR(w.pose(BodyId{1}).position.z() - kBallRadius,
                        bounced_height(drop, e, k * step), 1e-4 * drop)
                << "step " << k;
        }
        EXPECT_GE(w.stats().impacts, bounces);
        EXPECT_EQ(w.stats().impact_retries, 0);
        EXPECT_EQ(w.verdict().grade, Grade::good);
    }
}

TEST(Bounce, RestitutionOneKeepsTheEnergy) {
    for (const double step : {1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0}) {
        World w = make_balls(step, 1.0, {{0, 0, 10.0 + kBallRadius}}, {Vec3::Zero()}, {1.0}, true);
        ASSERT_EQ(w.step(), Status::ok);
        const double start = w.energy().mechanical();
        double most = 0.0;
        for (int k = static_cast<int>(60.0 / step); k > 1; --k) {
            ASSERT_EQ(w.step(), Status::ok);
            most = std::max(most, std::abs(w.energy().mechanical() - start));
            ASSERT_LE(w.stats().natural_map, 1e-6);
        }
        // 21 bounces with an error of 1e-6 of the speed each. Before: 51 % at 1/60 s.
        EXPECT_LE(most, 1e-4 * start) << step;
        EXPECT_EQ(w.verdict().grade, Grade::good);
    }
}

/// Balls that collide in free space exchange momentum at the time of their impact.
TEST(Bounce, BallsCollideAtTheirTime) {
    Random random(first_seed(2));
    for (int i = by_tier(30, 500, 5000); i > 0; --i) {
        const double step = 1.0 / random.uniform(30.0, 240.0), e = random.uniform(0.2, 1.0);
        const std::vector<double> mass{std::pow(10.0, random.uniform(-1, 1)),
                                       std::pow(10.0, random.uniform(-1, 1))};
        const double gap = random.uniform(0.05, 1.0);
        const double u = random.uniform(0.5, 8.0), v = random.uniform(-3.0, u - 0.4);
        const Vec3 side(0.0, random.uniform(-1.0, 1.0), 0.0);
        World w = make_balls(step, e, {{0, 0, 0}, {gap + 2.0 * kBallRadius, 0, 0}},
                             {Vec3(u, 0, 0) + side, Vec3(v, 0, 0) + side}, mass, false);
        const double hits = gap / (u - v), total = mass[0] + mass[1];
        const double mean = (mass[0] * u + mass[1] * v) / total;
        const double after[2] = {mean - e * mass[1] / total * (u - v),
                                 mean + e * mass[0] / total * (u - v)};
        const int steps = static_cast<int>(hits / step) + 5;
        for (int k = 0; k < steps; ++k) ASSERT_EQ(w.step(), Status::ok);
        const double left = steps * step - hits;
        const double exact[2] = {u * hits + after[0] * left,
                                 gap + 2.0 * kBallRadius + v * hits + after[1] * left};
        for (int b = 0; b < 2; ++b) {
            EXPECT_NEAR(w.velocity(BodyId{b}).linear.x(), after[b], 1e-5 * (u - v));
            EXPECT_NEAR(w.pose(BodyId{b}).position.x(), exact[b], 1e-5 * (u - v));
            EXPECT_NEAR(w.pose(BodyId{b}).position.y(), side.y() * steps * step, 1e-9);
        }
        EXPECT_EQ(w.stats().impacts, 1);
        EXPECT_EQ(w.verdict().grade, Grade::good);
    }
}

/// A bob on a hinged arm bounces on the floor below; the arm carries the impact. Reference: the
/// same at a sixteenth of the step.
TEST(Bounce, AnArmBouncesLikeAtAFineStep) {
    const auto make = [](double step) {
        World w({.step = step});
        const MaterialId steel =
            w.add_material({.name = "steel", .friction = 0.0, .restitution = 0.8});
        const BodyId ground = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, -0.5}});
        ShapeDef plane{.kind = ShapeKind::plane, .body = ground};
        plane.material = steel;
        w.add_shape(plane);
        BodyDef arm{.position = {0.5, 0, 0}, .mass = 2.0};
        arm.inertia = Vec3(0.01, 0.17, 0.17).asDiagonal();
        const BodyId b = w.add_body(arm);
        ShapeDef tip{.kind = ShapeKind::sphere, .body = b, .radius = 0.05};
        tip.position = {0.5, 0, 0};
        tip.material = steel;
        w.add_shape(tip);
        // Bodies of a joint do not touch: the hinge has another fixed body than the plane.
        const BodyId post = w.add_body({.kind = BodyKind::fixed});
        w.add(HingeDef{.name = "hinge", .a = post, .b = b, .point = {0, 0, 0}, .axis = {0, 1, 0}});
        return w;
    };
    const auto run = [](World w, double time) {
        for (long k = std::lround(time / w.settings().step); k > 0; --k)
            EXPECT_EQ(w.step(), Status::ok);
        EXPECT_GE(w.stats().impacts, 2);
        EXPECT_EQ(w.verdict().grade, Grade::good);
        return w.pose(BodyId{1}).position.z();
    };
    const double exact = run(make(1.0 / 3840.0), 1.0);
    EXPECT_NEAR(run(make(1.0 / 60.0), 1.0), exact, 1e-2);
    EXPECT_NEAR(run(make(1.0 / 240.0), 1.0), exact, 1e-3);
}

}  // namespace
}  // namespace hawser::test
