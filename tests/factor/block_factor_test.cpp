// SPDX-License-Identifier: Apache-2.0
/// The solver through its public header.
#include "factor/matrices.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/factor.h>

#include <cstring>
#include <limits>
#include <stdexcept>

namespace hawser::test {
namespace {

/// Return the values in the order of the public interface.
std::vector<double> values_of(BlockMatrix& m, const BlockPattern& p, const BlockFactor& f) {
    std::vector<double> values(static_cast<std::size_t>(f.value_count()));
    auto put = [&](std::size_t block, int a, int b) {
        const Matrix k = m.block(a, b);
        auto at = static_cast<std::size_t>(f.value_begin(static_cast<std::int32_t>(block)));
        for (Eigen::Index i = 0; i < k.rows(); ++i)
            for (Eigen::Index j = 0; j < k.cols(); ++j)
                // Entries that are not read may have any value.
                values[at++] = a == b && j > i ? std::numeric_limits<double>::quiet_NaN() : k(i, j);
    };
    for (std::size_t v = 0; v < p.size.size(); ++v)
        put(v, static_cast<int>(v), static_cast<int>(v));
    for (std::size_t e = 0; e < p.edges.size(); ++e)
        put(p.size.size() + e, p.edges[e].row, p.edges[e].column);
    return values;
}

BlockPattern pattern_of(const BlockMatrix& m, Random& random) {
    BlockPattern p;
    p.size = m.pattern.size;
    p.sign = m.pattern.sign;
    for (int a = 0; a < m.pattern.nodes(); ++a)
        for (const std::int32_t b : m.pattern.neighbours(a))
            if (b < a) p.edges.push_back(random.chance(0.5) ? BlockEdge{a, b} : BlockEdge{b, a});
    random.shuffle(p.edges);
    return p;
}

BlockMatrix draw_matrix(Random& random, std::uint32_t seed) {
    return seed % 2 == 0 ? wires(random, 8, 40) : random_quasi_definite(random, 40, 0.08);
}

TEST(BlockFactor, SolvesWithAnyNumberOfThreads) {
    for (const std::uint32_t seed : seeds(1, 8, 40, 400)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        const Vector b = random_matrix(random, m.scalars(), 1);
        std::vector<double> first;
        for (const int threads : {1, 3}) {
            BlockFactor f({.threads = threads});
            f.analyse(p);
            const std::vector<double> k = values_of(m, p, f);
            ASSERT_EQ(f.factor(k), Status::ok);
            std::vector<double> x(b.data(), b.data() + b.size());
            const std::vector<double> rhs = x;
            ASSERT_EQ(f.solve(x), Status::ok);
            const double error = backward_error(m, Eigen::Map<Vector>(x.data(), b.size()), b);
            EXPECT_LE(error, 1e-12);  // growth below 1e4 times 2⁻⁵³
            // Fixed seeds only: with others the residual can differ by more than one rounding.
            if (seed <= 20) {
                EXPECT_NEAR(f.residual(k, x, rhs), error, 1e-16);
            }
            ASSERT_EQ(f.refine(k, rhs, x), Status::ok);
            EXPECT_LE(f.residual(k, x, rhs), 1e-15);
            if (first.empty()) first = x;
            EXPECT_EQ(std::memcmp(x.data(), first.data(), x.size() * sizeof(double)), 0);
        }
    }
}

TEST(BlockFactor, RefactorsInPart) {
    std::int64_t part = 0, whole = 0;
    const auto all = seeds(1, 8, 40, 400);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        BlockFactor f({.partial = true}), full;
        f.analyse(p);
        full.analyse(p);
        std::vector<double> k = values_of(m, p, f);
        ASSERT_EQ(f.factor(k), Status::ok);
        for (int step = 0; step < 5; ++step) {
            std::vector<std::int32_t> changed;
            const auto blocks = static_cast<int>(p.size.size() + p.edges.size());
            for (int c = random.integer(0, 2); c > 0; --c) {
                const int block = random.integer(0, blocks - 1);
                changed.push_back(block);
                const bool diagonal = block < static_cast<int>(p.size.size());
                for (auto i = f.value_begin(block); i < f.value_begin(block + 1); ++i)
                    k[static_cast<std::size_t>(i)] *= diagonal ? 1.01 : 0.99;
            }
            ASSERT_EQ(f.refactor(k, changed), Status::ok);
            ASSERT_EQ(full.factor(k), Status::ok);
            part += f.info().part_flops;
            whole += f.info().flops;
            const Vector b = random_matrix(random, m.scalars(), 1);
            std::vector<double> x(b.data(), b.data() + b.size()), y = x;
            ASSERT_EQ(f.solve(x), Status::ok);
            ASSERT_EQ(full.solve(y), Status::ok);
            EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(double)), 0);
        }
    }
    if (all.size() == 1) return;
    EXPECT_GT(part, 0);
    EXPECT_LT(2 * part, whole);
}

