// SPDX-License-Identifier: Apache-2.0
/// Nodes inserted and removed along a wire: conserved quantities and losses.
#include <hawser/hawser.h>

#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kDensity = 23.0, kEA = 2.33e8;  // kg/m, N

struct Account {
    double mass = 0.0, energy = 0.0;
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};

/// Sum over the nodes and elements of a wire, including consistent masses, at the half step before
/// the poses, to which the energy of the scheme belongs.
Account account_of(const World& w, WireId wire) {
    Account a;
    const double half = 0.5 * w.settings().step;
    const auto point = [&](BodyId id) {
        return Vec3(w.pose(id).position - half * w.velocity(id).linear);
    };
    for (const BodyId id : w.wires().nodes(wire)) {
        const double m = w.body_def(id).mass;
        const Vec3 v = w.velocity(id).linear;
        a.mass += m;
        a.linear += m * v;
        a.angular += m * point(id).cross(v);
        a.energy += 0.5 * m * v.squaredNorm();
    }
    for (const InteractionId id : w.wires().elements(wire)) {
        const InteractionDef& d = w.interaction_def(id);
        const Vec3 separation = point(d.body[1]) - point(d.body[0]);
        const Vec3 u = w.velocity(d.body[1]).linear - w.velocity(d.body[0]).linear;
        a.angular -= d.get("mass") / 6.0 * separation.cross(u);
        a.energy -= d.get("mass") / 12.0 * u.squaredNorm();
        const double longer = separation.norm() - d.get("length");
        if (longer > 0.0) a.energy += 0.5 * d.get("EA") / d.get("length") * longer * longer;
    }
    return a;
}

/// A free wire, 23 kg/m, that spins about z with a wave along it.
struct Free {
    World w;
    WireId wire;
    explicit Free(int elements, double spin = 0.1, int threads = 1)
        : w({.gravity = Vec3::Zero(), .threads = threads}) {
        constexpr double kLength = 200.0;
        const double l = kLength / elements;
        std::vector<BodyId> lumps;
        const auto place = [&](int i) {
            const double s = l * i - 0.5 * kLength;
            return Vec3(s, 0.0, 0.5 * std::sin(2.0 * s / kLength * 6.28));
        };
        for (int i = 0; i <= elements; ++i) {
            BodyDef b{.kind = BodyKind::lump, .position = place(i)};
            b.mass = kDensity * l * (i == 0 || i == elements ? 0.5 : 1.0);
            b.velocity = Vec3(0, 0, spin).cross(b.position) + Vec3(1.0, 2.0, 0.5);
            lumps.push_back(w.add_body(b));
        }
        std::vector<InteractionId> made;
        for (int i = 0; i < elements; ++i) {
            InteractionDef d;
            d.kind = InteractionKind::Stretch;
            d.body = {lumps[static_cast<std::size_t>(i)], lumps[static_cast<std::size_t>(i) + 1]};
            // As long as in steady rotation: T = ρω²(L²/4 − s²)/2.
            const double s = l * (i + 0.5) - 0.5 * kLength;
            const double pull = kDensity * spin * spin * (0.25 * kLength * kLength - s * s) / 2.0;
            d.set("length", (place(i + 1) - place(i)).norm() / (1.0 + pull / kEA));
            d.set("EA", kEA).set("mass", kDensity * l);
            made.push_back(w.add_interaction(d));
        }
        wire = w.wires().adopt("free", made);
    }
};

TEST(WireNodes, PutOnAnElementChangeNoMotion) {
    Free f(20);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(f.w.step(), Status::ok);
    const Account before = account_of(f.w, f.wire);
    const InteractionId element = f.w.wires().elements(f.wire)[7];
    const BodyId node = f.w.wires().insert_node(element, 0.3);
    const Account after = account_of(f.w, f.wire);
    EXPECT_EQ(f.w.wires().elements(f.wire).size(), 21U);
    EXPECT_EQ(f.w.wires().nodes(f.wire)[8], node);
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
    EXPECT_LE((after.linear - before.linear).norm(), 1e-12 * before.linear.norm());
    EXPECT_LE((after.angular - before.angular).norm(), 1e-12 * before.angular.norm());
    EXPECT_NEAR(after.energy, before.energy, 1e-12 * before.energy);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(f.w.step(), Status::ok);
    EXPECT_EQ(f.w.verdict().grade, Grade::good);
}

TEST(WireNodes, TakenAwayAtOnceLeaveNoTrace) {
    Free f(20);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(f.w.step(), Status::ok);
    std::vector<Pose> pose;
    std::vector<Twist> twist;
    for (const BodyId id : f.w.wires().nodes(f.wire)) {
        pose.push_back(f.w.pose(id));
        twist.push_back(f.w.velocity(id));
    }
    const double length = f.w.wires().length(f.wire);
    ASSERT_TRUE(
        f.w.wires().remove_node(f.w.wires().insert_node(f.w.wires().elements(f.wire)[7], 0.3)));
    EXPECT_NEAR(f.w.wires().length(f.wire), length, 1e-12 * length);
    for (std::size_t k = 0; k < pose.size(); ++k) {
        const BodyId id = f.w.wires().nodes(f.wire)[k];
        EXPECT_LE((f.w.pose(id).position - pose[k].position).norm(), 1e-10);
        EXPECT_LE((f.w.velocity(id).linear - twist[k].linear).norm(), 1e-9);
    }
}

