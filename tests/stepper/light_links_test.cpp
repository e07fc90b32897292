// SPDX-License-Identifier: Apache-2.0
/// Closed loops that pass singular poses, and light bodies that joints hold between heavy ones
/// (docs/theory/joints.md).
#include "validate/light_links.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

/// The energy of the windows is known: no force but gravity does work.
TEST(SingularLoops, WindowsKeepTheirEnergy) {
    Random random(first_seed(1));
    for (int i = by_tier(8, 100, 1000); i > 0; --i) {
        const int windows = random.integer(1, 4);
        const double step = 1.0 / random.uniform(55.0, 240.0);
        SCOPED_TRACE(::testing::Message() << windows << " windows, " << step << " s");
        World w = validate::make_windows(step, windows);
        ASSERT_EQ(w.step(), Status::ok);
        const double start = w.energy().mechanical();
        double off = 0.0, most = 0.0;
        for (long k = std::lround(5.0 / step); k > 1; --k) {
            ASSERT_EQ(w.step(), Status::ok);
            off = std::max(off, std::abs(w.energy().mechanical() - start));
            most = std::max(most, w.energy().kinetic);
        }
        // Without the raised floors: up to all of it.
        EXPECT_LE(off, 0.02 * most);
        EXPECT_EQ(w.verdict().grade, Grade::good);
    }
}

/// A pendulum keeps its energy and amplitude for any mass of its rod. `hawser validate light_links`
/// compares its period with the closed form.
TEST(LightLinks, APendulumKeepsItsAmplitude) {
    Random random(first_seed(2));
    for (int i = by_tier(8, 100, 1000); i > 0; --i) {
        const double step = 1.0 / random.uniform(60.0, 240.0);
        const double ratio = std::pow(10.0, random.uniform(1.0, 8.0));
        const bool welded = random.chance(0.5);
        SCOPED_TRACE(::testing::Message()
                     << "ratio " << ratio << ", " << step << " s, welded " << welded);
        validate::LightPendulum p = validate::make_light_pendulum(step, ratio, welded);
        ASSERT_EQ(p.world.step(), Status::ok);
        const double start = p.world.energy().mechanical();
        double kinetic = 0.0, off = 0.0, last = 0.0;
        const long steps = std::lround(12.0 / step);
        for (long k = 2; k <= steps; ++k) {
            ASSERT_EQ(p.world.step(), Status::ok);
            const Energy e = p.world.energy();
            kinetic = std::max(kinetic, e.kinetic);
            off = std::max(off, std::abs(e.mechanical() - start));
            if (k > steps - std::lround(2.2 / step)) last = std::max(last, std::abs(p.angle()));
        }
        EXPECT_LE(off, 1e-2 * kinetic);
        EXPECT_NEAR(last, validate::LightPendulum::kAngle, 5e-3);
        EXPECT_EQ(p.world.verdict().grade, Grade::good);
    }
}

/// A rod that hangs freely on another one is not held: its motion is damped, and a loss of energy
/// is reported.
TEST(LightLinks, ALossOfEnergyIsReported) {
    World w(WorldDef{});
    BodyId last = w.add_body({.kind = BodyKind::fixed});
    Vec3 at = Vec3::Zero();
    // Ten rods of a gram and a bob of 10 t, released from 40 degrees.
    const Vec3 along = 0.1 * Vec3(std::sin(0.7), 0, -std::cos(0.7));
    const Quat turn(Eigen::AngleAxisd(-0.7, Vec3::UnitY()));
    const auto add = [&](BodyDef d) {
        d.orientation = turn;
        const BodyId b = w.add_body(d);
        w.add(HingeDef{.a = last, .b = b, .point = at, .axis = {0, 1, 0}});
        return b;
    };
    for (int i = 0; i < 10; ++i) {
        last = add(validate::solid_box(at + 0.5 * along, 1e-3, {0.005, 0.005, 0.05}));
        at += along;
    }
    const BodyId bob = add(validate::solid_box(at, 1e4, {0.2, 0.2, 0.2}));
    ASSERT_EQ(w.step(), Status::ok);
    const double start = w.energy().mechanical();
    double kinetic = 0.0;
    Status status = Status::ok;
    for (int k = 0; k < 1200 && status == Status::ok; ++k) {
        status = w.step();
        kinetic = std::max(kinetic, w.energy().kinetic);
    }
    const double lost = start - w.energy().mechanical();
    EXPECT_TRUE(lost < 0.3 * kinetic || status != Status::ok || w.verdict().grade != Grade::good)
        << lost << " of " << kinetic << " J, bob " << bob.index;
}

}  // namespace
}  // namespace hawser::test
