// SPDX-License-Identifier: Apache-2.0
/// A warm step allocates nothing.
#include "stepper/allocation_counter.h"
#include "stepper/scenes.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/experimental/splits.h>
#include <hawser/factor.h>

namespace hawser::test {
namespace {

using Guard = AllocationGuard;

TEST(Allocation, TheCounterCounts) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    const Guard guard;
    auto* p = new std::vector<double>(100);
    EXPECT_GE(Guard::seen(), 2);
    delete p;
    const long before = Guard::seen();
    base::Array<double> aligned(64);
    EXPECT_GE(Guard::seen(), before + 1);
}

void expect_none(const Recipe& recipe, int threads, std::size_t trace = 0) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    WorldDef def = recipe.world;
    def.threads = threads;
    World w = recipe.make(def);
    w.solver().start_trace(trace);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
    const auto growths = w.stats().growths;
    long seen = 0;
    bool ok = true;
    {
        const Guard guard;
        for (int i = 0; i < 200; ++i) {
            ok = ok && w.step() == Status::ok;
            (void)w.energy();
            (void)w.state().hash();
        }
        seen = Guard::seen();
    }
    EXPECT_TRUE(ok);
    EXPECT_EQ(seen, 0) << threads << " threads";
    EXPECT_EQ(w.stats().growths, growths);
}

TEST(Allocation, NoneInAWarmStep) {
    expect_none(pendulum(), 1);
    expect_none(link_chain(20), 1);
    expect_none(wire(30), 1);
    for (const std::uint32_t seed : seeds(1, 3, 6, 60)) {
        SCOPED_TRACE(seed);
        expect_none(mixed(seed, 10), 1);
    }
}

TEST(Allocation, NoneInAWarmStepOfTwoThreads) {
    expect_none(link_chain(200), 2);
    expect_none(mixed(4, 30), 2);
}

/// Nor do calls of a client after each step, once its own memory is large enough.
TEST(Allocation, NoneInWhatAClientReads) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    World w = mixed(3, 10).make();
    for (std::int32_t b = 0; b < w.body_count(); ++b)
        w.add_output({.name = "x" + std::to_string(b),
                      .kind = OutputKind::pose,
                      .body = {b},
                      .component = "x"});
    for (std::int32_t i = 0; i < w.interaction_count(); ++i)
        w.add_output({.name = "f" + std::to_string(i),
                      .kind = OutputKind::force,
                      .interaction = {i},
                      .component = "row_0"});
    w.add_output({.name = "e", .kind = OutputKind::statistic, .component = "mechanical"});
    std::vector<std::byte> saved;
    std::vector<ContactView> contacts;
    std::vector<Event> events;
    std::uint64_t cursor = 0;
    events.reserve(100'000);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
    w.state().save(saved);
    long seen = 0;
    double sum = 0.0;
    bool ok = true;
    {
        const Guard guard;
        for (int i = 0; i < 50; ++i) {
            ok = ok && w.step() == Status::ok;
            for (const double value : w.outputs()) sum += value;
            sum += w.state().arrays().positions[0];
            w.contacts(contacts);
            w.state().save(saved);
            (void)w.events().since(cursor, events);
        }
        seen = Guard::seen();
    }
    EXPECT_TRUE(ok && sum == sum);
    EXPECT_EQ(seen, 0);
}

/// Make a wire in two groups chosen by the world; drag brings it to rest.
Recipe broken_wire(int every) {
    Recipe r = wire(40);
    for (BodyDef& b : r.bodies) b.linear_damping = {50.0, 50.0, 50.0};
    r.world.coupling = Coupling::kinematic;
    r.world.predictor = Predictor::clique;
    r.world.parts = 2;
    r.world.regroup_every = every;
    return r;
}

/// Regrouping without changes does not allocate either, after the first one.
TEST(Allocation, NoneWhereGroupsAreLookedAtAndStay) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    World w = broken_wire(7).make();
    for (int i = 0; i < 600; ++i) ASSERT_EQ(w.step(), Status::ok);  // it comes to rest
    const std::int64_t before = w.stats().regroupings;
    long seen = 0;
    bool ok = true, looked = false;
    {
        const Guard guard;
        for (int i = 0; i < 70; ++i) {
            ok = ok && w.step() == Status::ok;
            looked |= w.stats().stage_seconds[static_cast<std::size_t>(Stage::graph)] > 0.0;
        }
        seen = Guard::seen();
    }
    EXPECT_TRUE(ok);
    EXPECT_TRUE(looked);
    EXPECT_EQ(w.stats().regroupings, before);
    EXPECT_EQ(seen, 0);
}

/// Any allocation of a regrouping may fail: the step returns a status, the state is the earlier
/// one, and the next call succeeds.
TEST(Allocation, WhereMemoryEndsInARegroupingItIsAStatus) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    const Recipe recipe = broken_wire(20);
    World good = recipe.make();
    const int round = static_cast<int>(context::Regroup::kSettle);
    for (int i = 0; i <= round; ++i) ASSERT_EQ(good.step(), Status::ok);
    ASSERT_EQ(good.stats().regroupings, 1) << "or the rest says nothing";
    int failed = 0;
    for (long k = 0;; k += 1 + k / 16) {
        SCOPED_TRACE(k);
        World w = recipe.make();
        for (int i = 0; i < round; ++i) ASSERT_EQ(w.step(), Status::ok);
        const std::vector<double> before = [&] {
            std::vector<double> x;
            for (int b = 0; b < w.body_count(); ++b)
                for (const double c : w.pose(BodyId{b}).position) x.push_back(c);
            return x;
        }();
        Status status = Status::ok;
        {
            const Guard guard(k);
            status = w.step();
        }
        if (status == Status::ok) break;  // it makes fewer allocations
        ++failed;
        ASSERT_EQ(status, Status::out_of_memory);
        ASSERT_EQ(w.step_count(), round);
        std::size_t i = 0;
        for (int b = 0; b < w.body_count(); ++b)
            for (const double c : w.pose(BodyId{b}).position) ASSERT_EQ(c, before[i++]);
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_EQ(w.splits().groups(), good.splits().groups());
        for (int b = 0; b < w.body_count(); ++b)
            ASSERT_LT((w.pose(BodyId{b}).position - good.pose(BodyId{b}).position).norm(), 1e-9);
    }
    EXPECT_GT(failed, 20);
}

