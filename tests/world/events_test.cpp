// SPDX-License-Identifier: Apache-2.0
/// Events, inputs and kinematic bodies.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <map>

namespace hawser::test {
namespace {

std::map<EventKind, std::vector<Event>> by_kind(World& w) {
    std::map<EventKind, std::vector<Event>> out;
    for (const Event& e : w.events().take()) out[e.kind].push_back(e);
    return out;
}

TEST(Events, ALineBreaksAboveItsLoadAndStaysBroken) {
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({0, 0, -1}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, b});
    r.add(d.set("EA", 1e5).set("length", 1.0).set("breaking_load", 200.0));
    World w = r.make();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_TRUE(w.intact(InteractionId{0})) << "98 N hang on it";
    w.set_force(b, {0, 0, -300}, {0, 0, 0});
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_FALSE(w.intact(InteractionId{0}));
    const auto events = by_kind(w);
    ASSERT_EQ(events.count(EventKind::line_break), 1U);
    ASSERT_EQ(events.at(EventKind::line_break).size(), 1U);
    const Event& e = events.at(EventKind::line_break)[0];
    EXPECT_GT(e.value, 200.0);
    EXPECT_EQ(e.interaction, InteractionId{0});
    EXPECT_EQ(w.force(InteractionId{0})[0], 0.0);
    // Free fall under 398.1 N / 10 kg from then on.
    const double v0 = w.velocity(b).linear.z();
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(b).linear.z() - v0, -39.81 / 60, 1e-12);
    EXPECT_EQ(w.stats().event_count[static_cast<std::size_t>(EventKind::line_break)], 1);
}

/// Thrown up on a rope: slack on the way, taut on return. It never pushes.
TEST(Events, ARopeGoesSlackAndTaut) {
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({0, 0, -1}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, b});
    r.add(d.set("EA", 1e5).set("length", 1.0));
    World w = r.make();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_TRUE(w.events().take().empty());
    w.set_velocity(b, {.linear = {0, 0, 3.0}, .angular = {0, 0, 0}});
    double least = 0.0;
    for (int i = 0; i < 90; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_EQ(w.stats().flips_left, 0);
        least = std::min(least, -w.force(InteractionId{0})[0]);
    }
    EXPECT_GE(least, 0.0) << "a tension-only element pushed";
    const auto events = by_kind(w);
    ASSERT_EQ(events.count(EventKind::slack), 1U);
    ASSERT_EQ(events.count(EventKind::taut), 1U);
    EXPECT_LT(events.at(EventKind::slack)[0].time, events.at(EventKind::taut)[0].time);
    // Up 1 m at 3 m/s: the rope is slack for 2·3/9.81 s, or until it is pulled from the other side;
    // the first return is between both.
    EXPECT_LE(events.at(EventKind::taut)[0].time, 1.0 + 6.0 / 9.81 + 0.05);
    EXPECT_GT(events.at(EventKind::taut)[0].value, 0.0);
}

/// Made a strut: with tension_only = 0 the element pushes and no event is reported.
TEST(Events, AnElementThatMayPushReportsNothing) {
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({0, 0, 1}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, b});
    r.add(d.set("EA", 1e5).set("length", 1.0).set("tension_only", 0.0));
    World w = r.make();
    double most = 0.0;
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        most = std::max(most, w.force(InteractionId{0})[0]);
    }
    EXPECT_GT(most, 50.0) << "98.1 N rest on it";
    EXPECT_TRUE(w.events().take().empty());
}

TEST(Events, ARangeStopsAHinge) {
    Recipe r;
    const BodyId g = r.ground();
    const BodyId b = r.rigid({0.5, 0, 0}, Quat::Identity(), 2.0, {0.1, 0.2, 0.2});
    r.add(r.at(InteractionKind::Hinge, {g, b}, {0, 0, 0}));
    InteractionDef d = r.at(InteractionKind::HingeRange, {g, b}, {0, 0, 0});
    r.add(d.set("min", -0.5).set("max", 0.5));
    r.bodies[1].velocity = {0, 0.5, 0};
    r.bodies[1].angular_velocity = {0, 0, 1.0};
    World w = r.make();
    double most = 0.0;
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const Quat q = w.pose(b).orientation;
        most = std::max(most, 2 * std::atan2(q.z(), q.w()));
    }
    // One step past the end, 1/60 rad, until the row acts.
    EXPECT_GT(most, 0.49);
    EXPECT_LT(most, 0.5 + 1.5 / 60);
    const auto events = by_kind(w);
    ASSERT_GE(events.count(EventKind::range), 1U);
    EXPECT_NEAR(events.at(EventKind::range)[0].time, 0.5, 0.05);
}

TEST(Inputs, AreClampedWithAnEvent) {
    World w = pendulum().make();
    InputDef def;
    def.name = "push";
    def.body = BodyId{1};
    def.component = 2;
    def.min = -5;
    def.max = 10;
    const InputId in = w.add_input(def);
    w.set_input(in, 7.0);
    EXPECT_EQ(w.input(in), 7.0);
    EXPECT_TRUE(w.events().take().empty());
    w.set_input(in, 70.0);
    EXPECT_EQ(w.input(in), 10.0);
    w.set_input(in, -70.0);
    EXPECT_EQ(w.input(in), -5.0);
    const auto events = w.events().take();
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].kind, EventKind::input_clamped);
    EXPECT_EQ(events[0].value, 70.0);
    EXPECT_EQ(events[1].value, -70.0);
    EXPECT_THROW(w.set_input(in, std::nan("")), DefError);
    EXPECT_THROW(w.set_input(in, HUGE_VAL), DefError);
    EXPECT_EQ(w.input(in), -5.0);
    EXPECT_THROW(w.set_input(InputId{7}, 0.0), DefError);
    EXPECT_EQ(w.find_input("push"), in);
    EXPECT_FALSE(w.find_input("pull").valid());
}

