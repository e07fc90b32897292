// SPDX-License-Identifier: Apache-2.0
/// Joints that rotate too fast for the end-of-step iteration are closed by position projection
/// (step/closing.h).
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kStep = 0.05, kLength = 1.0, kBob = 1000.0;

InteractionDef ball(BodyId a, BodyId b, const Vec3& on_a, const Vec3& on_b) {
    InteractionDef d{.kind = InteractionKind::Ball, .body = {a, b}};
    d.point = {on_a, on_b};
    return d;
}

/// Make three light rods in line with a heavy end, released from the horizontal, or floating in a
/// spin.
World whip(bool floats, double light = 1.0, double step = kStep) {
    World w({.step = step, .gravity = {0, 0, floats ? 0.0 : -9.81}});
    BodyId last = w.add_body({.kind = BodyKind::fixed});
    Vec3 at = Vec3::Zero();
    const Vec3 half(0.5 * kLength, 0, 0);
    for (int i = 0; i < 4; ++i) {
        const double mass = i == 3 ? kBob : light;
        BodyDef rod{.position = Vec3((i + 0.5) * kLength, 0, 0),
                    .mass = mass,
                    .inertia = mass / 12.0 * Vec3(0.01, 1.0, 1.0).asDiagonal()};
        if (floats) rod.velocity = Vec3(0, 0, 4.0).cross(rod.position);
        if (floats) rod.angular_velocity = {0, 0, 4.0};
        const BodyId body = w.add_body(rod);
        if (i > 0 || !floats) w.add_interaction(ball(last, body, at, -half));
        last = body;
        at = half;
    }
    return w;
}

/// Fast light rods and a heavy end: in every step some joint would end open by L (hω)²/2, 2 cm.
TEST(ClosedJoints, OfAHeavyWhip) {
    World w = whip(false);
    double open = 0.0, least = w.energy().mechanical(), gained = 0.0;
    bool linearised = false;
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(w.step(), Status::ok) << i;
        for (std::int32_t k = 0; k < w.interaction_count(); ++k) {
            linearised |= !w.solver().completed({k});
            for (const double g : w.violation({k})) open = std::max(open, std::fabs(g));
        }
        const double energy = w.energy().mechanical();
        least = std::min(least, energy);
        gained = std::max(gained, energy - least);
    }
    EXPECT_TRUE(linearised) << "or nothing had to be closed";
    EXPECT_LE(open, 1.01e-3);  // gap at which the projection starts
    // Fraction of the energy of the heavy end's fall.
    EXPECT_LE(gained, 0.005 * kBob * 9.81 * 4.0 * kLength);
    std::printf("open at most %.1e m, energy gained %.2g J\n", open, gained);
}

/// Rods a hundred-thousandth as heavy rotate by up to radians in a step, so that directions at its
/// start do not close the joints.
TEST(ClosedJoints, OfRodsThatTurnByRadians) {
    constexpr double kLong = 0.2;
    World w = whip(true, 0.01, kLong);
    double open = 0.0, turn = 0.0;
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(w.step(), Status::ok) << i;
        for (std::int32_t k = 0; k < w.interaction_count(); ++k)
            for (const double g : w.violation({k})) open = std::max(open, std::fabs(g));
        for (std::int32_t b = 1; b < w.body_count(); ++b)
            turn = std::max(turn, kLong * w.velocity({b}).angular.norm());
    }
    EXPECT_GE(turn, 0.7) << "or nothing is asked";
    EXPECT_LE(open, 1.01e-3);
    std::printf("open at most %.1e m, turned by %.2g rad in a step\n", open, turn);
}

/// Position projection does not move the centre of mass.
TEST(ClosedJoints, LeaveTheCentreOfMassWhereItIs) {
    World w = whip(true);
    const auto centre = [&] {
        Vec3 sum = Vec3::Zero();
        double mass = 0.0;
        for (std::int32_t b = 1; b < w.body_count(); ++b) {
            sum += w.body_def({b}).mass * w.pose({b}).position;
            mass += w.body_def({b}).mass;
        }
        return Vec3(sum / mass);
    };
    ASSERT_EQ(w.step(), Status::ok);
    const Vec3 from = centre();
    ASSERT_EQ(w.step(), Status::ok);
    const Vec3 a_step = centre() - from;
    for (int i = 1; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LE((centre() - from - 60.0 * a_step).norm(), 1e-9);
}

}  // namespace
}  // namespace hawser::test
