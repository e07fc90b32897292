// SPDX-License-Identifier: Apache-2.0
/// Lines over bollards and sheaves in the verifier, which finds tangents by another method.
#include "support/post.h"

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

void verify(World& w, int steps) {
    verify::Verifier verifier(w);
    for (int i = 0; i < steps; ++i) {
        verifier.before_step(w);
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(w), "") << "step " << i;
    }
}

TEST(RoutesVerified, SlidingAndHolding) {
    for (const int places : {1, 8, 64})
        for (const double share : {0.9, 1.1}) {
            test::Post p(places, 1.5, share);
            verify(p.w, 240);
        }
}

/// Verify a block that rotates on three falls between two wheels. @param spin  [rad/s]
void verify_tackle(const Vec3& spin, const Quat& turned) {
    World w;
    const BodyId boom = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, 20}});
    const BodyId block = w.add_body({.name = "block",
                                     .position = {0.3, 0.0, 5.0},
                                     .orientation = turned,
                                     .angular_velocity = spin,
                                     .mass = 2000.0,
                                     .inertia = 300.0 * Mat3::Identity()});
    const BodyId drum = w.add_body(
        {.kind = BodyKind::scalar, .velocity = {0.5, 0, 0}, .mass = 200.0, .gravity = false});
    w.add(DrumDef{.drum = drum, .motor = AxisMotor{.speed = 0.5}});
    const RoutePlace above{
        .body = boom, .point = {0.4, 0, 0}, .radius = 0.3, .efficiency = 0.96, .inertia = 5.0};
    const RoutePlace below{
        .body = block, .point = {0, 0, 0.8}, .radius = -0.4, .efficiency = 0.96, .inertia = 5.0};
    w.add(RouteDef{.name = "hoist",
                   .EA = 5e7,
                   .first = {.body = boom, .point = {-0.4, 0, 0}},
                   .places = {below, above},
                   .last = {.body = boom, .point = {10, 0, -2}, .drum = drum, .radius = 0.5},
                   .tension = 1000.0 * 9.81});
    verify(w, 240);
}

TEST(RoutesVerified, ATackleWithSheavesOnBodiesThatTurn) {
    verify_tackle(Vec3::Zero(), Quat::Identity());
}

TEST(RoutesVerified, ATackleWhoseBlockYawsAndSwings) {
    // Axes of its wheels are not parallel from the first step on.
    verify_tackle({0.2, 0.1, 0.6}, Quat::Identity());
    verify_tackle({0.0, 0.0, -0.3}, Quat(Eigen::AngleAxisd(0.8, Vec3(0.1, 0.2, 1.0).normalized())));
}

TEST(RoutesVerified, AWeightHauledIntoItsSheave) {
    // Inside the wheel's radius there is no tangent; its replacement is a law, too.
    World w(WorldDef{.step = 1.0 / 240.0});
    const BodyId boom = w.add_body({.kind = BodyKind::fixed}),
                 mast = w.add_body({.kind = BodyKind::fixed});
    const BodyId load =
        w.add_body({.kind = BodyKind::lump, .position = {0.3, 0.05, -0.6}, .mass = 500.0});
    const BodyId drum = w.add_body(
        {.kind = BodyKind::scalar, .velocity = {-1.0, 0, 0}, .mass = 200.0, .gravity = false});
    w.add(DrumDef{.drum = drum, .motor = AxisMotor{.speed = -1.0}});
    w.add(RouteDef{.EA = 2e6,
                   .first = {.body = load},
                   .places = {{.body = boom, .radius = -0.4}},
                   .last = {.body = mast, .point = {-5, 0, -1}, .drum = drum, .radius = 0.5},
                   .tension = 500.0 * 9.81,
                   .damping_time = 0.1});
    bool drawn_in = false;
    for (int i = 0; i < 120 && !drawn_in; ++i) {
        verify(w, 4);
        const Vec3 at = w.pose(load).position;
        drawn_in = std::hypot(at.x(), at.z()) < 0.4;
    }
    EXPECT_TRUE(drawn_in);
    verify(w, 12);
}

TEST(RoutesVerified, ATackleOfWhichAFallParts) {
    // After it only friction acts: the next falls run through until they are slack, and the broken
    // one stays without tension.
    World w(WorldDef{.step = 0.2});
    const BodyId boom = w.add_body({.kind = BodyKind::kinematic,
                                    .position = {0, 0, 17},
                                    .velocity = {-0.45, -0.35, -0.25},
                                    .angular_velocity = {0.06, 0.1, 0.08}}),
                 mast = w.add_body({.kind = BodyKind::fixed});
    // Inertia of a box of half sizes 3.1, 2.8 and 3.1 m, like the scene reader's.
    const BodyId load =
        w.add_body({.name = "load",
                    .position = {0, 0, 4},
                    .velocity = {0.2, 0.4, 0.6},
                    .mass = 5e5,
                    .inertia = Vec3(2.91e6, 3.2e6, 2.91e6).asDiagonal().toDenseMatrix()});
    RouteDef def{.name = "tackle",
                 .EA = 7.5e8,
                 .first = {.body = boom, .point = {-1.3, 0, 0}},
                 .last = {.body = mast, .point = {2.3, 0, 17}},
                 .breaking_load = 2e6,
                 .damping_time = 0.18};
    for (int i = 0; i < 5; ++i) {
        const bool up = i % 2 == 1;
        def.places.push_back({.body = up ? boom : load,
                              .point = {0.26 * i - 1.05, 0, up ? 0.0 : 3.1},
                              .radius = up ? 0.25 : -0.25,
                              .friction = 0.3,
                              .efficiency = 0.9});
    }
    const Route r = w.add(def);
    verify(w, 20);
    EXPECT_TRUE(std::any_of(r.parts.begin(), r.parts.end(),
                            [&](InteractionId id) { return !w.intact(id); }));
}

}  // namespace
}  // namespace hawser
