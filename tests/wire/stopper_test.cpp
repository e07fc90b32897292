// SPDX-License-Identifier: Apache-2.0
/// Shark jaws and chain stoppers: take, hold, release; their loads against the pulls; bits,
/// rejected definitions.
#include <hawser/hawser.h>

#include "support/bits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace hawser {
namespace {

constexpr double kDeckEA = 2.33e8, kDeckDensity = 23.0;  // N, kg/m: wire of 76 mm
constexpr double kDeckElement = 5.0;                     // m

/// A weightless wire along x over a deck at z = 0, pulled at both ends.
struct Deck {
    World w;
    BodyId ship{}, inboard{}, outboard{};
    WireId wire{};

    explicit Deck(const StopperDef& more = {}, int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .gravity = Vec3::Zero(), .threads = threads}) {
        ship = w.add_body({.name = "ship", .kind = BodyKind::fixed});
        const auto weight = [&](const char* name, double x) {
            return w.add_body({.name = name,
                               .kind = BodyKind::lump,
                               .position = {x, 0.2, 1.0},
                               .mass = 2e4,
                               .linear_damping = {1e5, 1e5, 1e5}});
        };
        inboard = weight("inboard", 40.0);
        outboard = weight("outboard", -40.0);
        wire = w.wires().add({.name = "wire",
                              .from = inboard,
                              .to = outboard,
                              .elements = 16,
                              .length = 16 * kDeckElement,
                              .EA = kDeckEA,
                              .mass_per_length = kDeckDensity,
                              .consistent_mass = true});
        StopperDef def = more;
        def.name = "jaw";
        def.body = ship;
        def.point = {1.8, 0, 1.0};
        if (def.rated_load == 0.0) def.rated_load = 7.35e6;
        w.add(def);
    }
    [[nodiscard]] double get(const char* signal) const { return w.system_signal(signal); }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return w.events().extremes(kind).count;
    }
    void pull(double in, double out) {
        w.set_force(inboard, {in, 0, 0}, Vec3::Zero());
        w.set_force(outboard, {-out, 0, 0}, Vec3::Zero());
    }
    void run(double seconds) {
        for (int i = 0; i < std::lround(60.0 * seconds); ++i) {
            ASSERT_EQ(w.step(), Status::ok) << w.time();
            ASSERT_LT(w.stats().momentum_residual, 1e-8) << w.time();
        }
    }
    /// Return the mass of nodes other than the two weights [kg].
    [[nodiscard]] double mass() const {
        double sum = 0.0;
        for (const BodyId id : w.wires().nodes(wire))
            if (id != inboard && id != outboard) sum += w.body_def(id).mass;
        return sum;
    }
};

TEST(Stoppers, AJawTakesTheNearestPlaceHoldsBothWaysAndLetsGo) {
    Deck d;
    d.pull(2e5, 2e5);
    d.run(20.0);
    const double mass = d.mass();
    d.w.set_system_signal("jaw.close", 1.0);
    d.run(0.1);
    EXPECT_EQ(d.get("jaw.state"), static_cast<double>(StopperState::holding));
    EXPECT_EQ(d.get("jaw.held"), 1.0);
    // The position next to the jaw, 38.2 m of unstretched wire from the inboard end.
    EXPECT_NEAR(d.get("jaw.at"), 38.2, 0.1);
    ASSERT_EQ(d.count(EventKind::join), 1);
    const Event taken = d.w.events().extremes(EventKind::join).first;
    EXPECT_EQ(taken.interaction, d.w.find_interaction("jaw/hold"));
    EXPECT_NEAR(taken.value, 0.2, 1e-3) << "the wire lies 0.2 m beside the point";
    EXPECT_NEAR(d.mass(), mass, 1e-9 * mass);
    // Outboard 500 kN against 200 kN, then inboard: the jaw holds the difference.
    for (const auto& [in, out] : {std::pair(2e5, 5e5), {6e5, 1e5}}) {
        d.pull(in, out);
        d.run(30.0);
        EXPECT_NEAR(d.get("jaw.load"), std::abs(out - in), 1e-3 * std::abs(out - in));
    }
    const BodyId node = d.w.interaction_def(d.w.find_interaction("jaw/hold")).body[1];
    EXPECT_LT(std::abs(d.w.velocity(node).linear.x()), 1e-9) << "no creep";
    const std::size_t nodes = d.w.wires().nodes(d.wire).size();
    d.w.set_system_signal("jaw.close", 0.0);
    d.run(5.0);
    EXPECT_FALSE(d.w.find_interaction("jaw/hold").valid());
    EXPECT_EQ(d.count(EventKind::detach), 1);
    EXPECT_EQ(d.get("jaw.state"), static_cast<double>(StopperState::open));
    EXPECT_EQ(d.w.wires().nodes(d.wire).size(), nodes - 1) << "the node that it put has gone";
    EXPECT_NEAR(d.mass(), mass, 1e-9 * mass);
    EXPECT_GT(d.w.velocity(d.inboard).linear.x(), 0.1) << "the wire runs";
    EXPECT_EQ(d.w.verdict().grade, Grade::good);
}

