// SPDX-License-Identifier: Apache-2.0
/// Stage collide: pairs, their order, and their memory.
#include "collide/site.h"
#include "collide/touch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace hawser::test {
namespace {

using collide::Contact;

std::vector<Vec3> line(int count, const Vec3& from, const Vec3& step) {
    std::vector<Vec3> nodes;
    for (int i = 0; i < count; ++i) nodes.push_back(from + i * step);
    return nodes;
}

bool ascending(const std::vector<Contact>& c) {
    for (std::size_t i = 1; i < c.size(); ++i) {
        const auto key = [](const Contact& x) {
            return std::tuple(x.shape[0], x.shape[1], x.feature);
        };
        if (!(key(c[i - 1]) < key(c[i]))) return false;
    }
    return true;
}

TEST(Collider, AWireOnAPlaneTouchesOncePerLump) {
    Site site;
    site.shape(ShapeKind::plane, site.body(BodyKind::fixed, Vec3::Zero()));
    site.wire(line(11, {0, 0, 0.049}, {1, 0, 0}), 0.05);
    site.prepare();
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 11U);
    EXPECT_TRUE(ascending(site.set.contacts));
    std::vector<int> seen(11, 0);
    for (const Contact& c : site.set.contacts) {
        EXPECT_EQ(c.slots, 2);
        EXPECT_EQ(c.side_0, 1);
        EXPECT_EQ(c.body[0], 0);
        EXPECT_EQ(c.weight[1], 1.0);
        EXPECT_EQ(c.body[2], -1);
        ++seen[static_cast<std::size_t>(c.body[1] - 1)];
        EXPECT_NEAR(c.gap, -0.001, 1e-15);  // rounding of coordinates near 0.05
        EXPECT_EQ(c.normal[2], 1.0);
    }
    for (const int n : seen) EXPECT_EQ(n, 1);
}

/// Positions and velocities of a diverging motion or a forged snapshot have no valid sort key and
/// no valid strip.
TEST(Collider, BodiesBeyondAllNumbersAreSaidAndSorted) {
    for (const double far : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e200}) {
        Site site;
        for (int i = 0; i < 40; ++i)
            site.shape(ShapeKind::sphere, site.body(BodyKind::rigid, {0.3 * i, 0.0, 0.0}));
        site.prepare();
        ASSERT_TRUE(site.collide());
        EXPECT_TRUE(site.collider.finite());
        const std::size_t before = site.set.contacts.size();
        for (const std::size_t entry : {std::size_t{3 * 7}, std::size_t{3 * 21 + 1}}) {
            double& x = site.bodies.x[entry];
            const double kept = x;
            x = far;
            EXPECT_FALSE(site.collide()) << far;
            EXPECT_FALSE(site.collider.finite());
            EXPECT_EQ(site.collider.limit_reached().bound, Bound::none);
            EXPECT_TRUE(site.set.contacts.empty());
            x = kept;
        }
        if (!std::isnan(far)) {  // the step itself rejects NaN, and no box is made
            site.bodies.v[2] = far;
            EXPECT_FALSE(site.collide()) << far;
            site.bodies.v[2] = 0.0;
        }
        ASSERT_TRUE(site.collide());
        EXPECT_TRUE(site.collider.finite());
        EXPECT_EQ(site.set.contacts.size(), before);
    }
}

TEST(Collider, WireOnWireSharesTheForceAmongFourLumps) {
    Site site;
    site.wire({{-1, 0, 0}, {3, 0, 0}}, 0.05);
    site.wire({{0, -3, 0.101}, {0, 1, 0.101}}, 0.05);
    site.prepare();
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 1U);
    const Contact& c = site.set.contacts[0];
    ASSERT_EQ(c.slots, 4);
    ASSERT_EQ(c.side_0, 2);
    const double expected[4] = {0.75, 0.25, 0.25, 0.75};
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(c.body[i], i);
        EXPECT_NEAR(c.weight[i], expected[i], 1e-14);
    }
    EXPECT_EQ(c.weight[0] + c.weight[1], 1.0);
    EXPECT_NEAR(c.gap, 0.001, 1e-15);
    EXPECT_NEAR(c.normal[2], 1.0, 1e-15);
}

TEST(Collider, AWireThatCrossesAnotherAtALumpTouchesOnce) {
    Site site;
    site.wire(line(5, {-2, 0, 0}, {1, 0, 0}), 0.05);
    site.wire(line(5, {0, -2, 0.1}, {0, 1, 0}), 0.05);
    site.prepare();
    ASSERT_TRUE(site.collide());
    // Four pairs of segments meet at the two middle nodes; one of them owns both.
    ASSERT_EQ(site.set.contacts.size(), 1U);
    EXPECT_EQ(site.set.contacts[0].slots, 2);
    EXPECT_EQ(site.set.contacts[0].body[0], 2);
    EXPECT_EQ(site.set.contacts[0].body[1], 7);
}

