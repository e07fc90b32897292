// SPDX-License-Identifier: Apache-2.0
#include "scene/catenary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::scene {
namespace {

const Vec3 kDown(0.0, 0.0, -1.0);

/// Expect that every element has its length. At each node the pulls of both neighbours have equal
/// horizontal parts, and the difference of their vertical parts is equal at all nodes.
void expect_at_rest(const std::vector<Vec3>& nodes, double length, const Vec3& down) {
    const std::size_t n = nodes.size() - 1;
    const double l = length / static_cast<double>(n);
    const Vec3 up = -down.normalized();
    std::vector<double> slope;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = nodes[i + 1] - nodes[i];
        // The last element contains the error of the sums, which Newton's method solved to 1e-11
        // per element.
        EXPECT_NEAR(d.norm(), l, 1e-9 * length);
        slope.push_back(d.dot(up) / (d - d.dot(up) * up).norm());
    }
    for (std::size_t i = 2; i < n; ++i) {
        const double first = slope[1] - slope[0];
        EXPECT_GT(slope[i] - slope[i - 1], 0.0);
        // The last element contains the error of the sums; at slopes of 150 it is 1e-6.
        EXPECT_NEAR(slope[i] - slope[i - 1], first, 1e-5 * std::abs(first)) << i;
    }
}

TEST(Catenary, hangs_at_rest_in_many_shapes) {
    const Vec3 ends[] = {{80, 0, 0},   {80, 0, 30},   {80, 0, -60}, {5, 0, 0},
                         {0.5, 3, 40}, {-30, 40, 10}, {1000, 0, 1}};
    for (const Vec3& b : ends) {
        for (const double slack : {1.00001, 1.01, 1.25, 2.0}) {
            for (const int n : {2, 3, 10, 101}) {
                // Two or three long elements deviate from the chord by up to acos(1/slack). Past
                // the vertical one of them would be in compression: no such shape exists.
                const double steep = std::asin(std::abs(b.z()) / b.norm());
                // Nor does it if the fold at the bottom is narrower than one element.
                const bool narrow = std::hypot(b.x(), b.y()) < slack * b.norm() / n;
                if (narrow || (n < 10 && steep + std::acos(1.0 / slack) > 1.4)) {
                    continue;
                }
                const Vec3 a(1, 2, 3);
                const double length = slack * b.norm();
                const auto nodes = hanging_nodes(a, a + b, length, n, kDown);
                ASSERT_TRUE(nodes) << b.transpose() << " " << slack << " " << n;
                ASSERT_EQ(nodes->size(), static_cast<std::size_t>(n) + 1);
                EXPECT_EQ(nodes->front(), a);
                EXPECT_EQ(nodes->back(), Vec3(a + b));
                expect_at_rest(*nodes, length, kDown);
            }
        }
    }
}

TEST(Catenary, tends_to_the_smooth_one) {
    // Span 80, length 100: a = 33.820188, sag 26.543751 (closed form). A chain of n elements
    // differs by O(1/n²): 5 ppm at n = 400.
    const auto nodes = hanging_nodes({0, 0, 0}, {80, 0, 0}, 100.0, 400, kDown);
    ASSERT_TRUE(nodes);
    EXPECT_NEAR((*nodes)[200].z(), -26.543751, 26.5 * 1e-5);
}

TEST(Catenary, follows_gravity) {
    const Vec3 down(1, 0, 0);
    const auto nodes = hanging_nodes({0, 0, 0}, {0, 50, 0}, 70.0, 20, down);
    ASSERT_TRUE(nodes);
    EXPECT_GT((*nodes)[10].x(), 10.0);
    expect_at_rest(*nodes, 70.0, down);
}

TEST(Catenary, is_straight_when_taut) {
    const auto nodes = hanging_nodes({0, 0, 0}, {30, 0, 40}, 50.0, 5, kDown);
    ASSERT_TRUE(nodes);
    EXPECT_TRUE((*nodes)[1].isApprox(Vec3(6, 0, 8), 1e-12));
}

TEST(Catenary, refuses_what_does_not_exist) {
    EXPECT_FALSE(hanging_nodes({0, 0, 0}, {10, 0, 0}, 9.99, 10, kDown));  // too short
    EXPECT_FALSE(
        hanging_nodes({0, 0, 0}, {0, 0, 10}, 20.0, 10, kDown));          // one vertical line: folds
    EXPECT_FALSE(hanging_nodes({0, 0, 0}, {10, 0, 0}, 20.0, 1, kDown));  // one rigid element
    EXPECT_FALSE(hanging_nodes({0, 0, 0}, {0.001, 0, 5}, 100.0, 10, kDown));  // nearly folded
    EXPECT_FALSE(
        hanging_nodes({0, 0, 0}, {80, 0, -60}, 200.0, 2, kDown));  // would be in compression
}

}  // namespace
}  // namespace hawser::scene
