// SPDX-License-Identifier: Apache-2.0
/// Condensed, saddle and automatic form are pivot orders of one matrix and give equal v₊.
#include "support/recipe.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

/// Return the largest difference of the velocities over the largest velocity.
double difference(const World& a, const World& b) {
    double most = 0.0, separation = 0.0;
    for (int i = 0; i < a.body_count(); ++i) {
        const Twist p = a.velocity(BodyId{i}), q = b.velocity(BodyId{i});
        most = std::max({most, p.linear.cwiseAbs().maxCoeff(), p.angular.cwiseAbs().maxCoeff()});
        separation = std::max({separation, (p.linear - q.linear).cwiseAbs().maxCoeff(),
                               (p.angular - q.angular).cwiseAbs().maxCoeff()});
    }
    return separation / most;
}

/// Expect equal velocities of the three forms after each step.
/// @param mass_ratio  Largest force per mass at a joint over that of the lightest body there:
/// rounding of the force moves this body by so much more.
void expect_same(const Recipe& recipe, int steps, double mass_ratio = 100.0) {
    constexpr double kRounding = 1e-14;  // of the force, after the number of joints in these scenes
    WorldDef def = recipe.world;
    def.solution_tolerance = 1e-13;  // compares the forms, not the end of refinement
    def.form = Form::automatic;
    World automatic = recipe.make(def);
    def.form = Form::saddle;
    World saddle = recipe.make(def);
    def.form = Form::condensed;
    World condensed = recipe.make(def);
    for (int i = 0; i < steps; ++i) {
        // Restore the same state before each step: compare one step without effects of earlier
        // differences.
        const auto state = automatic.state().save();
        saddle.state().restore(state);
        condensed.state().restore(state);
        ASSERT_EQ(automatic.step(), Status::ok);
        ASSERT_EQ(saddle.step(), Status::ok);
        ASSERT_EQ(condensed.step(), Status::ok);
        EXPECT_LE(difference(saddle, automatic), kRounding * mass_ratio) << "automatic, step " << i;
        EXPECT_LE(difference(saddle, condensed), kRounding * mass_ratio) << "condensed, step " << i;
    }
}

TEST(Forms, AgreeOnMixedScenes) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        expect_same(mixed(seed, 3 + static_cast<int>(seed)), 8);
    }
}

TEST(Forms, AgreeOnAChainWithAHeavyEnd) {
    Recipe r = link_chain(20);
    BodyDef& hook = r.bodies.back();
    hook.mass *= 1e4;
    hook.inertia *= 1e4;
    expect_same(r, 5, 1e4);
}

TEST(Forms, AgreeOnAWire) { expect_same(wire(30), 10); }

TEST(Forms, AgreeOnRedundantRows) {
    // A closed loop: four hinges of a plane four-bar linkage, with three redundant rows.
    Recipe r;
    const BodyId g = r.ground();
    const Vec3 corner[4] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    BodyId link[3];
    for (int i = 0; i < 3; ++i)
        link[i] = r.rigid(0.5 * (corner[i] + corner[i + 1]), Quat::Identity(), 2.0, {.2, .2, .2});
    const Quat axis(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));  // z along −y
    const BodyId chain[5] = {g, link[0], link[1], link[2], g};
    for (int i = 0; i < 4; ++i)
        r.add(r.at(InteractionKind::Hinge, {chain[i], chain[i + 1]}, corner[i], axis));
    r.bodies[1].velocity = {0.5, 0, 0};
    expect_same(r, 5);
}

}  // namespace
}  // namespace hawser::test
