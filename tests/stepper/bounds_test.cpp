// SPDX-License-Identifier: Apache-2.0
/// Rows with a bounded force, alone and within the iterations that find contacts.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>

namespace hawser {
namespace {

using test::between;

constexpr double kFrame = 1.0 / 60.0;

BodyDef block(const Vec3& at, const Vec3& velocity, double mass = 100.0) {
    BodyDef d;
    d.kind = BodyKind::rigid;
    d.position = at;
    d.velocity = velocity;
    d.mass = mass;
    d.inertia = 2.0 * Mat3::Identity();
    return d;
}

/// Return the rotation from z of the frame to x of the world.
Quat along_x() { return turn_between(Vec3::UnitZ(), Vec3::UnitX()); }

struct Slider {
    BodyId ground, block;
    InteractionId slide, friction;
};

/// Add a block on a horizontal slide along x. Its friction is a constant force plus a fraction of
/// the slide's force.
Slider add_slider(World& w, double y, double speed, double force, double share) {
    Slider s;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    s.ground = w.add_body(ground);
    s.block = w.add_body(block({0, y, 0}, {speed, 0, 0}));
    InteractionDef slide = between(InteractionKind::Prismatic, {s.ground, s.block});
    slide.point[0] = {0, y, 0};
    slide.frame[0] = slide.frame[1] = along_x();
    s.slide = w.add_interaction(slide);
    InteractionDef friction = slide;
    friction.kind = InteractionKind::SlideFriction;
    friction.compliance.fill(kDefault);
    friction.damping_time.fill(kDefault);
    friction.params.fill(kDefault);
    friction.set("force", force);
    if (share > 0.0) friction.load[0] = {s.slide, share};
    s.friction = w.add_interaction(friction);
    return s;
}

/// Add boxes that slide on a plane: Newton's method then solves the world.
void add_boxes(World& w) {
    const MaterialId rough = w.add_material({.name = "rough", .friction = 0.3});
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    plane.body = w.add_body(ground);
    plane.position = {0, 0, -1};
    plane.material = rough;
    w.add_shape(plane);
    for (int i = 0; i < 3; ++i) {
        ShapeDef s;
        s.kind = ShapeKind::box;
        s.half_size = {0.2, 0.2, 0.2};
        s.material = rough;
        s.body = w.add_body(block({1.0 * i, 5, -0.8}, {1.0 + i, 0, 0}));
        w.add_shape(s);
    }
}

class Bounds : public testing::TestWithParam<bool> {};

TEST_P(Bounds, FrictionOfASlideStopsAndHolds) {
    World w;
    const Slider s = add_slider(w, 0, 2.0, 100.0, 0.2);
    if (GetParam()) add_boxes(w);
    const double slows = 1.0 + 0.2 * 9.81;  // F/m + mu g
    for (int k = 0; k < 30; ++k) ASSERT_EQ(w.step(), Status::ok);
    // The bound follows its load to contact_tolerance, 1e-6.
    EXPECT_NEAR(w.velocity(s.block).linear.x(), 2.0 - slows * (w.time() - 0.5 * kFrame), 1e-6);
    EXPECT_NEAR(w.force(s.friction)[0], -slows * 100.0, 1e-3);
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.velocity(s.block).linear.norm(), 1e-12);
    // Pulled by less than the bound it stays, by more it moves.
    w.set_force(s.block, {290, 0, 0}, {0, 0, 0});
    const Vec3 at = w.pose(s.block).position;
    for (int k = 0; k < 600; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT((w.pose(s.block).position - at).norm(), 1e-9);
    EXPECT_NEAR(w.force(s.friction)[0], -290.0, 1e-6);
    w.set_force(s.block, {400, 0, 0}, {0, 0, 0});
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(s.block).linear.x(), 4.0 - slows, 1e-5);
    EXPECT_LT(w.stats().momentum_residual, 1e-9);
    EXPECT_EQ(w.stats().flips_left, 0);
}

TEST_P(Bounds, ABrakeFollowsItsInput) {
    World w;
    const Slider s = add_slider(w, 0, 0.0, 1000.0, 0.0);
    if (GetParam()) add_boxes(w);
    InputDef input;
    input.name = "brake";
    input.interaction = s.friction;
    input.param = "force";
    const InputId brake = w.add_input(input);
    w.set_force(s.block, {500, 0, 0}, {0, 0, 0});
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.velocity(s.block).linear.norm(), 1e-9);
    w.set_input(brake, 200.0);
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(s.block).linear.x(), 3.0, 1e-6);
    const Energy before = w.energy();
    w.set_input(brake, 1000.0);
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.velocity(s.block).linear.norm(), 1e-9);
    const Energy after = w.energy();
    EXPECT_GT(after.friction, before.friction) << "a brake takes energy";
    EXPECT_EQ(after.driven, before.driven);
    w.set_input(brake, 0.0);
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(s.block).linear.x(), 5.0, 1e-6);
}

