// SPDX-License-Identifier: Apache-2.0
// Heightfields and meshes: no false contacts at interior edges, points that support a shape, depth.
#include "collide/collide_function.h"
#include "collide/narrow/shape_data.h"
#include "support/collide/place.h"
#include "support/collide/random_pairs.h"
#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <hawser/def.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace hawser {
namespace {

using collide::Geometry;
using collide::Manifold;
using collide::Placement;
using collide::ShapeData;
using test::place;
using test::turn;
using enum ShapeKind;

using Height = std::function<double(double, double)>;

/// Make 21 by 21 nodes over ±5 m.
ShapeDef ground_def(const Height& height) {
    ShapeDef def;
    def.kind = heightfield;
    def.rows = def.columns = 21;
    def.cell = {0.5, 0.5};
    for (int i = 0; i < 21; ++i)
        for (int j = 0; j < 21; ++j) def.heights.push_back(height(0.5 * (j - 10), 0.5 * (i - 10)));
    return def;
}
/// Make the same surface of triangles; every second one is upside down.
ShapeDef mesh_def(const Height& height) {
    ShapeDef def;
    def.kind = mesh;
    for (int i = 0; i < 21; ++i)
        for (int j = 0; j < 21; ++j)
            def.vertices.push_back(
                {0.5 * (j - 10), 0.5 * (i - 10), height(0.5 * (j - 10), 0.5 * (i - 10))});
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const int a = 21 * i + j;
            def.triangles.push_back({a, a + 1, a + 22});
            def.triangles.push_back({a, a + 21, a + 22});
        }
    return def;
}

struct Surface {
    std::unique_ptr<ShapeData> data;
    Geometry geometry;
};
std::vector<Surface> surfaces(const Height& height) {
    std::vector<Surface> list;
    for (const ShapeDef& def : {ground_def(height), mesh_def(height)}) {
        Surface s{collide::make_shape_data(def), {}};
        s.geometry.kind = def.kind;
        s.geometry.data = s.data.get();
        list.push_back(std::move(s));
    }
    return list;
}
double flat(double, double) { return 0.0; }

struct Mover {
    const char* name;
    Geometry geometry;
    Quat attitude;
    double height;
    int points;
    std::shared_ptr<ShapeData> data;
};
std::vector<Mover> movers() {
    Geometry g;
    g.radius = 0.3;
    g.half_length = 0.8;
    g.half_size[0] = 0.5;
    g.half_size[1] = 0.7;
    g.half_size[2] = 0.3;
    const Quat lying = turn(M_PI / 2, Vec3(0, 1, 0));
    std::vector<Mover> list = {{"sphere", g, Quat::Identity(), 0.3, 1, nullptr},
                               {"lying capsule", g, lying, 0.3, 2, nullptr},
                               {"box", g, Quat::Identity(), 0.3, 4, nullptr},
                               {"standing cylinder", g, Quat::Identity(), 0.8, 4, nullptr},
                               {"lying cylinder", g, lying, 0.3, 2, nullptr},
                               {"hull", g, Quat::Identity(), 0.3, 4, nullptr}};
    const ShapeKind kinds[] = {sphere, capsule, box, cylinder, cylinder, hull};
    for (std::size_t i = 0; i < list.size(); ++i) list[i].geometry.kind = kinds[i];
    ShapeDef prism;  // eight sides
    prism.kind = hull;
    for (int i = 0; i < 16; ++i)
        prism.vertices.push_back(
            {0.6 * std::cos(M_PI * i / 4), 0.6 * std::sin(M_PI * i / 4), i < 8 ? -0.3 : 0.3});
    list.back().data = collide::make_shape_data(prism);
    list.back().geometry.data = list.back().data.get();
    return list;
}

Manifold touch(const Geometry& a, const Placement& pa, const Geometry& b, const Placement& pb,
               double margin = 0.02) {
    Manifold m;
    collide::collide_function(a.kind, b.kind)(a, pa, b, pb, margin, m);
    return m;
}
double least_of(const Manifold& m) {
    double least = 1e300;
    for (int i = 0; i < m.count; ++i) least = std::min(least, m.point[i].gap);
    return least;
}

