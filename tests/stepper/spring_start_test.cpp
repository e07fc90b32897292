// SPDX-License-Identifier: Apache-2.0
/// Springs much too stiff for the step start with the energy of the bodies (step/stagger.cpp).
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kMass = 2.0, kSpeed = 3.0;

/// Make a mass on an undamped spring at its rest length, which it stretches at 3 m/s.
World pulled(double stiffness) {
    World w({.step = 1.0 / 60.0, .gravity = {0, 0, 0}});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId lump = w.add_body({.kind = BodyKind::rigid,
                                    .position = {1, 0, 0},
                                    .velocity = {kSpeed, 0, 0},
                                    .mass = kMass,
                                    .inertia = Vec3(1, 1, 1).asDiagonal()});
    InteractionDef spring{.kind = InteractionKind::Distance, .body = {ground, lump}};
    spring.set("length", 1.0);
    spring.compliance[0] = 1.0 / stiffness;
    spring.damping_time[0] = 0.0;
    w.add_interaction(spring);
    return w;
}

/// (hω/2)² of 3e-5, 0.035, 35 and 3.5e4. If the step resolves the oscillation, the start is of
/// second order; otherwise the invariant of the scheme is the energy of the start.
TEST(SpringStart, MakesNoEnergy) {
    const double given = 0.5 * kMass * kSpeed * kSpeed;
    for (const double stiffness : {1.0, 1e3, 1e6, 1e9}) {
        World w = pulled(stiffness);
        double most = 0.0, least = HUGE_VAL;
        for (int i = 0; i < 200; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            const double energy = w.energy().mechanical();
            most = std::max(most, energy);
            least = std::min(least, energy);
        }
        const double z = stiffness / (4.0 * 3600.0 * kMass);
        // The plain start adds z of it; the other one is exact for a spring alone.
        EXPECT_LE(most, given * (z < 0.25 ? 1.0 + 1.01 * z : 1.0 + 1e-9)) << stiffness;
        EXPECT_GE(least, given * (1.0 - 1e-9)) << stiffness;
    }
}

}  // namespace
}  // namespace hawser::test
