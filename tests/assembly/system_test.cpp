// SPDX-License-Identifier: Apache-2.0
/// The assembled blocks, right-hand sides and solution against the dense equations.
#include "assembly/dense.h"
#include "assembly/geo.h"
#include "context/context.h"
#include "context/view.h"
#include "solve/drives.h"
#include "solve/losses.h"
#include "solve/solve.h"
#include "step/assemble_rows.h"
#include "step/step.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <string>

namespace hawser::test {
namespace {

using context::StepContext;

/// Return the matrix in the panels, in the permuted order.
Matrix assembled(const assembly::System& s, const double* panel) {
    Matrix k = Matrix::Zero(s.symbolic.scalars, s.symbolic.scalars);
    auto get = [&](int row, int column) {
        const factor::BlockTarget t = s.symbolic.target(row, column);
        const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
        for (int j = 0; j < s.pattern.size[c]; ++j)
            for (int i = row == column ? j : 0; i < s.pattern.size[r]; ++i) {
                const int a = s.symbolic.node_offset[r] + i, b = s.symbolic.node_offset[c] + j;
                k(a, b) = k(b, a) = panel[t.address + static_cast<std::int64_t>(j) * t.ld +
                                          static_cast<std::int64_t>(i) * t.step];
            }
    };
    for (int n = 0; n < s.pattern.nodes(); ++n) {
        get(n, n);
        for (std::int32_t m : s.pattern.neighbours(n))
            if (s.symbolic.position[static_cast<std::size_t>(m)] <
                s.symbolic.position[static_cast<std::size_t>(n)])
                get(n, m);
    }
    return k;
}

/// Compute the matrix from the dense equations: condensed rows eliminated, kept rows bordered.
Matrix expected(const StepContext& ctx, const DenseStep& d) {
    const assembly::System& s = ctx.model.system;
    const model::Interactions& in = ctx.model.interactions;
    const int n = ctx.model.bodies.dofs, size = s.symbolic.scalars;
    Matrix body = d.tilde();
    Matrix select = Matrix::Zero(size, n);  // permuted scalar of each velocity
    for (std::int32_t b : ctx.model.bodies.moving) {
        const auto i = static_cast<std::size_t>(b);
        for (int k = 0; k < ctx.model.bodies.dof(b); ++k)
            select(s.symbolic.node_offset[static_cast<std::size_t>(s.node_of_body[i])] + k,
                   ctx.model.bodies.dof_begin[i] + k) = 1.0;
    }
    Matrix kept = Matrix::Zero(size, n), sigma = Matrix::Zero(size, size);
    for (int id = 0; id < in.count(); ++id) {
        const auto i = static_cast<std::size_t>(id);
        for (int r = 0; r < in.rows[i]; ++r) {
            const int row = in.row_begin[i] + r;
            if (s.node_of_interaction[i] < 0) {
                body += d.g.row(row).transpose() * d.g.row(row) / d.sigma[row];
                continue;
            }
            const auto node = static_cast<std::size_t>(s.node_of_interaction[i]);
            const int at = s.symbolic.node_offset[node] + r;
            kept.row(at) = d.g.row(row);
            sigma(at, at) = -d.sigma[row];
        }
    }
    return select * body * select.transpose() + kept * select.transpose() +
           select * kept.transpose() + sigma;
}

/// Write the whole matrix like a step does, piece by piece.
void write_blocks(StepContext& ctx) {
    assembly::System& s = ctx.model.system;
    const assembly::View v = context::view(ctx);
    s.numeric.clear(s.symbolic, ctx.pool);
    for (int p = 0; p < static_cast<int>(s.numeric.pieces().size()); ++p)
        s.write_blocks(v, p, s.numeric.values());
}

/// A mixed scene, or chains long enough for batches of eight links, some steps after the start, so
/// that no term is zero. With even seeds, forces make the transverse vibration of joints too fast
/// for the step.
struct Drawn {
    std::uint32_t seed;
    Form form;
    bool in_chains;
    [[nodiscard]] bool fast() const { return seed % 2 == 0; }
    [[nodiscard]] std::unique_ptr<StepContext> context() const {
        Recipe r = in_chains ? chains(seed, 4, 11) : mixed(seed, 8);
        r.world.form = form;
        auto ctx = r.context();
        for (int i = 0; i < 4; ++i) EXPECT_EQ(step::step(*ctx), Status::ok);
        if (fast())
            for (double& l : ctx->model.interactions.lambda) l *= 1000.0;
        return ctx;
    }
    /// Return a context with the rows of the step. Joints iterated at the end of the step have
    /// other right-hand sides, which tests of step/completion.h check.
    [[nodiscard]] std::unique_ptr<StepContext> with_rows() const {
        auto ctx = context();
        ctx->model.completion.banned = true;
        step::assemble_rows(*ctx);
        return ctx;
    }
};

class Seeds : public testing::TestWithParam<Form> {
  protected:
    /// Call check(drawn) for mixed scenes and chains until it fails.
    template <class Check>
    static void for_each_scene(Check&& check) {
        for (const std::uint32_t seed : seeds(1, 2, 8, 80))
            for (const bool in_chains : {false, true}) {
                SCOPED_TRACE("seed " + std::to_string(seed) + (in_chains ? ", chains" : ", mixed"));
                check(Drawn{seed, GetParam(), in_chains});
                if (HasFatalFailure()) return;
            }
    }
};
INSTANTIATE_TEST_SUITE_P(Forms, Seeds,
                         testing::Values(Form::automatic, Form::saddle, Form::condensed));

TEST_P(Seeds, OfChainsGoEightAtATime) {
    for (const std::uint32_t seed : seeds(7, 2, 8, 80)) {
        SCOPED_TRACE(seed);
        const auto ctx = Drawn{seed, GetParam(), true}.context();
        const assembly::View v = context::view(*ctx);
        EXPECT_EQ(*std::max_element(v.links, v.links + v.body_count), 9);
        EXPECT_EQ(std::count_if(v.arms, v.arms + v.interaction_count, [](int a) { return a != 0; }),
                  4 * 10 + 4);
        const bool saddle = GetParam() == Form::saddle;
        const auto& ops = ctx->model.system.lane_ops;
        EXPECT_TRUE(std::any_of(ops.begin(), ops.end(), [&](const assembly::LaneOp& op) {
            return op.width == 0 &&
                   op.kind == (saddle ? assembly::Op::kept_rows : assembly::Op::condensed);
        }));
        EXPECT_TRUE(std::any_of(ops.begin(), ops.end(), [](const assembly::LaneOp& op) {
            return op.kind == assembly::Op::body_block;
        }));
        // Every other chain has its joints in the opposite direction.
        EXPECT_EQ(std::any_of(ops.begin(), ops.end(),
                              [](const assembly::LaneOp& op) { return op.turned != 0; }),
                  !saddle);
    }
}

TEST_P(Seeds, BlocksEqualTheDenseMatrix) {
    for_each_scene([](const Drawn& scene) {
        const auto ctx = scene.with_rows();
        const DenseStep d = dense_step(*ctx);
        write_blocks(*ctx);
        const Matrix got = assembled(ctx->model.system, ctx->model.system.numeric.values());
        const Matrix want = expected(*ctx, d);
        ASSERT_EQ(got.rows(), want.rows());
        // The diagonal of a block row bounds the terms that are added to it. 1e-11 of it covers
        // rounding of sums of a few hundred terms and of the projection's eigenvectors.
        for (Eigen::Index i = 0; i < got.rows(); ++i)
            for (Eigen::Index j = 0; j < got.cols(); ++j) {
                const double scale = std::sqrt(std::abs(want(i, i) * want(j, j)));
                ASSERT_NEAR(got(i, j), want(i, j), 1e-11 * scale + 1e-13) << i << " " << j;
            }
    });
}

TEST_P(Seeds, RightHandSidesEqualTheDenseOnes) {
    for_each_scene([](const Drawn& scene) {
        const auto ctx = scene.with_rows();
        const DenseStep d = dense_step(*ctx);
        const assembly::View v = context::view(*ctx);
        for (int r = 0; r < ctx->model.interactions.row_count; ++r) {
            const auto k = static_cast<std::size_t>(r);
            if (d.g.row(r).isZero(0.0)) continue;  // a joint inside its range
            EXPECT_NEAR(v.c[r], d.c[r], 1e-11 * (1.0 + std::abs(d.c[r]))) << "row " << r;
            EXPECT_NEAR(ctx->model.interactions.sigma[k], d.sigma[r], 1e-12 * d.sigma[r])
                << "row " << r;
        }
        const double scale = d.a.cwiseAbs().maxCoeff();
        for (std::int32_t b : ctx->model.bodies.moving) {
            const int at = ctx->model.bodies.dof_begin[static_cast<std::size_t>(b)];
            for (int k = 0; k < ctx->model.bodies.dof(b) && k < 3; ++k)
                EXPECT_NEAR(v.a[at + k], d.a[at + k], 1e-12 * scale) << "body " << b;
        }
    });
}

/// Reference: v₊ and λ by a dense solution in long double, with the stepper's own a.
TEST_P(Seeds, SolutionSolvesTheDenseEquations) {
    for_each_scene([](const Drawn& scene) {
        const auto ctx = scene.with_rows();
        const DenseStep d = dense_step(*ctx);
        const int n = ctx->model.bodies.dofs, rows = ctx->model.interactions.row_count;
        const assembly::View view = context::view(*ctx);
        const Vector a = Eigen::Map<const Vector>(view.a, n) - d.couple_fixed;
        ASSERT_EQ(solve::factor_and_solve(*ctx), Status::ok);

        Matrix k = Matrix::Zero(n + rows, n + rows);
        k.topLeftCorner(n, n) = d.tilde();
        k.bottomLeftCorner(rows, n) = d.g;
        k.topRightCorner(n, rows) = d.g.transpose();
        Vector b(n + rows);
        b << a, d.c;
        for (int r = 0; r < rows; ++r) {
            k(n + r, n + r) = -d.sigma[r];
            if (d.g.row(r).isZero(0.0)) b[n + r] = 0.0;  // inactive
        }
        const Vector x = solve_dense(k, b);
        const Vector want = x.head(n);
        const Vector got = Eigen::Map<const Vector>(view.v_new, n);
        // After one refinement on the saddle residual in double: 1e-12 of the largest velocity.
        EXPECT_LE((got - want).cwiseAbs().maxCoeff(), 1e-12 * want.cwiseAbs().maxCoeff());
        const Vector lambda = -x.tail(rows);
        const Vector have = Eigen::Map<const Vector>(view.lambda, rows);
        // λ of rows as stiff as 1e-12 m/N: rounding of the velocities over Σ ≈ 1e-9.
        EXPECT_LE((have - lambda).cwiseAbs().maxCoeff(), 1e-6 * lambda.cwiseAbs().maxCoeff());

        // The matrix-free residual equals the residual of the dense equations.
        const Vector residual = a - d.tilde() * got + d.g.transpose() * have;
        const double scale = a.cwiseAbs().maxCoeff();
        std::vector<double> momentum(static_cast<std::size_t>(n));
        assembly::View kept = view;
        kept.momentum = momentum.data();
        assembly::Norms norms;
        assembly::kernels().body_norms(kept, 0, view.body_count, &norms);
        for (int i = 0; i < n; ++i)
            EXPECT_NEAR(momentum[static_cast<std::size_t>(i)], residual[i], 1e-11 * scale);
        EXPECT_LE(ctx->work.stats.momentum_residual, 1e-10);
    });
}

/// Losses collected while the solution was measured equal the losses of its rows.
TEST_P(Seeds, LossesAreThoseOfTheSolution) {
    for_each_scene([](const Drawn& scene) {
        const auto ctx = scene.with_rows();
        EXPECT_FALSE(ctx->work.solve.losses_known);
        ASSERT_EQ(solve::factor_and_solve(*ctx), Status::ok);
        ASSERT_TRUE(ctx->work.solve.losses_known);
        const double taken = solve::row_losses(ctx->model, ctx->work.solve, ctx->pool);
        ctx->work.solve.losses_known = false;
        EXPECT_EQ(taken, solve::row_losses(ctx->model, ctx->work.solve, ctx->pool));
    });
}

TEST_P(Seeds, GeometricStiffnessIsSymmetricAndPositive) {
    int swinging = 0;
    for_each_scene([&](const Drawn& scene) {
        const auto ctx = scene.with_rows();
        const DenseStep d = dense_step(*ctx);
        for (const Matrix* k : {&d.geometric, &d.damping}) {
            EXPECT_LE((*k - k->transpose()).cwiseAbs().maxCoeff(),
                      1e-15 * (1 + k->cwiseAbs().maxCoeff()));
            EXPECT_GE(spectrum(*k).values.minCoeff(), -1e-14 * (1e-3 + k->cwiseAbs().maxCoeff()));
        }
        EXPECT_GT(d.geometric.cwiseAbs().maxCoeff(), 0.0) << "nothing was under load";
        swinging += scene.fast() && d.fastest > 0.1 ? 1 : 0;
    });
    if (std::uint32_t seed = 0; !seed_from_environment(seed)) {
        EXPECT_GT(swinging, 0);
    }
}

TEST(ArmStiffness, IsTheProjectionOfTheSymmetrisedOne) {
    Random random(first_seed(4));
    const int trials = by_tier(500, 2500, 25'000);
    for (int trial = 0; trial < trials; ++trial) {
        const Vec3 r = random.vector(2.0);
        Vec3 f = random.vector(1e5);
        if (trial % 5 == 0) f = random.uniform(-1, 1) * r;              // along the arm
        if (trial % 7 == 0) f = r.cross(f) / r.norm();                  // perpendicular to it
        if (trial % 50 == 0) f = 1e-9 * f + random.uniform(-9, 9) * r;  // almost along
        double s[6];
        generic::arm_stiffness({f.x(), f.y(), f.z()}, f.norm(), {r.x(), r.y(), r.z()}, r.norm(),
                               0.5, s);
        Mat3 got;
        got << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
        const Mat3 want = 0.5 * projected(f.dot(r) * Mat3::Identity() - r * f.transpose());
        EXPECT_LE((got - want).norm(), 1e-13 * f.norm() * r.norm()) << "trial " << trial;
    }
    double zero[6];
    generic::arm_stiffness({0, 0, 0}, 0.0, {1, 0, 0}, 1.0, 1.0, zero);
    for (double z : zero) EXPECT_EQ(z, 0.0);
}

/// All interactions are internal: impulses on the bodies sum to those of gravity and applied
/// forces. This holds for all forms and geometric stiffnesses.
TEST(Momentum, LinearMomentumOfAnIsolatedSystemIsConserved) {
    for (const std::uint32_t seed : seeds(1, 4, 20, 200)) {
        Recipe r = link_chain(8);
        r.interactions.erase(r.interactions.begin());  // leaves the system free in space
        r.world.gravity = {0, 0, 0};
        Random random(seed);
        double mass = 0.0;
        Vec3 before = Vec3::Zero();
        for (BodyDef& b : r.bodies) {
            if (b.kind != BodyKind::rigid) continue;
            b.velocity = random.vector(2.0);
            b.angular_velocity = random.vector(2.0);
            before += b.mass * b.velocity;
            mass += b.mass;
        }
        World w = r.make();
        for (int i = 0; i < 200; ++i) ASSERT_EQ(w.step(), Status::ok);
        Vec3 after = Vec3::Zero();
        for (int i = 1; i < w.body_count(); ++i)
            after += w.body_def(BodyId{i}).mass * w.velocity(BodyId{i}).linear;
        // 200 steps, each with rounding of impulses of about 1e3 N s: 200 · 1e3 · 2⁻⁵³ · 8.
        EXPECT_LE((after - before).norm(), 1e-9) << "seed " << seed << " mass " << mass;
    }
}

}  // namespace
}  // namespace hawser::test
