// SPDX-License-Identifier: Apache-2.0
/// Start of the solution of a step, and conditions of its refinement.
#include "stepper/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser {
namespace {

struct Seen {
    double residual = 0.0;  ///< Largest residual from the tenth step on.
    int refined = 0;        ///< Number of refined steps from the 70th on.
};

Seen run(const char* file, const std::vector<std::string>& set) {
    scene::Options options;
    options.set = set;
    scene::Scene s = scene::load_file("scenes/" + std::string(file) + ".json", options);
    Seen seen;
    for (int k = 0; k < 200; ++k) {
        EXPECT_EQ(s.world.step(), Status::ok);
        if (k >= 10) seen.residual = std::max(seen.residual, s.world.stats().momentum_residual);
        if (k >= 70) seen.refined += s.world.stats().refinements > 0 ? 1 : 0;
    }
    return seen;
}

/// Chains of rigid links are condensed, which leaves 1e-7 of a solution that starts at rest
/// (heavy_hook) and 2e-9 (mooring). A start at the expected velocities leaves a thousandth of that.
TEST(SolutionStart, LeavesLittleToRefine) {
    EXPECT_LE(run("heavy_hook", {"settings.refinements=0"}).residual, 1e-9);
    EXPECT_LE(run("mooring", {"settings.refinements=0"}).residual, 1e-10);
}

TEST(SolutionStart, IsRefinedWhereTheResidualAsks) {
    EXPECT_EQ(run("mooring", {}).refined, 0);
    const Seen usual = run("heavy_hook", {});  // just released
    EXPECT_LE(usual.residual, 1e-10);
    EXPECT_GT(usual.refined, 0);
    EXPECT_LT(usual.refined, 130);
    const Seen strict = run("heavy_hook", {"settings.solution_tolerance=1e-12"});
    EXPECT_LE(strict.residual, 1e-12);
    EXPECT_EQ(strict.refined, 130);
}

}  // namespace
}  // namespace hawser
