// SPDX-License-Identifier: Apache-2.0
/// Output of `hawser check` for scenes and their starts, and the reaction of `hawser run`.
#include "program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr const char* kTwoJointsApart = R"({"version": 1, "name": "contradiction",
  "settings": {"duration": 0.1},
  "bodies": [{"name": "a", "mass": 4, "box": [1, 1, 0.3]},
             {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "position": [0, 2, -0.5]}],
  "interactions": [
    {"name": "c", "kind": "cylindrical", "bodies": ["a", "b"], "at": [0.5, -0.5, 1],
     "axis": [0, 0, 1]},
    {"name": "l", "kind": "lock", "bodies": ["a", "b"],
     "points": [[-1, 0.5, 0], [0.5, -0.7, 0.7]]}]})";

TEST(Check, EverySceneOfTheLibraryPasses) {
    std::vector<std::string> arguments{"check"};
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string file = entry.path().string();
        if (entry.path().extension() == ".json" && file.find(".settled") == std::string::npos)
            arguments.push_back(file);
    }
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("error:"), std::string::npos) << outcome.err;
    EXPECT_EQ(static_cast<std::size_t>(std::count(outcome.out.begin(), outcome.out.end(), '\n')),
              arguments.size() - 1);
}

TEST(Check, ContradictoryJointsAreNamedAndRefused) {
    const auto folder = test_folder();
    const auto file = (folder / "c.json").string();
    write_text(file, kTwoJointsApart);
    const Outcome checked = run_program({"check", file});
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.err.find("error: the joints \"c\" and \"l\" are inconsistent"),
              std::string::npos)
        << checked.err;
    EXPECT_NE(checked.out.find("impossible, 1 error"), std::string::npos) << checked.out;
    const Outcome run = run_program({"run", file, "--summary", (folder / "s.json").string()});
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("inconsistent"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("--unchecked"), std::string::npos) << run.err;
    EXPECT_TRUE(run.out.empty());
    EXPECT_FALSE(std::filesystem::exists(folder / "s.json"));
    // The scene is not rejected, for any result.
    const Outcome unchecked = run_program({"run", file, "--unchecked"});
    EXPECT_EQ(unchecked.err.find("--unchecked"), std::string::npos) << unchecked.err;
    EXPECT_NE(unchecked.out.find("contradiction ("), std::string::npos) << unchecked.out;
}

TEST(Check, OtherCommandsSayHowManyMistakesThereAre) {
    const auto file = (test_folder() / "b.json").string();
    write_text(file, R"({"version": 1, "name": "b", "bodies": [{"name": "x", "kind": "lump",
        "mass": -1}], "settings": {"step": 7, "stp": 1}})");
    const Outcome run = run_program({"run", file});
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("/bodies/0/mass"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("and 2 more: `hawser check` lists them"), std::string::npos) << run.err;
}

TEST(Check, JsonHasWhatWasFound) {
    const auto folder = test_folder();
    const auto good = (folder / "c.json").string(), bad = (folder / "b.json").string();
    write_text(good, kTwoJointsApart);
    write_text(bad, R"({"version": 1, "name": "b", "bodies": [{"name": "x", "kind": "lump",
        "mass": -1}], "settings": {"step": 7}})");
    const Outcome outcome = run_program({"check", "--json", good, bad, "scenes/pendulum.json"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(outcome.err.empty()) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 3U);
    EXPECT_EQ(json[0]["errors"], 1);
    EXPECT_EQ(json[0]["findings"][0]["kind"], "contradiction");
    EXPECT_EQ(json[0]["findings"][0]["about"], (nlohmann::json{"c", "l"}));
    EXPECT_EQ(json[0]["findings"][0]["severity"], "error");
    ASSERT_EQ(json[1]["mistakes"].size(), 2U);
    EXPECT_EQ(json[1]["mistakes"][0]["path"], "/bodies/0/mass");
    EXPECT_FALSE(json[1]["good"].get<bool>());
    EXPECT_TRUE(json[2]["good"].get<bool>());
    EXPECT_EQ(json[2]["warnings"], 0);
}

