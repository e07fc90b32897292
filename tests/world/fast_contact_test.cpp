// SPDX-License-Identifier: Apache-2.0
/// Continuous collision detection in a world: a body that would be far beyond a thin obstacle after
/// one step stays on its side (docs/collision.md).
#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr int kFastSteps = 10;
constexpr double kWireRadius = 0.0025, kElement = 0.5;

/// Add point masses of 0.1 kg from `from` on, at intervals of `apart`, joined by elements; with
/// fixed or free ends.
std::vector<BodyId> add_fast_wire(World& w, int nodes, const Vec3& from, const Vec3& separation,
                                  const Vec3& velocity, double length, bool held) {
    std::vector<BodyId> wire;
    for (int i = 0; i < nodes; ++i) {
        BodyDef d;
        const bool end = held && (i == 0 || i + 1 == nodes);
        d.kind = end ? BodyKind::fixed : BodyKind::lump;
        d.mass = 0.1;
        d.position = from + i * separation;
        d.velocity = velocity;
        wire.push_back(w.add_body(d));
        if (i == 0) continue;
        InteractionDef line{.kind = InteractionKind::Stretch,
                            .body = {wire[wire.size() - 2], wire.back()}};
        line.set("length", length).set("EA", 2e6).set("tension_only", 1.0);
        w.add_interaction(line);
        ShapeDef s;
        s.kind = ShapeKind::capsule;
        s.body = wire[wire.size() - 2];
        s.body_b = wire.back();
        s.radius = kWireRadius;
        w.add_shape(s);
    }
    return wire;
}

/// Return the height of the middle element of `upper` over `lower` at their crossing, seen from
/// above; NaN if they do not cross.
double height_at_crossing(const World& w, const std::vector<BodyId>& upper,
                          const std::vector<BodyId>& lower) {
    const std::size_t middle = upper.size() / 2;
    const Vec3 c = w.pose(upper[middle - 1]).position, q = w.pose(upper[middle]).position - c;
    for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
        const Vec3 a = w.pose(lower[i]).position, p = w.pose(lower[i + 1]).position - a;
        Eigen::Matrix2d m;
        m << p.x(), -q.x(), p.y(), -q.y();
        const Eigen::Vector2d s = m.inverse() * (c - a).head<2>();
        if (s.minCoeff() >= 0.0 && s.maxCoeff() <= 1.0) return (c + s[1] * q - a - s[0] * p).z();
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// Expect that a free wire falls across a taut one of 4 m, `aside` of the middle of their elements,
/// and touches it for at least `least` steps.
void expect_held(double speed, double step, const Eigen::Vector2d& aside, double height,
                 int least = 6) {
    SCOPED_TRACE(std::to_string(speed) + " m/s, aside " + std::to_string(aside.x()) + ", " +
                 std::to_string(aside.y()) + ", from " + std::to_string(height));
    WorldDef def;
    def.step = step;
    World w(def);
    const auto taut = add_fast_wire(w, 9, {-1.75, 0.0, 0.0}, {kElement, 0.0, 0.0}, Vec3::Zero(),
                                    kElement * (1.0 - 2e-3), true);
    const auto falling = add_fast_wire(w, 4, {aside.x(), aside.y() - 1.5 * kElement, height},
                                       {0.0, kElement, 0.0}, {0.0, 0.0, -speed}, kElement, false);
    int touching = 0;
    for (int i = 0; i < kFastSteps; ++i) {
        ASSERT_EQ(w.step(), Status::ok) << i;
        ASSERT_LE(w.stats().natural_map, def.contact_tolerance) << i;
        touching += w.stats().contacts > 0 ? 1 : 0;
        // Two radii, less the compression of the spring of 5e7 N/m: 50 kN at 300 m/s, a millimetre.
        // Rotation of an element also reduces its height over the contact point.
        ASSERT_GT(height_at_crossing(w, falling, taut), 0.0) << i;
    }
    EXPECT_GE(touching, least);  // they collide and separate
}

TEST(FastContact, WiresHoldEachOtherAtTwentyFiveThicknessesAStepAndMore) {
    for (const double speed : {50.0, 300.0})
        for (const double way : {0.13, 0.2})  // m per step; an element is 0.5 m
            for (const double x : {0.0, 0.2})
                for (const double y : {0.0, 0.1}) {
                    if (kSanitized && (x == 0.0 || y == 0.0)) continue;
                    expect_held(speed, way / speed, {x, y}, 0.02);
                    expect_held(speed, way / speed, {x, y}, 0.25);
                }
}

/// At 60 Hz they would be 0.8 and 5 m apart after a step. An element hit off its middle rotates by
/// more than a radian in the next step and may then pass.
TEST(FastContact, WiresHoldEachOtherAtSixtyHertz) {
    // 50 ms, three times the duration at 50 m/s with resolved steps.
    constexpr int kSteps = 3;
    for (const double height : {0.02, 0.3}) {
        expect_held(50.0, 1.0 / 60.0, {0.0, 0.0}, height, kSteps);
        expect_held(50.0, 1.0 / 60.0, {0.1, 0.0}, height, kSteps);
    }
    expect_held(300.0, 1.0 / 60.0, {0.0, 0.0}, 0.02, kSteps);
    expect_held(300.0, 1.0 / 60.0, {0.0, 0.0}, 0.3, kSteps);
}

/// Make a floor at z = 0: a plate of 2 mm, two triangles, a heightfield.
ShapeDef thin_floor(ShapeKind kind) {
    ShapeDef s;
    s.kind = kind;
    if (kind == ShapeKind::box) {
        s.half_size = {1.0, 1.0, 1e-3};
        s.position = {0.0, 0.0, -1e-3};
    } else if (kind == ShapeKind::mesh) {
        s.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        s.triangles = {{0, 1, 2}, {0, 2, 3}};
    } else {
        s.rows = s.columns = 5;
        s.cell = {0.5, 0.5};
        s.heights.assign(25, 0.0);
    }
    return s;
}

TEST(FastContact, ABallAt300MetresASecondStaysAboveAThinFloor) {
    constexpr double kBall = 0.05;
    for (const ShapeKind kind : {ShapeKind::box, ShapeKind::mesh, ShapeKind::heightfield})
        for (const double height : {0.06, 1.0, 4.0}) {  // a step is 5 m
            SCOPED_TRACE(to_string(kind));
            World w;
            BodyDef d;
            d.kind = BodyKind::fixed;
            ShapeDef s = thin_floor(kind);
            s.body = w.add_body(d);
            w.add_shape(s);
            d.kind = BodyKind::rigid;
            d.mass = 1.0;
            d.inertia = 0.4 * kBall * kBall * Mat3::Identity();
            d.position = {0.13, 0.07, height};
            d.velocity = {0.0, 0.0, -300.0};
            ShapeDef ball;
            ball.radius = kBall;
            ball.body = w.add_body(d);
            w.add_shape(ball);
            for (int i = 0; i < kFastSteps; ++i) {
                ASSERT_EQ(w.step(), Status::ok) << i;
                ASSERT_LE(w.stats().natural_map, w.settings().contact_tolerance) << i;
                // The spring of 5e7 N/m stops 1 kg within the step: 18 kN, 0.4 mm.
                ASSERT_NEAR(w.pose(ball.body).position.z(), kBall, 5e-4) << height << ", " << i;
            }
        }
}

}  // namespace
}  // namespace hawser::test