TEST(NarrowSurface, SlidingOverFlatGroundMeetsNoEdge) {
    test::Random random(test::first_seed(1));
    const int cases = test::by_tier(test::kSanitized ? 40 : 150, test::kSanitized ? 40 : 800, 8000);
    for (const Surface& ground : surfaces(flat))
        for (const Mover& mover : movers())
            for (int i = 0; i < cases; ++i) {
                const double gap = random.uniform(-0.03, 0.015);
                // Includes positions exactly over edges and nodes.
                Vec3 x(random.uniform(-3, 3), random.uniform(-3, 3), mover.height + gap);
                if (i % 4 == 0) x.x() = 0.5 * random.integer(-6, 6);
                if (i % 8 == 0) x.y() = 0.5 * random.integer(-6, 6);
                const double heading = i % 3 == 0 ? 0.0 : random.uniform(-3, 3);
                const Quat q = turn(heading, Vec3(0, 0, 1)) * mover.attitude;
                const Manifold m =
                    touch(mover.geometry, place(x, q), ground.geometry, place({0, 0, 0}));
                ASSERT_EQ(m.count, mover.points)
                    << mover.name << " on " << test::kind_name(ground.geometry.kind) << " at "
                    << x.transpose();
                for (int k = 0; k < m.count; ++k) {
                    EXPECT_NEAR(m.point[k].normal[2], -1.0, 1e-9) << mover.name;
                    EXPECT_NEAR(m.point[k].gap, gap, 1e-9) << mover.name;
                }
            }
}

TEST(NarrowSurface, PointsHoldTheShape) {
    // The centre is within the points, so that a shape at rest does not tip.
    for (const Surface& ground : surfaces(flat))
        for (const Mover& mover : movers()) {
            const Vec3 x(0.13, -0.21, mover.height - 1e-4);
            const Manifold m =
                touch(mover.geometry, place(x, mover.attitude), ground.geometry, place({0, 0, 0}));
            ASSERT_EQ(m.count, mover.points);
            Vec3 mean(0, 0, 0);
            for (int k = 0; k < m.count; ++k)
                mean += Vec3(m.point[k].on[1][0], m.point[k].on[1][1], 0) / m.count;
            EXPECT_LT((mean - Vec3(x.x(), x.y(), 0)).norm(), 0.05) << mover.name;
        }
}

TEST(NarrowSurface, NamesSurviveNoise) {
    test::Random random(test::first_seed(5));
    const int cases = test::by_tier(20, 100, 1000);
    for (const Surface& ground : surfaces(flat))
        for (const Mover& mover : movers())
            for (const Vec3& at : {Vec3(0.13, -0.21, 0), Vec3(0, 0, 0), Vec3(0.5, 0.25, 0)}) {
                const auto names = [&](const Vec3& x, const Quat& q) {
                    const Manifold m =
                        touch(mover.geometry, place(x, q), ground.geometry, place({0, 0, 0}));
                    std::vector<std::uint32_t> list;
                    for (int k = 0; k < m.count; ++k) list.push_back(m.point[k].feature);
                    return list;
                };
                const Vec3 x = at + Vec3(0, 0, mover.height - 1e-4);
                const auto first = names(x, mover.attitude);
                for (int i = 0; i < cases; ++i)
                    EXPECT_EQ(names(x + random.vector(1e-9),
                                    turn(1e-9 * random.unit(), random.vector(1)) * mover.attitude),
                              first)
                        << mover.name << " on " << test::kind_name(ground.geometry.kind) << " at "
                        << at.transpose();
            }
}