TEST(Collider, NeighboursAlongAWireDoNotTouch) {
    Site site;
    // A zigzag so tight that all segments overlap.
    std::vector<Vec3> nodes;
    for (int i = 0; i < 6; ++i) nodes.push_back({i % 2 == 0 ? 0.0 : 1.0, 0.0, 0.01 * i});
    site.wire(nodes, 0.1);
    site.prepare();
    ASSERT_TRUE(site.collide());
    std::vector<std::pair<int, int>> pairs;
    for (const Contact& c : site.set.contacts) {
        EXPECT_GT(c.shape[1] - c.shape[0], 2);
        pairs.emplace_back(c.shape[0], c.shape[1]);
    }
    // Pairs of the five segments that are at least three apart: 0-3, 0-4 and 1-4.
    EXPECT_GE(pairs.size(), 3U);
}

TEST(Collider, LeavesOutOneBodyJointsAndWhatCannotMove) {
    Site site;
    const auto fixed = site.body(BodyKind::fixed, {0, 0, 0});
    const auto carrier = site.body(BodyKind::kinematic, {0, 0, 0});
    const auto a = site.body(BodyKind::rigid, {0, 0, 0}), b = site.body(BodyKind::rigid, {0, 0, 0});
    const auto c = site.body(BodyKind::rigid, {0, 0, 0});
    for (const auto body : {fixed, carrier, a, a, b, c}) site.shape(ShapeKind::sphere, body, 1.0);
    InteractionDef hinge{.kind = InteractionKind::Hinge, .body = {BodyId{a}, BodyId{b}}};
    InteractionDef line{.kind = InteractionKind::Distance, .body = {BodyId{b}, BodyId{c}}};
    for (const InteractionDef& def : {hinge, line}) site.interactions.add(def, site.bodies, site.h);
    // Separate the bodies, so that normals exist.
    site.move(carrier, {0.1, 0, 0});
    site.move(a, {0, 0.1, 0});
    site.move(b, {0, 0, 0.1});
    site.move(c, {0.1, 0.1, 0});
    site.prepare();
    ASSERT_TRUE(site.collide());
    std::vector<std::pair<int, int>> pairs;
    for (const Contact& p : site.set.contacts) pairs.emplace_back(p.shape[0], p.shape[1]);
    const std::vector<std::pair<int, int>> expected = {
        {0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 2}, {1, 3}, {1, 4}, {1, 5}, {2, 5}, {3, 5}, {4, 5}};
    EXPECT_EQ(pairs, expected);
}

TEST(Collider, GroupsMustMeetBothWays) {
    struct Case {
        std::uint32_t group[2], touches[2];
        bool meet;
    };
    for (const Case& t : {Case{{1, 1}, {~0U, ~0U}, true}, Case{{1, 2}, {2, 1}, true},
                          Case{{1, 2}, {2, 2}, false}, Case{{1, 2}, {1, 1}, false},
                          Case{{4, 6}, {2, 12}, true}, Case{{0, 1}, {~0U, ~0U}, false}}) {
        Site site;
        for (std::size_t i = 0; i < 2; ++i) {
            ShapeDef d;
            d.body = BodyId{site.lump({0.0, 0.0, 0.15 * static_cast<double>(i)})};
            d.radius = 0.1;
            d.group = t.group[i];
            d.touches = t.touches[i];
            site.collider.add(d, site.bodies);
        }
        site.prepare();
        ASSERT_TRUE(site.collide());
        EXPECT_EQ(!site.set.contacts.empty(), t.meet);
    }
}

TEST(Collider, AFastWireDoesNotPassThroughAThinOne) {
    for (const double speed : {5.0, 50.0, 300.0}) {
        Site site;
        site.wire({{-1, 0, 0}, {1, 0, 0}}, 0.005);
        const auto fast = site.wire({{0, -1, 0}, {0, 1, 0}}, 0.005, {0, 0, -speed});
        const double travel = speed * site.h;
        // From just within the reach of the next step to the surface.
        for (const double share : {0.999, 0.5, 0.0}) {
            for (const std::int32_t b : {2, 3})
                site.bodies.x[static_cast<std::size_t>(3 * b + 2)] = 0.01 + share * travel;
            site.prepare();
            ASSERT_TRUE(site.collide());
            ASSERT_EQ(site.set.contacts.size(), 1U) << speed << " m/s, " << share;
            EXPECT_EQ(site.set.contacts[0].shape[1], fast);
            EXPECT_NEAR(site.set.contacts[0].gap, share * travel, 1e-12);
        }
        // Moving away, it needs no row.
        site.bodies.x[8] = site.bodies.x[11] = 0.01 + 0.03;
        site.bodies.v[8] = site.bodies.v[11] = speed;
        ASSERT_TRUE(site.collide());
        EXPECT_TRUE(site.set.contacts.empty());
    }
}

