// SPDX-License-Identifier: Apache-2.0
// Verification of system loads by separate code: momentum and energy of scenes with systems.
#include <hawser/scene.h>

#include "systems/acting.h"
#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace hawser {
namespace {

/// Add water to every third moving body: coupled added mass, damping, a spring to its present
/// position, and an oscillating force.
void add_water(World& w, double scale) {
    test::act(w, "water", [scale](test::Acting&, Prestep& now, Loads& loads) {
        for (int b = 0; b < now.world.body_count(); b += 3) {
            const BodyDef& def = now.world.body_def(BodyId{b});
            const double m = scale * def.mass;
            const auto seed = static_cast<unsigned>(b);
            loads.add_mass(BodyId{b}, test::coupled(seed, m));
            loads.add_damping(BodyId{b}, test::coupled(seed + 1, 0.5 * m));
            loads.add_stiffness(BodyId{b}, test::coupled(seed + 2, 2.0 * m));
            loads.add_force(BodyId{b}, {m * std::sin(now.time), 0.5 * m, 0}, {0, 0.01 * m, 0});
        }
    });
}

TEST(LoadsVerified, ScenesWithWaterHoldByIndependentCode) {
    for (const char* name :
         {"belt", "heavy_hook", "moored_barge", "mooring_seabed", "tow_zigzag"}) {
        scene::Scene scene = scene::load_file(std::string("scenes/") + name + ".json");
        add_water(scene.world, 0.3);
        verify::Verifier verifier(scene.world);
        for (int i = 0; i < 60; ++i) {
            verifier.before_step(scene.world);
            ASSERT_EQ(scene.world.step(), Status::ok) << name;
            ASSERT_EQ(verifier.after_step(scene.world), "") << name << ", step " << i;
        }
        // The loads are relevant compared with the scale of the residual, 1e-9 of gravity's
        // impulse.
        double pushed = 0.0, weight = 0.0;
        for (const LoadView& load : scene.world.loads()) {
            pushed += std::abs(load.force[0]);
            weight += 9.81 * scene.world.body_def(load.body).mass;
        }
        EXPECT_GT(pushed, 1e-3 * weight) << name;
        EXPECT_LT(verifier.result().momentum, 1e-9) << name;
        EXPECT_GT(verifier.result().covered_bodies, verifier.result().moving_bodies / 2) << name;
        std::printf("%-16s momentum %.2g\n", name, verifier.result().momentum);
    }
}

/// A body at rest pushed up by more than its weight, like a hull that starts too deep.
TEST(LoadsVerified, AStartThatIsPushedUpMakesNoEnergy) {
    // Velocities start half a step before the poses, at a position higher by a h²/4: 10 cm at 0.2
    // s, for which the push has done the work.
    for (const bool by_system : {false, true})
        for (const double step : {0.2, 0.05, 1.0 / 60.0}) {
            World w(WorldDef{.step = step});
            const BodyId hull = w.add_body({.mass = 1e6, .inertia = 1e8 * Mat3::Identity()});
            const Vec3 push(0.0, 0.0, 2.0 * 9.81e6);
            if (by_system)
                test::act(w, "water", [push](test::Acting&, Prestep&, Loads& loads) {
                    loads.add_force(BodyId{0}, push, Vec3::Zero());
                });
            else
                w.set_force(hull, push, Vec3::Zero());
            verify::Verifier verifier(w);
            for (int i = 0; i < 40; ++i) {
                verifier.before_step(w);
                ASSERT_EQ(w.step(), Status::ok) << step << " step " << i;
                ASSERT_EQ(verifier.after_step(w), "") << step << " step " << i;
            }
            EXPECT_EQ(w.verdict().grade, Grade::good) << step << " by system: " << by_system;
            // v = a t at the half step before, exact in this scheme.
            EXPECT_NEAR(w.velocity(hull).linear.z(), 9.81 * 39.5 * step, 1e-9);
        }
}

}  // namespace
}  // namespace hawser