TEST(NarrowSurface, SlopesAndMovedFrames) {
    // A plane of slope 0.3 in a rotated and shifted frame has the gaps of that plane.
    test::Random random(test::first_seed(2));
    const int cases = test::by_tier(300, 1500, 15'000);
    const auto slope = [](double x, double y) { return 0.3 * x - 0.2 * y; };
    const Vec3 up = Vec3(-0.3, 0.2, 1.0).normalized();
    for (const Surface& ground : surfaces(slope))
        for (int i = 0; i < cases; ++i) {
            const Quat q = random.rotation();
            const Vec3 shift = random.vector(100.0);
            Geometry ball;
            ball.kind = sphere;
            ball.radius = 0.4;
            const double gap = random.uniform(-0.1, 0.019);
            const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
            const Vec3 centre = Vec3(x, y, slope(x, y)) + (0.4 + gap) * up;
            const Manifold m =
                touch(ball, place(shift + q * centre), ground.geometry, place(shift, q));
            ASSERT_EQ(m.count, 1);
            EXPECT_NEAR(m.point[0].gap, gap, 1e-9);
            const double* n = m.point[0].normal;
            EXPECT_LT((Vec3(n[0], n[1], n[2]) + q * up).norm(), 1e-9);
        }
}

TEST(NarrowSurface, RidgesAndValleys) {
    Geometry ball;
    ball.kind = sphere;
    ball.radius = 0.4;
    // A ridge along y with faces of slope 1 on both sides.
    const auto ridge = [](double x, double) { return -std::fabs(x); };
    const auto valley = [](double x, double) { return std::fabs(x); };
    for (const Surface& ground : surfaces(ridge)) {
        const Manifold m = touch(ball, place({0, 0.2, 0.41}), ground.geometry, place({0, 0, 0}));
        ASSERT_EQ(m.count, 1);
        EXPECT_NEAR(m.point[0].gap, 0.01, 1e-12);
        EXPECT_NEAR(m.point[0].normal[2], -1.0, 1e-12);
        // An edge of a box across the ridge, slightly deep.
        Geometry beam;
        beam.kind = box;
        beam.half_size[0] = 1.0;
        beam.half_size[1] = beam.half_size[2] = 0.2;
        const Manifold cross =
            touch(beam, place({0, 0.1, 0.2 * std::sqrt(2.0) - 0.01}, turn(M_PI / 4, Vec3(1, 0, 0))),
                  ground.geometry, place({0, 0, 0}));
        ASSERT_GE(cross.count, 1);
        EXPECT_NEAR(least_of(cross), -0.01, 1e-9);
    }
    for (const Surface& ground : surfaces(valley)) {
        const Manifold m = touch(ball, place({0, 0.2, 0.4 * std::sqrt(2.0) - 0.01}),
                                 ground.geometry, place({0, 0, 0}));
        ASSERT_EQ(m.count, 2);
        EXPECT_NEAR(m.point[0].gap, -0.01 / std::sqrt(2.0), 1e-9);
        EXPECT_NEAR(m.point[1].gap, -0.01 / std::sqrt(2.0), 1e-9);
        EXPECT_NEAR(m.point[0].normal[0] * m.point[1].normal[0], -0.5, 1e-9);
    }
}

TEST(NarrowSurface, GroundPushesUpFromAnyDepthAndAMeshToEitherSide) {
    const std::vector<Surface> both = surfaces(flat);
    for (const Mover& mover : movers())
        for (const double depth : {0.1, 0.5, 2.0, 20.0}) {
            const Manifold m =
                touch(mover.geometry, place({0.13, -0.2, mover.height - depth}, mover.attitude),
                      both[0].geometry, place({0, 0, 0}));
            ASSERT_GE(m.count, 1) << mover.name << depth;
            EXPECT_NEAR(least_of(m), -depth, 1e-9) << mover.name;
            EXPECT_NEAR(m.point[0].normal[2], -1.0, 1e-9);
        }
    for (const Mover& mover : movers()) {
        const Manifold m = touch(
            mover.geometry,
            place({0.13, -0.2, -mover.height + 0.01}, turn(M_PI, Vec3(1, 0, 0)) * mover.attitude),
            both[1].geometry, place({0, 0, 0}));
        ASSERT_EQ(m.count, mover.points) << mover.name;
        EXPECT_NEAR(least_of(m), -0.01, 1e-9);
        EXPECT_NEAR(m.point[0].normal[2], 1.0, 1e-9);
    }
}

TEST(NarrowSurface, RoughGroundGivesTheDistance) {
    // Off the ground, the smallest gap is the one of the nearest triangle, by the reference.
    test::Random random(test::first_seed(9));
    const int cases = test::by_tier(test::kSanitized ? 5 : 15, test::kSanitized ? 5 : 60, 600);
    const auto rough = [](double x, double y) {
        return 0.4 * std::sin(2.1 * x) * std::cos(1.7 * y);
    };
    const ShapeDef def = mesh_def(rough);
    int seen = 0;
    for (const Surface& ground : surfaces(rough))
        for (const ShapeKind kind : {sphere, capsule, box, cylinder, hull})
            for (int i = 0; i < cases; ++i) {
                const test::RandomShape shape = test::random_shape(random, kind);
                const Vec3 at(random.uniform(-2, 2), random.uniform(-2, 2),
                              random.uniform(0.5, 2.5));
                const Placement pa = place(at, random.rotation());
                const reference::Body body = test::body_of(shape, pa);
                reference::Real least = 1e30L;
                for (const auto& t : def.triangles) {
                    std::vector<reference::Vec> corners;
                    double reach = 1e300;
                    for (const auto v : t) {
                        const Vec3& x = def.vertices[v];
                        corners.push_back({x.x(), x.y(), x.z()});
                        reach = std::min(reach, (x - at).norm());
                    }
                    if (reach > 3.8) continue;
                    const auto answer =
                        reference::signed_distance(body, reference::make_points(corners, {}, {}));
                    least = std::min(least, answer.gap);
                }
                if (least < 1e-6L) continue;
                const Manifold m =
                    touch(shape.geometry, pa, ground.geometry, place({0, 0, 0}), 0.5);
                EXPECT_EQ(m.count > 0, least < 0.5L) << test::kind_name(kind) << i;
                if (m.count == 0 || least >= 0.5L) continue;
                ++seen;
                EXPECT_NEAR(least_of(m), static_cast<double>(least), 1e-6)
                    << test::kind_name(kind) << " on " << test::kind_name(ground.geometry.kind)
                    << " " << i;
            }
    EXPECT_GT(seen, cases);
}

TEST(NarrowSurface, BadDataIsRefused) {
    const auto refused = [](const ShapeDef& def) -> std::string {
        try {
            (void)collide::make_shape_data(def);
        } catch (const DefError& e) {
            return e.what();
        }
        return "";
    };
    ShapeDef h;
    h.kind = hull;
    h.name = "rock";
    h.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NE(refused(h).find("'rock': vertices has 3"), std::string::npos);
    h.vertices.push_back({1, 1, 0});
    EXPECT_NE(refused(h).find("one plane"), std::string::npos);
    h.vertices.assign(10, {1, 2, 3});
    EXPECT_NE(refused(h).find("one plane"), std::string::npos);
    h.vertices[3].x() = std::nan("");
    EXPECT_NE(refused(h).find("vertices[3]"), std::string::npos);
    ShapeDef m = mesh_def(flat);
    EXPECT_EQ(refused(m), "");
    m.triangles[5] = {1, 2, 441};
    EXPECT_NE(refused(m).find("triangles[5]"), std::string::npos);
    m.triangles[5] = {1, 1, 2};
    EXPECT_NE(refused(m).find("no area"), std::string::npos);
    m.triangles.clear();
    EXPECT_NE(refused(m).find("empty"), std::string::npos);
    ShapeDef g = ground_def(flat);
    EXPECT_EQ(refused(g), "");
    g.heights.pop_back();
    EXPECT_NE(refused(g).find("440"), std::string::npos);
    g = ground_def(flat);
    g.cell[1] = 0.0;
    EXPECT_NE(refused(g).find("cell[1]"), std::string::npos);
    g = ground_def(flat);
    g.heights[7] = 1.0 / 0.0;
    EXPECT_NE(refused(g).find("heights[7]"), std::string::npos);
}

TEST(NarrowSurface, HullsHaveTheFacesOfTheirPoints) {
    // A cube with points inside, on faces and on edges: six faces of four corners.
    ShapeDef def;
    def.kind = hull;
    for (int i = 0; i < 27; ++i)
        def.vertices.push_back({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
    const auto cube = collide::make_shape_data(def);
    EXPECT_EQ(cube->faces.size(), 6U);
    EXPECT_EQ(cube->vertices.size() + cube->faces.size(), cube->edges.size() + 2);
    // Points of a sphere: all are on the hull, none is outside.
    test::Random random(test::first_seed(6));
    const int rounds = test::by_tier(20, 100, 1000);
    for (int round = 0; round < rounds; ++round) {
        def.vertices.clear();
        for (int i = 0; i < 100; ++i) def.vertices.push_back(random.vector(1).normalized());
        const auto ball = collide::make_shape_data(def);
        EXPECT_EQ(ball->vertices.size(), 100U);
        for (const collide::HullFace& f : ball->faces)
            for (const Vec3& v : def.vertices)
                EXPECT_LT(f.normal.x * v.x() + f.normal.y * v.y() + f.normal.z * v.z(),
                          f.offset + 1e-8);
    }
}

}  // namespace
}  // namespace hawser
