// SPDX-License-Identifier: Apache-2.0
/// Loads of systems in stages with solutions of their own: impacts, and predicted velocities on
/// both sides of a cut.
#include "systems/acting.h"

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

/// A ball that falls onto a plane returns with e times its speed, for any added mass. The energy
/// that the impact takes from ball and added mass is the value in the account.
TEST(LoadStages, AnImpactReflectsAddedMass) {
    World w;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    w.add_body(ground);
    BodyDef ball = floating({0, 0, 1.0}, 2.0, {0.1, 0.1, 0.1});
    ball.velocity = {0, 0, -4.0};
    w.add_body(ball);
    MaterialDef rubber;
    rubber.name = "rubber";
    rubber.restitution = 0.5;
    const MaterialId material = w.add_material(rubber);
    for (const int b : {0, 1}) {
        ShapeDef s;
        s.kind = b == 0 ? ShapeKind::plane : ShapeKind::sphere;
        s.radius = 0.5;
        s.body = BodyId{b};
        s.material = material;
        w.add_shape(s);
    }
    act(w, "water", [](Acting&, Prestep&, Loads& loads) {
        loads.add_mass(BodyId{1}, Mat3(Mat3::Identity() * 6.0));
    });
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    for (int i = 0; i < 60 && w.velocity(BodyId{1}).linear.z() < 0.0; ++i)
        ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.stats().impacts, 1);
    // The contact yields slightly within the step of the impact, and is not part of the law.
    EXPECT_NEAR(w.velocity(BodyId{1}).linear.z(), 0.5 * 4.0, 1e-3);
    const Energy end = w.energy();
    // Three quarters of ½ (2 + 6) kg (4 m/s)².
    EXPECT_NEAR(end.contact - start.contact, 0.75 * 64.0, 1e-2);
    const double open = end.mechanical() - start.mechanical() + end.contact - start.contact +
                        end.friction - start.friction - (end.system - start.system);
    EXPECT_NEAR(open, 0.0, 1e-9);
}

/// Hulls and point masses side by side with equal accelerations by loads: the interactions between
/// them carry no force. A predictor that uses the loads leaves no defect of the cut.
TEST(LoadStages, PredictorsOfCutsKnowLoads) {
    for (const Predictor predictor : {Predictor::forces, Predictor::clique, Predictor::hold}) {
        World w({.gravity = Vec3::Zero(), .coupling = Coupling::kinematic, .predictor = predictor});
        for (int i = 0; i < 4; ++i) {
            BodyDef def = floating({2.0 * i, 0, 0}, 3.0, {1, 1, 1});
            if (i % 2 == 1) def.kind = BodyKind::lump;
            def.group = i < 2 ? "left" : "right";
            w.add_body(def);
        }
        for (int i = 0; i < 3; ++i) {
            InteractionDef d = between(InteractionKind::Distance, {BodyId{i}, BodyId{i + 1}});
            d.compliance[0] = 1e-3;
            w.add_interaction(d.set("length", 2.0));
        }
        act(w, "water", [](Acting&, Prestep&, Loads& loads) {
            for (int b = 0; b < 4; ++b) {
                loads.add_mass(BodyId{b}, Mat3(Mat3::Identity() * (1.0 + b)));
                loads.add_force(BodyId{b}, {0.5 * (4.0 + b), 0, 0});
            }
        });
        for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
        EXPECT_EQ(w.stats().cuts, 1);
        const double ahead = w.settings().step * 0.5;
        if (predictor == Predictor::hold) {  // it uses no forces: its error is theirs
            EXPECT_GT(w.stats().cut_residual, 1e-6);
        } else {
            EXPECT_LT(w.stats().cut_residual, 1e-12);
            EXPECT_NEAR(w.velocity(BodyId{0}).linear.x(), 0.5 * (w.time() - ahead / 1.0), 1e-10);
        }
    }
}

}  // namespace
}  // namespace hawser::test