/// A value that physics cannot follow is rejected with name, value, range and unit.
TEST(Inputs, RefuseWhatPhysicsCannotFollow) {
    World w = pendulum().make();
    const InputId in = w.add_input({.name = "push", .body = BodyId{1}, .component = 2});
    for (const double value : {1e308, -1e308, 1.1e30, HUGE_VAL, std::nan("")}) {
        try {
            w.set_input(in, value);
            ADD_FAILURE() << value;
        } catch (const DefError& error) {
            const std::string text = error.what();
            for (const char* part : {"push", "value = ", " N", "-1e+30", "1e+30"})
                EXPECT_NE(text.find(part), std::string::npos) << text;
        }
    }
    EXPECT_TRUE(w.events().take().empty());
    EXPECT_EQ(w.input(in), 0.0);
}

/// add_interaction() rejects a motor whose smallest force is above its largest one.
TEST(Inputs, RefuseAnEmptyRangeOfForces) {
    Recipe r;
    const BodyId a = r.add({.name = "a", .kind = BodyKind::fixed});
    const BodyId b = r.add({.name = "drum", .kind = BodyKind::scalar, .mass = 10.0});
    static_cast<void>(a);
    InteractionDef motor = between(InteractionKind::ScalarMotor, {b});
    const InteractionId id = r.add(motor.set("force_min", -5.0).set("force_max", 5.0));
    World w = r.make();
    const InputId low = w.add_input({.name = "low", .interaction = id, .param = "force_min"});
    const InputId high = w.add_input({.name = "high", .interaction = id, .param = "force_max"});
    EXPECT_THROW(w.set_input(high, -6.0), DefError);
    EXPECT_THROW(w.set_input(low, 6.0), DefError);
    EXPECT_EQ(w.interaction_def(id).get("force_max"), 5.0);
    w.set_input(low, -9.0);
    w.set_input(high, -6.0);
    EXPECT_EQ(w.interaction_def(id).get("force_max"), -6.0);
    EXPECT_EQ(w.step(), Status::ok);
}

/// An input never sets a value that add_interaction() rejects.
TEST(Inputs, KeepToTheRangeOfTheParameter) {
    World w = pendulum().make();
    InputDef def;
    def.name = "length";
    def.interaction = InteractionId{0};
    def.param = "length";
    const InputId in = w.add_input(def);
    EXPECT_THROW(w.set_input(in, -5.0), DefError) << "a rod of negative length";
    EXPECT_GT(w.input(in), 0.0);
    EXPECT_GT(w.interaction_def(InteractionId{0}).get("length"), 0.0);
    def.name = "nowhere";
    def.min = -20;
    def.max = -10;
    EXPECT_THROW(w.add_input(def), DefError);
}

TEST(Kinematic, MovesAsPrescribedWhateverPulls) {
    Recipe r;
    const BodyId cart = r.add({.name = "cart",
                               .kind = BodyKind::kinematic,
                               .velocity = {1.0, 0, 0.5},
                               .angular_velocity = {0, 0, 0.7}});
    const BodyId load = r.lump({0, 0, -2}, 1e6);
    InteractionDef d = between(InteractionKind::Stretch, {cart, load});
    r.add(d.set("EA", 1e9).set("length", 2.0));
    World w = r.make();
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LE((w.pose(cart).position - Vec3(10, 0, 5)).norm(), 1e-12);
    const Quat want(Eigen::AngleAxisd(7.0, Vec3::UnitZ()));
    EXPECT_LE(w.pose(cart).orientation.angularDistance(want), 1e-12);
    // The load is dragged along: after 10 s it has moved some metres along x.
    EXPECT_GT(w.pose(load).position.x(), 1.0);
    EXPECT_NEAR(w.velocity(cart).linear.x(), 1.0, 0.0);
}

/// A mass hangs in equilibrium on a carrier that rises at constant speed: the spring energy at the
/// half step must not contain the carrier's own motion.
TEST(Kinematic, EnergyIsTakenAtTheHalfStepOfTheCarrierToo) {
    Recipe r;
    const BodyId cart =
        r.add({.name = "cart", .kind = BodyKind::kinematic, .velocity = {0, 0, 6.0}});
    const double mass = 10.0, k = 1e4, stretch = mass * 9.81 / k;
    const BodyId load = r.lump({0, 0, -2 - stretch}, mass);
    r.bodies[1].velocity = {0, 0, 6.0};
    InteractionDef d = between(InteractionKind::Distance, {cart, load});
    d.compliance[0] = 1.0 / k;
    r.add(d.set("length", 2.0));
    World w = r.make();
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.violation(InteractionId{0})[0], stretch, 1e-10);
    EXPECT_NEAR(w.energy().elastic, 0.5 * k * stretch * stretch, 1e-8);
    (void)load;
}

TEST(Energy, IsKnownBeforeTheFirstStep) {
    Recipe r = pendulum();
    r.bodies[1].position = {0, 0, 1};
    r.bodies[1].velocity = {3, 0, 0};
    World w = r.make();
    w.prepare();
    EXPECT_NEAR(w.energy().kinetic, 4.5, 1e-14);
    EXPECT_NEAR(w.energy().gravity, 9.81, 1e-12);
}

}  // namespace
}  // namespace hawser::test
