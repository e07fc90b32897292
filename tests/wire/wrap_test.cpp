// SPDX-License-Identifier: Apache-2.0
/// Wires that wind on a bollard, and rollers that rotate under a wire, by more than half a
/// revolution. The wire's length includes the arc on the wheel with its whole turns, also in copies
/// and restored worlds.
#include <hawser/guide.h>
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hawser {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A ball that flies around a bollard on a wire, from 22.5 m; the wire ends 22.5 m on the other
/// side.
struct Tether {
    static constexpr double kLength = 45.0;
    double radius;
    World w{WorldDef{.step = 1.0 / 60.0, .gravity = Vec3::Zero()}};
    WireId wire{};
    Guide post{};

    /// Make the scene. @param through  True if nodes pass; otherwise elements are long enough that
    /// none has to.
    explicit Tether(bool through) : radius(through ? 1.0 : 0.5) {
        const BodyId quay = w.add_body({.kind = BodyKind::fixed});
        const Vec3 end(0.5 * kLength, -radius, 0.0);
        BodyDef ball{.name = "ball", .kind = BodyKind::lump, .position = end};
        ball.mass = 2000.0;
        ball.velocity = {0.0, 3.0, 0.0};
        WireDef def{.name = "line", .from = quay, .from_point = {-end.x(), end.y(), 0.0}};
        def.to = w.add_body(ball);
        def.length = kLength;
        def.elements = through ? 9 : 3;
        def.EA = 2e7;
        def.mass_per_length = 5.0;
        def.consistent_mass = true;
        wire = w.wires().add(def);
        post = w.add(GuideDef{.name = "post",
                              .wire = wire,
                              .body = quay,
                              .axis = {0, 0, 1},
                              .radius = radius,
                              .element_length = through ? 5.0 : 0.0});
    }
    [[nodiscard]] double angle() const {
        return w.wires().wrapped(post.before)[1] + w.wires().wrapped(post.behind)[0];
    }
    /// Return the length from end to end, including the part on the bollard [m].
    [[nodiscard]] double way() const {
        double sum = radius * angle();
        for (const InteractionId id : w.wires().elements(wire)) {
            const auto ends = w.wires().ends(id);
            sum += (ends[1] - ends[0]).norm();
        }
        return sum;
    }
    bool to(double time) {
        while (w.time() < time - 1e-9)
            if (w.step() != Status::ok) return false;
        return true;
    }
};

TEST(Wraps, ALineGoesOnRoundItsPost) {
    for (const bool through : {false, true}) {
        Tether t(through);
        ASSERT_TRUE(t.to(52.0));
        // 3 m/s on the remaining part of 22.5 m. A missed revolution would be 6.3 m of wire.
        EXPECT_GT(t.angle(), 2.0 * kPi) << through;
        // Between its nodes it is straight except for oscillations: chords of elements.
        EXPECT_NEAR(t.way(), Tether::kLength, 0.5) << through;
        // Signals are from the start of the step, 2.5e-3 rad before.
        EXPECT_NEAR(t.w.system_signal("post.angle"), t.angle(), 1e-2) << through;
        EXPECT_EQ(t.w.verdict().grade, Grade::good) << through;
        // Without friction only the damping of oscillating elements takes energy.
        EXPECT_NEAR(t.w.energy().kinetic, 0.5 * 2000.0 * 9.0, 0.1 * 9000.0) << through;
    }
}

TEST(Wraps, TurnsArePartOfTheState) {
    Tether t(false);
    ASSERT_TRUE(t.to(40.0));
    ASSERT_GT(t.angle(), kPi);
    const Structure made_of = t.w.state().structure();
    const std::vector<std::byte> saved = t.w.state().save();
    Tether fresh(false);
    fresh.w.state().restore(made_of, saved);
    Tether same(false);
    same.w.state().restore(saved);
    World twin = t.w.twin();
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(t.w.step(), Status::ok);
        for (World* other : {&fresh.w, &same.w, &twin}) {
            ASSERT_EQ(other->step(), Status::ok);
            ASSERT_EQ(other->state().hash(), t.w.state().hash()) << i;
        }
    }
    EXPECT_EQ(fresh.angle(), t.angle());
}

/// Two weights on a wire over a roller that rotates in a hinge; the marks of the guide rotate with
/// it. With the difference x of their paths, 0.5 kg/m of wire and I/R² of the roller: M x'' = g (D
/// + 2 · 0.5 x), x = (D/1)(cosh(t √(g/M)) − 1).
TEST(Wraps, ARollerTurnsUnderItsLine) {
    constexpr double kRadius = 0.4, kDensity = 0.5, kLength = 45.0, kShort = 6.87;
    World w(WorldDef{.step = 1.0 / 60.0});
    const BodyId frame = w.add_body({.kind = BodyKind::fixed});
    BodyDef roller{.name = "roller"};
    roller.mass = 200.0;
    roller.inertia = Vec3(30.0, 16.0, 30.0).asDiagonal();
    const BodyId drum = w.add_body(roller);
    w.add(HingeDef{.a = frame, .b = drum, .axis = {0, 1, 0}});
    const double bent = kPi * kRadius, hangs = kLength - bent - kShort;
    const auto at = [&](double s) -> Vec3 {
        if (s < kShort) return {-kRadius, 0, s - kShort};
        const double turn = (s - kShort) / kRadius;
        if (turn < kPi) return {-kRadius * std::cos(turn), 0, kRadius * std::sin(turn)};
        return {kRadius, 0, kShort + bent - s};
    };
    BodyDef heavy{.name = "heavy", .kind = BodyKind::lump, .position = at(0.0)};
    BodyDef light{.name = "light", .kind = BodyKind::lump, .position = at(kLength)};
    heavy.mass = 2100.0;
    light.mass = 1900.0;
    const BodyId falls = w.add_body(heavy);
    WireDef def{.name = "line", .from = falls, .to = w.add_body(light)};
    def.length = kLength;
    def.elements = 15;
    def.EA = 2e7;
    def.mass_per_length = kDensity;
    def.consistent_mass = true;
    for (int i = 1; i < def.elements; ++i) def.path.push_back(at(i * kLength / def.elements));
    const WireId wire = w.wires().add(def);
    w.add(
        GuideDef{.name = "guide", .wire = wire, .body = drum, .radius = kRadius, .friction = 0.3});
    for (int i = 0; i < 360; ++i) ASSERT_EQ(w.step(), Status::ok) << i;
    const double fallen = -kShort - w.pose(falls).position.z();
    const double all = 4000.0 + kDensity * kLength + 16.0 / (kRadius * kRadius);
    const double more = 200.0 + kDensity * (kShort - hangs);
    const double way =
        more / (2.0 * kDensity) * (std::cosh(6.0 * std::sqrt(9.81 * 2.0 * kDensity / all)) - 1.0);
    // 0.1 m of the whole path is the wire's stretch and its oscillation.
    EXPECT_NEAR(fallen, way, 0.02 * way);
    EXPECT_GT(fallen, 2.0 * kPi * 2.0 * kRadius);            // more than two revolutions
    EXPECT_NEAR(w.system_signal("guide.slide"), 0.0, 1e-6);  // it sticks
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

}  // namespace
}  // namespace hawser
