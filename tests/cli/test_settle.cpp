// SPDX-License-Identifier: Apache-2.0
/// `hawser settle` with systems: water, winches and cranes remain; parts that never come to rest
/// are left out.
#include "program.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json read_json(const fs::path& file) { return json::parse(read_text(file)); }

/// Write a scene of the library that starts from a state in still water, at the water level of its
/// start.
void write_from_state(const fs::path& file, const std::string& scene, const std::string& state) {
    json out = read_json("scenes/" + scene + ".json");
    out["state"] = {{"file", state}};
    if (out.contains("sea")) {
        json& sea = out["sea"];
        if (sea.contains("wind")) sea["wind"]["gusts"] = false;
        if (sea.contains("level")) sea["level"] = json::array({sea["level"][0]});
        out["timeline"] = json::array({{{"at", 0}, {"set", {{"sea.waves", 0}}}}});
    }
    write_text(file, out.dump());
}

/// Return the largest displacement and rotation of a body in a run from rest [m, deg].
std::pair<double, double> drift(const fs::path& file, const char* seconds, const char* body) {
    const fs::path summary = file.parent_path() / "drift.json";
    const Outcome run =
        run_program({"run", file, "--duration", seconds, "--quiet", "--summary", summary});
    EXPECT_EQ(run.code, 0) << run.err;
    const json motion = read_json(summary)["motions"][body];
    return {motion["displacement_max"].get<double>(), motion["tilt_max_deg"].get<double>()};
}

/// Archimedes: a box of 246 t and 4 m with 100 m² of waterplane has a draught of 2.4 m in water of
/// 1,025 kg/m³.
TEST(Settle, ABoxFloatsInStillWater) {
    const fs::path state = test_folder() / "box.settled.json";
    const Outcome settled = run_program({"settle", "scenes/floating_box.json", "--set",
                                         "bodies.box.mass=246000", "-o", state, "--quiet"});
    ASSERT_EQ(settled.code, 0) << settled.err;
    const json box = read_json(state)["bodies"]["box"];
    // Its speed is below 1e-5 m/s, its heave has a period of about 4 s.
    EXPECT_NEAR(box["p"][2].get<double>(), -0.4, 1e-5);
    EXPECT_NEAR(box["q"][0].get<double>(), 1.0, 1e-9);
}

/// The buoy rests where mean current and wind are balanced, and stays there once nothing drags.
TEST(Settle, ABuoyLiesInCurrentAndWindAndStays) {
    const fs::path folder = test_folder();
    const Outcome settled =
        run_program({"settle", "scenes/buoy.json", "-o", folder / "buoy.settled.json", "--quiet"});
    ASSERT_EQ(settled.code, 0) << settled.err;
    const json buoy = read_json(folder / "buoy.settled.json")["bodies"]["buoy"];
    // The anchor is at x = 45 m and 49.5 m below. In still water 22.5 m of the 72 m of chain would
    // lie on the bottom, with the buoy above their end. The fully stretched chain reaches 52.3 m.
    // Current and wind act towards −x.
    EXPECT_LT(buoy["p"][0].get<double>(), 22.5 - 1.0);
    EXPECT_GT(buoy["p"][0].get<double>(), 45.0 - 52.3);
    EXPECT_NEAR(buoy["p"][1].get<double>(), 0.0, 1e-3);
    write_from_state(folder / "rest.json", "buoy", "buoy.settled.json");
    // At the tolerance of 1e-5 m/s it would move 1e-4 m in 10 s.
    EXPECT_LT(drift(folder / "rest.json", "10", "buoy").first, 1e-4);
}

/// Three hulls do not fall if there is no time to come to rest.
TEST(Settle, AnchorSeaKeepsItsWater) {
    const auto heights = [&](const char* seconds) {
        const fs::path state = test_folder() / "sea.settled.json";
        const Outcome settled = run_program(
            {"settle", "scenes/anchor_sea.json", "-o", state, "--max-time", seconds, "--quiet"});
        EXPECT_EQ(settled.code, 2);
        EXPECT_NE(settled.err.find("not settled after"), std::string::npos) << settled.err;
        std::vector<double> out;
        const json bodies = read_json(state)["bodies"];
        for (const char* hull : {"rig", "ahts1/hull", "ahts2/hull"})
            out.push_back(bodies[hull]["p"][2].get<double>());
        return out;
    };
    const std::vector<double> start = heights("0.02"), later = heights("2");
    // Free fall would be 20 m, and 2 m with the drag of the first stage. With all loads they start
    // within 0.2 m of their draught.
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(later[i], start[i], 0.3) << i;
}

/// A crane's hoist is held by its brake, and its load is at rest afterwards.
TEST(Settle, ACraneHoldsItsLoad) {
    const fs::path folder = test_folder();
    const Outcome settled = run_program(
        {"settle", "scenes/crane_knuckle.json", "-o", folder / "crane.settled.json", "--quiet"});
    ASSERT_EQ(settled.code, 0) << settled.err;
    write_from_state(folder / "rest.json", "crane_knuckle", "crane.settled.json");
    // The hook is a pendulum of about 20 m: at 1e-5 m/s it moves by 1.4e-5 m and tilts by 5e-5 deg.
    const auto [moved, tilted] = drift(folder / "rest.json", "5", "crane/hook");
    EXPECT_LT(moved, 2e-4);
    EXPECT_LT(tilted, 2e-4);
}

/// A state file contains only nodes of the scene: the message names the new nodes and the remedy.
TEST(Settle, ADrumThatPaysOutIsSaid) {
    const fs::path state = test_folder() / "modes.settled.json";
    const Outcome settled =
        run_program({"settle", "scenes/winch_modes.json", "-o", state, "--quiet"});
    EXPECT_EQ(settled.code, 2);
    EXPECT_NE(settled.err.find("the node slip_wire node 36 came"), std::string::npos)
        << settled.err;
    EXPECT_NE(settled.err.find("let its winches hold more"), std::string::npos);
}

}  // namespace
}  // namespace hawser::test
