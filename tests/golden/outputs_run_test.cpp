// SPDX-License-Identifier: Apache-2.0
/// Reports, summaries and tables of `hawser run`, compared with those of an earlier commit
/// (CONTRIBUTING.md, "Golden files").
#include "golden/outputs.h"

#include <array>

namespace hawser::golden {
namespace {

/// A run whose report, summary and (if `every` is not empty) table are compared.
struct RunCase {
    const char* name;
    std::vector<std::string> arguments;
    std::string every{};  ///< Steps from one row of the table to the next.
};

void PrintTo(const RunCase& run, std::ostream* to) { *to << run.name; }

/// Values of the inputs of scenes/winch_modes.json.
constexpr const char* kWinches =
    "time,speed_winch.speed,tension_winch.tension,render_winch.mode,hold_winch.brake,"
    "slip_winch.mode,release_winch.mode\n"
    "0,0.1,60000,2,1,3,3\n0.4,0.3,90000,2,0.5,3,5\n0.8,-0.2,,1,0.1,4,5\n1.2,0,70000,0,1,0,3\n";

/// Operations of scenes/tow_payout.json.
constexpr const char* kOperations = R"([
  {"at": 0.2, "set": {"winch.mode": "speed", "winch.speed": 0.5}, "description": "pay out"},
  {"at": 0.6, "cut": "tow", "s": 150, "description": "the tow is cut"},
  {"at": 0.8, "detach": {"wire": "tow/2", "end": "last"}},
  {"at": 1.0, "set": {"winch.mode": "brake", "winch.brake": 0.5}}])";

const std::vector<RunCase> kRuns{
    {"cables", {"tow_zigzag", "--duration", "1.5"}, "30"},
    {"catenary", {"catenary", "--duration", "0.5"}, "30"},
    {"contact", {"arch", "--duration", "1"}, "20"},
    {"wedge", {"wedge", "--duration", "1", "--verify"}, "20"},
    {"rolling", {"rolling_resistance", "--duration", "0.5"}},
    {"bounce", {"bouncing_ball", "--duration", "1.5"}},
    {"winches", {"winch_modes", "--duration", "1.6", "--control", "$OUT/winches.csv"}, "60"},
    {"gypsy", {"chain_gypsy", "--duration", "0.5"}, "60"},
    {"crane",
     {"crane_knuckle", "--duration", "4", "--control", "scenes/crane_knuckle.control.csv"},
     "40"},
    {"timeline", {"crane_lattice", "--duration", "2"}},
    {"operations", {"tow_payout", "--duration", "1.5", "--control", "$OUT/operations.json"}, "20"},
    {"parting", {"wire_part", "--duration", "6.6"}},
    {"sea", {"buoy", "--duration", "4"}, "60"},
    {"hull", {"sphere_decay", "--duration", "1"}, "20"},
    {"friction", {"joint_friction", "--duration", "1"}, "60"},
    {"limits", {"joint_limits"}},
    {"motors", {"motor_limits", "--duration", "1"}},
    {"loop", {"bricard", "--duration", "0.3", "--form", "saddle"}},
    {"crank", {"slider_crank", "--duration", "0.3", "--form", "condensed"}},
    {"sleep", {"box_stack", "--sleep", "0.1", "--duration", "1.5"}},
    {"kinematic",
     {"cable_momentum", "--coupling", "kinematic", "--parts", "2", "--duration", "0.5"}},
    {"compliant", {"anchor_drag", "--coupling", "compliant", "--parts", "2", "--duration", "0.5"}},
    {"clique",
     {"cable_momentum", "--coupling", "compliant", "--parts", "3", "--predictor", "clique",
      "--duration", "0.3"}},
    {"split", {"incline", "--nonsmooth", "split", "--sweeps", "20", "--duration", "0.3"}},
    {"pgs", {"belt", "--nonsmooth", "pgs", "--duration", "0.3"}},
    {"convex", {"incline_slide", "--nonsmooth", "convex", "--duration", "0.3"}},
    {"pivoting", {"incline", "--nonsmooth", "pivoting", "--duration", "0.3"}},
    {"budget", {"wall_648", "--budget-work", "2", "--duration", "0.3"}},
    {"bollard", {"wire_bollard", "--duration", "1"}, "20"},
    {"edge", {"wire_edge", "--duration", "1"}, "20"},
    {"pins", {"wire_pins", "--duration", "1"}},
    {"chaser", {"chaser", "--duration", "1"}, "20"},
    {"settings", {"pendulum", "--step", "0.01", "--set", "bodies.bob.mass=3", "--duration", "1"}},
};

