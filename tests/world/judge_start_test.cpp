// SPDX-License-Identifier: Apache-2.0
/// Bodies that start at rest, or move, under constant forces create no energy: the monitors'
/// account starts half a step after the velocities.
#include <hawser/hawser.h>
#include <hawser/limits.h>

#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace hawser {
namespace {

struct Start {
    double step, mass, force, torque, speed;
    bool gravity, spring, motor;
};

Start random_start(std::mt19937& dice) {
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    const auto coin = [&] { return real(dice) > 0.0; };
    Start s{};
    s.step = std::pow(10.0, -1.5 + 0.8 * real(dice));  // 1/200 to 0.2 s
    s.mass = std::pow(10.0, 2.0 + 2.0 * real(dice));
    s.force = 20.0 * s.mass * real(dice);
    s.torque = s.mass * real(dice);
    s.speed = coin() ? 0.0 : real(dice);
    s.gravity = coin();
    s.spring = coin();
    s.motor = coin();
    return s;
}

World make(const Start& s) {
    World w({.step = s.step, .on_diverged = OnDiverged::warn});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId body = w.add_body({.position = {0, 0, -2},
                                    .velocity = {0, 0, s.speed},
                                    .mass = s.mass,
                                    .inertia = Mat3::Identity() * s.mass,
                                    .force = {0.3 * s.force, 0, s.force},
                                    .torque = {0, s.torque, 0},
                                    .gravity = s.gravity});
    if (s.spring) {  // resolved, and preloaded by a tenth of a metre
        const double stiffness = 4.0 * s.mass;
        InteractionDef d{.kind = InteractionKind::Distance, .body = {ground, body}};
        d.compliance[0] = 1.0 / stiffness;
        d.params[0] = 1.9;
        w.add_interaction(d);
    }
    if (s.motor) {  // always at its full torque, which is constant
        const BodyId wheel = w.add_body({.position = {5, 0, 0},
                                         .mass = s.mass,
                                         .inertia = Mat3::Identity() * s.mass,
                                         .gravity = false});
        InteractionDef hinge{.kind = InteractionKind::Hinge, .body = {ground, wheel}};
        hinge.point[0] = {5, 0, 0};
        w.add_interaction(hinge);
        InteractionDef motor{.kind = InteractionKind::HingeMotor, .body = {ground, wheel}};
        motor.point[0] = {5, 0, 0};
        motor.set("speed", 1e4);
        motor.set("force_max", 3.0 * s.mass);
        w.add_interaction(motor);
    }
    return w;
}

TEST(MonitorStart, ForcesThatStayMakeNoEnergy) {
    std::mt19937 dice(test::first_seed(20261127));
    const int starts = test::by_tier(300, 1000, 10'000);
    double most = 0.0;
    for (int i = 0; i < starts; ++i) {
        const Start s = random_start(dice);
        World w = make(s);
        // The first checks: later ones compare with more exchanged energy. Rotations are not
        // monitored.
        for (int k = 0; k < 4; ++k) ASSERT_EQ(w.step(), Status::ok) << i;
        const Finding energy = w.verdict().of(Judge::energy);
        most = std::max(most, energy.doubtful);
        EXPECT_LE(energy.doubtful, 0.5)
            << i << ": step " << s.step << ", mass " << s.mass << ", force " << s.force
            << ", speed " << s.speed << (s.gravity ? ", gravity" : "")
            << (s.spring ? ", spring" : "") << (s.motor ? ", motor" : "");
    }
    RecordProperty("largest share of what is doubtful", std::to_string(most));
}

}  // namespace
}  // namespace hawser
