// SPDX-License-Identifier: Apache-2.0
// Bent meshes must not push a shape from a distance, nor leave it without contact.
#include "collide/collide_function.h"
#include "collide/narrow/shape_data.h"
#include "support/collide/place.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <hawser/def.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace hawser {
namespace {

using collide::Geometry;
using collide::Manifold;
using collide::Placement;
using test::place;
using test::turn;

struct Ground {
    std::shared_ptr<collide::ShapeData> data;
    Geometry geometry;
};

Ground ground_of(const ShapeDef& def) {
    Ground g{collide::make_shape_data(def), {}};
    g.geometry.kind = def.kind;
    g.geometry.data = g.data.get();
    return g;
}

/// Make a floor, z = 0 for −5 < x < 0, and a wall of 5 m that rises from its edge at an angle to
/// +x.
Ground floor_and_wall(double angle) {
    ShapeDef def;
    def.kind = ShapeKind::mesh;
    for (const double y : {-5.0, 5.0}) {
        def.vertices.emplace_back(-5.0, y, 0.0);
        def.vertices.emplace_back(0.0, y, 0.0);
        def.vertices.emplace_back(5.0 * std::cos(angle), y, 5.0 * std::sin(angle));
    }
    def.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    return ground_of(def);
}

Manifold touch(const Geometry& shape, const Vec3& at, const Quat& q, const Ground& ground,
               double margin) {
    Manifold m;
    collide::collide_function(shape.kind, ground.geometry.kind)(
        shape, place(at, q), ground.geometry, place({0, 0, 0}), margin, m);
    return m;
}

double min_gap(const Manifold& m) {
    double least = 1e300;
    for (int i = 0; i < m.count; ++i) least = std::min(least, m.point[i].gap);
    return least;
}

TEST(NarrowMesh, ATriangleApartDoesNotPush) {
    // A slab leans over a wall that overhangs the floor. Its middle is below the plane of the
    // floor, but beyond its edge. Its top is above the floor, behind the wall.
    const double lean = M_PI * 110 / 180, wall = M_PI * 100 / 180;
    const Ground ground = floor_and_wall(wall);
    Geometry slab;
    slab.kind = ShapeKind::box;
    slab.half_size[0] = 2.0;
    slab.half_size[1] = 0.4;
    slab.half_size[2] = 0.05;
    const Vec3 middle(0.5, 0.0, -0.2), along(std::cos(lean), 0, std::sin(lean));
    const Vec3 across(-std::sin(lean), 0, std::cos(lean));
    const Vec3 corner = middle + 2.0 * along + 0.05 * across;
    const double gap = Vec3(std::sin(wall), 0, -std::cos(wall)).dot(corner);
    ASSERT_GT(gap, 0.01);
    ASSERT_LT(gap, 0.3);
    const Manifold m = touch(slab, middle, turn(-lean, Vec3(0, 1, 0)), ground, 0.6);
    ASSERT_GE(m.count, 1);
    EXPECT_NEAR(min_gap(m), gap, 1e-9);
}

TEST(NarrowMesh, WhatNoTriangleClaimsIsPushedOut) {
    // A capsule pierces the floor beside a wall of slope 30°. The shortest way out of the floor
    // leads over its edge, into the wall. Its lowest point is beyond the edge and not under the
    // wall.
    const Ground ground = floor_and_wall(M_PI / 6);
    Geometry pin;
    pin.kind = ShapeKind::capsule;
    pin.radius = 0.05;
    pin.half_length = 0.6 * std::sqrt(2.0);
    const Manifold m = touch(pin, {-0.5, 0.0, 0.4}, turn(-M_PI / 4, Vec3(0, 1, 0)), ground, 0.02);
    ASSERT_EQ(m.count, 1);
    EXPECT_NEAR(m.point[0].gap, -0.25, 1e-12);
    EXPECT_NEAR(m.point[0].normal[2], -1.0, 1e-12);
}

TEST(NarrowMesh, TheLowestPointOfARimIsFound) {
    // Deep in the ground the way out is upwards, and corners of a rim are not sufficient.
    ShapeDef def;
    def.kind = ShapeKind::heightfield;
    def.rows = def.columns = 2;
    def.cell = {10.0, 10.0};
    def.heights.assign(4, 0.0);
    const Ground ground = ground_of(def);
    Geometry drum;
    drum.kind = ShapeKind::cylinder;
    drum.radius = 0.7;
    drum.half_length = 0.4;
    for (int i = 0; i < 40; ++i) {
        const double tilt = 0.005 * i, heading = 0.37 * i;
        const Quat q = turn(tilt, Vec3(std::cos(heading), std::sin(heading), 0.0));
        const Manifold m = touch(drum, {1.0, -1.5, -3.0}, q, ground, 0.02);
        ASSERT_GE(m.count, 1);
        EXPECT_NEAR(min_gap(m), -3.0 - 0.4 * std::cos(tilt) - 0.7 * std::sin(tilt), 1e-7);
    }
}

TEST(NarrowMesh, TheFrameOfAHullMayLieAnywhere) {
    // The same hull, described in a frame 30 m away.
    test::Random random(test::first_seed(3));
    const int cases = test::by_tier(200, 1000, 10'000);
    for (const double angle : {M_PI / 6, M_PI * 100 / 180}) {
        const Ground ground = floor_and_wall(angle);
        int seen = 0;
        for (int i = 0; i < cases; ++i) {
            const Vec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            const Quat q = random.rotation();
            const Vec3 off(0.0, 0.0, -30.0);
            Manifold m[2];
            ShapeDef def;
            def.kind = ShapeKind::hull;
            for (int k = 0; k < 8; ++k) def.vertices.push_back(random.vector(0.8));
            for (int k = 0; k < 2; ++k) {
                const Ground hull = ground_of(def);
                m[k] = touch(hull.geometry, k == 0 ? at : Vec3(at - q * off), q, ground, 0.02);
                for (Vec3& v : def.vertices) v += off;
            }
            ASSERT_EQ(m[0].count > 0, m[1].count > 0) << i;
            if (m[0].count == 0) continue;
            ++seen;
            EXPECT_NEAR(min_gap(m[0]), min_gap(m[1]), 1e-6) << i;
        }
        EXPECT_GT(seen, cases / 4);
    }
}

}  // namespace
}  // namespace hawser
