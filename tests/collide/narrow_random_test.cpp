// SPDX-License-Identifier: Apache-2.0
// Random pairs of shapes against a slow reference in long double; tests/slow has 100,000 of each.
#include "support/collide/ground_pairs.h"
#include "support/collide/random_pairs.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

namespace hawser {
namespace {

using Kinds = std::pair<ShapeKind, ShapeKind>;

class NarrowRandom : public testing::TestWithParam<Kinds> {};

/// Return the number of pairs; 1 if a seed is given. Sanitizers run the quick number, the long tier
/// ten times the full one.
int pairs_of(int quick, int full) {
    return test::seed_count(quick, test::kSanitized ? quick : full, 10 * full);
}

TEST_P(NarrowRandom, AgreesWithTheReference) {
    const auto [a, b] = GetParam();
    const int count = pairs_of(test::kSanitized ? 100 : 250, 3000);
    const test::Score score = test::compare_pairs(a, b, count, test::first_seed(1'000'000));
    const std::string text = test::describe(a, b, score);
    if (count > 1) {
        EXPECT_GT(score.touching, count / 10) << text;
        EXPECT_GT(score.separated, count / 40) << text;
    }
    EXPECT_EQ(score.wrong_results, 0) << text;
    EXPECT_EQ(score.bad_points, 0) << text;
    // Requirement: 1e-6 m and 1e-6 where the normal is unique. Hulls and triangles may have 1e-4,
    // but are as accurate.
    EXPECT_LE(score.worst_gap, 1e-6) << text;
    EXPECT_LE(score.worst_normal, 1e-6) << text;
    EXPECT_LE(score.ambiguous, score.pairs / 100) << text;
}

TEST(NarrowRandomGround, AgreesWithTheReference) {
    const std::uint32_t seed = test::first_seed(1'000'000);
    const int count = pairs_of(test::kSanitized ? 20 : 100, 500);
    for (const test::Ground ground : test::grounds())
        for (const ShapeKind kind : test::ground_kinds()) {
            const auto score = test::check_ground(kind, ground, count, seed);
            const std::string text = test::describe(kind, ground, score);
            if (count > 20) {  // up to twenty, chance decides
                EXPECT_GT(score.touching, count / 10) << text;
                EXPECT_GT(score.separated, count / 10) << text;
                EXPECT_GT(score.normals, count / 4) << text;
            }
            EXPECT_EQ(score.wrong_results, 0) << text;
            EXPECT_EQ(score.bad_points, 0) << text;
            EXPECT_LE(score.worst_gap, 1e-6) << text;
            EXPECT_LE(score.worst_normal, 1e-6) << text;
            // Pairs without an exact comparison remain the smaller part.
            EXPECT_LE(score.ambiguous, 1 + score.pairs / 50) << text;
            EXPECT_LE(score.beside, 2 + score.touching / 3) << text;
            EXPECT_LE(score.left, 2 + score.touching / 15) << text;
        }
}

TEST_P(NarrowRandom, AlignedShapesAgreeToo) {
    const auto [a, b] = GetParam();
    const int count = pairs_of(test::kSanitized ? 50 : 200, 1000);
    const test::Score score =
        test::compare_pairs(a, b, count, test::first_seed(1), test::Draw::aligned);
    const std::string text = test::describe(a, b, score);
    EXPECT_EQ(score.wrong_results, 0) << text;
    EXPECT_EQ(score.bad_points, 0) << text;
    EXPECT_LE(score.worst_gap, 1e-6) << text;
    EXPECT_LE(score.worst_normal, 1e-6) << text;
}

TEST_P(NarrowRandom, ExtremeSizesAgreeToo) {
    const auto [a, b] = GetParam();
    const int count = pairs_of(test::kSanitized ? 50 : 150, 1000);
    const test::Score score =
        test::compare_pairs(a, b, count, test::first_seed(1), test::Draw::extreme);
    const std::string text = test::describe(a, b, score);
    EXPECT_EQ(score.wrong_results, 0) << text;
    EXPECT_EQ(score.bad_points, 0) << text;
    // Near the axis of a drum of 60 m all ways out are nearly equal: the one of a small cylinder
    // may be longer by 2e-5 of it. Otherwise 1e-7 of 100 m: the difference of a manifold's corner
    // from the deepest point.
    const bool drums = a == ShapeKind::cylinder && b == ShapeKind::cylinder;
    EXPECT_LE(score.worst_gap, drums ? 2e-3 : 1e-5) << text;
    if (!drums) {
        EXPECT_LE(score.worst_normal, 1e-6) << text;
    }
}

std::string name_of(const testing::TestParamInfo<Kinds>& kinds) {
    return test::kind_name(kinds.param.first) + "_" + test::kind_name(kinds.param.second);
}
INSTANTIATE_TEST_SUITE_P(Pairs, NarrowRandom, testing::ValuesIn(test::exact_pairs()), name_of);
INSTANTIATE_TEST_SUITE_P(Vertices, NarrowRandom, testing::ValuesIn(test::vertex_pairs()), name_of);

}  // namespace
}  // namespace hawser
