// SPDX-License-Identifier: Apache-2.0
/// Additions and removals between steps: ids, dependent objects, energy, sleep, equal bits.
#include <hawser/hawser.h>

#include "support/recipe.h"
#include "support/sleep_yard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

BodyDef stone(const std::string& name, double x) {
    return {.name = name, .kind = BodyKind::lump, .position = {x, 0, 0}, .mass = 1.0};
}

InteractionDef rod(BodyId a, BodyId b, const std::string& name = "") {
    InteractionDef d;
    d.name = name;
    d.kind = InteractionKind::Distance;
    d.body = {a, b};
    return d;
}

TEST(Edits, AnIdOfWhatIsGoneNamesNothingElse) {
    World w;
    const BodyId a = w.add_body(stone("a", 0)), b = w.add_body(stone("b", 1)),
                 c = w.add_body(stone("c", 2));
    ASSERT_EQ(w.remove_body(b).bodies, std::vector<BodyId>{b});
    EXPECT_FALSE(w.alive(b));
    EXPECT_FALSE(w.find_body("b").valid());
    EXPECT_EQ(w.bodies().size(), 2U);
    const BodyId d = w.add_body(stone("b", 3));  // the name can be used again
    EXPECT_EQ(d.index, b.index);
    EXPECT_EQ(d.generation, b.generation + 1);
    EXPECT_NE(d, b);
    EXPECT_EQ(w.find_body("b"), d);
    EXPECT_EQ(w.pose(d).position.x(), 3.0);
    for (const auto& refused : std::vector<std::function<void()>>{
             [&] { (void)w.pose(b); }, [&] { w.set_force(b, Vec3::Zero(), Vec3::Zero()); },
             [&] { (void)w.remove_body(b); }, [&] { w.add_interaction(rod(a, b)); },
             [&] { w.add_shape({.kind = ShapeKind::sphere, .body = b, .radius = 0.1}); },
             [&] { w.add_input({.name = "push", .body = b}); }}) {
        EXPECT_THROW(refused(), DefError);
    }
    try {
        (void)w.pose(b);
    } catch (const DefError& e) {
        EXPECT_NE(std::string(e.what()).find("removed"), std::string::npos) << e.what();
    }
    EXPECT_TRUE(w.alive(a));
    EXPECT_TRUE(w.alive(c));
    // Another kind of body does not reuse its slot.
    (void)w.remove_body(d);
    const BodyId drum = w.add_body({.kind = BodyKind::scalar, .mass = 1.0});
    EXPECT_EQ(drum.index, 3);
}

TEST(Edits, WhatHangsOnABodyGoesWithIt) {
    World w;
    const BodyId g = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    const BodyId a = w.add_body(stone("a", 1)), b = w.add_body(stone("b", 2)),
                 c = w.add_body(stone("c", 3));
    const InteractionId ga = w.add_interaction(rod(g, a, "ga")),
                        ab = w.add_interaction(rod(a, b, "ab")),
                        bc = w.add_interaction(rod(b, c, "bc"));
    const ShapeId ball = w.add_shape({.kind = ShapeKind::sphere, .body = b, .radius = 0.1});
    const ShapeId piece =
        w.add_shape({.kind = ShapeKind::capsule, .body = b, .body_b = c, .radius = 0.1});
    const InputId push = w.add_input({.name = "push", .body = b});
    const InputId reel = w.add_input({.name = "reel", .interaction = bc, .param = "length"});
    const InputId stay = w.add_input({.name = "stay", .interaction = ga, .param = "length"});
    ASSERT_EQ(w.step(), Status::ok);
    const Removed& gone = w.remove_body(b);
    EXPECT_EQ(gone.bodies, std::vector<BodyId>{b});
    EXPECT_EQ(gone.interactions, (std::vector<InteractionId>{ab, bc}));
    EXPECT_EQ(gone.shapes, (std::vector<ShapeId>{ball, piece}));
    EXPECT_EQ(gone.inputs, (std::vector<InputId>{push, reel}));
    for (const InteractionId id : {ab, bc}) EXPECT_THROW((void)w.force(id), DefError);
    EXPECT_THROW(w.set_input(reel, 1.0), DefError);
    EXPECT_THROW((void)w.shape_def(piece), DefError);
    EXPECT_FALSE(w.find_interaction("ab").valid());
    EXPECT_FALSE(w.find_input("reel").valid());
    w.set_input(stay, 1.0);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.stats().interactions, 1);
    EXPECT_EQ(w.stats().bodies, 2);
    EXPECT_EQ(w.stats().equations, 3 + 3 + 1);
    // c falls freely: g h per step, twice.
    const double h = w.settings().step;
    const double before = w.velocity(c).linear.z();
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(c).linear.z() - before, -9.81 * h, 1e-12);
}

/// An addition and its removal have no effect except on data that the analysis chooses by the poses
/// of its step. These are floors of rigid rows, a billionth of their mobility, in a chain that
/// whips.
TEST(Edits, WhatCameAndWentChangesNothing) {
    const Recipe chain = link_chain(6);
    World plain = chain.make(), edited = chain.make();
    std::vector<InteractionId> added;
    for (int i = 0; i < 120; ++i) {
        if (i == 30) {
            const BodyId x = edited.add_body(
                {.name = "x", .kind = BodyKind::lump, .position = {100, 0, 0}, .mass = 3.0});
            added.push_back(edited.add_interaction(rod(BodyId{0}, x)));
        }
        if (i == 60) (void)edited.remove_body(edited.find_body("x"));
        ASSERT_EQ(plain.step(), Status::ok);
        ASSERT_EQ(edited.step(), Status::ok);
    }
    for (const BodyId b : plain.bodies())
        EXPECT_LT((plain.pose(b).position - edited.pose(b).position).norm(), 1e-7);
    EXPECT_EQ(edited.stats().equations, plain.stats().equations);
}

