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
using validate::largest_distance;

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
        const World rigid = moved_loop(loop, kCoarseStep, {}, 2.0);
        const double error = largest_distance(rigid, exact);
        // Second order in h: measured 7.4 mm (four-bar linkage).
        EXPECT_LE(error, 1e-2);
        for (const double e : {0.0, 1e-12, 1e-9})
            for (const double t : kLoopDampings) {
                SCOPED_TRACE(::testing::Message() << e << " m/N, " << t << " s");
                const World w = moved_loop(loop, kCoarseStep, {e, t}, 2.0);
                // Measured: at most 1.00002 times the error of the rigid loop.
                EXPECT_LE(largest_distance(w, exact), 1.001 * error);
                // Measured 0.20 mm (boom, 1e-9 rad/(N m)): deflection of the hinge of the platform
                // and its lag in the direction of motion.
                EXPECT_LE(largest_distance(w, rigid), 3e-4);
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
                // Limit of the rigid loop. Measured 7.2 mm; the reference is right to 0.14 mm.
                EXPECT_LE(largest_distance(w, exact), 1e-2);
                EXPECT_EQ(w.verdict().grade, Grade::good);
            }
    }
}

/// Energies of a run of 5 s as fractions of the exchanged energy.
struct LoopEnergy {
    double unexplained = 0.0, risen = 0.0, end = 0.0;
};
LoopEnergy loop_energy(const CompliantLoop& loop, const JointLaw& law) {
    World w = moved_loop(loop, kCoarseStep, law, kCoarseStep);
    const Energy start = w.energy();
    LoopEnergy out;
    double least = start.kinetic, most = start.kinetic;
    for (int k = 0; k < 300; ++k) {
        EXPECT_EQ(w.step(), Status::ok);
        const Energy now = w.energy();
        out.end = now.mechanical() - start.mechanical();
        out.unexplained = std::max(out.unexplained, std::fabs(out.end + now.damped - start.damped));
        out.risen = std::max(out.risen, out.end);
        least = std::min(least, now.kinetic);
        most = std::max(most, now.kinetic);
    }
    for (double* each : {&out.unexplained, &out.risen, &out.end}) *each /= most - least;
    return out;
}

/// Kinetic, gravity and elastic energy plus the losses of rows are constant. Without damping the
/// mechanical energy alone is constant.
TEST(CompliantJoints, KeepTheirEnergy) {
    for (const CompliantLoop& loop : validate::kCompliantLoops) {
        SCOPED_TRACE(loop.name);
        const LoopEnergy rigid = loop_energy(loop, {});
        for (const double e : {0.0, 1e-12, 2e-11, 1e-9, 1e-7, 1e-6})
            for (const double t : {kDefault, 0.0, 0.1}) {
                SCOPED_TRACE(::testing::Message() << e << " m/N, " << t << " s");
                const LoopEnergy found = loop_energy(loop, {e, t});
                // Measured 1.5e-4 (boom, 1e-6 m/N, no damping).
                EXPECT_LE(found.unexplained, 5e-4);
                // The scheme oscillates: rigid loops rise by up to 1.8 % (four-bar linkage).
                EXPECT_LE(found.risen, rigid.risen + 1e-3);
                // Measured 3.1e-3 (four-bar linkage, 1e-6 m/N); the requirement is 1 %.
                if (t == 0.0) {
                    EXPECT_LE(std::fabs(found.end), 5e-3);
                }
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
