// SPDX-License-Identifier: Apache-2.0
/// Allocation fails anywhere: every request of every call fails once. The state is unchanged, and
/// the repeated call gives the bits of a world without failures.
#include "machine/retry.h"
#include "support/recipe.h"
#include "support/sleep_yard.h"
#include "support/yard.h"
#include "world/three_cables.h"

#include <hawser/experimental/splits.h>

#include <optional>

namespace hawser::test {
namespace {

/// Set up a world call by call, then step.
void build(Retry& retry, std::optional<World>& out, const WorldDef& def, const Recipe& recipe) {
    for (long n = 0;; ++n) {
        const failing::Memory memory(n);
        try {
            out.emplace(def);
            break;
        } catch (const std::bad_alloc&) {
            continue;  // repeats with one request more
        }
    }
    World& w = *out;
    for (const BodyDef& b : recipe.bodies)
        retry.call(w, "add_body", throwing([&](World& to) { to.add_body(b); }));
    for (const InteractionDef& i : recipe.interactions)
        retry.call(w, "add_interaction", throwing([&](World& to) { to.add_interaction(i); }));
}

void steps(Retry& retry, World& w, int count, bool saves = true) {
    for (int i = 0; i < count; ++i) retry.call(w, "step", step_once, saves && i > 0);
}

TEST(MemoryEnds, InWorldsOfJointsAndWires) {
    for (const int threads : {1, 2})
        for (std::uint64_t seed = 1; seed <= 2; ++seed)
            expect_same_bits("joints and wires", [&](Retry& retry) {
                const Recipe recipe = mixed(seed);
                WorldDef def = recipe.world;
                def.threads = threads;
                std::optional<World> w;
                build(retry, w, def, recipe);
                steps(retry, *w, 4);
                // Add more of each kind between steps: the analysis is repaired.
                BodyDef more = recipe.bodies[1];
                more.name = "a body with a name that is longer than a short string";
                retry.call(*w, "add_body", throwing([&](World& to) { to.add_body(more); }));
                InteractionDef line =
                    between(InteractionKind::Stretch, {BodyId{1}, BodyId{w->body_count() - 1}});
                line.name = "a line with a name that is longer than a short string";
                line.set("EA", 1e4).set("length", 2.0);
                retry.call(*w, "add_interaction",
                           throwing([&](World& to) { to.add_interaction(line); }));
                InputDef input{.name = "an input with a name that is longer than a short string",
                               .interaction = w->find_interaction(line.name),
                               .param = "length",
                               .body = {},
                               .component = 0,
                               .min = 0.1,
                               .max = 5.0};
                retry.call(*w, "add_input", throwing([&](World& to) { to.add_input(input); }));
                retry.call(*w, "set_input",
                           throwing([](World& to) { to.set_input(InputId{0}, 1.5); }));
                retry.call(*w, "prepare", throwing([](World& to) { to.prepare(); }));
                steps(retry, *w, 3);
                retry.call(*w, "take_events",
                           throwing([](World& to) { (void)to.events().take(); }));
            });
}

/// Add boxes and balls that fall, bounce and roll, with every kind of shape.
void fill(Retry& retry, World& w) {
    const auto add = [&](const BodyDef& body, ShapeDef shape, MaterialId material) {
        retry.call(w, "add_body", throwing([&](World& to) { to.add_body(body); }));
        shape.body = BodyId{w.body_count() - 1};
        shape.material = material;
        retry.call(w, "add_shape", throwing([&](World& to) { to.add_shape(shape); }));
    };
    MaterialDef felt;
    felt.name = "felt";
    felt.restitution = 0.5;
    felt.rolling = 0.01;
    retry.call(w, "add_material", throwing([&](World& to) { to.add_material(felt); }));
    const MaterialId bouncy{1};
    MaterialPairDef pair;
    pair.a = MaterialId{0};
    pair.b = bouncy;
    pair.values.friction = 0.3;
    retry.call(w, "add_material_pair", throwing([&](World& to) { to.add_material_pair(pair); }));
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    add(ground, plane, MaterialId{0});
    const ShapeKind kinds[] = {ShapeKind::box, ShapeKind::sphere, ShapeKind::capsule,
                               ShapeKind::cylinder, ShapeKind::hull};
    for (int i = 0; i < 5; ++i) {
        BodyDef body;
        body.mass = 10.0;
        body.inertia = Mat3::Identity();
        body.position = {0.3 * i, 0.02 * i, 0.6 + 1.15 * i};
        add(body, shape_of(kinds[i], 0.5), i == 1 ? bouncy : MaterialId{0});
    }
}

TEST(MemoryEnds, WhereShapesTouch) {
    for (const Nonsmooth method : {Nonsmooth::newton, Nonsmooth::split, Nonsmooth::pgs})
        expect_same_bits("contacts", [&](Retry& retry) {
            WorldDef def;
            def.nonsmooth = method;
            World w(def);
            if (method == Nonsmooth::newton) {
                fill(retry, w);
            } else {
                Yard yard(def);
                yard.plane(yard.fixed());
                for (int i = 0; i < 3; ++i)
                    yard.box({0.1 * i, 0, 0.55 + 1.1 * i}, 10.0, {.5, .5, .5});
                w = std::move(yard.world);
            }
            steps(retry, w, 45);
        });
}

TEST(MemoryEnds, WhereIslandsFallAsleepAndWake) {
    expect_same_bits("sleep", [](Retry& retry) {
        WorldDef def;
        def.sleep_after = 0.2;
        def.sleep_speed = 1e-2;
        SleepYard yard(def);
        std::string seen;
        for (int i = 0; i < 160; ++i) {
            retry.call(yard.w, "step", step_once, i % 8 < 2 && i > 0);
            if (testing::Test::HasFailure()) return;
            seen += yard.asleep();
            if (i == 90) yard.w.set_input(yard.push, 30.0);
            if (i == 120) yard.w.set_velocity(yard.box[2], {{0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}});
        }
        EXPECT_NE(seen.find('z'), std::string::npos) << "or nothing fell asleep";
    });
}

TEST(MemoryEnds, WhereGroupsAreCutAndFollowTheState) {
    using regrouping::Cables;
    for (const Predictor predictor : {Predictor::hold, Predictor::forces, Predictor::clique})
        expect_same_bits(
            "groups",
            [&](Retry& retry) {
                Cables t(2, 8);
                t.recipe.world.predictor = predictor;
                t.recipe.world.on_diverged = OnDiverged::warn;
                World w = t.recipe.make();
                steps(retry, w, 2, false);
                t.turn(w, 0);
                t.pull(w, 1);
                for (int i = 0; i < 18; ++i) retry.call(w, "step", step_once);
                retry.call(w, "groups", throwing([](World& to) { (void)to.splits().groups(); }));
                retry.call(w, "cuts", throwing([](World& to) { (void)to.splits().cuts(); }));
                retry.call(w, "set_group", throwing([](World& to) {
                               to.splits().set_group(BodyId{5},
                                                     "a group with a name that is not short");
                           }));
                retry.call(w, "set_coupling", throwing([](World& to) {
                               to.splits().set_coupling(InteractionId{0}, Coupling::kinematic);
                           }));
                steps(retry, w, 1, false);
                retry.call(w, "follow_groups",
                           throwing([](World& to) { to.splits().follow_groups(3, 5); }));
                steps(retry, w, 6, false);
                retry.call(w, "set_groups", throwing([](World& to) { to.splits().set_groups(2); }));
                steps(retry, w, 2, false);
            },
            // Predictors differ in the data of make_cuts() other than ghost bodies and duplicated
            // rows.
            predictor == Predictor::hold ? 2 : 9);
}

TEST(MemoryEnds, WhereDeadlinesChooseLevelsOfCuts) {
    expect_same_bits("deadline", [](Retry& retry) {
        using regrouping::Cables;
        Cables t(0);
        t.recipe.world.coupling = Coupling::deadline;
        t.recipe.world.on_diverged = OnDiverged::warn;  // arbitrary cuts create energy
        t.recipe.world.budget = 1e6;  // never reached: levels are analysed, none is chosen
        for (std::size_t b = 20; b < 60; ++b) t.recipe.bodies[b].group = "other";
        World w = t.recipe.make();
        steps(retry, w, 3, false);
        for (const std::uint64_t cuts : {1U, 0U, 1U}) {
            w.solver().degrade_next_step(
                {.iterations = cuts == 0 ? 1 : 0, .hasty = false, .cuts = cuts});
            steps(retry, w, 1, false);
        }
        steps(retry, w, 2, false);
    });
}

TEST(MemoryEnds, WhereAStateIsSavedRestoredAndCopied) {
    expect_same_bits("restore", [](Retry& retry) {
        WorldDef def;
        def.sleep_after = 0.2;
        def.sleep_speed = 1e-2;
        SleepYard yard(def);
        World& w = yard.w;
        std::vector<std::byte> early, late;
        for (int i = 0; i < 120; ++i) {
            if (i == 30) early = w.state().save();
            (void)w.step();
        }
        retry.call(w, "save", throwing([&](World& of) { late = of.state().save(); }));
        retry.call(w, "restore", throwing([&](World& to) { to.state().restore(early); }), true);
        steps(retry, w, 3);
        retry.call(w, "restore", throwing([&](World& to) { to.state().restore(late); }), true);
        steps(retry, w, 2);
        std::optional<World> twin;
        retry.call(w, "twin", throwing([&](World& of) { twin.emplace(of.twin()); }));
        steps(retry, *twin, 2);
        retry.call(*twin, "copy_state", throwing([&](World& to) { to.state().copy_from(w); }));
        steps(retry, *twin, 2);
        retry.call(w, "start_trace", throwing([](World& to) { to.solver().start_trace(100); }));
        retry.call(w, "inspect", throwing([](World& of) { (void)of.solver().matrix(); }));
        retry.call(w, "contacts", throwing([](World& of) { (void)of.contacts(); }));
        retry.call(w, "partition", throwing([](World& of) { (void)of.splits().partition({}); }));
        steps(retry, w, 2);
    });
    expect_same_bits("restore of groups", [](Retry& retry) {
        const regrouping::Cables t(2, 8);
        World w = t.recipe.make();
        t.turn(w, 0);
        std::vector<std::byte> early;
        for (int i = 0; i < 20; ++i) {
            if (i == 4) early = w.state().save();
            (void)w.step();
        }
        retry.call(w, "restore", throwing([&](World& to) { to.state().restore(early); }));
        steps(retry, w, 12, false);
    });
}

}  // namespace
}  // namespace hawser::test