class RunOutputs : public Outputs, public testing::WithParamInterface<RunCase> {};

TEST_P(RunOutputs, AreThoseOfTheFiles) {
    const RunCase& c = GetParam();
    write_text(out("winches.csv"), kWinches);
    write_text(out("operations.json"), kOperations);
    std::vector<std::string> arguments{"run", std::string("scenes/") + c.arguments[0] + ".json"};
    for (std::size_t i = 1; i < c.arguments.size(); ++i) {
        const std::string& argument = c.arguments[i];
        arguments.push_back(argument.starts_with("$OUT/") ? out(argument.substr(5)) : argument);
    }
    for (const std::string& word :
         {std::string("--verbose"), std::string("--summary"), out("summary.json")})
        arguments.push_back(word);
    if (!c.every.empty())
        for (const std::string& word :
             {std::string("--csv"), out("table.csv"), std::string("--record-every"), c.every})
            arguments.push_back(word);
    run(arguments);
    const std::string name = std::string("run_") + c.name;
    check_log(name);
    check_file("summary.json", name + ".json");
    if (!c.every.empty()) check_file("table.csv", name + ".csv");
}

INSTANTIATE_TEST_SUITE_P(All, RunOutputs, testing::ValuesIn(kRuns),
                         [](const auto& run) { return std::string(run.param.name); });

/// Joints between two bodies that no pose can close together.
constexpr const char* kOpenJoints = R"({"version": 1, "name": "open",
  "settings": {"duration": 0.5}, "bodies": [
    {"name": "a", "mass": 4, "box": [1, 1, 0.3]},
    {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "position": [0, 2, -0.5]}],
  "interactions": [
    {"name": "slide", "kind": "cylindrical", "bodies": ["a", "b"], "at": [0.5, -0.5, 1],
     "axis": [0, 0, 1]},
    {"name": "weld", "kind": "lock", "bodies": ["a", "b"],
     "points": [[-1, 0.5, 0], [0.5, -0.7, 0.7]]}]})";

using RunReports = Outputs;

TEST_F(RunReports, FailedRunIsThatOfTheFile) {
    write_text(out("open.json"), kOpenJoints);
    run({"run", out("open.json")});
    run({"run", out("open.json"), "--unchecked"});
    check_log("run_failed");
}

TEST_F(RunReports, SavedStateIsThatOfTheFile) {
    const std::string scene = "scenes/joint_limits.json";
    run({"run", scene, "--duration", "0.5", "--save-at", "0.25", out("state.hws"), "--quiet"});
    run({"run", scene, "--duration", "0.5", "--restore", out("state.hws")});
    check_log("run_restored");
}

TEST_F(RunReports, WrongOptionsAreRefusedAsInTheFile) {
    const std::string scene = "scenes/pendulum.json";
    run({"run", "scenes/no_such_scene.json"});
    run({"run", scene, "--step", "0"});
    run({"run", scene, "--nonsmooth", "fast"});
    run({"run", scene, "--set", "bodies.bab.mass=3"});
    run({"run", scene, "--set", "bodies.bob.mass=-3"});
    run({"run", scene, "--control", "scenes/crane_knuckle.control.csv"});
    run({"run", "scenes/tow_payout.json", "--control", out("no_such_file.csv")});
    run({"run", scene, "--restore", scene});
    run({"ran", scene});
    run({});
    check_log("run_refused");
}

}  // namespace
}  // namespace hawser::golden