/// Energy stored in a spring of friction is part of the friction loss, so that the balance closes.
TEST_P(Bounds, ASoftBrakeBalances) {
    World w;
    const Slider s = add_slider(w, 0, 2.0, 0.0, 0.0);
    InteractionDef soft = w.interaction_def(s.friction);
    soft.name = "soft";
    soft.compliance[0] = 1e-5;
    soft.set("force", 300.0);
    w.add_interaction(soft);
    if (GetParam()) add_boxes(w);
    ASSERT_EQ(w.step(), Status::ok);
    const Energy a = w.energy();
    for (int k = 0; k < 90; ++k) ASSERT_EQ(w.step(), Status::ok);
    const Energy b = w.energy();
    EXPECT_LT(w.velocity(s.block).linear.norm(), 1e-4) << "it swings on its spring";
    EXPECT_EQ(b.driven, 0.0);
    EXPECT_GT(b.friction - a.friction, 180.0);  // ½ m v² less a step
    const double left = b.mechanical() - a.mechanical() - (b.driven - a.driven) +
                        (b.friction - a.friction) + (b.contact - a.contact) + (b.damped - a.damped);
    EXPECT_NEAR(left, 0.0, 1e-6) << "of 200 J, or 1,600 with the boxes";
}

TEST_P(Bounds, SnapshotsAndThreadsKeepTheBits) {
    auto make = [&](int threads) {
        WorldDef def;
        def.threads = threads;
        World w(def);
        for (int i = 0; i < 5; ++i) add_slider(w, 10.0 + i, 1.0 + i, 50.0 * i, 0.1 * i);
        if (GetParam()) add_boxes(w);
        return w;
    };
    World a = make(1), b = make(2), c = make(4);
    for (int k = 0; k < 40; ++k) {
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(b.step(), Status::ok);
    }
    EXPECT_EQ(a.state().hash(), b.state().hash());
    c.state().restore(a.state().save());
    for (int k = 0; k < 80; ++k) {
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(c.step(), Status::ok);
        ASSERT_EQ(a.state().hash(), c.state().hash()) << k;
    }
}

/// Methods with sweeps apply the same bounds.
TEST_P(Bounds, OtherMethodsKnowThem) {
    for (const Nonsmooth method :
         {Nonsmooth::pivoting, Nonsmooth::split, Nonsmooth::convex, Nonsmooth::pgs}) {
        WorldDef def;
        def.nonsmooth = method;
        def.nonsmooth_sweeps = 200;
        World w(def);
        const Slider s = add_slider(w, 0, 2.0, 300.0, 0.0);
        if (GetParam()) add_boxes(w);
        for (int k = 0; k < 30; ++k) ASSERT_EQ(w.step(), Status::ok);
        // Sweeps leave a small residual in the rows.
        const double close = method == Nonsmooth::pgs ? 1e-3 : 1e-6;
        EXPECT_NEAR(w.velocity(s.block).linear.x(), 2.0 - 3.0 * (w.time() - 0.5 * kFrame), close);
        for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
        EXPECT_LT(w.velocity(s.block).linear.norm(), close);
    }
}

INSTANTIATE_TEST_SUITE_P(Worlds, Bounds, testing::Bool(), [](const auto& with) {
    return std::string(with.param ? "WithContacts" : "Alone");
});

TEST(BoundsOfHinges, FrictionTurnsMoreThanOnce) {
    World w;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    const BodyId g = w.add_body(ground);
    BodyDef wheel = block({0, 0, 0}, {0, 0, 0});
    wheel.angular_velocity = {0, 0, 10};
    const BodyId b = w.add_body(wheel);
    w.add_interaction(between(InteractionKind::Hinge, {g, b}));
    InteractionDef friction = between(InteractionKind::HingeFriction, {g, b});
    friction.set("torque", 2.0);
    const InteractionId f = w.add_interaction(friction);
    for (int k = 0; k < 300; ++k) ASSERT_EQ(w.step(), Status::ok);
    // 5 s at −1 rad/s²: 37.5 rad, six revolutions.
    EXPECT_NEAR(w.velocity(b).angular.z(), 10.0 - (5.0 - 0.5 * kFrame), 1e-9);
    EXPECT_NEAR(w.force(f)[0], -2.0, 1e-12);
    for (int k = 0; k < 600; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.velocity(b).angular.norm(), 1e-12);
}

TEST(BoundsOfDefinitions, LoadsAreChecked) {
    World w;
    const Slider s = add_slider(w, 0, 0, 1.0, 0.5);
    InteractionDef d = w.interaction_def(s.friction);
    d.load[1] = {InteractionId{7}, 0.1};
    EXPECT_THROW(w.add_interaction(d), DefError);
    d.load[1] = {s.slide, -0.1};
    EXPECT_THROW(w.add_interaction(d), DefError);
    InteractionDef other = w.interaction_def(s.slide);
    other.load[0] = {s.slide, 0.1};
    EXPECT_THROW(w.add_interaction(other), DefError);
    // A bound that an input sets below 0 is no error of the step.
    d.load[1] = {};
    InteractionDef motor = between(InteractionKind::SlideMotor, {s.ground, s.block});
    motor.frame[0] = motor.frame[1] = along_x();
    motor.set("speed", 1.0).set("force_max", 1e4);
    const InteractionId m = w.add_interaction(motor);
    InputDef input;
    input.name = "force_max";
    input.interaction = m;
    input.param = "force_max";
    const InputId i = w.add_input(input);
    w.set_input(i, -1e30);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(w.step(), Status::ok);
}

}  // namespace
}  // namespace hawser
