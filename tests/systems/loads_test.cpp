// SPDX-License-Identifier: Apache-2.0
/// Loads of systems against closed forms: coupled added mass, springs, dampers, their energy.
#include "systems/acting.h"

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace hawser::test {
namespace {

/// Return the added mass of a hull in sway and roll: y and the rotation about x are coupled.
Mat6 sway_roll(double sway, double roll, double both) {
    Mat6 a = Mat6::Zero();
    a(1, 1) = sway;
    a(3, 3) = roll;
    a(1, 3) = a(3, 1) = both;
    return a;
}

/// (M + A) v̇ = f has v = (M + A)⁻¹ f t for any step; velocities are those half a step before.
/// Rotation about a principal axis of a body has no gyroscopic torque.
TEST(Loads, CoupledAddedMassMovesABodyAsTheClosedFormSays) {
    const Mat6 a = sway_roll(5.0, 4.0, 3.0);
    const Vec3 force(0, 7, 0), torque(1.5, 0, 0);
    for (const int bodies : {1, 24}) {  // one by one, and in batches of eight
        World w({.gravity = Vec3::Zero()});
        for (int i = 0; i < bodies; ++i) w.add_body(floating({0, 0, 9.0 * i}, 2.0, {3, 4, 5}));
        act(w, "water", [&](Acting&, Prestep& now, Loads& loads) {
            for (int b = 0; b < now.world.body_count(); ++b) {
                loads.add_mass(BodyId{b}, a);
                loads.add_force(BodyId{b}, force, torque);
            }
        });
        for (int i = 0; i < 300; ++i) ASSERT_EQ(w.step(), Status::ok);
        Eigen::Matrix2d m;
        m << 2.0 + 5.0, 3.0, 3.0, 3.0 + 4.0;
        const Eigen::Vector2d rate = m.inverse() * Eigen::Vector2d(7.0, 1.5);
        const double t = w.time() - 0.5 * w.settings().step;
        for (int b = 0; b < bodies; ++b) {
            const Vec6 v = motion(w, BodyId{b});
            EXPECT_NEAR(v[1], rate[0] * t, 1e-12 * 300);
            EXPECT_NEAR(v[3], rate[1] * t, 1e-12 * 300);
            EXPECT_NEAR(w.pose(BodyId{b}).position.y(), 0.5 * rate[0] * w.time() * w.time(), 1e-10);
            EXPECT_LT(std::abs(v[0]) + std::abs(v[2]) + std::abs(v[4]) + std::abs(v[5]), 1e-12);
        }
        EXPECT_LT(w.stats().momentum_residual, 1e-13);
    }
}

/// Matrix and residual of the step use the loads independently: without them in one, no refinement
/// would reduce the residual. Chains have kernels of their own.
TEST(Loads, ResidualsOfChainsWithLoadsAreThoseOfRounding) {
    for (const Form form : {Form::automatic, Form::saddle, Form::condensed}) {
        Recipe r = chains(3, 4, 24);
        r.world.form = form;
        World w = r.make();
        act(w, "water", [&](Acting&, Prestep& now, Loads& loads) {
            for (int b = 1; b < now.world.body_count(); b += 3) {
                loads.add_mass(BodyId{b}, coupled(static_cast<unsigned>(b), 40.0));
                loads.add_damping(BodyId{b}, coupled(static_cast<unsigned>(b) + 99, 300.0));
                loads.add_stiffness(BodyId{b}, coupled(static_cast<unsigned>(b) + 7, 9e3));
                loads.add_force(BodyId{b}, {30, 20, -10}, {1, 2, 3});
            }
        });
        for (int i = 0; i < 60; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_LT(w.stats().momentum_residual, 1e-10) << "form " << static_cast<int>(form);
            ASSERT_LT(w.stats().constraint_residual, 1e-10);
            // One factorisation and its refinement: matrix and residual agree.
            ASSERT_LE(w.stats().refinements, 1);
        }
    }
}

TEST(Loads, FormsOfTheEquationsAgree) {
    std::vector<Vec6> v[2];
    for (const bool saddle : {false, true}) {
        Recipe r = chains(5, 3, 16);
        r.world.form = saddle ? Form::saddle : Form::condensed;
        World w = r.make();
        act(w, "water", [&](Acting&, Prestep& now, Loads& loads) {
            for (int b = 1; b < now.world.body_count(); b += 2)
                loads.add_mass(BodyId{b}, coupled(static_cast<unsigned>(b), 40.0));
        });
        for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
        for (int b = 1; b < w.body_count(); ++b) v[saddle ? 1 : 0].push_back(motion(w, BodyId{b}));
    }
    // Ten steps of rounding of velocities of some m/s.
    for (std::size_t b = 0; b < v[0].size(); ++b) EXPECT_LT((v[0][b] - v[1][b]).norm(), 1e-7);
}

/// A spring given as force and stiffness equals the spring of an interaction, to rounding.
TEST(Loads, ASpringIsThatOfAnInteraction) {
    const double k = 4e3, start = 0.3;
    World loaded({.gravity = Vec3::Zero()}), bound({.gravity = Vec3::Zero()});
    for (World* w : {&loaded, &bound}) w->add_body(floating({0, 0, start}, 10.0, {1, 1, 1}));
    act(loaded, "spring", [&](Acting&, Prestep& now, Loads& loads) {
        Mat3 stiff = Mat3::Zero();
        stiff(2, 2) = k;
        loads.add_stiffness(BodyId{0}, stiff);
        loads.add_force(BodyId{0}, {0, 0, -k * now.world.pose(BodyId{0}).position.z()});
    });
    InteractionDef d = between(InteractionKind::Hydrostatic, {BodyId{0}});
    d.set("heave_stiffness", k).set("roll_stiffness", 1.0).set("pitch_stiffness", 1.0);
    bound.add_interaction(d.set("rest_height", 0.0));
    for (int i = 0; i < 600; ++i) {
        ASSERT_EQ(loaded.step(), Status::ok);
        ASSERT_EQ(bound.step(), Status::ok);
        // 600 steps of rounding of 6 m/s; both start with the acceleration of the force.
        ASSERT_NEAR(motion(loaded, BodyId{0})[2], motion(bound, BodyId{0})[2], 1e-10) << i;
    }
}

/// Solve m ẍ + c ẋ + k x = 0 from x₀ at rest.
double damped(double m, double c, double k, double x0, double t) {
    const double g = 0.5 * c / m, w = std::sqrt(k / m - g * g);
    return x0 * std::exp(-g * t) * (std::cos(w * t) + g / w * std::sin(w * t));
}

TEST(Loads, ASpringWithDamperIsOfSecondOrder) {
    const double m = 2.0, c = 3.0, k = 80.0, x0 = 0.5;
    double error[3];
    for (int level = 0; level < 3; ++level) {
        World w({.step = 1.0 / (60 << level), .gravity = Vec3::Zero()});
        BodyDef slide;
        slide.kind = BodyKind::scalar;
        slide.position = {x0, 0, 0};
        slide.mass = m - 0.7;
        w.add_body(slide);
        act(w, "damper", [&](Acting&, Prestep& now, Loads& loads) {
            using One = Eigen::Matrix<double, 1, 1>;
            loads.add_mass(BodyId{0}, One(0.7));
            loads.add_damping(BodyId{0}, One(c));
            loads.add_stiffness(BodyId{0}, One(k));
            loads.add_force(BodyId{0}, {-k * now.world.pose(BodyId{0}).position.x(), 0, 0});
        });
        double worst = 0.0;
        for (int i = 0; i < 120 << level; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            worst = std::max(
                worst, std::abs(w.pose(BodyId{0}).position.x() - damped(m, c, k, x0, w.time())));
        }
        error[level] = worst;
    }
    const double first = std::log2(error[0] / error[1]), second = std::log2(error[1] / error[2]);
    std::printf("errors %.3g %.3g %.3g m, orders %.3f %.3f\n", error[0], error[1], error[2], first,
                second);
    // Order 2, except for the next term at these steps.
    EXPECT_NEAR(first, 2.0, 0.1);
    EXPECT_NEAR(second, 2.0, 0.1);
}

/// With θ of the whole mass, including added mass, a damper alone is exact for any step.
TEST(Loads, ADamperAloneIsExactAtAnyStep) {
    World w({.step = 0.1, .gravity = Vec3::Zero(), .staggered_start = false});
    BodyDef slide;
    slide.kind = BodyKind::scalar;
    slide.mass = 1.0;
    slide.velocity = {1, 0, 0};
    w.add_body(slide);
    act(w, "damper", [&](Acting&, Prestep&, Loads& loads) {
        using One = Eigen::Matrix<double, 1, 1>;
        loads.add_mass(BodyId{0}, One(3.0));
        loads.add_damping(BodyId{0}, One(100.0));
    });
    for (int i = 1; i <= 5; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_NEAR(w.velocity(BodyId{0}).linear.x(), std::exp(-100.0 / 4.0 * 0.1 * i), 1e-15);
    }
}

/// Return the unexplained energy of the account [J].
double left(const Energy& a, const Energy& b) {
    return b.mechanical() - a.mechanical() - (b.applied - a.applied) - (b.system - a.system) +
           (b.dissipated - a.dissipated) + (b.damped - a.damped);
}

/// A hull coupled in sway and roll with all three matrices, of which the added mass changes, under
/// an oscillating force. T + ½ vᵀA v less the work of systems and forces is constant to rounding.
TEST(Loads, EnergyClosesOverAThousandSteps) {
    World w;
    BodyDef def = floating({0, 0, 0}, 2.0, {3, 4, 5});
    def.gravity = true;
    const BodyId hull = w.add_body(def);
    w.set_force(hull, {0, 0.4, 0}, {0.1, 0, 0});
    act(w, "water", [&](Acting&, Prestep& now, Loads& loads) {
        const double t = now.time;
        loads.add_mass(hull, sway_roll(5.0 + std::sin(0.7 * t), 4.0, 3.0));
        loads.add_damping(hull, sway_roll(0.5, 0.4, 0.1));
        loads.add_stiffness(hull, sway_roll(20.0, 9.0, -2.0));
        const Pose p = now.world.pose(hull);
        const double roll = 2.0 * std::atan2(p.orientation.x(), p.orientation.w());
        loads.add_force(hull,
                        {0, 8.0 * std::cos(t) - 20.0 * p.position.y() + 2.0 * roll, 2.0 * 9.81},
                        {-9.0 * roll + 2.0 * p.position.y(), 0, 0});
    });
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    double worst = 0.0, most = 0.0;
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const Energy e = w.energy();
        worst = std::max(worst, std::abs(left(start, e)));
        most = std::max({most, e.mechanical(), std::abs(e.system)});
    }
    std::printf("energy: %.3g J open of %.3g J\n", worst, most);
    EXPECT_GT(most, 1.0);
    EXPECT_LT(worst, 1e-10 * most);
    EXPECT_GT(w.energy().added, 0.0);
    EXPECT_GT(w.energy().dissipated, 0.1);
    // Monitors use the explained energy of the account.
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

/// Removing added mass removes its energy, which the account contains.
TEST(Loads, RemovedAddedMassTakesItsEnergy) {
    World w({.gravity = Vec3::Zero()});
    BodyDef def = floating({0, 0, 0}, 2.0, {3, 4, 5});
    def.velocity = {3, 0, 0};
    const BodyId hull = w.add_body(def);
    Acting& water = act(w, "water", [&](Acting&, Prestep&, Loads& loads) {
        loads.add_mass(hull, Mat3(Mat3::Identity() * 6.0));
    });
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    EXPECT_NEAR(start.added, 0.5 * 6.0 * 9.0, 1e-12);
    const std::unique_ptr<System> gone = w.remove_system(water);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.energy().added, 0.0);
    EXPECT_NEAR(w.energy().system - start.system, -27.0, 1e-12);
    EXPECT_NEAR(left(start, w.energy()), 0.0, 1e-12);
    EXPECT_EQ(w.velocity(hull).linear.x(), 3.0);
}

/// A box slides under a force: (m + A) v̇ = F − μ m g. Added mass coupled to rolling does not tip
/// it, but is part of the matrix of each Newton iteration.
TEST(Loads, ALoadedBodySlidesAsCoulombSays) {
    World w;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    w.add_body(ground);
    BodyDef box = floating({0, 0, 0.5}, 10.0, {2, 2, 2});
    box.gravity = true;
    w.add_body(box);
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    plane.body = BodyId{0};
    w.add_shape(plane);
    ShapeDef cube;
    cube.kind = ShapeKind::box;
    cube.body = BodyId{1};
    cube.half_size = {1.0, 1.0, 0.5};
    w.add_shape(cube);
    Mat6 a = Mat6::Identity() * 15.0;
    a(0, 4) = a(4, 0) = 4.0;
    act(w, "water", [&](Acting&, Prestep&, Loads& loads) {
        loads.add_mass(BodyId{1}, a);
        loads.add_force(BodyId{1}, {90, 0, 0});
    });
    const double friction = w.material_def(MaterialId{0}).friction;
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    const double before = w.velocity(BodyId{1}).linear.x();
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_LT(w.stats().natural_map, 1e-6);
        ASSERT_LT(w.stats().momentum_residual, 1e-10);
    }
    const double rate = (90.0 - friction * 10.0 * 9.81) / 25.0;
    ASSERT_GT(rate, 0.0);
    // Contacts satisfy their law within 1e-6 of their impulses.
    EXPECT_NEAR(w.velocity(BodyId{1}).linear.x() - before, rate, 1e-4);
}

}  // namespace
}  // namespace hawser::test