TEST(Stoppers, OpenAboveTheirRatedLoad) {
    Deck d({.rated_load = 4e5});
    d.pull(1e5, 1e5);
    d.run(10.0);
    d.w.set_system_signal("jaw.close", 1.0);
    d.run(1.0);
    for (int k = 1; k <= 39; ++k) {  // gradually: a sudden pull would make the wire overshoot
        d.pull(1e5, 1e5 + 1e4 * k);
        d.run(0.5);
    }
    EXPECT_EQ(d.count(EventKind::overload), 0) << "holds 390 kN";
    d.pull(1e5, 6e5);
    d.run(3.0);
    ASSERT_EQ(d.count(EventKind::overload), 1);
    EXPECT_GT(d.w.events().extremes(EventKind::overload).first.value, 4e5);
    EXPECT_EQ(d.get("jaw.state"), static_cast<double>(StopperState::tripped));
    // Still closed, it takes nothing; opened and closed again, it does.
    d.pull(1e5, 1e5);
    d.run(1.0);
    EXPECT_EQ(d.count(EventKind::join), 1);
    d.w.set_system_signal("jaw.close", 0.0);
    d.run(0.1);
    d.w.set_system_signal("jaw.close", 1.0);
    d.run(0.1);
    EXPECT_EQ(d.count(EventKind::join), 2);
}

TEST(Stoppers, SayWhereNothingIsWithinReach) {
    Deck d({.reach = 0.15});
    d.w.set_system_signal("jaw.close", 1.0);
    d.run(1.0);
    ASSERT_EQ(d.count(EventKind::missed), 1) << "once";
    EXPECT_NEAR(d.w.events().extremes(EventKind::missed).first.value, 0.2, 1e-9);
    EXPECT_EQ(d.w.events().extremes(EventKind::missed).first.body, d.ship);
    EXPECT_EQ(d.get("jaw.state"), static_cast<double>(StopperState::empty));
    EXPECT_EQ(d.get("jaw.held"), 0.0);
}

/// It holds against paying out; when hauled in, the pawl falls behind each link.
TEST(Stoppers, AChainStopperLetsChainInAndNotOut) {
    Deck d({.pitch = 0.6});
    d.pull(1e5, 3e5);
    d.w.set_system_signal("jaw.close", 1.0);
    d.run(20.0);
    EXPECT_NEAR(d.get("jaw.load"), 2e5, 200.0);
    const double held = d.w.pose(d.outboard).position.x();
    d.run(10.0);
    EXPECT_NEAR(d.w.pose(d.outboard).position.x(), held, 1e-4) << "does not pay out";
    d.pull(5e5, 1e5);
    d.run(20.0);
    const double in = d.w.pose(d.outboard).position.x() - held;
    EXPECT_GT(in, 3.0) << "comes in, over an element and more";
    EXPECT_GE(d.count(EventKind::join), 4) << "the pawl falls again and again";
    d.pull(1e5, 3e5);
    d.run(20.0);
    // Back by less than two links, the pitch of the pawl, and the stretch of the wire.
    EXPECT_GT(d.w.pose(d.outboard).position.x() - held, in - 0.65);
    EXPECT_NEAR(d.get("jaw.load"), 2e5, 200.0);
    EXPECT_LE(d.w.wires().nodes(d.wire).size(), 19U) << "nodes of earlier links have gone";
    EXPECT_EQ(d.count(EventKind::detach), 0);
}