TEST(Collider, ALongBoomThatTurnsReachesAheadOfItsTip) {
    Site site;
    const auto boom = site.body(BodyKind::rigid, {0, 0, 0}, Vec3::Zero(), {0, 0, 2.0});
    ShapeDef d;
    d.kind = ShapeKind::capsule;
    d.body = BodyId{boom};
    d.radius = 0.1;
    d.half_length = 30.0;
    d.orientation = Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()));
    site.collider.add(d, site.bodies);
    // The tip moves 1 m in a step; the sphere is 0.6 m ahead of it.
    ShapeDef ball;
    ball.body = BodyId{site.lump({29.0, 0.8, 0.0})};
    ball.radius = 0.1;
    site.collider.add(ball, site.bodies);
    site.prepare();
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 1U);
    EXPECT_NEAR(site.set.contacts[0].gap, 0.6, 1e-9);
    // With the opposite spin the tip moves away from the sphere.
    site.bodies.v[5] = -2.0;
    ASSERT_TRUE(site.collide());
    EXPECT_TRUE(site.set.contacts.empty());
}

TEST(Collider, NothingIsInContactAcrossTheMarginOnAMovingDeck) {
    // A ship under way carries its wires along: only relative velocity counts.
    Site site;
    const auto ship = site.body(BodyKind::rigid, {0, 0, 0}, {8, 0, 0});
    site.shape(ShapeKind::plane, ship);
    site.wire(line(4, {0, 0, 0.10}, {1, 0, 0}), 0.05, {8, 0, 0});
    site.prepare();
    ASSERT_TRUE(site.collide());
    EXPECT_TRUE(site.set.contacts.empty());
    site.collider.margin = 0.06;
    site.prepare();
    ASSERT_TRUE(site.collide());
    EXPECT_EQ(site.set.contacts.size(), 4U);
}

TEST(Collider, APartedLineTouchesNothing) {
    Site site;
    site.shape(ShapeKind::plane, site.body(BodyKind::fixed, Vec3::Zero()));
    site.wire(line(5, {0, 0, 0.05}, {1, 0, 0}), 0.05);
    for (int i = 0; i < 4; ++i) {
        InteractionDef d{.kind = InteractionKind::Stretch, .body = {BodyId{i + 2}, BodyId{i + 1}}};
        d.set("length", 1.0);
        d.set("EA", 1e6);
        site.interactions.add(d, site.bodies, site.h);
    }
    site.prepare();
    ASSERT_TRUE(site.collide());
    EXPECT_EQ(site.set.contacts.size(), 5U);
    // Break the two in the middle: the outer nodes of the outer segments remain, and the inner
    // ones.
    site.interactions.parted[1] = site.interactions.parted[2] = 1;
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 4U);
    for (const Contact& c : site.set.contacts) {
        EXPECT_NE(c.body[1], 3);
        EXPECT_TRUE(c.shape[1] == 1 || c.shape[1] == 4);
    }
}

TEST(Collider, ContactsRememberWhoTheyWere) {
    Site site;
    site.shape(ShapeKind::plane, site.body(BodyKind::fixed, Vec3::Zero()));
    site.wire(line(6, {0, 0, 0.05}, {1, 0, 0}), 0.05);
    site.prepare();
    ASSERT_TRUE(site.collide());
    for (const Contact& c : site.set.contacts) EXPECT_EQ(c.previous, -1);
    // A failed step is repeated: its contacts still have no previous impulse.
    ASSERT_TRUE(site.collide());
    for (const Contact& c : site.set.contacts) EXPECT_EQ(c.previous, -1);
    site.collider.keep();
    ASSERT_TRUE(site.collide());
    for (std::size_t i = 0; i < site.set.contacts.size(); ++i)
        EXPECT_EQ(site.set.contacts[i].previous, static_cast<int>(i));
    // Lift node 3 off. The others keep their previous contacts, and node 3 returns without one.
    site.collider.keep();
    site.move(3, {0, 0, 1});
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 5U);
    const int expected[5] = {0, 1, 3, 4, 5};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(site.set.contacts[i].previous, expected[i]);
    site.collider.keep();
    site.move(3, {0, 0, -1});
    ASSERT_TRUE(site.collide());
    ASSERT_EQ(site.set.contacts.size(), 6U);
    EXPECT_EQ(site.set.contacts[2].previous, -1);
    EXPECT_EQ(site.set.contacts[3].previous, 2);
}

