// SPDX-License-Identifier: Apache-2.0
// scenes/tow_barge.json: an anchor handler of the library tows a barge in waves, current and wind,
// by fixed orders, under autopilot and under DP. Energy, separate verification, and the same bits
// for any threads, after a restore and in replay.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr const char* kTowScene = "scenes/tow_barge.json";

/// Return the mechanical energy less all explained parts [J].
double unexplained(const Energy& e) {
    return e.mechanical() - e.applied - e.driven - e.system - e.edited + e.dissipated + e.friction +
           e.contact + e.damped;
}

/// Control of the tow: orders of the scene's timeline, or a control file.
struct TowControl {
    const char* name;
    const char* file;
};

constexpr TowControl kFixedOrders{"fixed orders", ""};
constexpr TowControl kAutopilot{"autopilot", "scenes/tow_barge.autopilot.control.csv"};
constexpr TowControl kPositioning{"DP", "scenes/tow_barge.dp.control.csv"};

struct TowRun {
    std::uint64_t hash = 0, middle_hash = 0;
    std::vector<std::byte> middle;
    double residual = 0.0;  ///< Largest change of unexplained energy [J].
    double work = 0.0;      ///< Work of the main propellers on the ship, ahead and astern [J].
    double way = 0.0;       ///< Distance of the barge over ground [m].
    Grade grade = Grade::good;
};

/// Run the tow. @param record  Recording file, which also verifies each step; "": neither.
TowRun tow(const TowControl& control, double seconds, int threads, const std::string& record) {
    scene::Options options;
    options.threads = threads;
    Session session({.scene = kTowScene,
                     .options = options,
                     .control = control.file,
                     .record = record,
                     .verify = !record.empty()});
    const World& w = session.world();
    const BodyId barge = w.find_body("barge/hull");
    const Vec3 start = w.pose(barge).position;
    TowRun out;
    const auto steps = static_cast<int>(seconds * 60.0);
    double first = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Status status = session.step();
        if (status != Status::ok || session.objection() != "") {
            ADD_FAILURE() << to_string(status) << " at " << session.time() << " s; "
                          << session.objection();
            return out;
        }
        const Energy e = w.energy();
        if (i == 0) first = unexplained(e);
        out.residual = std::max(out.residual, std::abs(unexplained(e) - first));
        for (const char* side : {"ahts/ship.port_thrust", "ahts/ship.starboard_thrust"})
            out.work +=
                0.9 * std::abs(w.system_signal(side)) * w.system_signal("ahts/ship.speed") / 60.0;
        if (i == steps / 2) {
            out.middle = w.state().save();
            out.middle_hash = w.state().hash();
        }
    }
    out.hash = w.state().hash();
    out.way = (w.pose(barge).position - start).norm();
    out.grade = w.verdict().grade;
    session.finish();
    return out;
}

/// Tow once with verification and recording. Expect the energy, and the same bits with other
/// numbers of threads, from the middle in a new session, and in a replay on two threads.
void expect_tow(const TowControl& control, double seconds, const std::vector<int>& threads) {
    SCOPED_TRACE(control.name);
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("hawser_ship_tow_" + std::to_string(::getpid()) + ".hwr");
    const TowRun one = tow(control, seconds, 1, file.string());
    std::printf("%s: residual %.3g J of %.4g J, way %.1f m\n", control.name, one.residual, one.work,
                one.way);
    EXPECT_EQ(one.grade, Grade::good);
    EXPECT_GT(one.way, 0.5 * seconds);  // moves at more than 1 knot
    EXPECT_LE(one.residual, 1e-3 * one.work);
    for (const int n : threads)
        EXPECT_EQ(tow(control, seconds, n, "").hash, one.hash) << n << " threads";
    Session again({.scene = kTowScene, .state = one.middle, .control = control.file});
    EXPECT_EQ(again.world().state().hash(), one.middle_hash);
    while (again.world().step_count() < static_cast<std::int64_t>(seconds * 60.0))
        ASSERT_EQ(again.step(), Status::ok) << again.time();
    EXPECT_EQ(again.world().state().hash(), one.hash);
    (void)expect_repeats(record::Recording::open(file.string()), 2);
    std::filesystem::remove(file);
}

TEST(ShipTow, KeepsEnergyAndBits) {
    if (kSanitized) {
        (void)tow(kPositioning, 1.0, 2, "");
        return;
    }
    for (const TowControl& control : {kFixedOrders, kAutopilot, kPositioning})
        expect_tow(control, 4.0, {2, 4});
}

TEST(ShipTow, KeepsEnergyAndBitsForTenMinutesUnderAutopilot_long) {
    expect_tow(kAutopilot, 600.0, {2, 4, 8});
}

TEST(ShipTow, KeepsEnergyAndBitsForTenMinutesUnderDp_long) {
    expect_tow(kPositioning, 600.0, {2, 4, 8});
}

}  // namespace
}  // namespace hawser::test
