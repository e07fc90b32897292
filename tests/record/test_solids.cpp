// SPDX-License-Identifier: Apache-2.0
/// Convex surfaces: volumes, Euler's formula, all points inside, flat ones rejected.
#include "record/solids.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace hawser::test {
namespace {

/// Compute the volume by the divergence theorem; negative if the surface is inside out.
double volume(const record::Triangles& t) {
    double sum = 0.0;
    for (const auto& c : t.corners)
        sum += t.points[c[0]].dot(t.points[c[1]].cross(t.points[c[2]])) / 6.0;
    return sum;
}

/// Check that each edge occurs once in both directions, and V − E + F = 2 (Euler).
void expect_closed(const record::Triangles& t) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& c : t.corners)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_TRUE(edges.insert({c[k], c[(k + 1) % 3]}).second) << "an edge is there twice";
    for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a})) << "it has a hole";
    EXPECT_EQ(t.points.size() + t.corners.size(), edges.size() / 2 + 2);
}

TEST(ConvexSurface, OfABoxHasItsVolume) {
    const record::Triangles box = record::box_surface({1.0, 2.0, 0.25});
    EXPECT_EQ(box.points.size(), 8U);
    EXPECT_EQ(box.corners.size(), 12U);
    EXPECT_NEAR(volume(box), 8 * 1.0 * 2.0 * 0.25, 1e-12);
    expect_closed(box);
}

TEST(ConvexSurface, HoldsAllPoints) {
    std::mt19937 random(first_seed(7));
    const int rounds = by_tier(20, 100, 1000);
    std::normal_distribution<double> normal;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i)
            points.emplace_back(3.0 * normal(random), normal(random), 0.2 * normal(random));
        points.insert(points.end(), points.begin(), points.begin() + 5);  // some points twice
        const record::Triangles hull = record::convex_surface(points);
        expect_closed(hull);
        for (const auto& c : hull.corners) {
            const Vec3& a = hull.points[c[0]];
            const Vec3 n = (hull.points[c[1]] - a).cross(hull.points[c[2]] - a).normalized();
            // The method treats points within 1e-9 of an extent of about 20 m as one face.
            for (const Vec3& p : points) EXPECT_LE(n.dot(p - a), 1e-7);
        }
    }
}

TEST(ConvexSurface, OfABallIsAPolyhedronInIt) {
    const record::Triangles ball =
        record::outline_surface({.radius = 2.0, .points = {Vec3(1, 1, 1)}});
    expect_closed(ball);
    EXPECT_EQ(ball.points.size(), 42U);
    for (const Vec3& p : ball.points) EXPECT_NEAR((p - Vec3(1, 1, 1)).norm(), 2.0, 1e-12);
    const double whole = 4.0 / 3.0 * std::numbers::pi * 8.0;
    // 80 faces: 0.87 of the ball (an icosahedron of 20 has 0.61).
    EXPECT_GT(volume(ball), 0.85 * whole);
    EXPECT_LT(volume(ball), whole);
}

TEST(ConvexSurface, OfWhatIsFlatIsNone) {
    EXPECT_TRUE(record::convex_surface({}).empty());
    std::vector<Vec3> flat;
    for (int i = 0; i < 30; ++i) flat.emplace_back(i % 5, i * i % 7, 3.0);
    EXPECT_TRUE(record::convex_surface(flat).empty());
    EXPECT_TRUE(record::convex_surface(std::vector<Vec3>(9, Vec3(1, 2, 3))).empty());
    EXPECT_TRUE(record::convex_surface(std::vector<Vec3>(9, Vec3::Constant(NAN))).empty());
}

}  // namespace
}  // namespace hawser::test
