// SPDX-License-Identifier: Apache-2.0
/// Degenerate input: each step ends with a status, and the state stays finite.
#include "support/degenerate/cases.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace hawser::test {
namespace {

/// Result of a method for a case.
struct Fate {
    int failed = 0, uncertified = 0;
    double worst_map = 0.0, fastest = 0.0;
};

void run_degenerate(const Degenerate& d, Nonsmooth method, int steps, Fate& fate) {
    WorldDef def = d.def;
    def.nonsmooth = method;
    Yard y(def);
    d.build(y);
    for (int step = 0; step < steps; ++step) {
        if (d.before_step) d.before_step(y.world, step);
        const Status status = y.world.step();
        ASSERT_EQ(not_finite(y.world), "") << "step " << step << ", " << to_string(status);
        fate.failed += status == Status::ok ? 0 : 1;
        const double map = y.world.stats().natural_map;
        fate.worst_map = std::max(fate.worst_map, map);
        fate.uncertified += map > def.contact_tolerance ? 1 : 0;
        fate.fastest = std::max(fate.fastest, fastest(y.world));
    }
    if (tier() == Tier::long_runs)
        std::printf("%-40s %d: failed %d, uncertified %d (%.1e), fastest %.3g m/s\n",
                    d.name.c_str(), static_cast<int>(method), fate.failed, fate.uncertified,
                    fate.worst_map, fate.fastest);
}

struct Group {
    const char* name;
    Cases (*cases)();
};
void PrintTo(const Group& g, std::ostream* out) { *out << g.name; }

class Degenerates : public testing::TestWithParam<Group> {};
INSTANTIATE_TEST_SUITE_P(
    Cases, Degenerates,
    testing::Values(Group{"coincident", coincident}, Group{"faces", faces}, Group{"ratios", ratios},
                    Group{"sizes", sizes}, Group{"features", features},
                    Group{"weightless", weightless}, Group{"frictions", frictions},
                    Group{"teleported", teleported}, Group{"fast", fast},
                    Group{"materials", materials}, Group{"steps_and_gravity", steps_and_gravity}),
    [](const auto& each) { return each.param.name; });

/// A few iterations solve the rotation's equation; far above h|ω| = 1 they do not converge.
TEST(Degenerate, SpinFarAboveTheStepGainsNoEnergy) {
    for (double spin = 1.0; spin <= 1e5; spin *= 10.0) {  // faster rotation is rejected
        WorldDef def{.on_diverged = OnDiverged::warn};
        def.gravity.setZero();
        Yard y(def);
        const BodyId b = y.body({0, 0, 0}, 1.0, {0.1, 0.3, 1.0});
        y.world.set_velocity(b, {{0, 0, 0}, spin * Vec3(1.0, 0.5, 0.2)});
        y.world.prepare();
        const double before = y.world.energy().mechanical();
        double most = 0.0;
        for (int step = 0; step < 300; ++step) {
            ASSERT_EQ(y.world.step(), Status::ok);
            most = std::max(most, y.world.energy().mechanical());
        }
        // Its solutions gain and lose energy: by a factor of 1.26 at h|ω| = 17.
        EXPECT_LE(most, 1.5 * before) << spin << " rad/s";
    }
}

TEST_P(Degenerates, EndWithAStatusAndAFiniteState) {
    for (const Degenerate& d : GetParam().cases()) {
        SCOPED_TRACE(d.name);
        Fate fate;
        run_degenerate(d, Nonsmooth::newton, d.steps, fate);
        EXPECT_LE(fate.fastest, d.fastest);
        if (kSanitized || HasFatalFailure()) continue;
        for (const Nonsmooth method :
             {Nonsmooth::pivoting, Nonsmooth::split, Nonsmooth::pgs, Nonsmooth::convex}) {
            Fate other;
            SCOPED_TRACE(static_cast<int>(method));
            run_degenerate(d, method, std::min(d.steps, 20), other);
        }
    }
}

}  // namespace
}  // namespace hawser::test
