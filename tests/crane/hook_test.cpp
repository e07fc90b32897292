// SPDX-License-Identifier: Apache-2.0
/// Hooks on bodies and at the ends of wires: tensions of slings in closed form, taking, waiting and
/// releasing loads, latch, strength, bits, rejected definitions.
#include <hawser/hawser.h>

#include "support/bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace hawser {
namespace {

constexpr double kTurn = 6.283185307179586, kBoxMass = 2000.0, kFall = 9.81;

BodyId add_box(World& w, const char* name, const Vec3& at) {
    const BodyId box = w.add_body({.name = name,
                                   .position = at,
                                   .mass = kBoxMass,
                                   .inertia = Mat3::Identity() * 2000.0,
                                   .linear_damping = Vec3::Constant(4000.0),
                                   .angular_damping = Vec3::Constant(4000.0),
                                   .half_size = {1, 1, 0.5}});
    w.add_shape({.kind = ShapeKind::box, .body = box, .half_size = {1, 1, 0.5}});
    return box;
}

/// Make legs to eyes evenly spaced around the top of a box.
CraneLoad slung(BodyId body, int legs, double length, double radius) {
    CraneLoad load{.body = body, .sling_length = length, .sling_EA = 2e9, .reach = 0.05};
    for (int k = 0; k < legs; ++k)
        load.eyes.push_back({radius * std::cos(kTurn * k / legs + 0.3),
                             radius * std::sin(kTurn * k / legs + 0.3), 0.5});
    return load;
}

TEST(Hooks, CarryALoadOnEvenLegs) {
    for (const int legs : {1, 2, 3, 4}) {
        World w({.step = 0.01});
        const BodyId block =
            w.add_body({.name = "block", .kind = BodyKind::kinematic, .position = {0, 0, 10}});
        const double radius = legs == 1 ? 0.0 : 1.2, length = 2.5;
        const double drop = std::sqrt(length * length - radius * radius);
        const BodyId box = add_box(w, "box", {0, 0, 10 - 0.4 - drop - 0.5});
        w.add(HookDef{.name = "hook",
                      .body = block,
                      .point = {0, 0, -0.4},
                      .loads = {slung(box, legs, length, radius)},
                      .take = 1});
        for (int i = 0; i < 3000; ++i) ASSERT_EQ(w.step(), Status::ok);
        const double cosine = drop / length, expected = kBoxMass * kFall / (legs * cosine);
        std::printf("%d legs: %.3f N a leg, W/(n cos a) = %.3f N\n", legs,
                    w.system_signal("hook.leg"), expected);
        EXPECT_NEAR(w.system_signal("hook.leg") / expected, 1.0, 1e-3) << legs;
        for (int k = 1; k <= legs; ++k)
            EXPECT_NEAR(-w.force(w.find_interaction("hook/leg" + std::to_string(k)))[0] / expected,
                        1.0, 1e-3)
                << k;
        EXPECT_NEAR(w.system_signal("hook.load") / (kBoxMass * kFall), 1.0, 1e-3);
    }
}

/// A wire from a carrier down to a hook at its end, above a box on the ground.
struct Hoist {
    World w;
    BodyId carrier{}, box{}, other{};
    WireId wire{};