/// Random edits of a wire that spins and waves.
struct Sums {
    long in = 0, out = 0, stayed = 0;
    double created = 0.0, lost = 0.0;
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};
void edit(Free& f, std::mt19937& dice, Sums& sum) {
    const auto n = static_cast<int>(f.w.wires().elements(f.wire).size());
    const std::size_t at =
        1 + static_cast<std::size_t>(dice() % 1000U) * static_cast<std::size_t>(n - 2) / 1000;
    const double length = f.w.interaction_def(f.w.wires().elements(f.wire)[at]).get("length");
    const bool more = length > 2.0 && (n <= 24 || (n < 96 && (dice() & 1U) != 0));
    const Account before = account_of(f.w, f.wire);
    if (more) {
        (void)f.w.wires().insert_node(f.w.wires().elements(f.wire)[at], 0.5);
        ++sum.in;
    } else {
        ++(f.w.wires().remove_node(f.w.wires().nodes(f.wire)[at]) ? sum.out : sum.stayed);
    }
    const Account after = account_of(f.w, f.wire);
    const double change = after.energy - before.energy;
    (change > 0.0 ? sum.created : sum.lost) += std::abs(change);
    sum.linear += after.linear - before.linear;
    sum.angular += after.angular - before.angular;
}

TEST(WireNodes, KeepMomentaAndMakeNoEnergy) {
    // The faster it spins, the more angular momentum its steps lose; edits lose none.
    const int edits = by_tier(500, kSanitized ? 500 : 2000, 2000);
    for (const std::uint32_t seed : seeds(7, 1, 2, 25))
        for (const double spin : {0.1, 0.5}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", spin " + std::to_string(spin));
            Free f(24, spin);
            std::mt19937 dice(seed);
            for (int i = 0; i < 30; ++i) ASSERT_EQ(f.w.step(), Status::ok);
            const Account before = account_of(f.w, f.wire);
            Sums sum;
            while (sum.in + sum.out < edits) {
                edit(f, dice, sum);
                ASSERT_EQ(f.w.step(), Status::ok) << sum.in << " in, " << sum.out << " out";
            }
            const Account after = account_of(f.w, f.wire);
            EXPECT_GE(sum.out, 2 * edits / 5);
            EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
            EXPECT_LE((after.linear - before.linear).norm(), 1e-12 * before.linear.norm());
            EXPECT_LE(sum.angular.norm(), 1e-12 * before.angular.norm());
            if (spin < 0.2) {
                EXPECT_LE((after.angular - before.angular).norm(), 3e-4 * before.angular.norm());
            }
            EXPECT_LE(sum.created, 1e-9 * before.energy);
            EXPECT_LE(sum.lost, 5e-3 * before.energy);
            EXPECT_EQ(f.w.verdict().grade, Grade::good);
        }
}

TEST(WireNodes, StayWhereTheWireIsBent) {
    Free f(24);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(f.w.step(), Status::ok);
    const std::uint64_t hash = f.w.state().hash();
    EXPECT_FALSE(f.w.wires().remove_node(f.w.wires().nodes(f.wire)[6], 1e-4));
    EXPECT_EQ(f.w.state().hash(), hash);
    EXPECT_EQ(f.w.wires().elements(f.wire).size(), 24U);
}

TEST(WireNodes, ComeAndGoTheSameOnAnyNumberOfThreads) {
    for (const std::uint32_t seed : seeds(3, 1, 4, 40)) {
        SCOPED_TRACE(seed);
        std::uint64_t hash = 0;
        for (const int threads : {1, 2, 4}) {
            Free f(24, 0.3, threads);
            std::mt19937 dice(seed);
            Sums sum;
            for (int i = 0; i < 200; ++i) {
                edit(f, dice, sum);
                ASSERT_EQ(f.w.step(), Status::ok);
            }
            if (threads == 1) hash = f.w.state().hash();
            EXPECT_EQ(f.w.state().hash(), hash) << threads;
            const auto saved = f.w.state().save();
            for (int i = 0; i < 20; ++i) ASSERT_EQ(f.w.step(), Status::ok);
            const std::uint64_t later = f.w.state().hash();
            f.w.state().restore(saved);
            for (int i = 0; i < 20; ++i) ASSERT_EQ(f.w.step(), Status::ok);
            EXPECT_EQ(f.w.state().hash(), later);
        }
    }
}

/// 100 m under its own weight between two fixed bodies, with bending and capsules.
struct Hung {
    World w;
    WireId wire;
    Hung() {
        WireDef d{.name = "hung"};
        d.from = w.add_body({.name = "from", .kind = BodyKind::fixed});
        d.to =
            w.add_body({.name = "to", .kind = BodyKind::fixed, .position = Vec3(99.0, 0.0, 20.0)});
        d.elements = 20;
        d.length = 103.0;
        d.EA = kEA;
        d.mass_per_length = kDensity;
        d.EI = 1e3;
        d.radius = 0.02;
        d.drag = 20.0;
        d.consistent_mass = true;
        wire = w.wires().add(d);
    }
};

