// SPDX-License-Identifier: Apache-2.0
/// Rows of compliant joints at the end of a step (step/completion.h): right-hand sides, mean rates
/// and damping against formulas evaluated with moved bodies.
#include "assembly/kernels.h"
#include "base/index.h"
#include "context/view.h"
#include "solve/evaluate.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

constexpr InteractionKind kCompletedKinds[] = {
    InteractionKind::Ball,        InteractionKind::Hinge,     InteractionKind::Prismatic,
    InteractionKind::Cylindrical, InteractionKind::Universal, InteractionKind::Lock,
    InteractionKind::Distance};

/// Two bodies in motion with a joint; the first one may have a prescribed velocity.
Recipe moving_pair(InteractionKind kind, Random& random, double compliance, double damping) {
    Recipe r;
    r.world.step = 1.0 / 60.0;
    std::vector<BodyId> ids;
    for (int b = 0; b < 2; ++b) {
        const BodyId id = r.rigid(random.vector(1.0), random.rotation(), random.uniform(1.0, 3.0),
                                  {0.2, 0.3, 0.4});
        BodyDef& def = r.bodies[at(id.index)];
        if (b == 0 && random.chance(0.3)) def.kind = BodyKind::kinematic;
        def.velocity = random.vector(2.0);
        def.angular_velocity = random.vector(4.0);
        ids.push_back(id);
    }
    InteractionDef d = r.at(kind, ids, random.vector(1.0), random.rotation());
    if (kind == InteractionKind::Universal)
        d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
    // Open by a few centimetres and degrees, so that no violation is zero.
    d.point[1] += random.vector(0.05);
    d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(0.1, random.vector(1.0).normalized()));
    if (kind == InteractionKind::Distance) {
        d.point[1] += Vec3(0.7, 0.0, 0.0);
        d.set("length", 0.6);
    }
    d.compliance.fill(compliance);
    d.damping_time.fill(damping);
    r.add(d);
    return r;
}

/// Return the violations of interaction 0 after `time` with packed velocities.
model::RowState moved_state(model::Bodies& b, const model::Interactions& in, const double* v,
                            double time) {
    const auto x = b.x;
    const auto q = b.q;
    const auto r = b.r;
    for (const std::int32_t body : b.moving) {
        const double* u = v + b.dof_begin[at(body)];
        b.drift(body, u, u + 3, time);
    }
    for (const std::int32_t body : b.driven) {
        const double* u = &b.v_fixed[6 * at(body)];
        b.drift(body, u, u + 3, time);
    }
    const model::RowState out = in.row_state(0, b);
    b.x = x;
    b.q = q;
    b.r = r;
    return out;
}

TEST(CompliantRows, HoldWithTheViolationsAtBothEndsOfTheStep) {
    for (const std::uint32_t seed : seeds(1, 5, 50, 500))
        for (const InteractionKind kind : kCompletedKinds) {
            SCOPED_TRACE(::testing::Message() << kind_info(kind).name << ", seed " << seed);
            Random random(seed);
            const double tau = random.chance(0.5) ? kDefault : random.uniform(0.0, 0.1);
            const Recipe r = moving_pair(kind, random, 1e-8, tau);
            const auto ctx = r.context();
            model::Interactions& in = ctx->model.interactions;
            model::Bodies& b = ctx->model.bodies;
            ASSERT_TRUE(in.uses_secants(0));
            solve::evaluate_rows(ctx->model, ctx->pool);
            in.completed[0] = assembly::kCompliant;
            std::vector<double> u(b.v.begin(), b.v.end());
            for (double& each : u) each += random.uniform(-0.3, 0.3);
            const assembly::View v = context::row_view(ctx->model);
            const model::Pool& pool = in.pool[static_cast<std::size_t>(kind)];
            const double h = r.world.step;
            const model::RowState now = in.row_state(0, b, u.data());
            const model::RowState before = moved_state(b, in, b.v.data(), -h);
            const model::RowState after = moved_state(b, in, u.data(), h);
            double back[kMaxInteractionRows], ahead[kMaxInteractionRows];
            in.secants_before(0, b, h, back);
            in.secants_after(0, b, u.data(), h, ahead);
            for (const bool first : {true, false}) {
                (void)assembly::kernels().complete_rows(v, kind, pool.ids.data(), pool.data.data(),
                                                        0, 1, u.data(), first);
                for (std::size_t k = 0; k < in.rows[0]; ++k) {
                    const double d_before = (now.g[k] - before.g[k]) / h,
                                 d_after = (after.g[k] - now.g[k]) / h;
                    const double want = now.rate[k] - d_after - 4.0 * in.upsilon[k] / h * now.g[k] +
                                        in.upsilon[k] * in.recall[k] * d_before;
                    // Rounding of violations of order one, over the step.
                    const double tolerance = 1e-15 * 20.0 / h;
                    EXPECT_NEAR(first ? v.c[k] : v.c_next[k], want, tolerance);
                    EXPECT_NEAR(back[k], d_before, tolerance);
                    EXPECT_NEAR(ahead[k], d_after, tolerance);
                }
            }
        }
}

/// The law of a joint without damping contains κ (d₊ − d₋) if the step does not resolve its
/// vibration, and damping if it is stiff.
TEST(CompliantRows, HaveAShiftIfUnresolved) {
    for (const double compliance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-9, 1e-11}) {
        SCOPED_TRACE(compliance);
        Recipe r;
        const BodyId ground = r.ground(),
                     bob = r.rigid({0, 0, -1}, Quat::Identity(), 2.0, {0.1, 0.1, 0.1});
        InteractionDef d = r.at(InteractionKind::Ball, {ground, bob}, {0, 0, -1});
        d.compliance.fill(compliance);
        d.damping_time.fill(0.0);
        r.add(d);
        const auto ctx = r.context();
        const model::Interactions& in = ctx->model.interactions;
        // The joint is at the centre of mass: W = 1/m.
        const double h = r.world.step, z = h * h / (4.0 * compliance * 2.0);
        const double tau = z > 1e4 ? 0.1 * h * (z - 1e4) / (z + 1e4) : 0.0;
        const double least = z > 0.25 ? 0.1 * (z - 0.25) / (z + 0.25) : 0.0;
        const double shift = std::max(0.0, least - tau / h),
                     both = h * tau / (2.0 * compliance) + z;
        const double late = tau > 0.0 ? -1.0 / std::expm1(-both) - 1.0 / both : 1.0;
        // Tolerances: a few roundings of numbers of order one.
        EXPECT_NEAR(in.mobility[0], 0.5, 1e-15);
        EXPECT_NEAR(in.upsilon[0], 1.0 / (1.0 + 4.0 * (tau * late / h + shift)), 2e-15);
        EXPECT_NEAR(in.recall[0], 1.0 - 4.0 * (tau * (1.0 - late) / h - shift), 2e-15);
        EXPECT_EQ(in.uses_secants(0), z > 0.1);
    }
}

}  // namespace
}  // namespace hawser::test
