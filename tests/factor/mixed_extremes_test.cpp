// SPDX-License-Identifier: Apache-2.0
/// Precision::mixed where scales are far apart, and at the ends of the range of double.
#include "base/index.h"

#include <hawser/factor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

struct Outcome {
    Status factored, status;
    std::vector<double> x;
    FactorInfo info;
    double residual;
};

Outcome outcome(const BlockPattern& pattern, const std::vector<double>& values,
                const std::vector<double>& b, Precision precision) {
    BlockFactor f({.precision = precision});
    f.analyse(pattern);
    Outcome s{f.factor(values), Status::ok, b, {}, 0.0};
    s.status = f.solve(s.x);
    s.info = f.info();
    s.residual = f.residual(values, s.x, b);
    return s;
}

const BlockPattern kPair{{1, 1}, {1, -1}, {{1, 0}}};

/// Scalar 1 has next to nothing on its diagonal and a load; 2 and 3 know nothing of it.
TEST(MixedExtremes, LooseScalarsHideNoRows) {
    const BlockPattern pattern{{1, 1, 1, 1}, {1, -1, 1, 1}, {{1, 0}, {2, 3}}};
    for (const double loose : {1.0, 1e-10, 1e-20, 1e-28, 1e-32, 1.76e-38})
        for (const double load : {1.0, 1e4}) {
            SCOPED_TRACE(testing::Message() << loose << ' ' << load);
            const std::vector<double> values{4.0, -loose, 1.0, 1.0 + 1e-3 / 3, 0.5, 0.9999};
            const std::vector<double> b{1.0, load, 1.1 / 3, 0.7};
            const Outcome mixed = outcome(pattern, values, b, Precision::mixed),
                          full = outcome(pattern, values, b, Precision::full);
            ASSERT_EQ(mixed.status, Status::ok);
            EXPECT_LE(mixed.residual, BlockFactor::kMixedTolerance);
            // A condition of 4e3 times the tolerance, and a margin.
            for (std::size_t i = 0; i < b.size(); ++i)
                EXPECT_NEAR(mixed.x[i], full.x[i], 1e-10 * std::abs(full.x[i])) << i;
        }
}

/// |K| |x| + |b| overflows, b − K x does not.
TEST(MixedExtremes, NothingIsLittleBesideInfinity) {
    for (const std::vector<double>& values :
         {std::vector{3.0, -2.0, 0.7}, std::vector{1e8, -3e8, 1e8}}) {
        const std::vector<double> b{1e308, 1e308};
        const Outcome mixed = outcome(kPair, values, b, Precision::mixed),
                      full = outcome(kPair, values, b, Precision::full);
        ASSERT_EQ(mixed.status, Status::ok);
        EXPECT_EQ(mixed.info.fallbacks, 1);
        EXPECT_EQ(mixed.x, full.x);
    }
}

/// A load times the scale of its scalar overflows: double does without a scale.
TEST(MixedExtremes, DoubleStepsInWhereTheScaleOverflows) {
    const std::vector<double> values{1.0, -0x1p-200, 0x1p-45}, b{0.0, 0x1p930};
    const Outcome mixed = outcome(kPair, values, b, Precision::mixed),
                  full = outcome(kPair, values, b, Precision::full);
    ASSERT_EQ(full.status, Status::ok);
    EXPECT_EQ(mixed.status, Status::ok);
    EXPECT_EQ(mixed.info.fallbacks, 1);
    EXPECT_EQ(mixed.x, full.x);
}

TEST(MixedExtremes, SubnormalLoadsNeedNoDouble) {
    const std::vector<double> values{3.0, -2.0, 0.7}, b{1e-316, 0.0};
    const Outcome mixed = outcome(kPair, values, b, Precision::mixed);
    EXPECT_EQ(mixed.status, Status::ok);
    EXPECT_EQ(mixed.info.fallbacks, 0);
    // To the least number that there is.
    EXPECT_NEAR(mixed.x[0], 1e-316 * 2.0 / 6.49, 1e-322);
}

TEST(MixedExtremes, WhatIsNoNumberStaysNone) {
    const std::vector<double> values{3.0, -2.0, 0.7};
    for (const double b : {std::nan(""), HUGE_VAL, -HUGE_VAL})
        EXPECT_EQ(outcome(kPair, values, {b, 1.0}, Precision::mixed).status, Status::not_finite);
    const Outcome none = outcome(kPair, values, {0.0, 0.0}, Precision::mixed);
    EXPECT_EQ(none.status, Status::ok);
    EXPECT_EQ(none.x, (std::vector<double>{0.0, 0.0}));
}

}  // namespace
}  // namespace hawser::test
