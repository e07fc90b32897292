// SPDX-License-Identifier: Apache-2.0
// Separate code verifies contacts of capsules attached to a body: at a point, at a drum, and where
// the wire leaves a guide.
#include <hawser/hawser.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace hawser {
namespace {

TEST(EndCapsulesVerified, SeparateCodeAgrees) {
    World w({.step = 1.0 / 60.0, .contact_margin = 0.1});
    const BodyId ship = w.add_body({.name = "ship",
                                    .mass = 4e7,
                                    .inertia = Mat3::Identity() * 4e9,
                                    .linear_damping = Vec3::Constant(1e5),
                                    .angular_damping = Vec3::Constant(1e6),
                                    .gravity = false,
                                    .half_size = {20, 5, 2}});
    const BodyId weight = w.add_body({.name = "weight",
                                      .kind = BodyKind::rigid,
                                      .position = {27.5, 0, -8.2},
                                      .mass = 6e3,
                                      .inertia = Mat3::Identity() * 6e3,
                                      .angular_damping = Vec3::Constant(2e4)});
    WireDef def{.name = "wire", .from = ship, .from_point = {0, 0, 1}, .to = weight};
    def.to_point = {0, 0, 1.2};
    def.path = {{5, 0, 1}, {10, 0, 1}, {15, 0, 1}, {20, 0, 1}, {25, 0, 1}, {27.5, 0, -2}};
    def.elements = 7;
    def.length = 33.9;
    def.EA = 2.33e8;
    def.mass_per_length = 23.0;
    def.drag = 100.0;
    def.consistent_mass = true;
    def.radius = 0.038;
    def.end_capsules = true;
    const WireId wire = w.wires().add(def);
    w.add(GuideDef{.name = "roller",
                   .wire = wire,
                   .body = ship,
                   .point = {27, 0, 0.5},
                   .axis = {0, 1, 0},
                   .radius = 0.5,
                   .friction = 0.2});
    w.add(WinchDef{.name = "winch",
                   .wire = wire,
                   .core_radius = 0.6,
                   .width = 2.4,
                   .flange_radius = 1.4,
                   .wire_diameter = 0.076,
                   .mass_per_length = 23.0,
                   .stored = 500.0,
                   .inertia = 4e4,
                   .mode = WinchMode::speed});
    // Bars fall on the elements at the drum, before the guide and above the weight's shackle.
    int k = 0;
    for (const Vec3& at : {Vec3(2.5, 0, 2.0), Vec3(26.0, 0, 1.3), Vec3(27.6, 0.3, -5.0)}) {
        const BodyId bar = w.add_body({.name = "bar" + std::to_string(k++),
                                       .position = at,
                                       .velocity = {0, at.y() > 0 ? -3.0 : 0.0, 0},
                                       .mass = 60.0,
                                       .inertia = Vec3(20, 1, 20).asDiagonal()});
        w.add_shape({.kind = ShapeKind::capsule,
                     .body = bar,
                     .orientation = Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0),
                     .radius = 0.1,
                     .half_length = 1.0});
    }
    verify::Verifier verifier(w);
    std::set<std::string> held;
    for (int i = 0; i < 240; ++i) {
        if (i == 100) w.set_system_signal("winch.speed", 0.5);
        verifier.before_step(w);
        ASSERT_EQ(w.step(), Status::ok) << i;
        ASSERT_EQ(verifier.after_step(w), "") << i;
        for (const ContactView& c : w.contacts())
            for (const ShapeId s : c.shape) {
                const ShapeDef& d = w.shape_def(s);
                if (!d.body_b.valid() || !(c.force.norm() > 0.0)) continue;
                for (const InteractionId id : w.wires().elements(wire)) {
                    const InteractionDef& e = w.interaction_def(id);
                    if (e.body[0] != d.body || e.body[1] != d.body_b) continue;
                    const bool lumps = w.body_def(e.body[0]).kind == BodyKind::lump &&
                                       w.body_def(e.body[1]).kind == BodyKind::lump;
                    if (!lumps) held.insert(kind_info(e.kind).name);
                }
            }
    }
    EXPECT_EQ(held, (std::set<std::string>{"end_span", "stretch", "winch_stretch"}));
    EXPECT_LT(verifier.result().difference, 1e-9);
    EXPECT_GE(verifier.result().covered_bodies, verifier.result().moving_bodies - 2);
    EXPECT_LE(verifier.result().rejected_steps, 2);
}

// The lowest point of a capsule is at its attachment to a body that rotates. The node's part of
// such a contact acts with the velocity that the body would have at the node.
TEST(EndCapsulesVerified, SeparateCodeAgreesBeyondTheHeldPoint) {
    World w({.step = 1.0 / 60.0, .contact_margin = 0.1});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    w.add_shape({.kind = ShapeKind::plane, .body = ground});
    const BodyId post =
        w.add_body({.kind = BodyKind::fixed, .position = {20, 0, 6}, .half_size = {1, 1, 1}});
    const BodyId wheel = w.add_body({.name = "wheel",
                                     .position = {0, 0, 0.15},
                                     .angular_velocity = {0, 0.5, 0},
                                     .mass = 500,
                                     .inertia = Mat3::Identity() * 2e3});
    WireDef def{.name = "wire", .from = wheel, .to = post};
    def.elements = 4;
    def.length = 21.0;
    def.EA = 1e8;
    def.mass_per_length = 10.0;
    def.drag = 100.0;
    def.radius = 0.1;
    def.end_capsules = true;
    w.wires().add(def);
    verify::Verifier verifier(w);
    int beyond = 0;
    for (int i = 0; i < 60; ++i) {
        verifier.before_step(w);
        ASSERT_EQ(w.step(), Status::ok) << i;
        ASSERT_EQ(verifier.after_step(w), "") << i;
        for (const ContactView& c : w.contacts())
            if (w.shape_def(c.shape[1]).body == wheel && std::abs(c.point.x()) < 0.1) ++beyond;
    }
    EXPECT_GE(beyond, 50);
}

}  // namespace
}  // namespace hawser
