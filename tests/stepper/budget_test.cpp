// SPDX-License-Identifier: Apache-2.0
// Limits of a step's cost, with a clock of the test.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "state/state_hash.h"
#include "step/step.h"

namespace hawser {
namespace {

/// Every reading costs a tick of CPU time.
struct TickingClock final : runtime::Stopwatch {
    double tick, now = 0.0;
    int looks = 0;
    explicit TickingClock(double t) : tick(t) {}
    void start() noexcept override { now = 0.0; }
    double seconds() noexcept override {
        ++looks;
        return now += tick;
    }
};

/// Make a leaning pile of boxes pushed sideways: several iterations per step.
std::unique_ptr<context::StepContext> pile(const WorldDef& def) {
    auto ctx = std::make_unique<context::StepContext>(def);
    const auto add = [&](const BodyDef& body, ShapeDef shape) {
        shape.body = BodyId{ctx->model.bodies.add(body)};
        ctx->model.collider.add(shape, ctx->model.bodies);
    };
    ShapeDef plane, box;
    plane.kind = ShapeKind::plane;
    box.kind = ShapeKind::box;
    box.half_size = {0.5, 0.5, 0.25};
    add({.kind = BodyKind::fixed}, plane);
    for (int i = 0; i < 6; ++i)
        add({.position = {0.1 * i, 0.0, 0.25 + 0.499 * i},
             .velocity = {i % 2 == 0 ? 1.5 : -0.5, 0.3 * i, 0.0},
             .mass = 100.0,
             .inertia = Mat3::Identity() * 10.0},
            box);
    ctx->state.changed = context::Changed::all;
    return ctx;
}

TEST(Budget, AssumesThatTheNextIterationCostsWhatTheLastDid) {
    budget::Budget b;
    b.begin({.seconds = 10.0}, {1.0, 0.0});
    EXPECT_TRUE(b.allows_iteration({3.0, 0.0}, 1));   // next one ends at 5
    EXPECT_TRUE(b.allows_iteration({6.5, 0.0}, 2));   // next one ends at 10
    EXPECT_TRUE(b.allows_iteration({7.0, 0.0}, 3));   // at 7.5
    EXPECT_FALSE(b.allows_iteration({9.0, 0.0}, 4));  // at 11
    EXPECT_EQ(b.cause(), DegradedBy::clock);
    EXPECT_EQ(b.foreseen(), 11.0);
    EXPECT_TRUE(b.exits_early());
    b.record_end_of_solve(11.0);  // 2 after the last reading: stored for the next step
    b.begin({.seconds = 10.0}, {});
    EXPECT_FALSE(b.allows_iteration({4.5, 0.0}, 1));  // 9 + 2
    b.begin({.work = 100.0}, {});
    EXPECT_FALSE(b.exits_early());
    EXPECT_TRUE(b.allows_iteration({1e9, 50.0}, 1));
    EXPECT_FALSE(b.allows_iteration({1e9, 80.0}, 2));
    EXPECT_EQ(b.cause(), DegradedBy::work);
    b.begin({.seconds = 1e9, .most = 2, .foreseen = 7.0}, {});
    EXPECT_TRUE(b.allows_iteration({1.0, 1.0}, 1));
    EXPECT_FALSE(b.allows_iteration({2.0, 1.0}, 2));
    EXPECT_EQ(b.cause(), DegradedBy::prediction);
    EXPECT_EQ(b.foreseen(), 7.0);
    b.begin({.seconds = 1e-9, .work = 1e-9, .imposed = {3, false}}, {});  // limits have no effect
    EXPECT_FALSE(b.needs_time());
    EXPECT_FALSE(b.exits_early());
    EXPECT_TRUE(b.allows_iteration({1.0, 1.0}, 2));
    EXPECT_FALSE(b.allows_iteration({1.0, 1.0}, 3));
    EXPECT_EQ(b.cause(), DegradedBy::order);
    b.end();
    EXPECT_TRUE(b.allows_iteration({1e9, 1e9}, 1000));
}

TEST(Budget, CutsWithTheClockAndRepeatsWithoutIt) {
    WorldDef def;
    def.budget = 3.5e-3;
    auto timed = pile(def);
    auto repeated = pile({});
    TickingClock clock(1e-3), never(1e9);
    timed->stopwatch = &clock;
    repeated->stopwatch = &never;  // Nothing depends on its reading.
    int cuts = 0;
    for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(step::step(*timed), Status::ok);
        const StepStats& s = timed->work.stats;
        // One reading before the solution, one per iteration, and one at the end. From the second
        // step on the end is known to take 1 ms, so that a second iteration would end at 3 + 1 ms.
        if (s.cut) {
            EXPECT_EQ(s.newton_iterations, i == 0 ? 2 : 1) << "step " << i;
            // The first step ends with a solution of its rows, as there is no earlier solution.
            EXPECT_EQ(s.degradation, (Degradation{s.newton_iterations, i > 0})) << "step " << i;
            EXPECT_GT(s.foreseen_seconds, 0.95 * def.budget);
        } else {
            EXPECT_LE(s.natural_map, def.contact_tolerance);
            EXPECT_EQ(s.degradation, Degradation{});
            EXPECT_EQ(s.degraded_by, DegradedBy::nothing);
        }
        cuts += s.cut ? 1 : 0;
        repeated->state.imposed = s.degradation;
        ASSERT_EQ(step::step(*repeated), Status::ok);
        EXPECT_EQ(repeated->work.stats.cut, s.cut);
        EXPECT_EQ(repeated->work.stats.degradation, s.degradation);
        EXPECT_EQ(repeated->state.imposed, Degradation{});
        ASSERT_EQ(state::state_hash(repeated->model, repeated->state),
                  state::state_hash(timed->model, timed->state))
            << "step " << i;
    }
    EXPECT_GT(cuts, 10);
    EXPECT_GT(clock.looks, 40);
    for (const double x : timed->model.bodies.x) EXPECT_TRUE(std::isfinite(x));
}

TEST(Budget, IterationsThatRunOutLeaveMomentumBalanced) {
    WorldDef def;
    def.contact_iterations = 2;
    auto ctx = pile(def);
    int open = 0;
    for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(step::step(*ctx), Status::ok);
        const StepStats& s = ctx->work.stats;
        EXPECT_FALSE(s.cut);
        // The residual of a solved step is 1e-13; the margin is for badly conditioned laws.
        EXPECT_LE(s.momentum_residual, 1e-9) << "step " << i;
        open += s.natural_map > def.contact_tolerance ? 1 : 0;
    }
    EXPECT_GT(open, 5);
    for (const double x : ctx->model.bodies.x) EXPECT_TRUE(std::isfinite(x));
}

