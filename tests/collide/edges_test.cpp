// SPDX-License-Identifier: Apache-2.0
/// Convex edges of boxes, hulls and meshes, against shapes whose edges are known.
#include <hawser/def.h>
#include <hawser/edges.h>

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hawser {
namespace {

constexpr double kRight = 0.5 * std::numbers::pi;

ShapeDef box_of(const Vec3& half) { return {.kind = ShapeKind::box, .half_size = half}; }

/// Make a step of 1 m on a floor from triangles, counterclockwise seen from above. Floor, face and
/// top are strips along y whose vertices divide the edges.
ShapeDef step_mesh(int strips) {
    ShapeDef out{.kind = ShapeKind::mesh};
    for (int i = 0; i <= strips; ++i)
        for (const auto& [x, z] : {std::pair(-2.0, 0.0), {0.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}})
            out.vertices.emplace_back(x, 0.5 * i, z);
    for (std::int32_t i = 0; i < strips; ++i)
        for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t a = 4 * i + k, b = a + 1, c = a + 5, d = a + 4;
            out.triangles.push_back({a, b, c});
            out.triangles.push_back({a, c, d});
        }
    return out;
}

TEST(Edges, OfABoxAreTwelve) {
    const Vec3 half(3.0, 2.0, 1.0);
    const auto edges = convex_edges(box_of(half), 0.1);
    ASSERT_EQ(edges.size(), 12U);
    double length = 0.0;
    for (const ShapeEdge& edge : edges) {
        EXPECT_NEAR(edge.turn, kRight, 1e-12);
        length += (edge.to - edge.from).norm();
        // The cylinder touches both faces: its axis is one radius inside each.
        const EdgeAxis axis = axis_in_edge(edge, 0.2);
        const Vec3 middle = 0.5 * (axis.from + axis.to);
        int near = 0;
        for (int k = 0; k < 3; ++k)
            near += std::abs(half[k] - std::abs(middle[k]) - 0.2) < 1e-12 ? 1 : 0;
        EXPECT_EQ(near, 2);
        // Its thickness is the smaller size across.
        Vec3 across = half;
        int along = 0;
        (edge.to - edge.from).cwiseAbs().maxCoeff(&along);
        across[along] = 1e9;
        EXPECT_NEAR(edge.most_radius, across.minCoeff(), 1e-9);
    }
    EXPECT_NEAR(length, 8.0 * half.sum(), 1e-12);
    EXPECT_TRUE(convex_edges(box_of(half), 1.6).empty()) << "none is sharper than a right angle";
}

TEST(Edges, FollowTheShapesFrame) {
    test::Random random(3);
    ShapeDef def = box_of({3.0, 2.0, 1.0});
    const auto plain = convex_edges(def, 0.1);
    def.position = random.vector(5.0);
    def.orientation = Quat(0.5, -0.5, 0.5, 0.5);
    for (const ShapeEdge& edge : plain) {
        const Vec3 from = def.position + def.orientation * edge.from,
                   to = def.position + def.orientation * edge.to;
        const auto all = convex_edges(def, 0.1);
        const auto same = std::count_if(all.begin(), all.end(), [&](const ShapeEdge& other) {
            return distance_to_edge(other, from, to) < 1e-12 &&
                   (other.outward - def.orientation * edge.outward).norm() < 1e-12;
        });
        EXPECT_EQ(same, 1);
    }
}

TEST(Edges, OfAHullAreThoseBetweenItsFaces) {
    // A prism over an isosceles triangle with a ridge: two slopes of 30 degrees meet in it.
    ShapeDef roof{.kind = ShapeKind::hull};
    const double rise = std::tan(std::numbers::pi / 6.0);
    for (const double y : {-2.0, 0.0, 2.0}) {
        roof.vertices.emplace_back(-1.0, y, 0.0);
        roof.vertices.emplace_back(1.0, y, 0.0);
        roof.vertices.emplace_back(0.0, y, rise);
    }
    EXPECT_EQ(convex_edges(roof, 0.1).size(), 9U) << "points on an edge are no ends of it";
    const auto sharp = convex_edges(roof, 2.0);
    ASSERT_EQ(sharp.size(), 2U) << "the eaves turn by 150 degrees";
    for (const ShapeEdge& edge : sharp) EXPECT_NEAR(edge.turn, 5.0 * std::numbers::pi / 6.0, 1e-9);
    const auto all = convex_edges(roof, 0.1);
    const auto ridge = std::find_if(all.begin(), all.end(), [](const ShapeEdge& e) {
        return std::abs(e.turn - std::numbers::pi / 3.0) < 1e-9;
    });
    ASSERT_NE(ridge, all.end());
    EXPECT_NEAR((ridge->outward - Vec3::UnitZ()).norm(), 0.0, 1e-9);
    EXPECT_NEAR((ridge->to - ridge->from).norm(), 4.0, 1e-12);
    // A cylinder that touches both slopes and the floor: r = rise/(1 + 1/cos 30).
    EXPECT_NEAR(ridge->most_radius, rise / (1.0 + 1.0 / std::cos(std::numbers::pi / 6.0)), 1e-9);
}

TEST(Edges, OfAMeshAreItsConvexOnes) {
    for (const int strips : {1, 2, 9}) {
        const auto edges = convex_edges(step_mesh(strips), 0.5);
        ASSERT_EQ(edges.size(), 1U) << "its inner corner and its border are none";
        EXPECT_NEAR((edges[0].from - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
        EXPECT_NEAR((edges[0].to - Vec3(0, 0.5 * strips, 1)).norm(), 0.0, 1e-12);
        EXPECT_NEAR(edges[0].turn, kRight, 1e-12);
        EXPECT_NEAR((edges[0].outward - Vec3(-1, 0, 1).normalized()).norm(), 0.0, 1e-12);
    }
}

TEST(Edges, AreRefusedWhereThereAreNone) {
    EXPECT_THROW((void)convex_edges({.kind = ShapeKind::sphere, .radius = 1.0}, 0.1), DefError);
    EXPECT_THROW((void)convex_edges({.kind = ShapeKind::hull}, 0.1), DefError) << "without points";
}

}  // namespace
}  // namespace hawser
