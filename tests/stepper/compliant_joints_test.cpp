// SPDX-License-Identifier: Apache-2.0
/// Joints with a compliance and a damping time move like rigid ones: a boom on two hinges, a planar
/// four-bar linkage and Bennett's linkage at the user's step (docs/theory/compliance.md).
#include "validate/loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hawser::test {
namespace {

using validate::CompliantLoop;
using validate::JointLaw;

constexpr double kCoarseStep = 1.0 / 60.0;
constexpr double kLoopDampings[] = {kDefault, 0.0, 1.0 / 60.0, 0.1};

World moved_loop(const CompliantLoop& loop, double step, const JointLaw& law, double time) {
    World w = loop.make(step, law);
    for (long k = std::lround(time / step); k > 0; --k) EXPECT_EQ(w.step(), Status::ok);
    return w;
}

/// Up to 1e-9 m/N no joint deflects visibly: the reference is the rigid loop at 1/1920 s. Its own
/// error is a thousandth of that at 1/60 s.
TEST(CompliantJoints, MoveLikeRigidOnes) {
    for (const CompliantLoop& loop : validate::kCompliantLoops) {
        SCOPED_TRACE(loop.name);
        const World exact = moved_loop(loop, 1.0 / 1920.0, {}, 2.0);
        const double rigid = largest_distance(moved_loop(loop, kCoarseStep, {}, 2.0), exact);
        EXPECT_LE(rigid, 1e-2);
        for (const double e : {0.0, 1e-12, 1e-9})
            for (const double t : kLoopDampings) {
                SCOPED_TRACE(::testing::Message() << e << " m/N, " << t << " s");
                const World w = moved_loop(loop, kCoarseStep, {e, t}, 2.0);
                // A tenth for vibrations of the joints at the start.
                EXPECT_LE(largest_distance(w, exact), 1.1 * rigid + 1e-5);
                EXPECT_EQ(w.verdict().grade, Grade::good);
            }
    }
}

/// Softer joints deflect: the reference is the same loop at 1/960 s, with two coarse steps for the
/// default damping time.
TEST(CompliantJoints, MoveLikeTheirOwnFineMotion) {
    for (const CompliantLoop& loop : validate::kCompliantLoops) {
        SCOPED_TRACE(loop.name);
        for (const double e : {1e-7, 1e-6})
            for (const double t : kLoopDampings) {
                SCOPED_TRACE(::testing::Message() << e << " m/N, " << t << " s");
                const JointLaw fine{e, std::isnan(t) ? 2.0 * kCoarseStep : t};
                const World exact = moved_loop(loop, 1.0 / 960.0, fine, 2.0);
                const World w = moved_loop(loop, kCoarseStep, {e, t}, 2.0);
                EXPECT_LE(largest_distance(w, exact), 1.5e-2);
                EXPECT_EQ(w.verdict().grade, Grade::good);
            }
    }
}

/// Kinetic, gravity and elastic energy plus the losses of rows are constant, and nothing pumps.
TEST(CompliantJoints, KeepTheirEnergyBooks) {
    for (const CompliantLoop& loop : validate::kCompliantLoops) {
        SCOPED_TRACE(loop.name);
        for (const double e : {0.0, 1e-12, 1e-9, 1e-7, 1e-6})
            for (const double t : {kDefault, 0.0, 0.1}) {
                SCOPED_TRACE(::testing::Message() << e << " m/N, " << t << " s");
                World w = moved_loop(loop, kCoarseStep, {e, t}, kCoarseStep);
                const Energy start = w.energy();
                double off = 0.0, risen = 0.0, least = start.kinetic, most = start.kinetic;
                for (int k = 0; k < 300; ++k) {
                    ASSERT_EQ(w.step(), Status::ok);
                    const Energy now = w.energy();
                    const double change = now.mechanical() - start.mechanical();
                    off = std::max(off, std::fabs(change + now.damped - start.damped));
                    risen = std::max(risen, change);
                    least = std::min(least, now.kinetic);
                    most = std::max(most, now.kinetic);
                }
                // Fractions of the exchanged energy. The scheme itself oscillates by a hundredth.
                EXPECT_LE(off, 5e-3 * (most - least));
                EXPECT_LE(risen, 2e-2 * (most - least));
            }
    }
}

/// A warm step with compliant joints allocates nothing: no buffer grows after the second step.
TEST(CompliantJoints, GrowNoBufferOnceWarm) {
    World w = moved_loop(validate::kCompliantLoops[1], kCoarseStep, {1e-9, kDefault}, 0.1);
    const auto before = w.stats().growths;
    for (int k = 0; k < 60; ++k) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.stats().growths, before);
}

}  // namespace
}  // namespace hawser::test
