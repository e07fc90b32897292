// SPDX-License-Identifier: Apache-2.0
/// Bodies with rolling and spinning resistance: against each other, on a moving deck, in a heap.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

MaterialDef resisting(double rolling, double torsional) {
    MaterialDef m;
    m.name = "felt";
    m.friction = 0.6;
    m.stiffness = 1e6;
    m.rolling = rolling;
    m.torsional = torsional;
    return m;
}

BodyId add_ball(World& w, MaterialId material, const Vec3& at, double radius = 0.5,
                double mass = 10.0) {
    BodyDef d;
    d.mass = mass;
    d.inertia = 0.4 * mass * radius * radius * Mat3::Identity();
    d.position = at;
    const BodyId id = w.add_body(d);
    ShapeDef s;
    s.radius = radius;
    s.body = id;
    s.material = material;
    w.add_shape(s);
    return id;
}

BodyId add_plane(World& w, MaterialId material, BodyKind kind) {
    BodyDef d;
    d.kind = kind;
    const BodyId id = w.add_body(d);
    ShapeDef s;
    s.kind = ShapeKind::plane;
    s.body = id;
    s.material = material;
    w.add_shape(s);
    return id;
}

/// Two free balls that collide, one of them spinning: no external torque.
TEST(Resistance, BetweenTwoBodiesKeepsMomentum) {
    WorldDef def;
    def.gravity.setZero();
    def.contact_tolerance =
        1e-11;  // of the impulse that would stop the spin: bounds are met to 1e-9
    World w(def);
    const MaterialId felt = w.add_material(resisting(0.05, 0.1));
    const BodyId a = add_ball(w, felt, {0, 0, 0}), b = add_ball(w, felt, {1.02, 0.1, 0}, 0.5, 3.0);
    w.set_velocity(b, {{-2.0, 0.3, 0.0}, {8.0, 3.0, -5.0}});
    const auto momenta = [&] {
        Eigen::Matrix<double, 6, 1> p = Eigen::Matrix<double, 6, 1>::Zero();
        for (const auto& [id, m] : {std::pair(a, 10.0), std::pair(b, 3.0)}) {
            const Twist v = w.velocity(id);
            p.head<3>() += m * v.linear;
            p.tail<3>() += m * w.pose(id).position.cross(v.linear) + 0.4 * m * 0.25 * v.angular;
        }
        return p;
    };
    const auto start = momenta();
    double moment = 0.0, energy = w.energy().kinetic;
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        for (const ContactView& c : w.contacts()) {
            moment = std::max(moment, c.moment.norm());
            const double normal = c.force.dot(c.normal), spin = c.moment.dot(c.normal);
            EXPECT_LE(std::abs(spin), 0.1 * normal * (1.0 + 1e-9));
            EXPECT_LE((c.moment - spin * c.normal).norm(), 0.05 * normal * (1.0 + 1e-9));
        }
        EXPECT_LE(w.stats().natural_map, 1e-6);
    }
    EXPECT_GT(moment, 1.0);  // [N m]: resistance has acted.
    EXPECT_LT(w.energy().kinetic, energy == 0.0 ? 1e300 : energy);
    // Rounding of about 100 N m s over 60 steps.
    EXPECT_LT((momenta() - start).norm(), 1e-11);
}