TEST(BlockFactor, FollowsAPattern) {
    for (const std::uint32_t seed : seeds(3, 1, 5, 50)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        BlockMatrix m = random_quasi_definite(random, 60, 0.05);
        BlockPattern p = pattern_of(m, random);
        BlockFactor f;
        f.analyse(p);
        EXPECT_TRUE(f.info().planned);
        for (int step = 0; step < 20; ++step) {
            // Remove an edge: the values of its block are ignored.
            const std::size_t e =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(p.edges.size()) - 1));
            m.block(p.edges[e].row, p.edges[e].column).setZero();
            m.block(p.edges[e].column, p.edges[e].row).setZero();
            p.edges.erase(p.edges.begin() + static_cast<std::ptrdiff_t>(e));
            f.update(p);
            EXPECT_TRUE(f.info().planned || f.info().columns < f.info().nodes);
            const std::vector<double> k = values_of(m, p, f);
            ASSERT_EQ(f.factor(k), Status::ok);
            const Vector b = random_matrix(random, m.scalars(), 1);
            std::vector<double> x(b.data(), b.data() + b.size());
            ASSERT_EQ(f.solve(x), Status::ok);
            EXPECT_LE(backward_error(m, Eigen::Map<Vector>(x.data(), b.size()), b), 1e-12);
        }
    }
}

TEST(BlockFactor, ReportsWhatIsNotQuasiDefinite) {
    BlockFactor f;
    f.analyse({{2, 1}, {1, -1}, {{1, 0}}});
    std::vector<double> k{1, 0, 0, 1, -1, 1, 1};
    EXPECT_EQ(f.factor(k), Status::ok);
    k[3] = -1.0;
    EXPECT_EQ(f.factor(k), Status::wrong_pivot);
    EXPECT_EQ(f.info().wrong_pivots, 1);
    k[3] = 1.0;
    EXPECT_EQ(f.factor(k), Status::ok);
    std::vector<double> x{1.0, std::numeric_limits<double>::infinity(), 0.0};
    EXPECT_EQ(f.solve(x), Status::not_finite);
}

TEST(BlockFactor, RejectsMalformedPatterns) {
    BlockFactor f;
    EXPECT_THROW(f.analyse({{7}, {1}, {}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{0}, {1}, {}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{1}, {2}, {}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{1}, {}, {}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{1, 1}, {1, 1}, {{0, 2}}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{1, 1}, {1, 1}, {{1, 1}}}), std::invalid_argument);
    EXPECT_THROW(f.analyse({{1, 1}, {1, 1}, {{0, 1}, {1, 0}}}), std::invalid_argument);
    f.analyse({{1, 1}, {1, 1}, {{0, 1}}});
    const std::int32_t twice[] = {0, 0}, far[] = {0, 2};
    EXPECT_THROW(f.update({{1, 1}, {1, 1}, {}}, twice), std::invalid_argument);
    EXPECT_THROW(f.update({{1, 1}, {1, 1}, {}}, far), std::invalid_argument);
    f.update({{1, 1}, {1, 1}, {}});
    std::vector<double> x{4.0, 9.0};
    EXPECT_EQ(f.factor(std::vector<double>{2.0, 3.0}), Status::ok);
    EXPECT_EQ(f.solve(x), Status::ok);
    EXPECT_EQ(x, (std::vector<double>{2.0, 3.0}));
}

