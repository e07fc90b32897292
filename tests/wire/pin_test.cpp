// SPDX-License-Identifier: Apache-2.0
/// Guide pins that are lowered and raised: their contacts, wires held and lifted, rejected
/// definitions.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser {
namespace {

constexpr double kDeckEA = 2.33e8, kDeckDensity = 23.0;  // N, kg/m: wire of 76 mm

/// A wire under 50 kN between two moving carriers, over a deck with a pin.
struct PinDeck {
    World w;
    BodyId ship{}, left{}, right{};
    WireId wire{};

    explicit PinDeck(bool up, double y, double z, int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        ship = w.add_body({.name = "ship", .kind = BodyKind::fixed});
        left = w.add_body({.name = "left", .kind = BodyKind::kinematic, .position = {-20, y, z}});
        right = w.add_body({.name = "right", .kind = BodyKind::kinematic, .position = {20, y, z}});
        wire = w.wires().add({.name = "wire",
                              .from = left,
                              .to = right,
                              .elements = 9,
                              .length = 40.0 / (1.0 + 5e4 / kDeckEA),
                              .EA = kDeckEA,
                              .mass_per_length = kDeckDensity,
                              .drag = 60.0,
                              .radius = 0.038,
                              .consistent_mass = true});
        w.add(PinDef{.name = "pin",
                     .body = ship,
                     .from = {0, 0, 0},
                     .to = {0, 0, 2},
                     .radius = 0.15,
                     .friction = 0.15,
                     .up = up});
    }
    void move(const Vec3& by, double seconds) {
        for (const BodyId id : {left, right}) w.set_velocity(id, {by / seconds, Vec3::Zero()});
        for (int i = 0; i < std::lround(60.0 * seconds); ++i)
            ASSERT_EQ(w.step(), Status::ok) << w.time();
        for (const BodyId id : {left, right}) w.set_velocity(id, {});
    }
    [[nodiscard]] double middle() const {
        return 0.5 * (w.pose(w.wires().nodes(wire)[4]).position +
                      w.pose(w.wires().nodes(wire)[5]).position)
                         .y();
    }
};

TEST(Pins, LoweredTouchNothingAndRaisedHoldAWireOnItsSide) {
    PinDeck d(false, 1.0, 1.2);
    d.move({0, 0, 0}, 5.0);
    d.move({0, -2.0, 0}, 10.0);
    EXPECT_EQ(d.w.system_signal("pin/post.taken"), 0.0) << "passes over a lowered pin";
    EXPECT_LT(d.middle(), -0.8);
    d.w.set_system_signal("pin.up", 1.0);
    d.move({0, 0, 0}, 30.0);  // 2 m at 0.1 m/s, and some time more
    EXPECT_NEAR(d.w.system_signal("pin.height"), 1.0, 1e-3);
    d.move({0, 2.0, 0}, 10.0);
    d.move({0, 0, 0}, 10.0);
    EXPECT_EQ(d.w.system_signal("pin/post.held"), 1.0) << "a raised one stops it";
    EXPECT_GT(std::abs(d.w.system_signal("pin/post.angle")), 0.01);
    d.w.set_system_signal("pin.up", 0.0);
    d.move({0, 0, 0}, 30.0);
    EXPECT_NEAR(d.w.system_signal("pin.height"), 0.0, 1e-3);
    EXPECT_EQ(d.w.system_signal("pin/post.held"), 0.0) << "let go past its top";
    EXPECT_GT(d.middle(), 0.8) << "and straight again";
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

/// A force above that of its motor, like that of a wire climbing along it: its stops hold it.
TEST(Pins, StayBetweenTheirStops) {
    PinDeck d(true, 1.0, 1.2);
    const BodyId pin = d.w.find_body("pin");
    for (const double up : {1.0, 0.0}) {
        d.w.set_force(pin, Vec3::Zero(), Vec3::Zero());
        d.w.set_system_signal("pin.up", up);
        d.move({0, 0, 0}, 25.0);
        EXPECT_NEAR(d.w.system_signal("pin.height"), up, 1e-3);
        d.w.set_force(pin, {0, 0, up > 0.5 ? 1e6 : -1e6}, Vec3::Zero());
        d.move({0, 0, 0}, 5.0);
        // 1 cm of play on 2 m.
        EXPECT_NEAR(d.w.system_signal("pin.height"), up > 0.5 ? 1.005 : -0.005, 1e-4);
    }
}

/// Directly above it: lifted, not taken.
TEST(Pins, LiftAWireThatLiesAcrossTheirTop) {
    PinDeck d(false, 0.0, 1.2);
    d.move({0, 0, 0}, 5.0);
    d.w.set_system_signal("pin.up", 1.0);
    d.move({0, 0, 0}, 30.0);
    EXPECT_NEAR(d.w.system_signal("pin.height"), 1.0, 1e-3);
    EXPECT_EQ(d.w.system_signal("pin/post.taken"), 0.0);
    double highest = 0.0;
    for (const BodyId id : d.w.wires().nodes(d.wire))
        highest = std::max(highest, d.w.pose(id).position.z());
    EXPECT_GT(highest, 1.9) << "on top of 2 m";
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

TEST(Pins, RefuseWhatCannotBe) {
    PinDeck d(true, 1.0, 1.0);
    const PinDef good{
        .name = "p", .body = d.ship, .from = {0, 3, 0}, .to = {0, 3, 2}, .radius = 0.1};
    const auto refusal = [&](const PinDef& def) -> std::string {
        const auto bodies = d.w.bodies().size();
        try {
            d.w.add(def);
        } catch (const DefError& error) {
            EXPECT_EQ(d.w.bodies().size(), bodies) << "all or nothing";
            return error.what();
        }
        return "";
    };
    const auto with = [&](auto change) {
        PinDef def = good;
        change(def);
        return refusal(def);
    };
    EXPECT_NE(with([](PinDef& p) { p.name = "pin"; }).find("names must be unique"),
              std::string::npos);
    EXPECT_NE(with([](PinDef& p) { p.to = p.from; }).find("shorter"), std::string::npos);
    EXPECT_NE(with([](PinDef& p) { p.radius = 0.0; }).find("radius = 0"), std::string::npos);
    EXPECT_NE(with([](PinDef& p) { p.force = 100.0; }).find("more than its weight"),
              std::string::npos);
    EXPECT_NE(with([](PinDef& p) { p.friction = -1.0; }).find("friction = -1"), std::string::npos);
    EXPECT_EQ(refusal(good), "");
}

}  // namespace
}  // namespace hawser
