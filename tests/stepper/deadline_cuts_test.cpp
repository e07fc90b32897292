// SPDX-License-Identifier: Apache-2.0
// Cuts requested by a deadline: chosen by a clock of the test, replayed without one.
#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include "budget/deadline.h"
#include "state/state_hash.h"
#include "step/step.h"
#include "support/small_recipes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace hawser::test {
namespace {

constexpr int kSide = 12;

/// Make a net of point masses, fixed at its upper edge; its right half is a group. The exact
/// factorisation has a separator across its middle, which a cut removes.
Recipe net(double budget) {
    Recipe r;
    r.world.coupling = Coupling::deadline;
    r.world.budget = budget;
    const BodyId wall = r.ground();
    BodyId lump[kSide][kSide];
    const auto join = [&](BodyId a, BodyId b, const Vec3& at, double length) {
        InteractionDef d = between(InteractionKind::Distance, {a, b});
        d.point[0] = at;
        d.compliance[0] = 1e-4;
        r.add(d.set("length", length));
    };
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            lump[i][j] = r.lump({1.0 * j, 0.0, -1.0 * i}, 1.0);
            if (j >= kSide / 2) r.bodies.back().group = "right";
            if (i == 0) join(wall, lump[i][j], {1.0 * j, 0.0, 1.0}, 1.0);
            if (i > 0) join(lump[i - 1][j], lump[i][j], Vec3::Zero(), 1.0);
            if (j > 0) join(lump[i][j - 1], lump[i][j], Vec3::Zero(), 1.0);
        }
    return r;
}

std::unique_ptr<context::StepContext> net_context(double budget) {
    const Recipe r = net(budget);
    auto ctx = r.context();
    for (std::size_t b = 0; b < r.bodies.size(); ++b)
        ctx->model.cuts.group[b] = r.bodies[b].group.empty() ? 0 : 1;
    ctx->state.changed = context::Changed::all;
    return ctx;
}

/// The solver takes a second per unit of work of the matrix, times `slow`.
struct MatrixClock final : runtime::Stopwatch {
    const context::StepContext& ctx;
    double slow = 1.0;
    int looks = 0;
    explicit MatrixClock(const context::StepContext& c) : ctx(c) {}
    void start() noexcept override { looks = 0; }
    double seconds() noexcept override {
        // 0 at the start of the solution.
        return looks++ == 0
                   ? 0.0
                   : slow * budget::matrix_work(static_cast<double>(ctx.work.stats.factor_flops),
                                                static_cast<double>(ctx.work.stats.factor_nnz));
    }
};

TEST(DeadlineCuts, OpenWhileTheMachineIsSlowAndAreRepeatedWithoutAClock) {
    auto probe = net_context(1.0);
    ASSERT_EQ(step::step(*probe), Status::ok);
    ASSERT_EQ(step::step(*probe), Status::ok);
    const auto& levels = probe->work.limits.cut_levels.levels();
    ASSERT_EQ(levels.size(), 2U);
    const double exact = levels[0].matrix;
    ASSERT_LT(levels[1].matrix, 0.9 * exact);  // precondition of the test

    // At the first speed, an exact step has a margin of a fifth; 1.3 times slower, it does not fit.
    auto ctx = net_context(1.2 * exact);
    auto repeated = net_context(0.0);
    MatrixClock clock(*ctx);
    ctx->stopwatch = &clock;
    int open = 0, last_open = 0;
    for (int i = 0; i < 200; ++i) {
        clock.slow = i >= 60 && i < 120 ? 1.3 : 1.0;
        ASSERT_EQ(step::step(*ctx), Status::ok) << "step " << i;
        const Degradation d = ctx->work.stats.degradation;
        EXPECT_EQ(d.iterations, 0);  // no contacts
        EXPECT_EQ(ctx->work.stats.cuts > 0, d.cuts != 0);
        if (d.any()) {
            EXPECT_EQ(ctx->work.stats.degraded_by, DegradedBy::prediction);
            EXPECT_GE(i, 60);
            ++open;
            last_open = i;
        }
        repeated->state.imposed = d;
        ASSERT_EQ(step::step(*repeated), Status::ok);
        EXPECT_EQ(repeated->work.stats.degradation, d);
        ASSERT_EQ(state::state_hash(repeated->model, repeated->state),
                  state::state_hash(ctx->model, ctx->state))
            << "step " << i;
    }
    EXPECT_GE(open, 50);
    EXPECT_LT(last_open, 120 + 60);
    for (const double x : ctx->model.bodies.x) EXPECT_LT(std::fabs(x), 100.0);
}