/// Energy of additions and removals is counted, so that the balance closes.
TEST(Edits, TheEnergyBalanceClosesOverEdits) {
    World w({.on_diverged = OnDiverged::warn});
    const BodyId g = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    BodyId last = g;
    std::vector<BodyId> node;
    for (int i = 1; i <= 5; ++i) {
        const BodyId b = w.add_body(stone("n" + std::to_string(i), i));
        InteractionDef d;
        d.kind = InteractionKind::Stretch;
        d.body = {last, b};
        w.add_interaction(d.set("EA", 2e4).set("length", 1.0));
        node.push_back(b);
        last = b;
    }
    const auto sum = [&] {
        const Energy e = w.energy();
        return e.mechanical() - e.applied - e.driven - e.edited + e.dissipated + e.damped;
    };
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    const double start = sum();
    const double scale = w.energy().kinetic;
    ASSERT_GT(scale, 10.0);
    (void)w.remove_body(node[4]);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(sum(), start, 2e-3 * scale) << "the last lump";
    BodyDef heavy = stone("heavy", 0);
    heavy.position = w.pose(node[3]).position + Vec3(0, 0, -1);
    heavy.mass = 4.0;
    const BodyId h = w.add_body(heavy);
    InteractionDef d;
    d.kind = InteractionKind::Stretch;
    d.body = {node[3], h};
    (void)w.add_interaction(d.set("EA", 2e4).set("length", 0.98));  // starts stretched
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(sum(), start, 2e-2 * std::max(scale, w.energy().kinetic)) << "a stretched one";
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

TEST(Edits, OnlyWhatAnEditTouchesWakes) {
    WorldDef def;
    def.sleep_after = 0.5;
    SleepYard y(def);
    y.run(600);
    ASSERT_EQ(y.asleep(), "zzzzzzzzz");
    const std::uint64_t hash = y.w.state().hash();
    // Far away, without joints.
    const BodyId far = y.w.add_body(
        {.name = "far", .kind = BodyKind::lump, .position = {500, 0, 50}, .mass = 1.0});
    ASSERT_EQ(y.w.step(), Status::ok);
    EXPECT_EQ(y.asleep().substr(0, 9), "zzzzzzzzz");
    EXPECT_NE(y.w.state().hash(), hash);
    (void)y.w.remove_body(far);
    ASSERT_EQ(y.w.step(), Status::ok);
    EXPECT_EQ(y.asleep().substr(0, 9), "zzzzzzzzz");
}

/// A new shape wakes bodies that are near now, not those that were near before the last step: a
/// twin has no data of that step.
TEST(Edits, WhatIsNearDoesNotDependOnStepsBefore) {
    WorldDef def;
    def.sleep_after = 0.2;
    World w(def);
    const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    w.add_body({.name = "sleeper",
                .kind = BodyKind::lump,
                .position = {0, 50, 0},
                .mass = 1.0,
                .gravity = false});
    for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_TRUE(w.asleep(w.find_body("sleeper")));
    const double slow = 0.5 * def.sleep_speed, radius = 0.1;
    BodyDef drifting{.name = "drifting", .kind = BodyKind::lump, .mass = 1.0, .gravity = false};
    drifting.velocity = {slow, 0, 0};
    const BodyId body = w.add_body(drifting);
    w.add_shape({.kind = ShapeKind::sphere, .body = body, .radius = radius});
    for (int i = 0; i < 5; ++i) ASSERT_EQ(w.step(), Status::ok);
    // Contact positions of the boxes, some steps before and after.
    const double way = slow * def.step,
                 meets = w.pose(body).position.x() + way + 2.0 * radius + def.contact_margin;
    for (int k = -10; k <= 10; ++k) {
        World a = w.twin(), b = w.twin();
        ASSERT_EQ(a.step(), Status::ok);
        b.state().restore(a.state().save());
        for (World* world : {&a, &b})
            world->add_shape({.kind = ShapeKind::sphere,
                              .body = ground,
                              .position = {meets + 0.2 * k * way, 0, 0},
                              .radius = radius});
        EXPECT_EQ(a.state().save(), b.state().save()) << k;
    }
}

/// Repeated additions and removals reuse their memory, and the order of elimination is repaired,
/// not made again.
TEST(Edits, GrowNothingOnceWarm) {
    World w = wire(120).make();
    for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
    const BodyId end = w.bodies().back();
    StepStats before;
    for (int round = 0; round < 40; ++round) {
        if (round == 5) before = w.stats();
        BodyDef def = stone("x", 0);
        def.position = w.pose(end).position - Vec3(0, 0, 1);
        const BodyId x = w.add_body(def);
        (void)w.add_interaction(rod(end, x));
        (void)w.add_shape({.kind = ShapeKind::sphere, .body = x, .radius = 0.1});
        ASSERT_EQ(w.step(), Status::ok);
        (void)w.remove_body(x);
        ASSERT_EQ(w.step(), Status::ok);
    }
    EXPECT_EQ(w.stats().growths, before.growths);
    EXPECT_EQ(w.stats().plans, before.plans);
    EXPECT_GE(w.stats().repairs, before.repairs + 70);
}

}  // namespace
}  // namespace hawser::test
