// SPDX-License-Identifier: Apache-2.0
/// Power bus of vessels: grants by priority, shedding, failures.
#include <hawser/hawser.h>
#include <hawser/vessel.h>

#include <gtest/gtest.h>

#include "vessel/held_ship.h"

#include <cmath>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kMega = 1e6;

/// A held ship with thrusters on two switchboards.
struct Bus : HeldShip {
    void thrusters() {
        for (const char* name : {"az", "bow1", "bow2"}) azimuth(name);
        def.power.boards = {{"a", {{"a1", kMega}, {"a2", kMega}}}, {"b", {{"b1", kMega}}}};
        def.power.consumers = {
            {.name = "bow1", .board = "a", .priority = 3, .power = 0.5 * kMega, .efficiency = 0.5},
            {.name = "bow2", .board = "a", .priority = 3, .power = 0.5 * kMega, .efficiency = 0.5},
            {.name = "az", .board = "a", .priority = 2, .power = kMega, .efficiency = 0.9},
            {.name = "hotel", .board = "a", .priority = 1, .power = 0.2 * kMega}};
    }
    void add() { world.add(def); }
};

// Closed form: 0.9 of 2 MW, less 0.2 MW and 1/0.9 MW, halved for two thrusters of 1 MW demand.
TEST(PowerBus, GrantsByPriorityAndSharesWithinOne) {
    Bus b;
    b.thrusters();
    b.add();
    for (const char* name : {"az", "bow1", "bow2"}) b.set(name, 1.0);
    b.run(1.0);
    const double left = 0.9 * 2.0 - 0.2 - 1.0 / 0.9;
    const double order = std::cbrt(0.5 * left);
    EXPECT_NEAR(b.get("az_thrust"), 1e5, 1e-6);
    EXPECT_NEAR(b.get("bow1_thrust"), 1e5 * order * order, 1e-3);
    EXPECT_NEAR(b.get("bow2_thrust"), 1e5 * order * order, 1e-3);
    EXPECT_NEAR(b.get("bow1_shed"), (1.0 - 0.5 * left) * kMega, 1.0);
    EXPECT_NEAR(b.get("a_load"), 1.8 * kMega, 1.0);
    EXPECT_NEAR(b.get("a_spare"), 0.0, 1.0);
    EXPECT_EQ(b.count(EventKind::shed), 2);  // once each, for any duration
    EXPECT_NEAR(b.world.events().extremes(EventKind::shed).worst.value, b.get("bow1_shed"), 1.0);

    b.set("a2_failed", 1.0);  // 0.9 MW: hotel, then 0.7 MW for the azimuth
    b.run(1.0);
    const double azimuth = std::cbrt(0.7 * 0.9);
    EXPECT_NEAR(b.get("az_thrust"), 1e5 * azimuth * azimuth, 1e-3);
    EXPECT_EQ(b.get("bow1_thrust"), 0.0);
    EXPECT_EQ(b.count(EventKind::failure), 1);

    b.set("tie", 1.0);  // the generator of board b joins
    b.run(1.0);
    EXPECT_NEAR(b.get("az_thrust"), 1e5, 1e-6);
    EXPECT_NEAR(b.get("bow1_thrust"), 1e5 * order * order, 1e-3);

    b.set("a_failed", 1.0);
    b.run(1.0);
    for (const char* name : {"az_thrust", "bow1_thrust", "bow2_thrust"})
        EXPECT_EQ(b.get(name), 0.0) << name;
    EXPECT_NEAR(b.get("hotel_shed"), 0.2 * kMega, 1e-6);
    EXPECT_EQ(b.count(EventKind::failure), 2);
    b.set("a_failed", 0.0);
    b.set("a2_failed", 0.0);
    b.run(1.0);
    EXPECT_NEAR(b.get("az_thrust"), 1e5, 1e-6);
}