TEST(Collider, MemoryOutlivesAChangeOfFeature) {
    std::vector<Contact> contacts(3);
    base::Array<collide::KeptContact> now(3), last(3);
    for (std::size_t i = 0; i < 3; ++i) {
        contacts[i].shape[0] = 1;
        contacts[i].shape[1] = 2;
        contacts[i].previous = -1;
        now[i] = {{1, 2}, static_cast<std::uint32_t>(i), 0, {0.1 * static_cast<double>(i), 0, 0}};
        last[i] = {{1, 2},
                   static_cast<std::uint32_t>(10 + i),
                   0,
                   {0.1 * static_cast<double>(2 - i) + 0.001, 0, 0}};
    }
    last[0].feature = 1;  // has the key of a contact at another place
    base::Array<std::uint8_t> taken;
    collide::match(contacts, now, last, last.size(), 0.01, taken);
    EXPECT_EQ(contacts[1].previous, 0);
    EXPECT_EQ(contacts[0].previous, 2);
    EXPECT_EQ(contacts[2].previous, -1);  // the neighbour is assigned already, the next one is too
                                          // far
}

TEST(Collider, MixesMaterials) {
    collide::Materials m;
    MaterialDef steel;
    steel.name = "steel";
    steel.friction = 0.25;
    steel.restitution = 0.3;
    steel.stiffness = 4e8;
    steel.tangential = 0.5;
    steel.damping_time = 0.01;
    steel.rolling = 0.04;
    MaterialDef mud = steel;
    mud.friction = 1.0;
    mud.restitution = 0.0;
    mud.stiffness = 1e6;
    mud.tangential = 1.0;
    mud.damping_time = std::nan("");
    mud.rolling = 0.01;
    mud.torsional = 0.5;
    const auto s = m.add(steel), d = m.add(mud);
    MaterialPairDef pair;
    pair.a = MaterialId{d};
    pair.b = MaterialId{0};
    pair.values.friction = 0.9;
    pair.values.stiffness = 5e5;
    m.add_pair(pair);
    std::vector<collide::Surface> out;
    const double h = 0.02;
    m.surfaces(h, out);
    ASSERT_EQ(out.size(), 6U);
    const auto& mixed = out[static_cast<std::size_t>(m.surface(d, s))];
    EXPECT_EQ(m.surface(d, s), m.surface(s, d));
    EXPECT_DOUBLE_EQ(mixed.friction, 0.5);
    EXPECT_DOUBLE_EQ(mixed.restitution, 0.3);
    EXPECT_DOUBLE_EQ(mixed.compliance, 1.0 / 4e8 + 1.0 / 1e6);
    EXPECT_DOUBLE_EQ(mixed.tangential_compliance, 1.0 / 2e8 + 1.0 / 1e6);
    EXPECT_DOUBLE_EQ(mixed.damping_time, 2.0 * h);
    EXPECT_DOUBLE_EQ(mixed.rolling, 0.02);
    EXPECT_DOUBLE_EQ(mixed.torsional, 0.0);
    const auto& given = out[static_cast<std::size_t>(m.surface(0, d))];
    EXPECT_DOUBLE_EQ(given.friction, 0.9);
    EXPECT_DOUBLE_EQ(given.compliance, 1.0 / 5e5);
    EXPECT_DOUBLE_EQ(out[0].compliance, 2.0 / 1e8);
}

TEST(Collider, ReducesWhatHasOneNormalToFour) {
    collide::Manifold m;
    for (int i = 0; i < 8; ++i) {
        auto& p = m.point[m.count++];
        p = {};
        // A square of four corners and the middles of its sides; one corner is deepest.
        const double x[8] = {-1, 0, 1, 1, 1, 0, -1, -1}, y[8] = {-1, -1, -1, 0, 1, 1, 1, 0};
        p.on[0][0] = p.on[1][0] = x[i];
        p.on[0][1] = p.on[1][1] = y[i];
        p.normal[2] = 1.0;
        p.gap = i == 4 ? -0.02 : -0.01;
        p.feature = static_cast<std::uint32_t>(i);
    }
    collide::Manifold mixed = m;
    collide::reduce(m);
    ASSERT_EQ(m.count, 4);
    const std::uint32_t corners[4] = {0, 2, 4, 6};
    for (int i = 0; i < 4; ++i) EXPECT_EQ(m.point[i].feature, corners[i]);
    // With a wall: contacts of another normal are not compared with the floor.
    for (const int i : {3, 7}) {
        mixed.point[i].normal[2] = 0.0;
        mixed.point[i].normal[0] = 1.0;
    }
    collide::reduce(mixed);
    EXPECT_EQ(mixed.count, 6);
}

}  // namespace
}  // namespace hawser::test