/// A body at rest on a deck that rolls in a seaway keeps its place on the deck.
TEST(Resistance, HoldsOnAMovingDeckWithoutCreep) {
    constexpr double kAmplitude = 0.06, kPeriod = 5.0, kStep = 1.0 / 60.0;  // 0.06 < 0.05/0.5
    World w;
    const MaterialId felt = w.add_material(resisting(0.05, 0.02));
    const BodyId deck = add_plane(w, felt, BodyKind::kinematic);
    const BodyId ball = add_ball(w, felt, {0.8, 0.3, 0.5 - 98.1e-6});
    const auto tilt = [&](int step) {  // about an axis that is not one of the body's
        return kAmplitude * std::sin(2.0 * M_PI * step * kStep / kPeriod);
    };
    const Vec3 axis = Vec3{2.0, 1.0, 0.0}.normalized();
    const auto on_deck = [&] {
        const Pose d = w.pose(deck), b = w.pose(ball);
        return Pose{d.orientation.conjugate() * (b.position - d.position),
                    d.orientation.conjugate() * b.orientation};
    };
    const int cycle = static_cast<int>(std::lround(kPeriod / kStep));
    Pose settled;
    double drift = 0.0, turn = 0.0;
    for (int i = 0; i < 22 * cycle; ++i) {
        const double rate = (tilt(i + 1) - tilt(i)) / kStep;
        w.set_velocity(deck, {Vec3::Zero(), rate * axis});
        ASSERT_EQ(w.step(), Status::ok);
        if (i + 1 < 2 * cycle || (i + 1) % cycle != 0) continue;
        if (i + 1 == 2 * cycle) settled = on_deck();
        const Pose now = on_deck();
        drift = std::max(drift, (now.position - settled.position).norm());
        turn = std::max(turn, now.orientation.angularDistance(settled.orientation));
    }
    EXPECT_LT(drift, 1e-9);  // Over 20 cycles, like a box without creep.
    EXPECT_LT(turn, 1e-7);   // angularDistance() takes an arc cosine: √ε near zero.
}

TEST(Resistance, HeapIsSolvedAndMakesNoEnergy) {
    World w;
    const MaterialId felt = w.add_material(resisting(0.02, 0.01));
    (void)add_plane(w, felt, BodyKind::fixed);
    for (int i = 0; i < 27; ++i) {
        const Vec3 jitter{0.03 * (i % 5), 0.02 * (i % 7), 0.0};
        (void)add_ball(w, felt,
                       Vec3{0.42 * (i % 3), 0.42 * (i / 3 % 3), 0.25 + 0.45 * (i / 9)} + jitter,
                       0.2, i % 4 == 0 ? 10.0 : 2.0);
    }
    double energy = 1e300, moment = 0.0;
    int unsolved = 0;
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        unsolved += w.stats().natural_map > 1e-6 ? 1 : 0;
        const double now = w.energy().mechanical();
        // The sum leaves out contact springs, which return their energy: about (10 kg g)²/2k per
        // ball, and more at impacts.
        EXPECT_LT(now, energy + 0.5) << i;
        energy = std::min(energy, now);
        for (const ContactView& c : w.contacts()) moment = std::max(moment, c.moment.norm());
    }
    // Steps with impacts may end without a certificate: of 1,800 steps of six such heaps 5 with
    // friction alone, 6 with resistance.
    EXPECT_LE(unsolved, 3);
    EXPECT_GT(moment, 0.1);
    EXPECT_LT(w.energy().kinetic, 1.0);
}

TEST(Resistance, IsForBodiesWithAnOrientation) {
    World w;
    const MaterialId felt = w.add_material(resisting(0.05, 0.02));
    (void)add_plane(w, felt, BodyKind::fixed);
    BodyDef d;
    d.kind = BodyKind::lump;
    d.mass = 5.0;
    d.position = {0, 0, 0.1};
    ShapeDef s;
    s.radius = 0.1;
    s.body = w.add_body(d);
    s.material = felt;
    w.add_shape(s);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_EQ(w.contacts().size(), 1U);
    EXPECT_GT(w.contacts()[0].force.z(), 0.0);
    EXPECT_EQ(w.contacts()[0].moment, Vec3::Zero());
}

TEST(Resistance, NeedsTheMethodThatHasIt) {
    for (const Nonsmooth method :
         {Nonsmooth::pivoting, Nonsmooth::split, Nonsmooth::pgs, Nonsmooth::convex}) {
        WorldDef def;
        def.nonsmooth = method;
        World w(def);
        EXPECT_THROW(w.add_material(resisting(0.01, 0.0)), DefError);
        const MaterialId plain = w.add_material(resisting(0.0, 0.0));
        EXPECT_THROW(w.add_material_pair({plain, plain, resisting(0.0, 0.01)}), DefError);
        EXPECT_NO_THROW(w.add_material_pair({plain, plain, resisting(0.0, 0.0)}));
    }
}

}  // namespace
}  // namespace hawser