    explicit Hoist(HookDef def = {}, int threads = 1) : w({.step = 0.01, .threads = threads}) {
        const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
        w.add_shape({.kind = ShapeKind::plane, .body = ground});
        carrier =
            w.add_body({.name = "carrier", .kind = BodyKind::kinematic, .position = {0, 0, 25}});
        box = add_box(w, "box", {0, 0, 0.5});
        other = add_box(w, "other", {6, 0, 0.5});
        WireDef line{.name = "fall", .from = carrier, .elements = 8, .length = 20.0, .EA = 1e8};
        line.mass_per_length = 10.0;
        line.drag = 50.0;
        line.consistent_mass = true;
        wire = w.wires().add(line);
        def.name = "hook";
        def.body = w.wires().nodes(wire).back();
        def.loads = {slung(box, 4, 2.5, 1.2), slung(other, 2, 2.5, 0.9)};
        w.add(def);
    }
    void move(const Vec3& by, double seconds) {
        w.set_velocity(carrier, {.linear = by / seconds, .angular = Vec3::Zero()});
        run(seconds);
        w.set_velocity(carrier, {});
    }
    void run(double seconds) {
        for (long i = std::lround(seconds / w.settings().step); i > 0; --i)
            ASSERT_EQ(w.step(), Status::ok) << w.time();
    }
    void take(double number) { w.set_system_signal("hook.take", number); }
    [[nodiscard]] double get(const char* what) const {
        return w.system_signal(std::string("hook.") + what);
    }
    [[nodiscard]] bool is(HookState state) const {
        return get("state") == static_cast<double>(state);
    }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return w.events().extremes(kind).count;
    }
};