TEST(DeadlineCuts, GoOnFromASnapshotTakenWhileTheyAreOpen) {
    World a = net(0.0).make();
    std::vector<std::byte> saved;
    const auto take = [](World& w, int i) {
        w.solver().degrade_next_step({0, false, i >= 10 && i < 30 ? std::uint64_t{1} : 0});
        ASSERT_EQ(w.step(), Status::ok);
    };
    for (int i = 0; i < 50; ++i) {
        if (i == 20) saved = a.state().save();
        take(a, i);
        EXPECT_EQ(a.stats().cuts, i >= 10 && i < 30 ? kSide : 0) << i;
        EXPECT_EQ(a.stats().islands, i >= 10 && i < 30 ? 2 : 1) << i;
    }
    World b = net(0.0).make();
    b.state().restore(saved);
    for (int i = 20; i < 50; ++i) take(b, i);
    EXPECT_EQ(a.state().hash(), b.state().hash());
}

TEST(DeadlineCuts, AreTakenWithACopiedState) {
    const auto open = [](const World& w) {
        int count = 0;
        for (const CutView& c : w.splits().cuts()) count += c.open ? 1 : 0;
        return count;
    };
    for (const Predictor predictor : {Predictor::hold, Predictor::forces, Predictor::clique}) {
        Recipe r = net(0.0);
        r.world.predictor = predictor;
        World a = r.make(), b = r.make();
        for (const std::uint64_t asked : {std::uint64_t{1}, std::uint64_t{0}}) {
            for (int i = 0; i < 10; ++i) {
                a.solver().degrade_next_step({0, false, asked});
                ASSERT_EQ(a.step(), Status::ok);
            }
            // The other world has them inverted until then.
            ASSERT_NE(open(b) != 0, asked != 0);
            b.state().copy_from(a);
            EXPECT_EQ(open(b), asked != 0 ? kSide : 0);
            EXPECT_EQ(open(b), open(a));
            for (World* w : {&a, &b}) {
                w->solver().degrade_next_step({0, false, asked});
                ASSERT_EQ(w->step(), Status::ok);
            }
            EXPECT_EQ(b.stats().cuts, a.stats().cuts);
            EXPECT_EQ(b.state().hash(), a.state().hash());
        }
    }
}

TEST(DeadlineCuts, ChangeNothingWhileTheyAreNotAskedFor) {
    World a = net(0.0).make(), b = net(0.0).make({});
    for (int i = 0; i < 30; ++i) {
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(b.step(), Status::ok);
    }
    EXPECT_EQ(a.splits().cuts().size(), static_cast<std::size_t>(kSide));
    EXPECT_FALSE(a.splits().cuts()[0].open);
    for (std::int32_t i = 0; i < a.body_count(); ++i)
        EXPECT_LT((a.pose({i}).position - b.pose({i}).position).norm(), 1e-9);
}

TEST(DeadlineCuts, AreNotTakenWhereTheySaveNothing) {
    budget::Deadline d;
    const budget::Load load{1e-9, 1000.0};  // almost no rows
    for (int i = 0; i < 100; ++i) d.add_sample(load, {0.0, 1.0, 1.0, 1.0, 1, false});
    budget::CutLevels levels;
    levels.set({{0, 1000.0}, {1, 1100.0}, {3, 980.0}});
    EXPECT_EQ(levels.choose(d, load, 0.5, 0), 0U);  // 2 % do not justify a cut
    levels.set({{0, 1000.0}, {1, 1100.0}, {3, 700.0}, {7, 500.0}});
    EXPECT_EQ(levels.choose(d, load, 0.8, 0), 3U);  // the first that fits
    levels.set({{0, 1000.0}, {1, 1100.0}, {3, 700.0}, {7, 500.0}});
    EXPECT_EQ(levels.choose(d, load, 0.1, 0), 7U);  // none fits: the cheapest
    // Return to exact after it has fitted with a margin of a tenth for kMinStepsAtLevel steps.
    const budget::Load cut{1e-9, 500.0};
    for (int i = 0; i + 1 < budget::CutLevels::kMinStepsAtLevel; ++i)
        EXPECT_EQ(levels.choose(d, cut, 1.2, 7), 7U);
    EXPECT_EQ(levels.choose(d, cut, 1.2, 7), 0U);
}

