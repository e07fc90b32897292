// SPDX-License-Identifier: Apache-2.0
/// Shapes and materials of a world: rejected ones, their contacts, snapshots.
#include "support/random.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <functional>
#include <limits>

namespace hawser::test {
namespace {

std::string refusal(const std::function<void()>& f) {
    try {
        f();
    } catch (const DefError& e) {
        return e.what();
    }
    return "";
}

BodyDef node_at(const Vec3& x) {
    BodyDef d;
    d.kind = BodyKind::lump;
    d.position = x;
    d.mass = 2.0;
    return d;
}

/// Make a wire of point masses that falls past a plane to which it is drawn, with a ball. At most
/// 14 contacts.
World falling_wire(int threads = 1) {
    WorldDef def;
    def.threads = threads;
    World w(def);
    BodyDef ground;
    ground.name = "ground";
    ground.kind = BodyKind::fixed;
    const BodyId g = w.add_body(ground);
    MaterialDef steel;
    steel.name = "steel";
    steel.friction = 0.2;
    ShapeDef plane;
    plane.name = "floor";
    plane.kind = ShapeKind::plane;
    plane.body = g;
    plane.material = w.add_material(steel);
    w.add_shape(plane);
    BodyId last{};
    for (int i = 0; i < 12; ++i) {
        const BodyId now = w.add_body(node_at({1.0 * i, 0.0, 0.052 + 0.001 * i}));
        if (last.valid()) {
            InteractionDef line{.kind = InteractionKind::Distance, .body = {last, now}};
            w.add_interaction(line.set("length", 1.0));
            ShapeDef s;
            s.kind = ShapeKind::capsule;
            s.body = last;
            s.body_b = now;
            s.radius = 0.05;
            w.add_shape(s);
        }
        last = now;
    }
    return w;
}

TEST(Shapes, FindsThemByName) {
    World w = falling_wire();
    EXPECT_EQ(w.shape_count(), 12);
    EXPECT_EQ(w.find_shape("floor").index, 0);
    EXPECT_FALSE(w.find_shape("roof").valid());
    EXPECT_EQ(w.shape_def(w.find_shape("floor")).kind, ShapeKind::plane);
    EXPECT_EQ(w.material_count(), 2);
    EXPECT_EQ(w.find_material("default").index, 0);
    EXPECT_EQ(w.material_def(w.find_material("steel")).friction, 0.2);
    EXPECT_NE(refusal([&] { (void)w.shape_def(ShapeId{12}); }), "");
    EXPECT_NE(refusal([&] { (void)w.material_def(MaterialId{}); }), "");
}

TEST(Shapes, RefusesWhatMakesNoSense) {
    World w;
    const BodyId lump = w.add_body(node_at({0, 0, 0})), other = w.add_body(node_at({1, 0, 0}));
    BodyDef b;
    b.mass = 1.0;
    b.inertia = Mat3::Identity();
    const BodyId rigid = w.add_body(b);
    b.kind = BodyKind::scalar;
    const BodyId drum = w.add_body(b);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto why = [&](const std::function<void(ShapeDef&)>& change) {
        ShapeDef d;
        d.name = "s";
        d.kind = ShapeKind::box;
        d.body = rigid;
        d.half_size = {1, 1, 1};
        change(d);
        return refusal([&] { w.add_shape(d); });
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.body = BodyId{}; }), "body does not exist"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) { d.body = drum; }), "scalar"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) { d.body = lump; }), "orientation"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) { d.body_b = lump; }), "capsule"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) {
                        d.kind = ShapeKind::capsule;
                        d.radius = 1.0;
                        d.body = lump;
                        d.body_b = drum;
                    }),
                    "a body that is not scalar"));
    b.kind = BodyKind::rigid;
    b.position = {5, 0, 0};
    const BodyId second = w.add_body(b);
    EXPECT_TRUE(has(why([&](ShapeDef& d) {
                        d.kind = ShapeKind::capsule;
                        d.radius = 1.0;
                        d.body_b = second;
                    }),
                    "a node on one side"));
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.half_size[1] = 0.0; }), "half_size"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) { d.half_size[1] = nan; }), "half_size"));
    EXPECT_TRUE(has(why([&](ShapeDef& d) { d.position[1] = nan; }), "position"));
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.orientation = Quat(0, 0, 0, 0); }), "orientation"));
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.material = MaterialId{7}; }), "material"));
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.kind = ShapeKind::sphere; }), "radius"));
    EXPECT_TRUE(has(why([](ShapeDef& d) { d.kind = ShapeKind::hull; }), "4,096"));
    EXPECT_TRUE(
        has(why([](ShapeDef& d) { d.kind = ShapeKind::mesh; }), "a fixed or kinematic body"));
    EXPECT_TRUE(has(why([](ShapeDef& d) {
                        d.kind = ShapeKind::heightfield;
                        d.rows = d.columns = 2;
                        d.cell = {1.0, 1.0};
                        d.heights = {0.0, 0.0, 0.0};
                    }),
                    "3 heights"));
    EXPECT_EQ(w.shape_count(), 0);
    EXPECT_EQ(why([](ShapeDef&) {}), "");
    EXPECT_TRUE(has(why([](ShapeDef&) {}), "name is in use"));
    EXPECT_EQ(w.shape_count(), 1);
    ShapeDef segment;
    segment.kind = ShapeKind::capsule;
    segment.body = lump;
    segment.body_b = other;
    segment.radius = 0.1;
    EXPECT_EQ(refusal([&] { w.add_shape(segment); }), "");
    MaterialDef m;
    EXPECT_TRUE(has(refusal([&] { w.add_material(m); }), "name"));
    m.name = "default";
    EXPECT_TRUE(has(refusal([&] { w.add_material(m); }), "name is in use"));
    m.name = "ice";
    m.friction = -0.1;
    EXPECT_TRUE(has(refusal([&] { w.add_material(m); }), "friction"));
    MaterialPairDef pair;
    pair.a = pair.b = MaterialId{0};
    EXPECT_EQ(refusal([&] { w.add_material_pair(pair); }), "");
    pair.values.restitution = 1.5;
    EXPECT_TRUE(has(refusal([&] { w.add_material_pair(pair); }), "restitution"));
    pair.a = MaterialId{4};
    EXPECT_TRUE(has(refusal([&] { w.add_material_pair(pair); }), "does not exist"));
    WorldDef def;
    def.contact_margin = 0.0;
    EXPECT_TRUE(has(refusal([&] { World{def}; }), "contact_margin"));
}

