// SPDX-License-Identifier: Apache-2.0
/// Release and stops of winches: emergency release, empty drum, weak link, last turns, full drum.
#include "wire/winch_deck.h"

#include <utility>
#include <vector>

namespace hawser::test {
namespace {

TEST(WinchEnds, ReleasesAfterItsDelayDownToTheResidualLoad) {
    WinchDef def = big_winch();
    def.brake_static = 5e6;
    def.release_delay = 2.0;
    def.release_load = 2e4;
    Deck d(def);
    d.run(0.7, 0.1);
    d.run(0.3, 0.0);
    const double design = d.tension();
    EXPECT_GT(design, 5e5);
    const double asked = d.w.time();
    d.set(WinchMode::release);
    d.run(1.9, 0.0);
    EXPECT_EQ(d.state(), WinchState::waiting);
    EXPECT_NEAR(d.tension(), design, 0.01 * design);
    double low = 0.0;
    while (low == 0.0 && d.w.time() < asked + 5.0) {
        d.step(0.5);
        if (d.tension() < 1.5e5) low = d.w.time() - asked;
    }
    EXPECT_GT(low, 2.0);
    EXPECT_LT(low, 3.0);
    d.run(12.0, 0.5);
    double mean = 0.0;
    for (int i = 0; i < 960; ++i) {
        d.step(0.5);
        mean += d.tension() / 960.0;
    }
    EXPECT_NEAR(mean, 2e4, 0.01 * 2e4);
    EXPECT_EQ(d.count(EventKind::release), 1);
    EXPECT_EQ(d.state(), WinchState::released);
}

TEST(WinchEnds, LetsGoWhenItsDrumIsEmpty) {
    WinchDef def = big_winch();
    def.stored = 6.0;
    def.mode = WinchMode::free;
    Deck d(def);
    d.run(80.0, 0.1);
    EXPECT_EQ(d.state(), WinchState::parted);
    EXPECT_NEAR(d.get("wire_left"), 0.0, 5e-3);
    EXPECT_FALSE(d.w.intact(d.ids.line));
    EXPECT_EQ(d.count(EventKind::drum_empty), 1);
    EXPECT_EQ(d.count(EventKind::weak_link), 0);
    // The jerk of the start makes it run ahead, at most at twice the speed.
    EXPECT_GT(d.w.events().extremes(EventKind::drum_empty).first.time, 30.0);
    EXPECT_LT(d.w.events().extremes(EventKind::drum_empty).first.time, 61.0);
}

TEST(WinchEnds, WeakLinkPartsOnceBehindTheLastWrap) {
    WinchDef def = big_winch();
    def.stored = 6.0;
    def.mode = WinchMode::free;
    def.weak_link = 3e5;
    Deck d(def);
    d.run(80.0, 0.1);
    EXPECT_EQ(d.count(EventKind::drum_empty), 1);
    EXPECT_EQ(d.count(EventKind::weak_link), 1);
    EXPECT_EQ(d.count(EventKind::line_break), 1);
    EXPECT_FALSE(d.w.intact(d.ids.line));
    const double value = d.w.events().extremes(EventKind::weak_link).first.value;
    EXPECT_GT(value, 3e5);
    EXPECT_LT(value, 4e5);  // detected after the step that reached it
}

TEST(WinchEnds, MotorStopsAtDeadWrapsAndWhenTheDrumIsFull) {
    WinchDef def = big_winch();
    def.stored = 40.0;
    def.mode = WinchMode::speed;
    def.speed = 1.0;
    Deck d(def);
    d.run(40.0, 1.0 * (40.0 - 5.0 * 2.0 * M_PI * 0.638) / 40.0);
    EXPECT_NEAR(d.get("wraps"), 5.0, 0.05);
    EXPECT_EQ(d.state(), WinchState::last_wraps);
    EXPECT_EQ(d.w.system_signal("winch.layer"), 1.0);
}

TEST(WinchEnds, HaulsInNoMoreThanTheElementAtItHas) {
    for (const WinchMode mode : {WinchMode::speed, WinchMode::tension}) {
        WinchDef def = big_winch();
        def.stored = 1420.0;  // of the drum's capacity
        def.mode = mode;
        def.speed = -1.0;
        def.tension = 2e5;
        def.max_speed = 1.0;
        Deck d(def);
        // The end follows at the speed of the winch until 20 m are in, except for 40 cm.
        d.run(25.0, -1.0);
        EXPECT_EQ(d.state(), WinchState::full);
        EXPECT_GE(d.w.wires().length(d.wire), 20.0 + 0.01 * 20.0);
        EXPECT_LE(d.w.wires().length(d.wire), 20.0 + 0.03 * 20.0);
        EXPECT_LT(std::abs(d.w.velocity(d.ids.drum).linear.x()), 1e-3);
        // Only the start is suspect, at which the end reaches 1 m/s in one step.
        EXPECT_NE(d.w.verdict().grade, Grade::wrong);
        EXPECT_LT(d.w.verdict().of(Judge::energy).time, 0.1);
    }
}

/// A wire whose elements accept no node (their compliance is not that of their length): the winch
/// reports it once, and continues with its element.
TEST(WinchEnds, NoRoomForANodeIsAnEvent) {
    World w(WorldDef{.step = 0.01, .gravity = Vec3::Zero()});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId node =
        w.add_body({.name = "node", .kind = BodyKind::lump, .position = {10, 0, 0}, .mass = 500.0});
    const BodyId end =
        w.add_body({.name = "end", .kind = BodyKind::lump, .position = {20, 0, 0}, .mass = 1000.0});
    std::vector<InteractionId> elements;
    for (const auto& [from, to] : {std::pair(deck, node), std::pair(node, end)}) {
        InteractionDef d{.name = "", .kind = InteractionKind::Stretch};
        d.body = {from, to, {}};
        d.set("length", 10.0).set("EA", 1e7);
        if (from == node) d.set("mass", 250.0);
        d.compliance[0] = 1e-6;
        elements.push_back(w.add_interaction(d));
    }
    WinchDef def = big_winch();
    def.wire = w.wires().adopt("wire", elements);
    def.element = 10.0;
    def.mode = WinchMode::speed;
    def.speed = 1.0;
    w.add(def);
    w.set_force(end, {1e4, 0, 0}, Vec3::Zero());
    for (int i = 0; i < 3000; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.events().extremes(EventKind::no_node).count, 1);
    EXPECT_NEAR(w.events().extremes(EventKind::no_node).first.value, 15.0, 0.1);
    EXPECT_GT(w.system_signal("winch.at_drum"), 30.0);
}

/// The element paid out by a drum is heavier than the next one, whose node gets half of it: a fault
/// rejected its release.
TEST(WinchEnds, ALongElementComesOffTheDrum) {
    World w(WorldDef{.step = 0.01});
    const BodyId deck =
        w.add_body({.name = "deck", .kind = BodyKind::fixed, .position = {0, 0, 30}});
    WinchDef def = big_winch();
    def.wire = w.wires().add({.name = "hoist",
                              .from = deck,
                              .elements = 10,
                              .length = 20.0,
                              .EA = 3e8,
                              .mass_per_length = 25.0,
                              .consistent_mass = true});
    w.add(def);
    w.set_system_signal("winch.mode", static_cast<double>(WinchMode::speed));
    w.set_system_signal("winch.speed", 0.5);
    const BodyId next = w.wires().nodes(def.wire)[1];
    while (w.system_signal("winch.at_drum") < 2.8) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_EQ(w.wires().nodes(def.wire)[1], next);  // Before the next node is inserted, at 3 m.
    const double before = w.body_def(next).mass;
    const double half = 0.5 * 25.0 * w.system_signal("winch.at_drum");
    EXPECT_LT(before, half);
    w.wires().detach(def.wire, 0);
    // The signal is from the start of the last step, 5 mm of wire ago.
    EXPECT_NEAR(w.body_def(w.wires().nodes(def.wire).front()).mass, half, 0.1);
    EXPECT_NEAR(w.body_def(next).mass - before, half, 0.1);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(w.step(), Status::ok);
    // Only the start is suspect, at which the drum reaches its speed in one step.
    EXPECT_NE(w.verdict().grade, Grade::wrong);
    EXPECT_LT(w.verdict().of(Judge::energy).time, 0.1);
}

}  // namespace
}  // namespace hawser::test