TEST(Budget, OfWorkIsTheSameForAnyNumberOfThreads) {
    std::vector<std::uint64_t> hashes;
    int cuts = 0;
    for (const int threads : {1, 2, 4}) {
        WorldDef def;
        def.threads = threads;
        def.budget_work = 1.0;  // less than any iteration: one is made nevertheless
        auto ctx = pile(def);
        for (int i = 0; i < 40; ++i) {
            ASSERT_EQ(step::step(*ctx), Status::ok);
            cuts += ctx->work.stats.cut ? 1 : 0;
            EXPECT_LE(ctx->work.stats.newton_iterations, 2);
        }
        hashes.push_back(state::state_hash(ctx->model, ctx->state));
    }
    EXPECT_GT(cuts, 30);
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Stopwatch, CountsWhatAWorkerComputes) {
    runtime::Pool pool(2);
    runtime::PoolStopwatch watch(pool);
    pool.resume();
    watch.start();
    auto burn = [](int, int) noexcept {
        double x = 1.0;
        for (int i = 0; i < 2'000'000; ++i) x = std::sqrt(x + i);
        volatile double sink = x;
        (void)sink;
    };
    pool.for_each(8, burn);
    pool.pause();
    // 2 million square roots and additions take more than a millisecond on any processor.
    EXPECT_GT(watch.seconds(), 1e-3);
}

}  // namespace
}  // namespace hawser
