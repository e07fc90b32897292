// SPDX-License-Identifier: Apache-2.0
/// Chain on a gypsy: its radius, the condition and length of its jumps, its locker and its end.
#include "wire/gypsy_deck.h"

namespace hawser::test {
namespace {

constexpr double kPocket = 2.0 * 4.0 * kBar;  // two links of 4 d
constexpr double kGravity = 9.81;

TEST(Gypsy, PaysOutWholeLinksATurnAtOneRadius) {
    WinchDef def = windlass();
    EXPECT_NEAR(2.0 * std::numbers::pi * gypsy_radius(def), 5 * kPocket, 1e-12);
    def.mode = WinchMode::speed;
    def.speed = 0.5;
    ChainDeck d(def);
    d.run(20.0, 0.5);
    const double turned = d.drum();
    EXPECT_GT(turned, 15.0);
    EXPECT_EQ(d.get("radius"), gypsy_radius(def));
    EXPECT_EQ(d.get("layer"), 1.0);
    // Chain and wheel move together, up to the compliance of the grip.
    EXPECT_NEAR(d.jumped(), 0.0, 1e-9);
    EXPECT_NEAR(d.w.wires().length(d.wire), 40.0 + gypsy_radius(def) * d.chain(), 1e-9);
    // The length that left the locker is the length paid out, except in the last step.
    EXPECT_NEAR(300.0 - d.get("wire_left"),
                gypsy_radius(def) *
                    (d.chain() - d.w.velocity(d.ids.chain).linear.x() * d.w.settings().step),
                1e-9);
}

TEST(Gypsy, JumpsAtItsLoad) {
    ChainDeck d(windlass());
    double most = 0.0;
    while (d.count(EventKind::chain_jump) == 0 && d.w.time() < 60.0) {
        most = std::max(most, d.tension());
        d.step(0.01);
    }
    ASSERT_EQ(d.count(EventKind::chain_jump), 1);
    EXPECT_NEAR(most, 1.2e6, 0.005 * 1.2e6);
    EXPECT_NEAR(d.w.events().extremes(EventKind::chain_jump).first.value, 1.2e6, 1.0);
    EXPECT_EQ(d.w.events().extremes(EventKind::chain_jump).first.body, d.ids.drum);
    EXPECT_EQ(d.drum(), d.w.pose(d.ids.drum).position.x());
    EXPECT_LT(std::abs(d.drum()), 1e-5);  // the brake holds
}

TEST(Gypsy, HoldsBelowItsLoad) {
    ChainDeck d(windlass());
    while (d.tension() < 1.18e6 && d.w.time() < 60.0) d.step(0.01);
    d.run(5.0, 0.0);
    EXPECT_EQ(d.count(EventKind::chain_jump), 0);
    EXPECT_LT(std::abs(d.jumped()), 1e-8);
}

/// A weight above the jump load would continue past a pocket. The end hauled off slowly lets the
/// chain fall into the next pocket each time.
TEST(Gypsy, JumpsByWholePocketsWithTheWheelStanding) {
    ChainDeck d(windlass());
    std::int64_t last = 0;
    double farthest = 0.0;
    for (int i = 0; i < 240 * 120; ++i) {
        d.step(0.02);
        const double pockets = d.get("jumped") / kPocket;
        farthest = std::max(farthest, pockets);
        if (d.state() == WinchState::jumping || d.state() == WinchState::slipping) continue;
        EXPECT_NEAR(pockets, std::round(pockets), 1e-5) << i;
        last = std::lround(pockets);
    }
    EXPECT_GE(last, 2);
    EXPECT_LT(std::abs(d.drum()), 1e-5);
    EXPECT_LE(d.count(EventKind::chain_jump), std::lround(std::ceil(farthest)));
}

/// Gravity and a fall: the jump tension is higher by the weight of the fall.
TEST(Gypsy, TheFallIntoTheLockerHoldsBack) {
    WinchDef def = windlass();
    def.gypsy.locker_fall = 30.0;
    ChainDeck d(def, kGravity);
    d.step(0.0);
    const double tail = def.mass_per_length * kGravity * 30.0;
    EXPECT_NEAR(d.get("tail"), tail, 1e-9 * tail);
    double most = 0.0;
    while (d.count(EventKind::chain_jump) == 0 && d.w.time() < 60.0) {
        most = std::max(most, d.get("pull"));
        d.step(0.01);
    }
    // `pull` is at the fairlead, half an element's weight above the tension at the wheel: both add
    // equally there.
    EXPECT_NEAR(most, 1.2e6 + tail, 0.005 * 1.2e6);
}

/// Chain released without a load accelerates until the momentum of the heap, ρ v², equals the
/// remaining weight (Cayley): v² = g (L − fall).
TEST(Gypsy, ChainFromTheHeapTakesMomentum) {
    WinchDef def = windlass();
    def.mode = WinchMode::speed;
    def.speed = 4.0;
    def.gypsy.locker_fall = 5.0;
    ChainDeck d(def, kGravity);
    d.run(10.0, 4.0);
    const double rho = def.mass_per_length;
    EXPECT_NEAR(d.get("tail"), rho * (kGravity * 5.0 + 16.0), 1e-3 * rho * 16.0);
    // The motor carries the weight of the outboard part above that.
    const double torque = d.w.force(d.ids.motor)[0];
    EXPECT_NEAR(-torque / gypsy_radius(def), d.get("pull") - d.get("tail"), 0.01 * d.get("pull"));
}

TEST(Gypsy, BitterEndPartsAtItsLoadOnce) {
    for (const double link : {0.0, 3e5, 1e7}) {
        WinchDef def = windlass();
        def.stored = 2.0;
        def.brake_static = 2e4;  // it slips, and stops the wheel
        def.weak_link = link;
        ChainDeck d(def);
        d.run(19.0, 0.1);
        // Slowly: the wheel reaches the end with v sqrt(k J/r^2).
        d.run(20.0, 0.01);
        EXPECT_EQ(d.count(EventKind::drum_empty), 1) << link;
        EXPECT_EQ(d.count(EventKind::weak_link), link == 3e5 ? 1 : 0) << link;
        EXPECT_EQ(d.w.intact(d.ids.line), link == 1e7) << link;
        EXPECT_EQ(d.state(), link == 1e7 ? WinchState::empty : WinchState::parted) << link;
        if (link == 3e5) {
            EXPECT_NEAR(d.w.events().extremes(EventKind::weak_link).first.value, 3e5, 0.02 * 3e5);
        } else if (link == 1e7) {
            EXPECT_GT(d.get("wire_left"), -0.01);  // stretch of the part after the wheel at 1.4 MN
        }
    }
}

TEST(Gypsy, MotorStopsAtTheLockersEnds) {
    WinchDef def = windlass();
    def.stored = 20.0;
    def.mode = WinchMode::speed;
    def.speed = 0.5;
    def.dead_wraps = 2.0;
    ChainDeck out(def);
    out.run(60.0, 20.0 / 60.0 * (1.0 - 10 * kPocket / 20.0));
    EXPECT_EQ(out.state(), WinchState::last_wraps);
    EXPECT_NEAR(out.get("wire_left"), 10 * kPocket, 0.02);
    def.speed = -0.5;
    def.gypsy.locker = 25.0;
    ChainDeck in(def);
    in.run(10.0, -0.5);
    in.run(2.0, 0.0);
    EXPECT_EQ(in.state(), WinchState::full);
    EXPECT_NEAR(in.get("wire_left"), 25.0, 0.02);
}

/// State: snapshots during a jump, threads and twins.
TEST(Gypsy, GoesOnBitForBitFromWithinAJump) {
    ChainDeck d(windlass());
    while (d.state() != WinchState::jumping && d.w.time() < 60.0) d.step(0.02);
    ASSERT_EQ(d.state(), WinchState::jumping);
    const auto middle = d.w.state().save();
    World twin = d.w.twin();
    d.run(10.0, 0.02);
    ChainDeck other(windlass());
    other.w.state().restore(middle);
    other.run(10.0, 0.02);
    EXPECT_EQ(other.w.state().hash(), d.w.state().hash());
    Twist t;
    t.linear.z() = -0.02;
    for (int i = 0; i < 2400; ++i) {
        twin.set_velocity(d.end, t);
        ASSERT_EQ(twin.step(), Status::ok);
    }
    EXPECT_EQ(twin.state().hash(), d.w.state().hash());
}

/// A weight on light chain falls by a pocket against the friction of the links: s = a t²/2, a = (W
/// − F)/(M + m), with m the chain on the wheel. The grip dissipates F s, which is counted as
/// driven.
TEST(Gypsy, FallsByAPocketAgainstItsFriction) {
    constexpr double kMass = 1e4, kWeight = kMass * kGravity, kFriction = 0.3 * kWeight;
    World w(WorldDef{.step = 1.0 / 960.0, .gravity = Vec3(0, 0, -kGravity)});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId weight = w.add_body({.name = "weight",
                                      .kind = BodyKind::lump,
                                      .position = {0, 0, -20.0 * (1.0 + kWeight / 5e8)},
                                      .mass = kMass});
    WinchDef def = windlass();
    def.mass_per_length = 1.0;
    def.element = 0.0;
    def.gypsy.jump_load = 0.9 * kWeight;
    def.gypsy.jump_friction = kFriction;
    def.wire = w.wires().add({.name = "chain",
                              .from = deck,
                              .to = weight,
                              .elements = 1,
                              .length = 20.0,
                              .EA = 5e8,
                              .mass_per_length = 1.0,
                              .axial_damping = 2.0});
    const WinchIds ids = w.add(def);
    const double r = gypsy_radius(def);
    const auto way = [&] {
        return r * (w.pose(ids.chain).position.x() - w.pose(ids.drum).position.x());
    };
    double before = 0.0;
    while (way() < 0.9 * kPocket && w.time() < 2.0) {
        before = w.energy().driven;
        ASSERT_EQ(w.step(), Status::ok);
    }
    const double reached = way();
    const double a = (kWeight - kFriction) / (kMass + gypsy_chain_inertia(def) / (r * r));
    // It starts in the first step, in which the chain loses the stretch of W − F, 3 mm.
    EXPECT_NEAR(w.time(), std::sqrt(2.0 * reached / a), 0.02 * w.time());
    EXPECT_NEAR(before, -kFriction * reached, 0.03 * kFriction * reached);
    EXPECT_EQ(w.events().extremes(EventKind::chain_jump).count, 1);
    EXPECT_LT(std::abs(w.pose(ids.drum).position.x()), 1e-5);
    while (way() < 0.9999 * kPocket && w.time() < 2.0) ASSERT_EQ(w.step(), Status::ok);
    // It falls into the next pocket. The falling weight brings the chain above its jump load, so
    // that it passes this pocket, too.
    EXPECT_NEAR(way(), kPocket, 1e-6);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.events().extremes(EventKind::chain_jump).count, 2);
    EXPECT_GT(w.events().extremes(EventKind::chain_jump).worst.value, def.gypsy.jump_load);
    EXPECT_GT(way(), kPocket);
    EXPECT_EQ(w.events().extremes(EventKind::energy_created).count, 0);
}

/// If the fall into the locker is heavier, chain jumps inwards by the same rule.
TEST(Gypsy, JumpsInwardsWhereTheFallIsHeavier) {
    WinchDef def = windlass();
    def.gypsy.jump_load = 5e4;
    def.gypsy.jump_friction = 1e4;
    def.gypsy.locker_fall = 60.0;  // 74 kN
    ChainDeck d(def, kGravity, 1.0 / 240.0, 10.0);
    d.run(5.0, -0.2);
    EXPECT_GT(d.count(EventKind::chain_jump), 0);
    EXPECT_LT(d.get("jumped"), -0.5 * kPocket);
    EXPECT_GT(d.get("wire_left"), 300.0);
    EXPECT_LT(std::abs(d.drum()), 1e-5);
}

/// Jumps create no energy.
TEST(Gypsy, JumpsMakeNoEnergy) {
    ChainDeck d(windlass());
    d.run(120.0, 0.02);
    EXPECT_GE(d.count(EventKind::chain_jump), 2);
    EXPECT_EQ(d.count(EventKind::energy_created), 0);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

TEST(Gypsy, BadDefinitionsAreRefusedWithARemedy) {
    const auto refused = [](auto&& change) {
        WinchDef def = windlass();
        change(def);
        try {
            ChainDeck d(def);
        } catch (const DefError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto says = [&](auto&& change, const char* what) {
        const std::string r = refused(change);
        EXPECT_NE(r.find(what), std::string::npos) << r << " / " << what;
    };
    EXPECT_EQ(refused([](WinchDef&) {}), "");
    says([](WinchDef& d) { d.gypsy.pockets = 2; }, "3 to 100");
    says([](WinchDef& d) { d.gypsy.pockets = -5; }, "3 to 100");
    says([](WinchDef& d) { d.core_radius = 0.5; }, "leave them out");
    says([](WinchDef& d) { d.gypsy.pitch = 0.1; }, "4 is usual");
    says([](WinchDef& d) { d.gypsy.jump_load = 0.0; }, "jump_load");
    says([](WinchDef& d) { d.gypsy.jump_friction = 2e6; }, "above jump_load");
    says([](WinchDef& d) { d.gypsy.locker_fall = -1.0; }, "locker_fall");
    says([](WinchDef& d) { d.gypsy.locker = 200.0; }, "its locker holds 200 m");
    says([](WinchDef& d) { d.gypsy.wrap = 10.0; }, "wrap");
    says([](WinchDef& d) { d.mass_per_length = 0.0; }, "mass_per_length");
    says([](WinchDef& d) { d.gypsy.pitch = std::numeric_limits<double>::quiet_NaN(); }, "");
}

}  // namespace
}  // namespace hawser::test