/// A load that appears while cuts are open and disappears again: costs of levels are those of the
/// present load.
TEST(DeadlineCuts, AreTakenBackWhenALoadThatCameWithThemGoes) {
    budget::Deadline d;
    const budget::Load load{1e-9, 1000.0};
    for (int i = 0; i < 100; ++i) d.add_sample(load, {0.0, 1.0, 1.0, 1.0, 1, false});
    budget::CutLevels levels;
    levels.set({{0, 1000.0}, {1, 700.0}});
    std::uint64_t asked = 0;
    // Work of a step: 1000 or 700, and 1000 more during the load.
    const auto step = [&](double more) {
        asked = levels.choose(d, {1e-9, (asked != 0 ? 700.0 : 1000.0) + more}, 1.8, asked);
    };
    for (int i = 0; i < 30; ++i) step(0.0);
    EXPECT_EQ(asked, 0U);
    step(1000.0);
    EXPECT_EQ(asked, 1U) << "1.7 is within 1.8, 2.0 is not";
    for (int i = 0; i < 300; ++i) step(1000.0);
    EXPECT_EQ(asked, 1U);
    for (int i = 0; i < budget::CutLevels::kMinStepsAtLevel + 2; ++i) step(0.0);
    EXPECT_EQ(asked, 0U);
}

TEST(DeadlineCuts, StayAsARestoredWorldHasThemUntilRatesAreKnown) {
    const budget::Deadline nothing;
    budget::CutLevels levels;
    levels.set({{0, 1000.0}, {1, 700.0}, {3, 500.0}});
    EXPECT_EQ(levels.choose(nothing, {1.0, 500.0}, 0.6, 3), 3U);
}

/// Records whether levels of cuts were known when the solver's time started.
struct LevelsClock final : runtime::Stopwatch {
    const context::StepContext& ctx;
    bool known_at_start = false;
    explicit LevelsClock(const context::StepContext& c) : ctx(c) {}
    void start() noexcept override { known_at_start = ctx.work.limits.cut_levels.known(); }
    double seconds() noexcept override { return 0.0; }
};

TEST(DeadlineCuts, TheAnalysisOfLevelsIsPartOfTheSolversTime) {
    auto ctx = net_context(1.0);
    LevelsClock clock(*ctx);
    ctx->stopwatch = &clock;
    ASSERT_EQ(step::step(*ctx), Status::ok);
    ASSERT_FALSE(ctx->work.limits.cut_levels.known());
    ASSERT_EQ(step::step(*ctx), Status::ok);
    EXPECT_TRUE(ctx->work.limits.cut_levels.known());
    EXPECT_FALSE(clock.known_at_start);
    EXPECT_TRUE(ctx->work.limits.laps.analysed) << "or rates would be learned from it";
}

/// One row across the middle is coupled exactly: it joins the halves, so that no requested cut
/// comes into force.
TEST(DeadlineCuts, ThatAreHeldShutDegradeNothing) {
    World open = net(0.0).make(), shut = net(0.0).make();
    shut.splits().set_coupling(open.splits().cuts().front().interaction, Coupling::exact);
    for (World* w : {&open, &shut})
        for (int i = 0; i < 5; ++i) {
            w->solver().degrade_next_step({0, false, 1});
            ASSERT_EQ(w->step(), Status::ok);
        }
    EXPECT_EQ(open.stats().compliant, 1U);
    EXPECT_EQ(open.stats().degraded_by, DegradedBy::order);
    EXPECT_GT(open.stats().cut_defect, 0.0);
    EXPECT_GT(open.stats().cuts, 0);
    EXPECT_EQ(shut.stats().degradation.cuts, 1U);  // needed by a replay
    EXPECT_EQ(shut.stats().compliant, 0U);
    EXPECT_EQ(shut.stats().degraded_by, DegradedBy::nothing);
    EXPECT_EQ(shut.stats().cut_defect, 0.0);
    EXPECT_EQ(shut.stats().cuts, 0);
}

}  // namespace
}  // namespace hawser::test
