// SPDX-License-Identifier: Apache-2.0
// Contact points at rest: their number, their positions, and whether they keep their keys.
#include "collide/collide_function.h"
#include "support/collide/place.h"
#include "support/collide/random_pairs.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace hawser {
namespace {

using collide::Geometry;
using collide::Manifold;
using collide::Placement;
using test::place;
using test::turn;
using enum ShapeKind;

const Quat kLying = turn(M_PI / 2, Vec3(0, 1, 0));  // z along x

Geometry shape(ShapeKind kind) {
    Geometry g;
    g.kind = kind;
    g.radius = 0.3;
    g.half_length = 0.8;
    g.half_size[0] = 0.5;
    g.half_size[1] = 0.7;
    g.half_size[2] = 0.3;
    return g;
}
Geometry slab() {
    Geometry g = shape(box);
    g.half_size[0] = g.half_size[1] = 5.0;
    g.half_size[2] = 1.0;
    return g;
}

Manifold collide_two(const Geometry& a, const Placement& pa, const Geometry& b, const Placement& pb,
                     double margin = 0.02) {
    Manifold m;
    collide::collide_function(a.kind, b.kind)(a, pa, b, pb, margin, m);
    return m;
}
std::vector<std::uint32_t> names(const Manifold& m) {
    std::vector<std::uint32_t> list;
    for (int i = 0; i < m.count; ++i) list.push_back(m.point[i].feature);
    return list;
}
void expect_gaps(const Manifold& m, double gap, double tolerance = 1e-12) {
    for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.point[i].gap, gap, tolerance) << i;
}

/// A shape at rest on a slab, with its contact points.
struct Resting {
    const char* name;
    Geometry shape;
    Quat attitude;
    double height;  ///< Height of its centre over the surface.
    int points;
};
const std::vector<Resting>& resting() {
    static const std::vector<Resting> list = {
        {"sphere", shape(sphere), Quat::Identity(), 0.3, 1},
        {"standing capsule", shape(capsule), Quat::Identity(), 1.1, 1},
        {"lying capsule", shape(capsule), kLying, 0.3, 2},
        {"box on a face", shape(box), Quat::Identity(), 0.3, 4},
        {"box on another face", shape(box), kLying, 0.5, 4},
        {"box on an edge", shape(box), turn(M_PI / 4, Vec3(1, 0, 0)), (0.7 + 0.3) / std::sqrt(2.0),
         2},
        {"standing cylinder", shape(cylinder), Quat::Identity(), 0.8, 4},
        {"lying cylinder", shape(cylinder), kLying, 0.3, 2},
    };
    return list;
}

TEST(NarrowManifold, HoldsWhatRestsOnAPlaneOrABox) {
    for (const Resting& r : resting())
        for (const double gap : {-1e-3, 0.0, 1e-3}) {
            for (const double heading : {0.0, 0.4}) {
                SCOPED_TRACE(testing::Message()
                             << r.name << " gap " << gap << " turned " << heading);
                const Quat q = turn(heading, Vec3(0, 0, 1)) * r.attitude;
                const Vec3 at(0.2, -0.1, r.height + gap);
                const Manifold plane_m =
                    collide_two(r.shape, place(at, q), shape(plane), place({0, 0, 0}));
                EXPECT_EQ(plane_m.count, r.points);
                expect_gaps(plane_m, gap);
                const Manifold box_m =
                    collide_two(r.shape, place(at, q), slab(), place({0, 0, -1}));
                EXPECT_EQ(box_m.count, r.points);
                expect_gaps(box_m, gap);
                for (int i = 0; i < box_m.count; ++i)
                    EXPECT_NEAR(box_m.point[i].normal[2], -1.0, 1e-12);
            }
        }
}