TEST(Shapes, ContactsAreSeenFromOutside) {
    World w = falling_wire();
    EXPECT_TRUE(w.contacts().empty());
    ASSERT_EQ(w.step(), Status::ok);
    const auto contacts = w.contacts();
    ASSERT_EQ(contacts.size(), 12U);
    EXPECT_EQ(w.stats().contacts, 12);
    for (const ContactView& c : contacts) {
        EXPECT_EQ(c.shape[0].index, 0);
        EXPECT_EQ(c.normal, Vec3::UnitZ());
        // Each is on its side of the gap; the first is at 2 mm.
        EXPECT_GT(c.gap, 0.0);
        EXPECT_LT(c.gap, 0.02);
    }
    EXPECT_GT(w.stats().stage_seconds[static_cast<std::size_t>(Stage::collide)], 0.0);
}

TEST(Shapes, AWorldGoesOnBitForBitAfterRestore) {
    World a = falling_wire();
    for (int i = 0; i < 3; ++i) ASSERT_EQ(a.step(), Status::ok);
    const auto saved = a.state().save();
    const std::uint64_t hash = a.state().hash();
    World b = falling_wire(2);
    // Other contacts than when saved.
    ASSERT_EQ(b.step(), Status::ok);
    EXPECT_NE(b.state().hash(), hash);
    b.state().restore(saved);
    EXPECT_EQ(b.state().hash(), hash);
    EXPECT_TRUE(b.contacts().empty());
    EXPECT_EQ(b.state().save(), saved);
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(b.step(), Status::ok);
        ASSERT_EQ(a.state().hash(), b.state().hash()) << i;
        ASSERT_EQ(a.contacts().size(), b.contacts().size());
    }
    // Back in time, to another number of contacts.
    a.state().restore(saved);
    EXPECT_EQ(a.state().hash(), hash);
}

TEST(Shapes, ASnapshotOfOtherShapesIsRefused) {
    World a = falling_wire();
    ASSERT_EQ(a.step(), Status::ok);
    auto saved = a.state().save();
    World b = falling_wire();
    ShapeDef ball;
    ball.kind = ShapeKind::sphere;
    ball.body = BodyId{3};
    ball.radius = 0.2;
    b.add_shape(ball);
    EXPECT_NE(refusal([&] { b.state().restore(saved); }), "");
    World c = falling_wire();
    MaterialPairDef pair;
    pair.a = pair.b = MaterialId{0};
    c.add_material_pair(pair);
    EXPECT_NE(refusal([&] { c.state().restore(saved); }), "");
    // A count of contacts that exceeds the bytes.
    for (const std::size_t at : {24U, 30U}) {
        auto damaged = saved;
        damaged[at] ^= std::byte{0x55};
        EXPECT_NE(refusal([&] { a.state().restore(damaged); }), "");
    }
}

TEST(Shapes, MayBeAddedBetweenSteps) {
    World w = falling_wire();
    ASSERT_EQ(w.step(), Status::ok);
    ShapeDef ball;
    ball.kind = ShapeKind::sphere;
    ball.body = BodyId{12};
    ball.radius = 0.06;
    w.add_shape(ball);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.contacts().size(), 13U);
}

}  // namespace
}  // namespace hawser::test
