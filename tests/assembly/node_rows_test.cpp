// SPDX-License-Identifier: Apache-2.0
/// Update of rows of wires in lanes (assembly/isa/node_rows.h) against its formula by scalars.
#include "assembly/kernels.h"
#include "base/index.h"
#include "context/view.h"
#include "solve/evaluate.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

/// Make two wires whose elements and bends are added in a random order, so that their rows are
/// partly consecutive. Some elements are tension-only and slack.
Recipe shuffled_wires(Random& random) {
    Recipe r = wire(random.integer(3, 40));
    const Recipe other = wire(random.integer(3, 20));
    const auto shift = static_cast<std::int32_t>(r.bodies.size());
    r.bodies.insert(r.bodies.end(), other.bodies.begin(), other.bodies.end());
    for (InteractionDef d : other.interactions) {
        for (BodyId& id : d.body)
            if (id.index >= 0) id.index += shift;
        r.interactions.push_back(d);
    }
    for (BodyDef& b : r.bodies)
        if (b.kind == BodyKind::lump) b.position += random.vector(0.2);
    for (std::size_t i = r.interactions.size() - 1; i > 0; --i)
        if (random.chance(0.3))
            std::swap(
                r.interactions[i],
                r.interactions[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    return r;
}

struct Rows {
    std::vector<double> lambda, residual, multiplier, force;
    bool operator==(const Rows&) const = default;
};

/// Values that an update reads and overwrites.
struct Start {
    std::vector<double> lambda, residual;
};

class UpdatedRows {
  public:
    UpdatedRows(context::StepContext& ctx, Random& random)
        : ctx_(ctx), v(context::row_view(ctx.model)) {
        const auto fill = [&](double* p, std::int64_t n, double size) {
            for (std::int64_t i = 0; i < n; ++i) p[i] = random.uniform(-size, size);
        };
        rows_ = ctx.model.interactions.row_count;
        fill(v.solution, ctx.model.system.symbolic.scalars, 1.0);
        fill(v.v_new, ctx.model.bodies.dofs, 1.0);
        fill(v.lambda, rows_, 10.0);
        fill(v.residual, rows_, 1.0);
        for (std::int32_t i = 0; i < v.interaction_count; ++i)
            v.active[i] = random.chance(0.8) ? 1.0 : 0.0;
        start_ = {{v.lambda, v.lambda + rows_}, {v.residual, v.residual + rows_}};
    }

    /// Update the rows of all interactions, in ranges that end at the given numbers.
    Rows update(const std::vector<std::int32_t>& ends, bool first) {
        std::copy(start_.lambda.begin(), start_.lambda.end(), v.lambda);
        std::copy(start_.residual.begin(), start_.residual.end(), v.residual);
        std::int32_t begin = 0;
        for (const std::int32_t end : ends) {
            assembly::kernels().row_update(v, begin, end, first);
            begin = end;
        }
        Rows out;
        out.lambda.assign(v.lambda, v.lambda + rows_);
        out.residual.assign(v.residual, v.residual + rows_);
        out.multiplier.assign(v.multiplier, v.multiplier + rows_);
        for (std::int32_t i = 0; i < v.interaction_count; ++i)
            if (v.geo[i].record >= 0)
                for (int k = 0; k < 3; ++k) out.force.push_back(v.geo_force[v.geo[i].force + k]);
        return out;
    }

    /// Return row r of G u of interaction i.
    template <class Offset>
    [[nodiscard]] double product(std::int32_t i, int r, const double* u, Offset offset) const {
        int width = 0;
        for (int b = 0; b < v.bodies[i]; ++b) width += v.dof[body(i, b)];
        const double* jac = v.jacobian + v.jac_begin[i] + r * width;
        double sum = 0.0;
        for (int b = 0; b < v.bodies[i]; ++b)
            for (int k = 0; k < v.dof[body(i, b)]; ++k) sum += *jac++ * u[offset(body(i, b)) + k];
        return sum;
    }

    /// Expect λ, residuals and multipliers of condensed rows, and the geometric force of lines
    /// between point masses, by their definitions.
    void expect(const Rows& got, bool first) const {
        std::size_t line = 0;
        for (std::int32_t i = 0; i < v.interaction_count; ++i) {
            SCOPED_TRACE(testing::Message() << "interaction " << i << (first ? ", first" : ""));
            ASSERT_LT(v.interaction_offset[i], 0);
            for (int r = 0; r < v.rows[i]; ++r) {
                const auto row = static_cast<std::size_t>(v.row_begin[i] + r);
                const double on = v.active[i], kept = r == 0 ? (1.0 - on) * v.held[i] : 0.0;
                const double change =
                    product(i, r, v.solution, [&](int b) { return v.body_offset[b]; });
                const double speed = product(i, r, v.v_new, [&](int b) { return v.dof_begin[b]; });
                const double last = start_.residual[row],
                             before = first ? kept : start_.lambda[row];
                const double lambda = before + on / v.sigma[row] * (last - change);
                const double residual =
                    first ? last - on * change - v.sigma[row] * lambda
                          : on * (v.c[row] - speed) - v.sigma[row] * (lambda - kept);
                // Rounding of sums of nine products of order one, over Σ.
                const double tolerance = 1e-14 * (1.0 + std::abs(v.c[row]));
                EXPECT_NEAR(got.lambda[row], lambda, tolerance * (10.0 + 1.0 / v.sigma[row]));
                EXPECT_NEAR(got.residual[row], residual, tolerance * 10.0 * (1.0 + v.sigma[row]));
                EXPECT_NEAR(got.multiplier[row], on * (lambda + residual / v.sigma[row]) + kept,
                            tolerance * (10.0 + 20.0 / v.sigma[row]));
            }
            if (v.geo[i].record < 0) continue;
            if (v.dof[body(i, 0)] == 3 && v.dof[body(i, 1)] == 3) expect_force(i, &got.force[line]);
            line += 3;
        }
    }

  private:
    [[nodiscard]] std::int32_t body(std::int32_t i, int b) const {
        return v.body[kMaxInteractionBodies * i + b];
    }
    void expect_force(std::int32_t i, const double* got) const {
        const double* record = v.geo_record + v.geo[i].record;
        const Vec3 along(record[1], record[2], record[3]);
        const Vec3 speed =
            Vec3(v.v_new + v.dof_begin[body(i, 0)]) - Vec3(v.v_new + v.dof_begin[body(i, 1)]);
        const Vec3 want =
            record[0] * (speed - along.dot(speed) * along) - assembly::pair_mass_of(v, i) * speed;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(got[k], want[k],
                        1e-14 * (1.0 + std::abs(record[0]) + assembly::pair_mass_of(v, i)));
    }

    context::StepContext& ctx_;
    std::int64_t rows_ = 0;
    Start start_;

  public:
    const assembly::View v;
};

TEST(NodeRows, HoldByDefinitionWithTheSameBitsInAnyGroup) {
    for (const std::uint32_t seed : seeds(1, 20, 200, 2000)) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const Recipe r = shuffled_wires(random);
        const auto ctx = r.context();
        solve::evaluate_rows(ctx->model, ctx->pool);
        UpdatedRows rows(*ctx, random);
        const std::int32_t count = rows.v.interaction_count;
        for (const bool first : {true, false}) {
            const Rows whole = rows.update({count}, first);
            rows.expect(whole, first);
            const std::int32_t split = random.integer(0, count),
                               next = random.integer(split, count);
            EXPECT_EQ(rows.update({split, next, count}, first), whole);
        }
    }
}

}  // namespace
}  // namespace hawser::test