TEST(Stoppers, GiveTheSameBitsOnAnyThreadsAndAfterRestoring) {
    const auto drive = [](Deck& d, int i) {
        if (i == 0) d.pull(1e5, 3e5);
        if (i == 30) d.w.set_system_signal("jaw.close", 1.0);
        if (i == 60) d.pull(5e5, 1e5);
        if (i == 660) d.w.set_system_signal("jaw.close", 0.0);
    };
    test::expect_same_bits(
        {.steps = 780, .restored = {31, 32, 33, 200, 400, 661, 662}},
        [](int threads) { return Deck({.pitch = 0.6}, threads); }, drive,
        [](const Deck& d) { EXPECT_EQ(d.count(EventKind::detach), 1); });
}

TEST(Stoppers, RefuseWhatCannotBe) {
    Deck d;
    struct Row {
        StopperDef def;
        const char* says;
    };
    for (const Row& row :
         {Row{{.body = d.ship, .rated_load = 1e6}, "needs a name"},
          Row{{.name = "jaw", .body = d.ship, .rated_load = 1e6}, "name is in use"},
          Row{{.name = "j", .rated_load = 1e6}, "body is missing"},
          Row{{.name = "j", .body = d.inboard, .rated_load = 1e6}, "on a point mass"},
          Row{{.name = "j", .body = d.ship}, "rated_load = 0"},
          Row{{.name = "j", .body = d.ship, .reach = 0.0, .rated_load = 1e6}, "reach = 0"},
          Row{{.name = "j", .body = d.ship, .outboard = Vec3::Zero(), .rated_load = 1e6},
              "no direction"},
          Row{{.name = "j", .body = d.ship, .rated_load = 1e6, .pitch = 0.01}, "pitch = 0.01"}}) {
        const std::string said = test::error_message(d.w, row.def);
        EXPECT_NE(said.find(row.says), std::string::npos) << row.says << " in: " << said;
    }
}

/// A node has one stopper: the second one waits until the first has released it.
TEST(Stoppers, DoNotHoldOneNodeTogether) {
    Deck d;
    d.pull(2e5, 2e5);
    StopperDef second{
        .name = "second", .body = d.ship, .point = {1.8, 0.4, 1.0}, .rated_load = 7.35e6};
    d.w.add(second);
    d.w.set_system_signal("jaw.close", 1.0);
    d.w.set_system_signal("second.close", 1.0);
    d.run(1.0);
    EXPECT_EQ(d.get("jaw.state"), static_cast<double>(StopperState::holding));
    EXPECT_EQ(d.get("second.state"), static_cast<double>(StopperState::empty));
    EXPECT_EQ(d.get("second.held"), 0.0);
    ASSERT_EQ(d.count(EventKind::missed), 1) << "once";
    EXPECT_LT(d.w.events().extremes(EventKind::missed).first.value, 0.5) << "within its reach";
    d.pull(2e5, 5e5);
    d.run(30.0);
    EXPECT_NEAR(d.get("jaw.load"), 3e5, 300.0) << "alone";
    d.w.set_system_signal("jaw.close", 0.0);
    d.w.set_system_signal("second.close", 0.0);
    d.run(0.1);
    d.w.set_system_signal("second.close", 1.0);
    d.run(0.1);
    EXPECT_EQ(d.get("second.state"), static_cast<double>(StopperState::holding));
    // Further along the wire both hold.
    second.name = "third";
    second.point = {5.0, 0, 1.0};
    d.w.add(second);
    d.w.set_system_signal("third.close", 1.0);
    d.run(1.0);
    EXPECT_EQ(d.get("third.state"), static_cast<double>(StopperState::holding));
}

TEST(Stoppers, RefuseTwoThatStartClosedOnOneNode) {
    Deck d({.closed = true});
    const auto refusal = [&](double x, bool closed) {
        return test::error_message(d.w, StopperDef{.name = "at" + std::to_string(x),
                                                   .body = d.ship,
                                                   .point = {x, 0, 1.0},
                                                   .rated_load = 1e6,
                                                   .closed = closed});
    };
    EXPECT_NE(refusal(1.85, true).find("node that stopper 'jaw' holds"), std::string::npos)
        << refusal(1.85, true);
    EXPECT_NE(refusal(1.85, true).find("start one of them open"), std::string::npos);
    EXPECT_EQ(refusal(1.85, false), "");
    EXPECT_EQ(refusal(2.2, true), "");
}

}  // namespace
}  // namespace hawser