// 5 MW at the shaft are 5/(0.9 · 0.9) MW of generators; the pull is that of the published series.
TEST(PowerBus, PropellerKeepsToItsGrant) {
    Bus b;
    PropulsorDef p;
    p.name = "main";
    p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = 1.2};
    p.most_rps = 3.0;
    p.shaft_inertia = 2e4;
    b.def.propulsors.push_back(p);
    b.def.power.boards = {{"a", {{"a1", 5.0 * kMega / 0.81}}}};
    b.def.power.consumers = {{.name = "main", .board = "a"}};
    b.add();
    b.set("main", 1.0);
    b.run(60.0);
    EXPECT_NEAR(b.get("main_thrust") * 1e-3, 919.2, 0.005 * 919.2);
    EXPECT_NEAR(b.get("main_rps"), 2.2470, 0.005 * 2.2470);
    EXPECT_EQ(b.count(EventKind::saturation), 0);
    EXPECT_GE(b.count(EventKind::shed), 1);
    // It turns back without power of the bus.
    b.set("a1_failed", 1.0);
    b.run(60.0);
    EXPECT_LT(std::abs(b.get("main_thrust")), 1e3);
}

TEST(PowerBus, WithEnoughPowerNothingChanges) {
    std::uint64_t hashes[2];
    for (const bool with : {false, true}) {
        Bus b;
        PropulsorDef p;
        p.name = "main";
        p.propeller = {.series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = 1.2};
        p.most_rps = 2.0;
        p.shaft_inertia = 2e4;
        b.def.propulsors.push_back(p);
        b.azimuth("az");
        if (with) {
            b.def.power.boards = {{"a", {{"a1", 50.0 * kMega}}}};
            b.def.power.consumers = {{.name = "main", .board = "a"},
                                     {.name = "az", .board = "a", .power = kMega}};
        }
        b.add();
        b.set("main", 1.0);
        b.set("az", -0.7);
        b.run(20.0);
        hashes[with ? 1 : 0] = b.world.state().motion_hash();
        if (with) {
            EXPECT_EQ(b.count(EventKind::shed), 0);
        }
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(PowerBus, StateIsSavedAndRestored) {
    Bus first, second;
    for (Bus* b : {&first, &second}) {
        b->thrusters();
        b->add();
    }
    for (const char* name : {"az", "bow1"}) first.set(name, 1.0);
    first.set("a1_failed", 1.0);
    first.set("hotel", 0.4 * kMega);
    first.run(0.5);
    second.world.state().restore(first.world.state().save());
    EXPECT_EQ(second.world.state().hash(), first.world.state().hash());
    EXPECT_EQ(second.get("hotel"), 0.4 * kMega);
    for (Bus* b : {&first, &second}) {
        b->set("bow2", 1.0);
        b->run(1.0);
    }
    EXPECT_EQ(second.world.state().hash(), first.world.state().hash());
}

/// Return the message of a rejected definition.
std::string refusal(Bus& b) {
    try {
        b.add();
    } catch (const DefError& error) {
        return error.what();
    }
    return "";
}

TEST(PowerBus, RefusesBadDefinitions) {
    const auto with = [](auto&& change) {
        Bus b;
        b.thrusters();
        change(b.def.power);
        return refusal(b);
    };
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(with([](PowerDef& p) { p.consumers[0].board = "c"; }), "power/consumers/0/board");
    has(with([](PowerDef& p) { p.consumers[0].board = "c"; }), "a, b");
    has(with([](PowerDef& p) { p.consumers[0].power = 0.0; }), "power/consumers/0/power");
    has(with([](PowerDef& p) { p.consumers[1].name = "bow1"; }), "power/consumers/1/name");
    has(with([](PowerDef& p) { p.consumers[3].name = "a1"; }), "taken");
    has(with([](PowerDef& p) { p.boards[0].generators.clear(); }), "power/boards/0/generators");
    has(with([](PowerDef& p) { p.boards[0].generators[0].power = -1.0; }),
        "power/boards/0/generators/0/power");
    has(with([](PowerDef& p) { p.share = 0.0; }), "power/share");
    has(with([](PowerDef& p) { p.consumers[2].efficiency = 1.2; }), "efficiency");
    has(with([](PowerDef& p) { p.boards.clear(); }), "power/boards");
}

}  // namespace
}  // namespace hawser::test
