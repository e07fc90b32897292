// SPDX-License-Identifier: Apache-2.0
// Deadlines with clocks of the test: nothing depends on the speed of the machine.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "state/state_hash.h"
#include "step/step.h"

namespace hawser {
namespace {

using budget::Deadline;
using budget::Laps;
using budget::Load;

constexpr Load kLoad{1e4, 1e6};

/// Return a step with 1 ms start, 2 ms for the first iteration, `next` for each further one, 0.5 ms
/// finish.
Laps laps(int iterations, double next, double scale = 1.0) {
    const double last = scale * (3e-3 + (iterations - 1) * next);
    return {scale * 1e-3, scale * 3e-3, last, last + scale * 0.5e-3, iterations, false};
}

Deadline taught(double next) {
    Deadline d;
    for (int i = 0; i < 200; ++i) d.add_sample(kLoad, laps(1 + i % 3, next));
    return d;
}

TEST(Deadline, LearnsStagesAndScalesThemWithWork) {
    const Deadline d = taught(1e-3);
    // 200 samples without scatter reduce the first guess of the deviation to (3/4)^200.
    EXPECT_NEAR(d.predict(kLoad, 1), 3.5e-3, 1e-9);
    EXPECT_NEAR(d.predict(kLoad, 4), 6.5e-3, 1e-9);
    EXPECT_NEAR(d.predict({2e4, 1e6}, 1), 4.5e-3, 1e-9);
    EXPECT_NEAR(d.predict({1e4, 2e6}, 1), 6e-3, 1e-9);
    EXPECT_EQ(d.iterations_by(6.6e-3, kLoad), 4);
    EXPECT_EQ(d.iterations_by(6.4e-3, kLoad), 3);
    EXPECT_EQ(d.iterations_by(1e-9, kLoad), 1);  // one is always made
    EXPECT_EQ(d.iterations_by(1e9, kLoad), 1000);
}

TEST(Deadline, ReckonsWithScatter) {
    Deadline d;
    for (int i = 0; i < 400; ++i) d.add_sample(kLoad, laps(1, 0.0, i % 2 == 0 ? 0.8 : 1.2));
    // Mean 3.5 ms, mean deviation 0.7 ms: the slower half fits within 2 deviations.
    EXPECT_GT(d.predict(kLoad, 1), 1.2 * 3.5e-3);
    EXPECT_LT(d.predict(kLoad, 1), 1.5 * 3.5e-3);
}

TEST(Deadline, ForgetsOneStepThatTookAHundredTimesAsLong) {
    Deadline d = taught(1e-3);
    d.add_sample(kLoad, laps(3, 1e-3, 100.0));
    // The sample counts as four times the mean: + 3/8 of the mean, and twice 3/4 of it by its
    // deviation.
    EXPECT_LT(d.predict(kLoad, 1), 3.0 * 3.5e-3);
    for (int i = 0; i < 30; ++i) d.add_sample(kLoad, laps(3, 1e-3));
    EXPECT_LT(d.predict(kLoad, 1), 1.05 * 3.5e-3);
}

TEST(Deadline, DoesNotLearnFromAnalyses) {
    Deadline d = taught(1e-3);
    const double before = d.predict(kLoad, 2);
    Laps touch = laps(2, 1e-3);
    touch.start += 20e-3;
    touch.first += 20e-3;
    touch.last += 20e-3;
    touch.end += 20e-3;
    touch.analysed = true;
    d.add_sample(kLoad, touch);
    EXPECT_NEAR(d.predict(kLoad, 2), before, 1e-12);
}

TEST(Deadline, LearnsOfContactsAfterStepsWithoutAny) {
    Deadline d;
    // All 4 ms after the start are one factorisation without an iteration.
    for (int i = 0; i < 100; ++i) d.add_sample(kLoad, {1e-3, 1e-3, 1e-3, 5e-3, 0, false});
    EXPECT_TRUE(d.has_enough_samples());
    EXPECT_NEAR(d.predict(kLoad, 1), 5e-3, 1e-9);
    EXPECT_GT(d.predict_next(kLoad), 0.0);
    for (int i = 0; i < 200; ++i) d.add_sample(kLoad, laps(1 + i % 3, 1e-3));
    EXPECT_NEAR(d.predict(kLoad, 1), 3.5e-3, 1e-9);
    EXPECT_NEAR(d.predict(kLoad, 4), 6.5e-3, 1e-9);
}

TEST(Deadline, TriesAgainWhatItHasGivenUp) {
    Deadline d = taught(5e-3);
    EXPECT_EQ(d.iterations_by(6e-3, kLoad), 1);
    int refused = 0;
    while (d.iterations_by(6e-3, kLoad) == 1 && refused < 1000) {
        d.record_refusal();
        ++refused;
    }
    // 3.5 ms + 5 ms 0.99^n ≤ 6 ms: n = 69.
    EXPECT_EQ(refused, 69);
    for (int i = 0; i < 1000; ++i) d.record_refusal();
    EXPECT_GE(d.predict_next(kLoad), 0.99 * 0.25 * 2e-3);  // its lower bound
}

/// Clock with a model of the machine: contacts and iterations cost time.
struct ModelClock final : runtime::Stopwatch {
    const context::StepContext& ctx;
    double per_contact, per_iteration;
    ModelClock(const context::StepContext& c, double contact, double iteration)
        : ctx(c), per_contact(contact), per_iteration(iteration) {}
    void start() noexcept override {}
    double seconds() noexcept override {
        const double n = static_cast<double>(ctx.model.system.contacts.count());
        return n * (per_contact + per_iteration * ctx.work.newton.iterations);
    }
};

constexpr int kBoxes = 24;

/// Make boxes that slide on a shaking floor; the second half hangs weightless above it.
std::unique_ptr<context::StepContext> floor_with_boxes(const WorldDef& def) {
    auto ctx = std::make_unique<context::StepContext>(def);
    ShapeDef plane, box;
    plane.kind = ShapeKind::plane;
    box.kind = ShapeKind::box;
    box.half_size = {0.5, 0.5, 0.25};
    plane.body = BodyId{ctx->model.bodies.add({.kind = BodyKind::kinematic})};
    ctx->model.collider.add(plane, ctx->model.bodies);
    for (int i = 0; i < kBoxes; ++i) {
        const bool parked = i >= kBoxes / 2;
        box.body = BodyId{ctx->model.bodies.add({.position = {2.0 * i, 0.0, parked ? 5.0 : 0.2499},
                                                 .mass = 100.0,
                                                 .inertia = Mat3::Identity() * 10.0,
                                                 .gravity = !parked})};
        ctx->model.collider.add(box, ctx->model.bodies);
    }
    ctx->state.changed = context::Changed::all;
    return ctx;
}

/// Put the parked half down, or lift it.
void put(context::StepContext& ctx, bool down) {
    for (std::size_t b = 1 + kBoxes / 2; b <= kBoxes; ++b) {
        ctx.model.bodies.x[3 * b + 2] = down ? 0.2499 : 5.0;
        ctx.model.bodies.force[6 * b + 2] = down ? -981.0 : 0.0;
        for (std::size_t k = 0; k < 6; ++k)
            ctx.model.bodies.v[static_cast<std::size_t>(ctx.model.bodies.dof_begin[b]) + k] = 0.0;
    }
}

/// Move the floor: it starts to slide under the boxes, and reverses.
void shake(context::StepContext& ctx) {
    ctx.model.bodies.v_fixed[0] = std::sin(0.4 * static_cast<double>(ctx.state.step));
    ctx.model.bodies.v_fixed[1] = std::cos(0.3 * static_cast<double>(ctx.state.step));
}

TEST(Deadline, HoldsWhileTheLoadDoublesAndIsExactAgainAfterwards) {
    WorldDef def;
    // Half of the boxes have 48 contacts: 2 ms per step and 1 ms per iteration, so that five would
    // end by 7 ms. All of them take 4 ms and 2 ms: one ends by 6 ms, two do not.
    def.budget = 7.4e-3;
    auto ctx = floor_with_boxes(def);
    auto replayed = floor_with_boxes({});
    ModelClock clock(*ctx, 2e-3 / 48, 1e-3 / 48), never(*replayed, 1e9, 1e9);
    ctx->stopwatch = &clock;
    replayed->stopwatch = &never;
    int loaded = 0, after = 0, late = 0, exact_since = 0;
    for (int i = 0; i < 240; ++i) {
        if (i == 80 || i == 160)
            for (auto* c : {ctx.get(), replayed.get()}) put(*c, i == 80);
        shake(*ctx);
        shake(*replayed);
        ASSERT_EQ(step::step(*ctx), Status::ok) << "step " << i;
        const StepStats& s = ctx->work.stats;
        EXPECT_EQ(s.degradation.any(), s.cut);
        if (s.cut) {
            EXPECT_GT(s.foreseen_seconds, 0.95 * def.budget) << "step " << i;
            EXPECT_TRUE(s.degraded_by == DegradedBy::prediction ||
                        s.degraded_by == DegradedBy::clock);
            (i < 160 ? loaded : after) += i < 80 ? 0 : 1;
            if (i >= 160) exact_since = i - 159;
        } else {
            EXPECT_LE(s.natural_map, def.contact_tolerance) << "step " << i;
        }
        late += s.solver_cpu_seconds > def.budget ? 1 : 0;
        EXPECT_LE(s.momentum_residual, 1e-9) << "step " << i;
        replayed->state.imposed = s.degradation;
        ASSERT_EQ(step::step(*replayed), Status::ok);
        EXPECT_EQ(replayed->work.stats.degradation, s.degradation);
        ASSERT_EQ(state::state_hash(replayed->model, replayed->state),
                  state::state_hash(ctx->model, ctx->state))
            << "step " << i;
    }
    EXPECT_GT(loaded, 40);
    EXPECT_LE(late, 2);  // of 240: 99 %
    EXPECT_LT(exact_since, 60);
    // A shaking floor moves no box through it or off it: at most 1 m/s for 4 s.
    for (std::size_t b = 1; b <= kBoxes / 2; ++b) {
        EXPECT_NEAR(ctx->model.bodies.x[3 * b + 2], 0.25, 1e-3);
        EXPECT_LT(std::fabs(ctx->model.bodies.x[3 * b + 1]), 4.0);
    }
}

}  // namespace
}  // namespace hawser