TEST(NarrowManifold, NamesSurviveNoise) {
    test::Random random(test::first_seed(3));
    const int cases = test::by_tier(200, 1000, 10'000);
    for (const Resting& r : resting())
        for (const Geometry& ground : {shape(plane), slab()}) {
            SCOPED_TRACE(r.name);
            const Vec3 base(0, 0, ground.kind == plane ? 0.0 : -1.0);
            const Vec3 at(0.0, 0.0, r.height - 1e-4);
            const auto first =
                names(collide_two(r.shape, place(at, r.attitude), ground, place(base)));
            for (int i = 0; i < cases; ++i) {
                const Quat q = turn(1e-9 * random.unit(), random.vector(1)) * r.attitude;
                const Manifold m =
                    collide_two(r.shape, place(at + random.vector(1e-9), q), ground, place(base));
                EXPECT_EQ(names(m), first);
            }
        }
}

TEST(NarrowManifold, StacksOfEqualShapesKeepTheirNames) {
    test::Random random(test::first_seed(4));
    const int cases = test::by_tier(300, 1500, 15'000);
    struct Stack {
        Geometry g;
        double height;
        Vec3 shift;
        int points;
    };
    const Stack stacks[] = {{shape(box), 0.6, {0, 0, 0}, 4},        // aligned on all sides
                            {shape(box), 0.6, {0.5, 0, 0}, 4},      // bricks, half over the edge
                            {shape(box), 0.6, {0.5, 0.7, 0}, 4},    // a corner
                            {shape(cylinder), 1.6, {0, 0, 0}, 4}};  // one standing on the other
    for (const Stack& s : stacks) {
        const Vec3 at = s.shift + Vec3(0, 0, s.height - 1e-5);
        const auto first = names(collide_two(s.g, place({0, 0, 0}), s.g, place(at)));
        EXPECT_EQ(first.size(), static_cast<std::size_t>(s.points));
        for (int i = 0; i < cases; ++i) {
            const Quat q = turn(1e-9 * random.unit(), random.vector(1));
            const Manifold m = collide_two(s.g, place(random.vector(1e-9)), s.g,
                                           place(at + random.vector(1e-9), q));
            EXPECT_EQ(names(m), first) << "shift " << s.shift.transpose();
        }
    }
}

TEST(NarrowManifold, FaceOnFaceIsWhereTheyOverlap) {
    // Turned by 45 degrees over a large one: its own four corners. Over an equal one: four of the
    // eight crossings, which span the octagon.
    Geometry cube = shape(box);
    cube.half_size[0] = cube.half_size[1] = cube.half_size[2] = 0.5;
    const Quat q = turn(M_PI / 4, Vec3(0, 0, 1));
    EXPECT_EQ(collide_two(cube, place({0, 0, 0.49}, q), slab(), place({0, 0, -1})).count, 4);
    const Manifold m = collide_two(cube, place({0, 0, 0.99}, q), cube, place({0, 0, 0}));
    ASSERT_EQ(m.count, 4);
    for (int i = 0; i < 4; ++i) {
        const double* p = m.point[i].on[0];
        EXPECT_NEAR(std::max(std::fabs(p[0]), std::fabs(p[1])), 0.5, 1e-9);
        EXPECT_NEAR(m.point[i].gap, -0.01, 1e-12);
    }
    // Half over the edge: two corners and two crossings.
    const Manifold edge = collide_two(cube, place({5, 0.2, 0.5}), slab(), place({0, 0, -1}));
    ASSERT_EQ(edge.count, 4);
    for (int i = 0; i < 4; ++i) EXPECT_LE(edge.point[i].on[0][0], 5.0 + 1e-12);
}

TEST(NarrowManifold, EdgesThatCrossTouchAtOnePoint) {
    const Quat roof = turn(M_PI / 4, Vec3(1, 0, 0));
    const Quat keel = turn(M_PI / 2, Vec3(0, 0, 1)) * roof;
    Geometry g = shape(box);
    g.half_size[0] = 1.0;
    g.half_size[1] = g.half_size[2] = 0.5;
    const double ridge = 0.5 * std::sqrt(2.0);
    for (const double gap : {-0.01, 0.01}) {
        const Manifold m =
            collide_two(g, place({0, 0, 0}, roof), g, place({0, 0, 2 * ridge + gap}, keel));
        ASSERT_EQ(m.count, 1);
        EXPECT_NEAR(m.point[0].gap, gap, 1e-12);
        EXPECT_NEAR(m.point[0].normal[2], 1.0, 1e-12);
    }
}

TEST(NarrowManifold, ParallelCapsulesAndCylindersTouchAlongTheirCommonLength) {
    for (const ShapeKind kind : {capsule, cylinder})
        for (const double tilt : {0.0, 1e-6, 1e-3}) {
            const Quat q = turn(tilt, Vec3(1, 0, 0)) * kLying;
            const Manifold m =
                collide_two(shape(kind), place({0, 0, 0}, kLying), shape(kind),
                            place({0.3, 0, 0.6}, turn(tilt, Vec3(0, 0, 1)) * q), 0.01);
            std::vector<double> x;
            for (int i = 0; i < m.count; ++i) x.push_back(m.point[i].on[0][0]);
            ASSERT_GE(m.count, 2) << test::kind_name(kind) << " " << tilt;
            EXPECT_NEAR(*std::min_element(x.begin(), x.end()), -0.5, 1e-3);
            EXPECT_NEAR(*std::max_element(x.begin(), x.end()), 0.8, 1e-3);
        }
    // Crossing capsules: one point.
    const Manifold m = collide_two(shape(capsule), place({0, 0, 0}, kLying), shape(capsule),
                                   place({0, 0, 0.6}, turn(1.0, Vec3(0, 0, 1)) * kLying));
    EXPECT_EQ(m.count, 1);
}

TEST(NarrowManifold, NothingBeyondTheMargin) {
    for (const Resting& r : resting())
        for (const double margin : {0.001, 0.1}) {
            const auto at = [&](double gap) { return place({0, 0, r.height + gap}, r.attitude); };
            for (const Geometry& ground : {shape(plane), slab()}) {
                const Placement base = place({0, 0, ground.kind == plane ? 0.0 : -1.0});
                EXPECT_EQ(collide_two(r.shape, at(margin + 1e-9), ground, base, margin).count, 0);
                EXPECT_EQ(collide_two(r.shape, at(margin - 1e-9), ground, base, margin).count,
                          r.points)
                    << r.name;
            }
        }
}

TEST(NarrowManifold, TheOtherWayRoundIsTheMirrorImage) {
    test::Random random(test::first_seed(8));
    const int cases = test::by_tier(200, 1000, 10'000);
    const ShapeKind kinds[] = {sphere, capsule, box, cylinder, plane};
    for (const ShapeKind a : kinds)
        for (const ShapeKind b : kinds)
            for (int i = 0; i < cases; ++i) {
                const Placement pa = place({0, 0, 0}, random.rotation());
                const Placement pb = place(random.vector(0.8), random.rotation());
                const Manifold m = collide_two(shape(a), pa, shape(b), pb, 0.1);
                const Manifold w = collide_two(shape(b), pb, shape(a), pa, 0.1);
                ASSERT_EQ(m.count > 0, w.count > 0);
                if (m.count == 0) continue;
                const auto least = [](const Manifold& x) {
                    return *std::min_element(x.point, x.point + x.count,
                                             [](auto& p, auto& q) { return p.gap < q.gap; });
                };
                EXPECT_NEAR(least(m).gap, least(w).gap, 2e-8)
                    << test::kind_name(a) << test::kind_name(b) << i;
                if (a == b) continue;
                ASSERT_EQ(m.count, w.count);
                for (int k = 0; k < m.count; ++k) {
                    EXPECT_EQ(m.point[k].feature, w.point[k].feature);
                    EXPECT_EQ(m.point[k].gap, w.point[k].gap);
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_EQ(m.point[k].on[0][c], w.point[k].on[1][c]);
                        EXPECT_EQ(m.point[k].normal[c], -w.point[k].normal[c]);
                    }
                }
            }
}

TEST(NarrowManifold, DegenerateInputGivesFiniteUnitNormals) {
    const Quat turns[] = {Quat::Identity(), kLying, turn(M_PI / 4, Vec3(0, 0, 1)),
                          turn(1e-9, Vec3(1, 0, 0)), turn(M_PI, Vec3(1, 0, 0))};
    const Vec3 shifts[] = {{0, 0, 0},   {0, 0, 0.3}, {0.5, 0, 0},   {0, 0, 1e-13},
                           {0.6, 0, 0}, {0, 0, 1.6}, {1e-160, 0, 0}};
    for (const ShapeKind a : {sphere, capsule, box, cylinder, plane})
        for (const ShapeKind b : {sphere, capsule, box, cylinder, plane})
            for (const Quat& q : turns)
                for (const Vec3& shift : shifts)
                    for (const double length : {0.8, 0.0}) {
                        if ((a == cylinder || b == cylinder) && length == 0.0) continue;
                        Geometry ga = shape(a), gb = shape(b);
                        ga.half_length = length;
                        const Manifold m =
                            collide_two(ga, place({1, 2, 3}), gb, place(Vec3(1, 2, 3) + shift, q));
                        if (a != plane && b != plane && shift.norm() < 0.4) {
                            EXPECT_GT(m.count, 0)
                                << test::kind_name(a) << " " << test::kind_name(b);
                        }
                        for (int i = 0; i < m.count; ++i) {
                            const auto& p = m.point[i];
                            const Vec3 n(p.normal[0], p.normal[1], p.normal[2]);
                            EXPECT_NEAR(n.norm(), 1.0, 1e-12);
                            for (int k = 0; k < 3; ++k) {
                                EXPECT_TRUE(std::isfinite(p.on[0][k]));
                                EXPECT_TRUE(std::isfinite(p.on[1][k]));
                            }
                        }
                    }
}

}  // namespace
}  // namespace hawser