TEST(Check, WarningsAreSaidBeforeTheFirstStepAndInTheReport) {
    const Outcome run = run_program({"run", "scenes/heavy_hook.json", "--duration", "0.05"});
    EXPECT_EQ(run.code, 0);
    const char* words = "warning: the cable \"chain\": under the ";
    const auto said = run.err.find(words);
    EXPECT_NE(said, std::string::npos) << run.err;
    EXPECT_LT(said, run.err.find("steps of 16.6667 ms"));
    EXPECT_NE(run.out.find("  warning      the cable \"chain\""), std::string::npos) << run.out;
    const Outcome quiet =
        run_program({"run", "scenes/heavy_hook.json", "--duration", "0.05", "--quiet"});
    EXPECT_TRUE(quiet.err.empty()) << quiet.err;
}

/// A line has 20 kg/m, so that 47.5 m of the 100 m hang from the end of the first element.
constexpr const char* kHangingAndLying = R"({"version": 1, "name": "wires",
  "line_types": {"wire": {"mass_per_length": 20, "EA": 1e8, "breaking_load": 1e6}},
  "cables": [
    {"name": "hung", "line_type": "wire", "elements": 20, "length": 100, "shape": "hanging",
     "from": {"at": [0, 0, 0]}, "to": {"at": [80, 0, 0]}},
    {"name": "lies", "line_type": "wire", "elements": 20, "shape": "laid",
     "seabed": {"height": -20}, "from": {"at": [0, 0, -20]}, "to": {"at": [60, 0, -20]}}]})";

TEST(Check, SaysWithWhatTensionCablesStart) {
    const auto file = (test_folder() / "wires.json").string();
    write_text(file, kHangingAndLying);
    const Outcome one = run_program({"check", file});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_NE(one.out.find("cable \"hung\" starts with 11.4"), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("% of its breaking load"), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("cable \"lies\" starts slack; it lies on its seabed from 0 m to 60 m"),
              std::string::npos)
        << one.out;
    // With several scenes, cables are printed only with --cables.
    const Outcome two = run_program({"check", file, "scenes/mooring.json"});
    EXPECT_EQ(two.out.find("starts with"), std::string::npos) << two.out;
    const Outcome asked = run_program({"check", "--cables", file, "scenes/mooring.json"});
    EXPECT_NE(asked.out.find("cable \"tow_east\" starts with"), std::string::npos) << asked.out;
    const Outcome json = run_program({"check", "--json", file});
    const auto cables = nlohmann::json::parse(json.out)[0]["cables"];
    ASSERT_EQ(cables.size(), 2U);
    // The horizontal pull is the weight of 33.82 m, the vertical one the weight of 47.5 m.
    EXPECT_NEAR(cables[0]["tension_largest"].get<double>(), 196.2 * std::hypot(33.82, 47.5), 60.0);
    EXPECT_NEAR(cables[0]["tension_first"].get<double>(), cables[0]["tension_last"].get<double>(),
                1e-3);
    EXPECT_EQ(cables[1]["tension_largest"], 0.0);
    EXPECT_EQ(cables[1]["laid"], (nlohmann::json{0.0, 60.0}));
}

TEST(Check, OptionsChangeWhatIsChecked) {
    const Outcome fine = run_program({"check", "scenes/heavy_hook.json", "--step", "0.001"});
    EXPECT_EQ(fine.err.find("swings"), std::string::npos) << fine.err;
    const Outcome heavy =
        run_program({"check", "scenes/box_stack.json", "--set", "bodies.box3.mass=1e9"});
    EXPECT_EQ(heavy.code, 0);
    EXPECT_NE(heavy.err.find("\"box3\" has an implausible density of 1e+09"), std::string::npos)
        << heavy.err;
}

/// Data for users come first, data of the solver last.
TEST(Check, ReportBeginsWithTensionsAndMotions) {
    const Outcome run =
        run_program({"run", "scenes/mooring.json", "--duration", "0.1", "--verbose"});
    ASSERT_EQ(run.code, 0) << run.err;
    std::size_t last = 0;
    for (const char* word : {"simulated", "of break", "moved at most", "events", "system", "matrix",
                             "residuals", "\n  energy", "state hash", "machine"}) {
        const std::size_t at = run.out.find(word);
        ASSERT_NE(at, std::string::npos) << word << "\n" << run.out;
        EXPECT_GT(at, last) << word << "\n" << run.out;
        last = at;
    }
}

}  // namespace
}  // namespace hawser::test