/// A given order is kept up to a postorder of its tree, and so is its fill.
TEST(BlockFactor, EliminatesInAGivenOrder) {
    for (const std::uint32_t seed : seeds(1, 8, 40, 400)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        std::vector<std::int32_t> order = minimum_degree_order(p);
        if (seed % 3 == 0) {
            random.shuffle(order);
            rows_after_bodies(p, order);
        }
        BlockFactor f;
        f.analyse(p, order);
        EXPECT_EQ(f.info().nodes, m.pattern.nodes());
        // Eliminating in the solver's final order changes nothing.
        const std::vector<std::int32_t> taken(f.order().begin(), f.order().end());
        const FactorInfo info = f.info();
        f.analyse(p, taken);
        EXPECT_TRUE(std::equal(taken.begin(), taken.end(), f.order().begin(), f.order().end()));
        EXPECT_EQ(f.info().factor_nnz, info.factor_nnz);
        EXPECT_EQ(f.info().flops, info.flops);
        const std::vector<double> k = values_of(m, p, f);
        ASSERT_EQ(f.factor(k), Status::ok);
        const Vector b = random_matrix(random, m.scalars(), 1);
        std::vector<double> x(b.data(), b.data() + b.size());
        ASSERT_EQ(f.solve(x), Status::ok);
        EXPECT_LE(backward_error(m, Eigen::Map<Vector>(x.data(), b.size()), b), 1e-12);
    }
    // A star of scalars: eliminating its centre last makes no fill, eliminating it first couples
    // all others.
    const BlockPattern star{{1, 1, 1, 1}, {1, 1, 1, 1}, {{0, 1}, {0, 2}, {0, 3}}};
    BlockFactor f;
    f.analyse(star, std::vector<std::int32_t>{0, 1, 2, 3});
    EXPECT_EQ(f.info().factor_nnz, 10);
    for (const std::vector<std::int32_t>& bad :
         {std::vector<std::int32_t>{0, 1, 2}, {0, 1, 2, 2}, {0, 1, 2, 4}, {0, 1, 2, -1}}) {
        EXPECT_THROW(f.analyse(star, bad), std::invalid_argument);
        std::vector<std::int32_t> order = bad;
        EXPECT_THROW(rows_after_bodies(star, order), std::invalid_argument);
    }
    std::vector<std::int32_t> order{0, 2, 1};
    rows_after_bodies({{1, 1, 1}, {-1, 1, 1}, {{0, 1}}}, order);
    EXPECT_EQ(order, (std::vector<std::int32_t>{2, 1, 0}));
}

/// An empty matrix is valid.
TEST(BlockFactor, SolvesNothing) {
    BlockFactor f;
    EXPECT_EQ(f.factor({}), Status::ok);
    EXPECT_EQ(f.solve({}), Status::ok);
    EXPECT_EQ(f.info().scalars, 0);
}

/// A large change leads to a new plan, except for given orders: they remain until the flops have
/// grown.
TEST(BlockFactor, UpdatesKeepAnOrderThatWasGiven) {
    constexpr std::int32_t kNodes = 64;
    BlockPattern path;
    path.size.assign(kNodes, 3);
    path.sign.assign(kNodes, 1);
    std::vector<std::int32_t> order;
    for (std::int32_t i = 0; i < kNodes; ++i) order.push_back(kNodes - 1 - i);
    for (std::int32_t i = 0; i + 1 < kNodes; ++i) path.edges.push_back({i, i + 1});
    BlockPattern edited = path;
    for (std::int32_t i = 0; i < 5; ++i) edited.edges.push_back({12 * i, 12 * i + 2});
    BlockFactor given, own;
    given.analyse(path, order);
    own.analyse(path);
    given.update(edited);
    own.update(edited);
    EXPECT_FALSE(given.info().planned);
    EXPECT_TRUE(own.info().planned);
}

}  // namespace
}  // namespace hawser::test
