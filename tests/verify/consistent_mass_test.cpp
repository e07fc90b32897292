// SPDX-License-Identifier: Apache-2.0
/// Elements that move as straight pieces between their nodes: momentum, energy and frequencies are
/// those of the consistent mass matrix.
#include "verify/certificate.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kDensity = 23.0, kEA = 2.33e8;  // kg/m, N
constexpr double kAnchor = 1e10;                 // kg: fixes an end

struct Account {
    double kinetic = 0.0;
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};

/// Integrate over straight pieces, linear along them: (m/6)(2 a·b + …). At the half step before the
/// poses, to which the energy of the scheme belongs.
Account account_of(const World& w) {
    Account out;
    for (const InteractionId id : w.interactions()) {
        const InteractionDef& d = w.interaction_def(id);
        const double m = d.get("mass"), half = 0.5 * w.settings().step;
        Vec3 x[2], v[2];
        for (std::size_t b = 0; b < 2; ++b) {
            v[b] = w.velocity(d.body[b]).linear;
            x[b] = w.pose(d.body[b]).position - half * v[b];
        }
        out.linear += 0.5 * m * (v[0] + v[1]);
        out.angular +=
            m / 6.0 *
            (2.0 * x[0].cross(v[0]) + x[0].cross(v[1]) + x[1].cross(v[0]) + 2.0 * x[1].cross(v[1]));
        out.kinetic += m / 6.0 * (v[0].squaredNorm() + v[0].dot(v[1]) + v[1].squaredNorm());
    }
    return out;
}

/// A wire of equal elements along x, with free or fixed ends.
struct Straight {
    World w;
    std::vector<BodyId> lumps;
    Straight(int elements, double length, bool fixed, double tension, double wave)
        : w({.gravity = Vec3::Zero()}) {
        const double l = length / elements;
        for (int i = 0; i <= elements; ++i) {
            const bool end = i == 0 || i == elements;
            BodyDef b{.kind = BodyKind::lump};
            const double s = l * i;
            b.position =
                Vec3(s - 0.5 * length, 0.0, wave * std::sin(std::numbers::pi * s / length));
            // An end on a rigid body would leave the mass of its element in the other node. The
            // wire would then pull both together, by 2 mm and half of its tension in 40 s.
            if (fixed && end) b.force = Vec3(i == 0 ? -tension : tension, 0.0, 0.0);
            b.mass = fixed && end ? kAnchor : kDensity * l * (end ? 0.5 : 1.0);
            lumps.push_back(w.add_body(b));
        }
        for (std::size_t i = 0; i + 1 < lumps.size(); ++i) {
            InteractionDef d;
            d.kind = InteractionKind::Stretch;
            d.body = {lumps[i], lumps[i + 1]};
            d.set("length", l / (1.0 + tension / kEA)).set("EA", kEA).set("mass", kDensity * l);
            (void)w.add_interaction(d);
        }
    }
};

TEST(ConsistentMass, FreeWireKeepsItsMomenta) {
    Straight s(12, 120.0, false, 0.0, 1.0);
    for (std::size_t i = 0; i < s.lumps.size(); ++i) {
        const Vec3 x = s.w.pose(s.lumps[i]).position;
        s.w.set_velocity(s.lumps[i], {.linear = Vec3(0.2, 0.1, 0.4).cross(x) + Vec3(1, 2, 3)});
    }
    ASSERT_EQ(s.w.step(), Status::ok);
    const Account before = account_of(s.w);
    for (int i = 0; i < 600; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    const Account after = account_of(s.w);
    EXPECT_LE((after.linear - before.linear).norm(), 1e-11 * before.linear.norm());
    // The direction of a row rotates within a step: second order in the rotation.
    EXPECT_LE((after.angular - before.angular).norm(), 1e-4 * before.angular.norm());
    EXPECT_NEAR(s.w.energy().kinetic, after.kinetic, 1e-12 * after.kinetic);
    EXPECT_EQ(s.w.verdict().grade, Grade::good);
}

/// Linear elements with consistent masses: ω = (2c/l) sin(kl/2)/√(1 − ⅔ sin²(kl/2)), c = √(T/ρ).
/// Point masses have no root: 3 % less with ten elements in the third mode.
TEST(ConsistentMass, SwaysAtTheFrequencyOfLinearElements) {
    constexpr int kElements = 6;
    constexpr double kLength = 60.0, kPull = 2e4;
    Straight s(kElements, kLength, true, kPull, 0.01);
    const double l = kLength / kElements, half = 0.5 * std::numbers::pi / kElements;
    const double square = std::sin(half) * std::sin(half);
    const double lumped = 2.0 / l * std::sqrt(kPull / kDensity) * std::sin(half);
    const double right = lumped / std::sqrt(1.0 - 2.0 / 3.0 * square);
    // Zero crossings of the middle, interpolated, over ten periods.
    const BodyId middle = s.lumps[kElements / 2];
    std::vector<double> crossings;
    double last = s.w.pose(middle).position.z();
    while (crossings.size() < 21) {
        ASSERT_EQ(s.w.step(), Status::ok);
        const double now = s.w.pose(middle).position.z();
        if ((last > 0.0) != (now > 0.0))
            crossings.push_back(s.w.time() - s.w.settings().step * now / (now - last));
        last = now;
    }
    const double measured = std::numbers::pi * 20.0 / (crossings.back() - crossings.front());
    // The step lengthens a period by (hω)²/24 to (hω)²/12, here at most 1e-4.
    EXPECT_NEAR(measured / right, 1.0, 3e-4);
    EXPECT_GT(std::abs(measured / lumped - 1.0), 1e-2);
}

TEST(ConsistentMass, IsWhatTheVerifierComputes) {
    Straight s(10, 50.0, true, 1e5, 0.2);
    verify::Verifier verifier(s.w);
    for (int i = 0; i < 120; ++i) {
        verifier.before_step(s.w);
        ASSERT_EQ(s.w.step(), Status::ok);
        EXPECT_EQ(verifier.after_step(s.w), "") << "step " << i;
    }
}

/// Nodes of a broken element continue separately: their energy gain is counted as driven.
TEST(ConsistentMass, PartingIsAccountedFor) {
    Straight s(8, 80.0, true, 1e6, 0.0);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    s.w.wires().part(s.w.interactions()[3]);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    s.w.wires().part(s.w.interactions()[5]);  // in motion
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    EXPECT_NE(s.w.verdict().grade, Grade::wrong);
    const auto saved = s.w.state().save();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    const std::uint64_t hash = s.w.state().hash();
    s.w.state().restore(saved);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    EXPECT_EQ(s.w.state().hash(), hash);
}

TEST(ConsistentMass, ComesBackWithWhatWasWhole) {
    Straight s(8, 80.0, true, 1e6, 0.1);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    const auto saved = s.w.state().save();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    const std::uint64_t hash = s.w.state().hash();
    s.w.wires().part(s.w.interactions()[3]);
    ASSERT_EQ(s.w.step(), Status::ok);
    s.w.state().restore(saved);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(s.w.step(), Status::ok);
    EXPECT_EQ(s.w.state().hash(), hash);
}

TEST(ConsistentMass, GoesWithMethodsThatKnowRowsOnly) {
    WorldDef def;
    def.nonsmooth = Nonsmooth::pgs;
    World w(def);
    const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed});
    WireDef wire{.name = "wire", .from = top};
    wire.elements = 5;
    wire.length = 50.0;
    wire.EA = 1e6;
    wire.mass_per_length = 4.0;
    wire.consistent_mass = true;
    (void)w.wires().add(wire);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
}

}  // namespace
}  // namespace hawser::test
