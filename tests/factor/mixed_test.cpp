// SPDX-License-Identifier: Apache-2.0
/// Factors in float, refined in double: Precision::mixed of hawser/factor.h.
#include "base/index.h"
#include "factor/block_inputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace hawser::test {
namespace {

constexpr FactorOptions kMixed{.precision = Precision::mixed};

std::vector<double> random_values(Random& random, int n) {
    std::vector<double> v;
    for (int i = 0; i < n; ++i) v.push_back(random.uniform(-1, 1));
    return v;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// max_i |b − K x|_i / (|K| |x| + |b|)_i in long double.
double componentwise_error(const BlockMatrix& m, const std::vector<double>& x,
                           const std::vector<double>& b) {
    long double most = 0.0L;
    for (int i = 0; i < m.scalars(); ++i) {
        long double left = b[at(i)], total = std::abs(left);
        for (int j = 0; j < m.scalars(); ++j) {
            const long double product = static_cast<long double>(m.dense(i, j)) * x[at(j)];
            left -= product;
            total += std::abs(product);
        }
        if (total > 0.0L) most = std::max(most, std::abs(left) / total);
    }
    return static_cast<double>(most);
}

TEST(Mixed, SolvesAsExactlyAsDouble) {
    std::int64_t refinements = 0;
    for (int seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        const std::vector<double> b = random_values(random, m.scalars());
        BlockFactor full;
        full.analyse(p);
        const std::vector<double> k = values_of(m, p, full);
        ASSERT_EQ(full.factor(k), Status::ok);
        std::vector<double> exact = b, first;
        ASSERT_EQ(full.solve(exact), Status::ok);
        ASSERT_EQ(full.refine(k, b, exact), Status::ok);
        for (const int threads : {1, 2, 3, 4}) {
            BlockFactor f({.threads = threads, .precision = Precision::mixed});
            f.analyse(p);
            ASSERT_EQ(f.factor(k), Status::ok);
            EXPECT_TRUE(f.info().single);
            std::vector<double> x = b;
            ASSERT_EQ(f.solve(x), Status::ok);
            EXPECT_TRUE(f.info().single);
            EXPECT_EQ(f.info().fallbacks, 0);
            // What it computes in double of itself is off by less than half of its bound.
            EXPECT_LE(componentwise_error(m, x, b), 1.5 * BlockFactor::kMixedTolerance);
            EXPECT_LE(f.residual(k, x, b), BlockFactor::kMixedTolerance);
            for (std::size_t i = 0; i < x.size(); ++i)
                // A backward error of 1e-14 times a condition below 1e4.
                EXPECT_NEAR(x[i], exact[i], 1e-10 * (1.0 + std::abs(exact[i])));
            if (first.empty()) first = x;
            EXPECT_TRUE(same_bits(x, first)) << threads << " threads";
            refinements += f.info().refinements;
        }
    }
    // Each took one at least: floats alone are not that good.
    EXPECT_GE(refinements, 4 * 30);
}

/// Other units, a power of two for each scalar, far beyond what floats hold: not a bit changes.
TEST(Mixed, DoesNotDependOnUnits) {
    for (int seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        std::vector<double> b = random_values(random, m.scalars()), x = b;
        BlockFactor f(kMixed);
        f.analyse(p);
        ASSERT_EQ(f.factor(values_of(m, p, f)), Status::ok);
        ASSERT_EQ(f.solve(x), Status::ok);
        const std::int64_t refinements = f.info().refinements;
        std::vector<double> unit;
        for (int i = 0; i < m.scalars(); ++i)
            unit.push_back(std::ldexp(1.0, random.integer(-200, 200)));
        for (int i = 0; i < m.scalars(); ++i) {
            b[at(i)] *= unit[at(i)];
            for (int j = 0; j < m.scalars(); ++j) m.dense(i, j) *= unit[at(i)] * unit[at(j)];
        }
        ASSERT_EQ(f.factor(values_of(m, p, f)), Status::ok);
        ASSERT_EQ(f.solve(b), Status::ok);
        for (int i = 0; i < m.scalars(); ++i) b[at(i)] *= unit[at(i)];
        EXPECT_TRUE(same_bits(b, x));
        EXPECT_EQ(f.info().refinements, refinements);
        EXPECT_EQ(f.info().fallbacks, 0);
    }
}

/// Two scalars, [1 c; c d].
struct Pair {
    BlockPattern pattern{{1, 1}, {1, 1}, {{1, 0}}};
    std::vector<double> values;
    Pair(double c, double d) : values{1.0, d, c} {}
};
// Pivots of the second scalar, in units of the last place of a float at 1: in float, in double.
constexpr double kUnit = 0x1p-23;
const Pair kGood(0.5, 1.0);
const Pair kNoPivot(1.0, 1.0 + 0.01 * kUnit);   // 0, 0.01
const Pair kManySteps(1.0, 1.0 + 1.3 * kUnit);  // 1, 1.3: 0.3 of the error stays in each step
/// c rounds to 1. 1, 0.4: 0.6 of the error stays.
const double kAlmostOne = 1.0 + kUnit / 2;
const Pair kSlow(kAlmostOne, kAlmostOne* kAlmostOne + 0.4 * kUnit);
/// 1, −0.4: solutions move away.
const Pair kIndefinite(kAlmostOne, kAlmostOne* kAlmostOne - 0.4 * kUnit);

/// What double does with it: status of the factorisation, solution.
std::pair<Status, std::vector<double>> in_double(const Pair& pair, std::vector<double> b) {
    BlockFactor f;
    f.analyse(pair.pattern);
    const Status status = f.factor(pair.values);
    EXPECT_EQ(f.solve(b), Status::ok);
    return {status, b};
}

TEST(Mixed, FallsBackWhereFloatLosesAPivot) {
    BlockFactor f(kMixed);
    f.analyse(kNoPivot.pattern);
    EXPECT_EQ(f.factor(kNoPivot.values), Status::ok);
    EXPECT_FALSE(f.info().single);
    EXPECT_EQ(f.info().fallbacks, 1);
    EXPECT_EQ(f.info().wrong_pivots, 0);
    std::vector<double> x{3.0, -5.0};
    const auto [status, want] = in_double(kNoPivot, x);
    EXPECT_EQ(status, Status::ok);
    EXPECT_EQ(f.solve(x), Status::ok);
    EXPECT_TRUE(same_bits(x, want));
    EXPECT_EQ(f.info().fallbacks, 1);
    EXPECT_EQ(f.info().refinements, 0);
}

TEST(Mixed, FallsBackWhereRefinementDoesNotEnd) {
    for (const Pair* p : {&kManySteps, &kSlow}) {
        const Pair& pair = *p;
        BlockFactor f(kMixed);
        f.analyse(pair.pattern);
        EXPECT_EQ(f.factor(pair.values), Status::ok);
        EXPECT_TRUE(f.info().single);
        EXPECT_EQ(f.info().fallbacks, 0);
        const std::vector<double> b{3.0, -5.0};
        std::vector<double> x = b, y = b;
        const auto [status, want] = in_double(pair, b);
        EXPECT_EQ(f.solve(x), Status::ok);
        EXPECT_FALSE(f.info().single);
        EXPECT_EQ(f.info().fallbacks, 1);
        EXPECT_TRUE(same_bits(x, want));
        // The one goes as far as it may; the other is seen to be slow soon.
        if (p == &kManySteps)
            EXPECT_EQ(f.info().refinements, 10);
        else
            EXPECT_LT(f.info().refinements, 5);
        // That factor stays.
        EXPECT_EQ(f.solve(y), Status::ok);
        EXPECT_TRUE(same_bits(y, want));
        EXPECT_EQ(f.info().fallbacks, 1);
        EXPECT_EQ(f.info().refinements, 0);
    }
}

TEST(Mixed, ReportsWhatDoubleFindsWrong) {
    BlockFactor f(kMixed);
    f.analyse(kGood.pattern);
    EXPECT_EQ(f.factor(std::vector<double>{1.0, -1.0, 0.5}), Status::wrong_pivot);
    EXPECT_FALSE(f.info().single);
    EXPECT_EQ(f.info().wrong_pivots, 1);
    // Float does not see it, refinement does.
    EXPECT_EQ(f.factor(kIndefinite.values), Status::ok);
    EXPECT_EQ(f.info().wrong_pivots, 0);
    const std::vector<double> b{3.0, -5.0};
    std::vector<double> x = b;
    EXPECT_EQ(f.solve(x), Status::wrong_pivot);
    EXPECT_EQ(f.info().wrong_pivots, 1);
    EXPECT_EQ(f.info().fallbacks, 2);
    const auto [status, want] = in_double(kIndefinite, b);
    EXPECT_EQ(status, Status::wrong_pivot);
    EXPECT_TRUE(same_bits(x, want));
}

TEST(Mixed, StaysInDoubleAfterThreeFallbacksInARow) {
    BlockFactor f(kMixed);
    f.analyse(kGood.pattern);
    auto solved = [&](const Pair& pair) {
        EXPECT_EQ(f.factor(pair.values), Status::ok);
        std::vector<double> x{1.0, 2.0};
        EXPECT_EQ(f.solve(x), Status::ok);
        return f.info().single;
    };
    EXPECT_FALSE(solved(kNoPivot));
    EXPECT_FALSE(solved(kSlow));
    EXPECT_TRUE(solved(kGood));  // the count begins anew
    EXPECT_FALSE(solved(kNoPivot));
    EXPECT_FALSE(solved(kNoPivot));
    EXPECT_FALSE(solved(kSlow));
    EXPECT_EQ(f.info().fallbacks, 5);
    EXPECT_FALSE(solved(kGood));
    f.update(kGood.pattern);
    EXPECT_FALSE(solved(kGood));
    EXPECT_EQ(f.info().fallbacks, 5);
    f.analyse(kGood.pattern);
    EXPECT_EQ(f.info().fallbacks, 0);
    EXPECT_TRUE(solved(kGood));
}

/// Right-hand sides of no size, of any size, and of none.
TEST(Mixed, TakesAnyRightHandSide) {
    Random random(5);
    BlockMatrix m = random_quasi_definite(random, 30, 0.1);
    const BlockPattern p = pattern_of(m, random);
    BlockFactor f(kMixed);
    f.analyse(p);
    ASSERT_EQ(f.factor(values_of(m, p, f)), Status::ok);
    const std::vector<double> b = random_values(random, m.scalars());
    std::vector<double> one = b, x(b.size(), 0.0);
    ASSERT_EQ(f.solve(one), Status::ok);
    EXPECT_EQ(f.solve(x), Status::ok);
    EXPECT_EQ(x, std::vector<double>(b.size(), 0.0));
    for (const double size : {0x1p-400, 0x1p400}) {
        for (std::size_t i = 0; i < b.size(); ++i) x[i] = b[i] * size;
        EXPECT_EQ(f.solve(x), Status::ok);
        for (double& v : x) v /= size;
        EXPECT_TRUE(same_bits(x, one));
    }
    x = b;
    x[3] = HUGE_VAL;
    EXPECT_EQ(f.solve(x), Status::not_finite);
    x = b;
    x.back() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(f.solve(x), Status::not_finite);
    EXPECT_TRUE(f.info().single);
    EXPECT_EQ(f.info().fallbacks, 0);
    x = b;
    EXPECT_EQ(f.solve(x), Status::ok);
    EXPECT_TRUE(same_bits(x, one));
    BlockFactor none(kMixed);
    EXPECT_EQ(none.factor({}), Status::ok);
    EXPECT_EQ(none.solve({}), Status::ok);
}

/// A load at the end of a chain whose solution fades by more than floats hold.
TEST(Mixed, FollowsSolutionsThatFade) {
    constexpr int kNodes = 200;
    BlockPattern p;
    p.size.assign(kNodes, 1);
    p.sign.assign(kNodes, 1);
    for (std::int32_t i = 0; i + 1 < kNodes; ++i) p.edges.push_back({i + 1, i});
    BlockFactor f(kMixed);
    f.analyse(p);
    std::vector<double> k(at(f.value_count()), 1.0), x(kNodes, 0.0);
    std::fill(k.begin() + kNodes, k.end(), -0.25);
    x[0] = 3.0;
    const std::vector<double> b = x;
    ASSERT_EQ(f.factor(k), Status::ok);
    ASSERT_EQ(f.solve(x), Status::ok);
    EXPECT_TRUE(f.info().single);
    EXPECT_EQ(f.info().fallbacks, 0);
    EXPECT_LE(f.residual(k, x, b), BlockFactor::kMixedTolerance);
    EXPECT_LT(std::abs(x.back()), 1e-40);
}

TEST(Mixed, RefactorsInPart) {
    std::int64_t part = 0, whole = 0;
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        BlockMatrix m = draw_matrix(random, seed);
        const BlockPattern p = pattern_of(m, random);
        BlockFactor f({.partial = true, .precision = Precision::mixed}), full(kMixed);
        f.analyse(p);
        full.analyse(p);
        std::vector<double> k = values_of(m, p, f);
        ASSERT_EQ(f.factor(k), Status::ok);
        for (int step = 0; step < 6; ++step) {
            std::vector<std::int32_t> changed;
            const auto blocks = static_cast<int>(p.size.size() + p.edges.size());
            // In the last step one grows so much that its scale does not serve any more.
            const bool grows = step == 5;
            for (int c = grows ? 1 : random.integer(0, 2); c > 0; --c) {
                const int most = grows ? static_cast<int>(p.size.size()) : blocks;
                const int block = random.integer(0, most - 1);
                changed.push_back(block);
                const bool diagonal = block < static_cast<int>(p.size.size());
                for (auto i = f.value_begin(block); i < f.value_begin(block + 1); ++i)
                    k[at(i)] *= grows ? 0x1p60 : diagonal ? 1.01 : 0.99;
            }
            ASSERT_EQ(f.refactor(k, changed), Status::ok);
            ASSERT_EQ(full.factor(k), Status::ok);
            if (grows) {
                EXPECT_EQ(f.info().part_flops, f.info().flops);
            }
            part += grows ? 0 : f.info().part_flops;
            whole += grows ? 0 : f.info().flops;
            std::vector<double> x = random_values(random, m.scalars()), y = x;
            ASSERT_EQ(f.solve(x), Status::ok);
            ASSERT_EQ(full.solve(y), Status::ok);
            EXPECT_TRUE(same_bits(x, y));
            EXPECT_TRUE(f.info().single);
            EXPECT_EQ(f.info().fallbacks, 0);
        }
    }
    EXPECT_GT(part, 0);
    EXPECT_LT(2 * part, whole);
}

/// From float to double and on from there, and back with the next whole factorisation.
TEST(Mixed, RefactorsInTheFactorInUse) {
    BlockFactor f({.partial = true, .precision = Precision::mixed});
    f.analyse(kGood.pattern);
    ASSERT_EQ(f.factor(kGood.values), Status::ok);
    const std::int32_t all[] = {0, 1, 2};
    ASSERT_EQ(f.refactor(kNoPivot.values, all), Status::ok);
    EXPECT_FALSE(f.info().single);
    EXPECT_EQ(f.info().fallbacks, 1);
    ASSERT_EQ(f.refactor(kGood.values, all), Status::ok);
    EXPECT_FALSE(f.info().single);
    std::vector<double> x{1.0, 7.0};
    const auto [status, want] = in_double(kGood, x);
    ASSERT_EQ(f.solve(x), Status::ok);
    EXPECT_TRUE(same_bits(x, want));
    ASSERT_EQ(f.factor(kGood.values), Status::ok);
    EXPECT_TRUE(f.info().single);
}

TEST(Mixed, FollowsAPattern) {
    Random random(3);
    BlockMatrix m = random_quasi_definite(random, 60, 0.05);
    BlockPattern p = pattern_of(m, random);
    BlockFactor f(kMixed);
    f.analyse(p);
    for (int step = 0; step < 20; ++step) {
        const std::size_t e = at(random.integer(0, static_cast<int>(p.edges.size()) - 1));
        m.block(p.edges[e].row, p.edges[e].column).setZero();
        m.block(p.edges[e].column, p.edges[e].row).setZero();
        p.edges.erase(p.edges.begin() + static_cast<std::ptrdiff_t>(e));
        f.update(p);
        const std::vector<double> k = values_of(m, p, f);
        ASSERT_EQ(f.factor(k), Status::ok);
        const std::vector<double> b = random_values(random, m.scalars());
        std::vector<double> x = b;
        ASSERT_EQ(f.solve(x), Status::ok);
        EXPECT_TRUE(f.info().single);
        EXPECT_LE(componentwise_error(m, x, b), 1.5 * BlockFactor::kMixedTolerance);
    }
    EXPECT_EQ(f.info().fallbacks, 0);
}

TEST(Mixed, FullSaysNothingOfIt) {
    BlockFactor f;
    f.analyse(kGood.pattern);
    ASSERT_EQ(f.factor(kGood.values), Status::ok);
    EXPECT_FALSE(f.info().single);
    EXPECT_EQ(f.info().fallbacks, 0);
    EXPECT_EQ(f.info().refinements, 0);
}

}  // namespace
}  // namespace hawser::test