TEST(WireNodes, TakeBendsAndCapsulesWithThem) {
    Hung h;
    for (int i = 0; i < 300; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    const std::size_t interactions = h.w.interactions().size(), shapes = h.w.shapes().size();
    const double length = h.w.wires().length(h.wire);
    std::vector<BodyId> came;
    for (const std::size_t k : {15U, 10U, 5U, 0U})
        came.push_back(h.w.wires().insert_node(h.w.wires().elements(h.wire)[k], 0.5));
    EXPECT_EQ(h.w.interactions().size(), interactions + 8);
    EXPECT_EQ(h.w.shapes().size(), shapes + 4);  // all new elements are between nodes
    for (int i = 0; i < 60; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    for (const BodyId id : came) EXPECT_TRUE(h.w.wires().remove_node(id, 3.2));
    EXPECT_EQ(h.w.interactions().size(), interactions);
    EXPECT_EQ(h.w.shapes().size(), shapes);
    EXPECT_NEAR(h.w.wires().length(h.wire), length, 1e-3);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    EXPECT_EQ(h.w.verdict().grade, Grade::good);
    h.w.wires().remove(h.wire);
    EXPECT_TRUE(h.w.interactions().empty());
    EXPECT_TRUE(h.w.shapes().empty());
}

TEST(WireNodes, LeaveTheTensionOfAWireAtRest) {
    Hung h;
    for (int i = 0; i < 3600; ++i) ASSERT_EQ(h.w.step(), Status::ok);
    const auto pull = [&] { return -h.w.force(h.w.wires().elements(h.wire).back())[0]; };
    const double before = pull();
    BodyId node{};
    for (int edit = 0; edit < 2; ++edit) {
        if (edit == 0)
            node = h.w.wires().insert_node(h.w.wires().elements(h.wire)[16], 0.5);
        else
            EXPECT_TRUE(h.w.wires().remove_node(node, 3.2));
        for (int i = 0; i < 30; ++i) {
            ASSERT_EQ(h.w.step(), Status::ok);
            EXPECT_NEAR(pull(), before, 50.0) << edit << " " << i;
        }
    }
}

/// No moving body beside it could take its momentum.
TEST(WireNodes, GoWhereTheyAreTheOnlyOne) {
    World w({.gravity = Vec3::Zero()});
    const BodyId first = w.add_body({.name = "first", .kind = BodyKind::fixed});
    const BodyId last =
        w.add_body({.name = "last", .kind = BodyKind::fixed, .position = {10, 0, 0}});
    WireDef def{.name = "line", .from = first, .to = last};
    def.elements = 2;
    def.length = 9.99;
    def.EA = kEA;
    def.mass_per_length = kDensity;
    def.consistent_mass = true;
    const WireId wire = w.wires().add(def);
    ASSERT_EQ(w.step(), Status::ok);
    const BodyId lump = w.wires().nodes(wire)[1];
    w.set_velocity(lump, {{0, 0, 0.1}, Vec3::Zero()});
    const double pull = w.wires().tension(wire, 2.0);
    EXPECT_TRUE(w.wires().remove_node(lump, 3.2));
    ASSERT_EQ(w.wires().elements(wire).size(), 1U);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.wires().tension(wire, 2.0), pull, 50.0);  // like in the wire at rest, above
}

TEST(WireNodes, AreRefusedWhereTheyCannotBe) {
    Free f(8);
    const InteractionId element = f.w.wires().elements(f.wire)[3];
    for (const double share : {0.0, 1.0, -0.5, std::nan("")})
        EXPECT_THROW((void)f.w.wires().insert_node(element, share), DefError) << share;
    const BodyId end = f.w.wires().nodes(f.wire)[0], node = f.w.wires().nodes(f.wire)[3];
    EXPECT_THROW((void)f.w.wires().remove_node(end), DefError);
    EXPECT_THROW((void)f.w.wires().remove_node(node, -1.0), DefError);
    InteractionDef held{.kind = InteractionKind::Distance};
    held.body = {node, f.w.add_body({.name = "load",
                                     .position = Vec3(0, 0, -30),
                                     .mass = 1.0,
                                     .inertia = Mat3::Identity()})};
    (void)f.w.add_interaction(held);
    EXPECT_THROW((void)f.w.wires().remove_node(node), DefError);
    InteractionDef plain{.kind = InteractionKind::Stretch};
    plain.body = {f.w.wires().nodes(f.wire)[8],
                  f.w.add_body({.name = "end", .kind = BodyKind::fixed})};
    plain.set("EA", 1e6);
    EXPECT_THROW((void)f.w.wires().insert_node(f.w.add_interaction(plain), 0.5), DefError);
}

}  // namespace
}  // namespace hawser::test
