// SPDX-License-Identifier: Apache-2.0
/// Scenes without a motor, whose mechanical energy can only decrease. None gains energy, and none
/// ends as good with an unexplained change. Compared are sums of kinetic, gravity and elastic
/// energy, not the accounts that explain them.
#include <hawser/session.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::test {

namespace {

/// End of a run, and changes of its mechanical energy.
struct EnergyRun {
    Grade grade = Grade::good;
    double driven = 0.0;  ///< Largest magnitude in any step [J].
    double rise = 0.0;    ///< Largest rise that lasted for half a second [J].
    double exchanged =
        0.0;  ///< Half the changes of kinetic and gravity energy, and of kinetic energy [J].
    bool refused = false;
};

EnergyRun run_passive(const std::string& name, bool verify) {
    Session session({.scene = "tests/data/energy/" + name + ".json", .verify = verify});
    const World& w = session.world();
    const double h = w.settings().step, end = session.scene().duration;
    EnergyRun out;
    std::vector<double> sums;
    double kinetic = 0.0, gravity = 0.0, moved = 0.0;
    while (session.time() < end - 1e-9) {
        if (session.step() != Status::ok) {
            out.refused = true;
            break;
        }
        const Energy e = w.energy();
        out.driven = std::max(out.driven, std::abs(e.driven));
        // In these scenes only applied forces add energy.
        sums.push_back(e.mechanical() - e.applied - e.system);
        if (sums.size() > 1)
            moved += 0.5 * (std::abs(e.kinetic - kinetic) + std::abs(e.gravity - gravity));
        kinetic = e.kinetic;
        gravity = e.gravity;
        out.exchanged = std::max(out.exchanged, kinetic + moved);
    }
    const auto window = static_cast<std::size_t>(0.5 / h);
    double least = sums.empty() ? 0.0 : sums.front();
    for (std::size_t i = 0; i + window < sums.size(); ++i) {
        least = std::min(least, sums[i]);
        const auto from = sums.begin() + static_cast<std::ptrdiff_t>(i);
        out.rise = std::max(
            out.rise, *std::min_element(from, from + static_cast<std::ptrdiff_t>(window)) - least);
    }
    out.grade = w.verdict().grade;
    return out;
}

}  // namespace

TEST(EnergyAccounts, WhatHasNoMotorDrivesNothing) {
    for (const char* name : {"passive_guide_20hz", "passive_guide_60hz", "passive_hanging_30hz",
                             "passive_post_20hz", "passive_post_60hz"})
        EXPECT_EQ(run_passive(name, false).driven, 0.0) << name;
}

TEST(EnergyAccounts, WhatMakesEnergyIsNotGood) {
    for (const char* name : {"passive_guide_20hz", "passive_guide_60hz", "passive_hanging_20hz",
                             "passive_hanging_30hz", "passive_post_20hz", "passive_post_30hz",
                             "passive_post_60hz", "fourbar_compliant", "bennett_compliant"}) {
        const EnergyRun run = run_passive(name, false);
        const bool made = run.rise > 0.2 * run.exchanged;
        EXPECT_FALSE(made && !run.refused && run.grade == Grade::good)
            << name << ": " << run.rise << " J of " << run.exchanged << " J";
    }
    // Without a stop, the mechanisms gain 25 to 557 J and 2 to 431 J.
    for (const char* name : {"fourbar_compliant", "bennett_compliant"}) {
        const EnergyRun run = run_passive(name, false);
        EXPECT_TRUE(run.refused || run.rise < 0.02 * run.exchanged) << name;
    }
}

TEST(EnergyAccounts, WhatLosesEnergyInJointsIsRefused) {
    // A boom that rotates freely on a platform keeps its energy: it loses 0 of 3.5 kJ. It lost 44 %
    // when both hinges had 1e-12 m/N.
    for (const bool verify : {false, true}) {
        Session session(
            {.scene = "tests/data/energy/slew_two_hinges_c1e-12.json", .verify = verify});
        (void)session.step();
        const double start = session.world().energy().mechanical();
        double kinetic = 0.0;
        Status status = Status::ok;
        while (status == Status::ok && session.time() < 2.0 - 1e-9) {
            status = session.step();
            kinetic = std::max(kinetic, session.world().energy().kinetic);
        }
        const double lost = start - session.world().energy().mechanical();
        if (lost < 0.1 * kinetic && status == Status::ok) continue;  // correct
        EXPECT_NE(session.world().verdict().grade, Grade::good);
        if (verify) {
            EXPECT_EQ(status, Status::diverged);
        }
    }
}

}  // namespace hawser::test