TEST(Hooks, TakeWhatComesIntoReachAndLetItGo) {
    Hoist d;
    d.run(1.0);
    EXPECT_TRUE(d.is(HookState::empty));
    d.take(1);
    d.run(2.0);
    EXPECT_TRUE(d.is(HookState::waiting)) << "the hook is 5 m up";
    EXPECT_EQ(d.count(EventKind::missed), 1) << "once";
    EXPECT_NEAR(d.w.events().extremes(EventKind::missed).first.value, std::hypot(4.0, 1.2), 0.1);
    d.move({0, 0, -2}, 4.0);
    EXPECT_TRUE(d.is(HookState::holding));
    EXPECT_EQ(d.get("held"), 1.0);
    EXPECT_EQ(d.count(EventKind::join), 1);
    d.move({0, 0, 6}, 12.0);
    d.run(8.0);
    EXPECT_GT(d.w.pose(d.box).position.z(), 2.0) << "lifted";
    EXPECT_NEAR(d.get("load") / (kBoxMass * kFall), 1.0, 1e-3);
    d.move({0, 0, -6}, 12.0);
    d.run(2.0);
    d.take(0);
    d.run(0.1);
    EXPECT_TRUE(d.is(HookState::empty));
    EXPECT_EQ(d.count(EventKind::detach), 1);
    EXPECT_FALSE(d.w.find_interaction("hook/leg1").valid());
    // Another load, 6 m away, and then the first one again without 0 between.
    d.take(2);
    d.run(0.2);
    EXPECT_TRUE(d.is(HookState::waiting));
    EXPECT_EQ(d.count(EventKind::missed), 2);
    d.take(1);
    d.run(0.1);
    EXPECT_EQ(d.get("held"), 1.0);
    EXPECT_EQ(d.count(EventKind::join), 2);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

TEST(Hooks, KeepShutUnderALoadThatHasALatch) {
    Hoist d({.latch = 2e3});
    d.take(1);
    d.move({0, 0, -2}, 4.0);
    d.move({0, 0, 6}, 12.0);
    d.run(2.0);
    d.take(0);
    d.run(2.0);
    EXPECT_TRUE(d.is(HookState::latched));
    EXPECT_EQ(d.get("held"), 1.0);
    EXPECT_GT(d.w.pose(d.box).position.z(), 2.0) << "it hangs on";
    d.take(1);
    d.run(0.1);
    EXPECT_TRUE(d.is(HookState::holding)) << "the order is taken back";
    d.take(0);
    d.move({0, 0, -6}, 12.0);
    EXPECT_TRUE(d.is(HookState::empty)) << "set down";
    EXPECT_EQ(d.count(EventKind::detach), 1);
    EXPECT_LE(d.w.events().extremes(EventKind::detach).first.value, 2e3);
}

TEST(Hooks, OpenAboveTheirStrength) {
    Hoist d({.strength = 15e3});  // the box weighs 19.6 kN
    d.take(1);
    d.move({0, 0, -2}, 4.0);
    d.move({0, 0, 6}, 12.0);
    EXPECT_TRUE(d.is(HookState::opened));
    EXPECT_EQ(d.count(EventKind::overload), 1);
    EXPECT_GT(d.w.events().extremes(EventKind::overload).first.value, 15e3);
    EXPECT_LT(d.w.pose(d.box).position.z(), 0.6);
    d.move({0, 0, -6}, 12.0);
    EXPECT_EQ(d.get("held"), 0.0) << "until it has been opened";
    d.take(0);
    d.run(0.1);
    EXPECT_TRUE(d.is(HookState::empty));
    d.take(1);
    d.run(0.1);
    EXPECT_TRUE(d.is(HookState::holding));
}

TEST(Hooks, OpenWhenTheirLegsHaveParted) {
    Hoist d;
    d.take(1);
    d.move({0, 0, -2}, 4.0);
    for (int k = 1; k <= 4; ++k)
        d.w.wires().part(d.w.find_interaction("hook/leg" + std::to_string(k)));
    d.run(0.1);
    EXPECT_TRUE(d.is(HookState::opened));
    EXPECT_EQ(d.get("held"), 0.0);
}

TEST(Hooks, RepeatBitForBit) {
    const auto drive = [](Hoist& d, int i) {
        if (i == 50) d.take(1);
        if (i == 600) d.take(0);
        d.w.set_velocity(d.carrier,
                         {.linear = {0, 0, i < 400 ? -0.6 : 0.5}, .angular = Vec3::Zero()});
    };
    test::expect_same_bits(
        {.steps = 700, .restored = {10, 51, 300, 420, 600, 601, 602}},
        [](int threads) { return Hoist({}, threads); }, drive,
        [](const Hoist& d) {
            EXPECT_EQ(d.count(EventKind::join), 1);
            EXPECT_EQ(d.count(EventKind::detach), 1);
        });
}

/// A wire from a fixed point ends in a hook. Its leg of 2 m lies on a fixed roller of radius 1 m;
/// the load, a ball of 400 kg, falls on the other side.
struct OverRoller {
    static constexpr double kRadius = 1.0, kWire = 0.03, kLeg = 2.0;

    explicit OverRoller(bool touches, int take = 1, int threads = 1)
        : w({.step = 1.0 / 60.0, .threads = threads}) {
        const double top = kRadius + kWire;
        const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
        w.add_shape({.kind = ShapeKind::cylinder,
                     .body = ground,
                     .orientation = Quat(Eigen::AngleAxisd(kTurn / 4, Vec3::UnitX())),
                     .radius = kRadius,
                     .half_length = 2.0});
        const WireId wire =
            w.wires().add(WireDef{.name = "wire",
                                  .from = ground,
                                  .from_point = {5.0, 0.0, top},
                                  .elements = 4,
                                  .length = 4.0,
                                  .EA = 2e8,
                                  .mass_per_length = 20.0,
                                  .path = {{4, 0, top}, {3, 0, top}, {2, 0, top}, {1, 0, top}},
                                  .radius = touches ? kWire : 0.0});
        end = w.wires().nodes(wire).back();
        load = w.add_body({.name = "ball",
                           .position = {1.0 - kLeg, 0.0, top},
                           .mass = 400.0,
                           .inertia = Mat3::Identity() * 10.0});
        w.add(HookDef{.name = "hook",
                      .body = end,
                      .loads = {{.body = load,
                                 .eyes = {Vec3::Zero()},
                                 .sling_length = kLeg,
                                 .sling_EA = 2e8,
                                 .reach = 0.05}},
                      .take = take});
    }
    /// Return the distance of the leg from the roller's axis [m].
    [[nodiscard]] double distance() const {
        const Vec3 a = w.pose(end).position, b = w.pose(load).position, along = b - a;
        const double s = std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (a + s * along).norm();
    }
    World w;
    BodyId end, load;  ///< Node with the hook; ball.
};

TEST(Hooks, LegsTouchLikeTheirWire) {
    OverRoller with(true), without(false);
    double least = without.distance();
    for (int i = 0; i < 600; ++i) {
        ASSERT_EQ(with.w.step(), Status::ok);
        ASSERT_EQ(without.w.step(), Status::ok);
        least = std::min(least, without.distance());
        // 5 mm: sag of the contact, some 4 kN on 1e8 N/m, and its settling from a fall.
        EXPECT_GE(with.distance(), OverRoller::kRadius + OverRoller::kWire - 5e-3) << i;
    }
    EXPECT_LT(least, OverRoller::kRadius - 0.1) << "the case needs the contact";
    EXPECT_TRUE(with.w.find_shape("hook/leg1").valid());
    EXPECT_FALSE(without.w.find_shape("hook/leg1").valid());
    with.w.set_system_signal("hook.take", 0.0);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(with.w.step(), Status::ok);
    EXPECT_FALSE(with.w.find_shape("hook/leg1").valid()) << "removed with the leg";
}

TEST(Hooks, TouchingLegsRepeatBitForBit) {
    const auto drive = [](OverRoller& d, int i) {
        if (i == 1) d.w.set_system_signal("hook.take", 1.0);
        if (i == 90) d.w.set_system_signal("hook.take", 0.0);
    };
    test::expect_same_bits(
        {.steps = 120, .restored = {1, 2, 60, 90, 91}},
        [](int threads) { return OverRoller(true, 0, threads); }, drive,
        [](const OverRoller& d) { EXPECT_FALSE(d.w.find_shape("hook/leg1").valid()); });
}

TEST(Hooks, RefuseWhatCannotBe) {
    World w;
    const BodyId block =
        w.add_body({.name = "block", .kind = BodyKind::kinematic, .position = {0, 0, 10}});
    const BodyId box = add_box(w, "box", {0, 0, 0});
    const BodyId lump = w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 10.0});
    const BodyId drum = w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 10.0});
    const CraneLoad load = slung(box, 2, 2.0, 1.0);
    CraneLoad no_length = load, of_fixed = load, no_eyes = load;
    no_length.sling_length = 0.0;
    of_fixed.body = block;
    no_eyes.eyes.clear();
    struct Row {
        HookDef def;
        const char* says;
    };
    for (const Row& row :
         {Row{{.body = block, .loads = {load}}, "needs a name"},
          Row{{.name = "h", .loads = {load}}, "body of the hook is missing"},
          Row{{.name = "h", .body = drum, .loads = {load}}, "scalar"},
          Row{{.name = "h", .body = lump, .point = {0, 0, 1}, .loads = {load}}, "lump is a point"},
          Row{{.name = "h", .body = block}, "it has no loads"},
          Row{{.name = "h", .body = block, .loads = {no_length}}, "loads/0/sling_length"},
          Row{{.name = "h", .body = lump, .loads = {of_fixed}}, "rigid body or a lump"},
          Row{{.name = "h", .body = block, .loads = {of_fixed}}, "a hook cannot attach itself"},
          Row{{.name = "h", .body = block, .loads = {no_eyes}}, "give 1 to 8"},
          Row{{.name = "h", .body = block, .loads = {load}, .take = 2}, "no load 2"},
          Row{{.name = "h", .body = block, .loads = {load}, .take = 1}, "attach it later"},
          Row{{.name = "h", .body = block, .loads = {load}, .latch = 0.0}, "above 0"},
          Row{{.name = "h", .body = block, .loads = {load}, .strength = 1e3, .latch = 2e3},
              "above strength"}}) {
        const auto hash = w.state().hash();
        const std::string said = test::error_message(w, row.def);
        EXPECT_NE(said.find(row.says), std::string::npos) << row.says << " in: " << said;
        EXPECT_EQ(said.find("crane"), std::string::npos) << said;
        EXPECT_TRUE(row.def.name.empty() || said.starts_with("hook 'h': ")) << said;
        EXPECT_EQ(w.state().hash(), hash);
    }
}

}  // namespace
}  // namespace hawser
