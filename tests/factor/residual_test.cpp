// SPDX-License-Identifier: Apache-2.0
/// Residuals and backward errors of block matrices against dense ones in long double.
#include "factor/residual.h"
#include "base/index.h"
#include "factor/block_inputs.h"
#include "factor/instruction_sets.h"
#include "runtime/tasks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hawser::test {
namespace {

/// A matrix, a vector that is no solution, and scales, as the class wants them.
struct ResidualCase {
    explicit ResidualCase(std::uint64_t seed)
        : random(seed), m(draw_matrix(random, static_cast<int>(seed))) {
        const BlockPattern p = pattern_of(m, random);
        BlockFactor f;
        f.analyse(p);
        given = values_of(m, p, f);
        residual.reserve(p);
        const std::size_t n = at(m.scalars()) + 8;
        x.assign(n, std::nan(""));  // nothing is to be taken from behind the end
        b = scale = rest = x;
        for (int i = 0; i < m.scalars(); ++i) {
            x[at(i)] = random.uniform(-1, 1);
            b[at(i)] = random.uniform(-1, 1);
        }
    }
    /// max_i |b − K x|_i s_i / ((|K| |x| + |b|)_i s_i + guard).
    [[nodiscard]] double error(double guard) const {
        long double most = 0.0L;
        for (int i = 0; i < m.scalars(); ++i) {
            long double left = b[at(i)], total = std::abs(b[at(i)]);
            for (int j = 0; j < m.scalars(); ++j) {
                const long double product = static_cast<long double>(m.dense(i, j)) * x[at(j)];
                left -= product;
                total += std::abs(product);
            }
            const long double s = scale[at(i)];
            most = std::max(most, std::abs(left) * s / (total * s + guard));
        }
        return static_cast<double>(most);
    }

    Random random;
    BlockMatrix m;
    std::vector<double> given;
    factor::BlockResidual residual;
    std::vector<double> x, b, scale, rest;
};

TEST(BlockResidual, IsThatOfTheDenseMatrix) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        ResidualCase c(seed);
        std::vector<double> first;
        for (const int threads : {1, 3}) {
            runtime::Pool pool(threads);
            c.residual.keep(c.given, pool);
            c.residual.find_scale(c.scale.data(), pool);
            const factor::ResidualSize size =
                c.residual.run(c.scale.data(), c.x.data(), c.b.data(), 0.125, c.rest.data(), pool);
            // Sums of a few hundred products.
            EXPECT_NEAR(size.error, c.error(0.125), 1e-13);
            double most = 0.0;
            for (int i = 0; i < c.m.scalars(); ++i) {
                long double left = c.b[at(i)];
                for (int j = 0; j < c.m.scalars(); ++j)
                    left -= static_cast<long double>(c.m.dense(i, j)) * c.x[at(j)];
                EXPECT_NEAR(c.rest[at(i)], static_cast<double>(left), 1e-12);
                most = std::max(most, std::abs(c.rest[at(i)] * c.scale[at(i)]));
                const double d = std::abs(c.m.dense(i, i)) * c.scale[at(i)] * c.scale[at(i)];
                EXPECT_TRUE(d >= 1.0 && d < 4.0) << d;
            }
            EXPECT_EQ(size.size, most);
            EXPECT_TRUE(std::isnan(c.rest[at(c.m.scalars())])) << "written behind the end";
            if (first.empty()) first = c.rest;
            EXPECT_TRUE(std::equal(first.begin(), first.end() - 8, c.rest.begin()));
        }
    }
}

TEST(BlockResidual, FindsWhatIsNotFinite) {
    ResidualCase c(4);
    base::SerialExecutor serial;
    c.residual.keep(c.given, serial);
    c.residual.find_scale(c.scale.data(), serial);
    auto error = [&] {
        return c.residual.run(c.scale.data(), c.x.data(), c.b.data(), 1.0, c.rest.data(), serial)
            .error;
    };
    EXPECT_TRUE(std::isfinite(error()));
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
        for (const int i : {0, c.m.scalars() / 2, c.m.scalars() - 1}) {
            const double good = c.x[at(i)];
            c.x[at(i)] = bad;
            EXPECT_FALSE(std::isfinite(error())) << bad << " at " << i;
            c.x[at(i)] = good;
        }
    EXPECT_TRUE(std::isfinite(error()));
}

/// Rows of one to six scalars with every instruction set: 2 x, −x, x in two nodes.
TEST(BlockResidual, EveryKernelAgrees) {
    for (int rows = 1; rows <= 6; ++rows)
        for (int others = 1; others <= 6; ++others) {
            Random random(static_cast<std::uint64_t>(10 * rows + others));
            const std::int64_t term[] = {0, 2}, scalar[] = {0, rows};
            const factor::ResidualTerm terms[] = {{0, 0, rows}, {rows * rows, rows, others}};
            std::vector<double> k(at(rows * (rows + others)) + 8, 1e300), x(20, 1e300),
                b(20, 1e300), scale(20, 1e300);
            for (int i = 0; i < rows * (rows + others); ++i) k[at(i)] = random.integer(-8, 8);
            for (int i = 0; i < rows + others; ++i) x[at(i)] = random.integer(-8, 8);
            for (int i = 0; i < rows; ++i) {
                b[at(i)] = random.integer(-8, 8);
                scale[at(i)] = 0.5;
            }
            for (const Set& set : sets()) {
                if (!set.available) continue;
                std::vector<double> r(20, 7.0);
                const factor::ResidualSize size =
                    set.kernels->residual({term, terms, scalar, k.data(), scale.data(), x.data(),
                                           b.data(), r.data(), 0.25},
                                          0, 1);
                double error = 0.0, most = 0.0;
                for (int i = 0; i < rows; ++i) {
                    double left = b[at(i)], total = std::abs(left);
                    for (int j = 0; j < rows + others; ++j) {
                        left -= k[at(j * rows + i)] * x[at(j)];
                        total += std::abs(k[at(j * rows + i)] * x[at(j)]);
                    }
                    EXPECT_EQ(r[at(i)], left) << set.name;  // whole numbers
                    error = std::max(error, std::abs(left) / (total + 0.5));
                    most = std::max(most, std::abs(left) / 2);
                }
                EXPECT_EQ(r[at(rows)], 7.0) << set.name;
                EXPECT_EQ(size.size, most) << set.name;
                EXPECT_NEAR(size.error, error, 1e-15) << set.name;
            }
        }
}

}  // namespace
}  // namespace hawser::test