TEST(Allocation, NoneInAWarmStepThatIsTraced) {
    expect_none(mixed(1, 10), 1, 500);  // ring buffer wraps
    expect_none(mixed(4, 30), 2, 500);
}

/// Make a wire that lies on a floor and over a bar: contacts appear and end in the first steps
/// only.
World lying_wire(int threads) {
    WorldDef def;
    def.threads = threads;
    World w(def);
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    ShapeDef shape;
    shape.kind = ShapeKind::plane;
    shape.body = w.add_body(ground);
    w.add_shape(shape);
    shape.kind = ShapeKind::box;
    shape.half_size = {0.5, 5.0, 0.5};
    shape.position = {10.25, 0.0, 0.2};
    w.add_shape(shape);
    BodyId last{};
    for (int i = 0; i < 60; ++i) {
        BodyDef d;
        d.kind = BodyKind::lump;
        d.position = {0.5 * i, 0.0, i > 18 && i < 23 ? 0.76 : 0.06};
        d.mass = 1.0;
        d.gravity = false;
        const BodyId now = w.add_body(d);
        if (last.valid()) {
            InteractionDef rod{.kind = InteractionKind::Distance, .body = {last, now}};
            w.add_interaction(rod);
            ShapeDef s;
            s.kind = ShapeKind::capsule;
            s.radius = 0.05;
            s.body = last;
            s.body_b = now;
            w.add_shape(s);
        }
        last = now;
    }
    return w;
}

TEST(Allocation, NoneInAWarmStepWithContacts) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    for (const int threads : {1, 2}) {
        World w = lying_wire(threads);
        for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
        EXPECT_GT(w.stats().contacts, 50);
        const auto growths = w.stats().growths;
        long seen = 0;
        {
            const Guard guard;
            for (int i = 0; i < 100; ++i) (void)w.step();
            seen = Guard::seen();
        }
        EXPECT_EQ(w.stats().status, Status::ok);
        EXPECT_EQ(seen, 0) << threads << " threads";
        EXPECT_EQ(w.stats().growths, growths);
    }
}

TEST(Allocation, NoneInAWarmStepOfACommittedScene) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    for (const auto& file : scene_files()) {
        for (const int threads : {1, 2}) {
            scene::Options options;
            options.threads = threads;
            scene::Scene s = scene::load_file(file, options);
            for (int i = 0; i < 3; ++i) ASSERT_EQ(s.world.step(), Status::ok) << file;
            // A step with more contacts than ever before, or with the first contact of two bodies,
            // grows and reports it. All others are warm.
            // A scene that starts with wires on deck grows in most of its first steps.
            int warm = 0;
            for (int i = 0; i < 20 || (warm < 10 && i < 60); ++i) {
                const std::int64_t growths = s.world.stats().growths;
                long seen = 0;
                {
                    const Guard guard;
                    (void)s.world.step();
                    seen = Guard::seen();
                }
                if (s.world.stats().growths != growths) continue;
                ++warm;
                EXPECT_EQ(seen, 0) << file << " on " << threads << ", step " << i;
            }
            EXPECT_GE(warm, 10) << file;
        }
    }
}

/// Nor does the warm path of the solver alone.
TEST(Allocation, NoneInAWarmFactorisation) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    constexpr int kNodes = 500;
    BlockPattern p;
    for (int i = 0; i < kNodes; ++i) {
        p.size.push_back(3);
        p.sign.push_back(1);
        if (i > 0) p.edges.push_back({i, (i - 1) / 2});
    }
    for (const int threads : {1, 2}) {
        BlockFactor f({.threads = threads, .partial = true});
        f.analyse(p);
        std::vector<double> k(static_cast<std::size_t>(f.value_count()), 0.01);
        for (int i = 0; i < kNodes; ++i)
            for (int d = 0; d < 3; ++d) k[static_cast<std::size_t>(f.value_begin(i) + 4 * d)] = 1.0;
        std::vector<double> b(3 * kNodes, 1.0), x = b;
        const std::vector<std::int32_t> changed{1, 400, kNodes + 7};
        const Guard guard;
        bool ok = f.factor(k) == Status::ok && f.solve(x) == Status::ok;
        ok = ok && f.refactor(k, changed) == Status::ok && f.refine(k, b, x) == Status::ok;
        ok = ok && f.residual(k, x, b) < 1e-15;
        EXPECT_EQ(Guard::seen(), 0) << threads << " threads";
        EXPECT_TRUE(ok);
    }
}

/// Nor does a failed step.
TEST(Allocation, NoneInAFailedStep) {
    if (!kCountsAllocations) GTEST_SKIP() << "a sanitizer owns malloc";
    World w = mixed(2).make();
    for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
    w.set_force(BodyId{1}, {1e300, 0, 0}, {0, 0, 0});
    Status status = Status::ok;
    long seen = 0;
    {
        const Guard guard;
        status = w.step();
        seen = Guard::seen();
    }
    EXPECT_EQ(status, Status::not_finite);
    EXPECT_EQ(seen, 0);
}

}  // namespace
}  // namespace hawser::test
