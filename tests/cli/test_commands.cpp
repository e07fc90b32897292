// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"
#include "record/bytes.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <span>

namespace hawser::test {

using nlohmann::json;

constexpr const char* kPendulum = "scenes/pendulum.json";
constexpr const char* kMooring = "scenes/mooring.json";

// Return a scene: an input pulls a box along a line, which breaks at 5 kN.
std::string tug_scene() {
    return R"({"version": 1, "name": "tug",
        "settings": {"step": 0.01, "duration": 2, "gravity": [0, 0, 0]},
        "line_types": {"thread": {"mass_per_length": 0.5, "EA": 2e5, "breaking_load": 5000}},
        "bodies": [{"name": "tug", "position": [10, 0, 0], "mass": 100, "box": [1, 0.5, 0.5]}],
        "cables": [{"name": "line", "line_type": "thread", "from": {"at": [0, 0, 0]},
                    "to": {"body": "tug", "point": [-1, 0, 0]}, "elements": 4}],
        "inputs": [{"name": "tug.thrust", "body": "tug", "component": "force_x",
                    "min": -1e5, "max": 1e5}],
        "plot": {"tensions": ["line"], "motions": ["tug"]}})";
}

TEST(Program, HelpAndVersion) {
    const Outcome help = run_program({"--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* command : {"run", "check", "settle", "replay", "plot", "inspect", "figures",
                                "validate", "bench", "study", "stats"}) {
        EXPECT_NE(help.out.find(command), std::string::npos) << command;
        const Outcome own = run_program({command, "--help"});
        EXPECT_EQ(own.code, 0) << command;
        EXPECT_NE(own.out.find("Examples:"), std::string::npos) << command;
    }
    EXPECT_NE(help.out.find("Exit codes"), std::string::npos);
    const Outcome version = run_program({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.rfind("hawser ", 0), 0u) << version.out;
}

TEST(Program, WrongUseIsCode1) {
    EXPECT_EQ(run_program({}).code, 1);
    EXPECT_EQ(run_program({"sail"}).code, 1);
    EXPECT_EQ(run_program({"run"}).code, 1);
    EXPECT_EQ(run_program({"run", kPendulum, "--step", "-1"}).code, 1);
    EXPECT_EQ(run_program({"run", kPendulum, "--form", "round"}).code, 1);
    EXPECT_EQ(run_program({"run", kPendulum, "--record", "/proc/none/r.hwr"}).code, 1);
    EXPECT_EQ(run_program({"run", kPendulum, "--summary", "/proc/none/s.json"}).code, 1);
    EXPECT_EQ(run_program({"run", kPendulum, "--duration", "1", "--save-at", "5", "s"}).code, 1);
    const auto says = [](const std::vector<std::string>& args, const char* words) {
        const Outcome o = run_program(args);
        EXPECT_EQ(o.code, 1) << words;
        EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
    };
    says({"sail"}, "there is no command \"sail\"");
    says({"run", kPendulum, "--step", "-1"}, "expected a number greater than 0, found \"-1\"");
    says({"run", kPendulum, "--duration", "nan"}, "expected a number of at least 0, found \"nan\"");
    says({"run", kPendulum, "--threads", "257"}, "256");
    const Outcome missing = run_program({"run", "scenes/no_such.json"});
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.err.find("no_such.json"), std::string::npos);
}

TEST(Program, BenchWithoutItsProgramSaysSo) {
    if (std::filesystem::exists(program_file().parent_path() / "hawser-bench"))
        GTEST_SKIP() << "hawser-bench is built";
    const Outcome bench = run_program({"bench", "peers"});
    EXPECT_EQ(bench.code, 1);
    EXPECT_NE(bench.err.find("hawser-bench"), std::string::npos);
}

TEST(Check, GoodAndBadScenes) {
    const auto folder = test_folder();
    write_text(folder / "bad.json", R"({"version": 1, "name": "x", "bodis": []})");
    const Outcome good = run_program({"check", kPendulum, kMooring});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_NE(good.out.find("scenes/mooring.json: ok"), std::string::npos);
    const Outcome bad = run_program({"check", folder / "bad.json", kPendulum});
    EXPECT_EQ(bad.code, 1);
    EXPECT_NE(bad.err.find("bodis"), std::string::npos);
    EXPECT_NE(bad.out.find("pendulum.json: ok"), std::string::npos);
}

TEST(Run, WritesEverythingAsked) {
    const auto folder = test_folder();
    const Outcome run =
        run_program({"run", kMooring, "--duration", "2", "--record", folder / "r.hwr", "--csv",
                     folder / "r.csv", "--summary", folder / "s.json"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("state hash"), std::string::npos);
    const json summary = json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(summary["scene"], "mooring");
    EXPECT_EQ(summary["steps"], 120);
    EXPECT_EQ(summary["outcome"], "finished");
    EXPECT_EQ(summary["status"], "ok");
    EXPECT_GT(summary["tensions"].size(), 0u);
    const Outcome replay = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_NE(replay.out.find(summary["state_hash"].get<std::string>()), std::string::npos);
    const Outcome plot = run_program({"plot", folder / "r.hwr", "-o", folder / "pictures"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    for (const char* name :
         {"tensions.svg", "tensions.png", "motions.svg", "motions.png", "scene.svg", "scene.png"})
        EXPECT_GT(std::filesystem::file_size(folder / "pictures" / name), 2000u) << name;
}

TEST(Run, OptionsChangeTheScene) {
    const auto folder = test_folder();
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"run",     kPendulum,   "--duration",     "0.1",
                                       "--quiet", "--summary", folder / "s.json"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out + outcome.err, "");
        return json::parse(read_text(folder / "s.json"));
    };
    EXPECT_EQ(run({"--step", "0.01"})["steps"], 10);
    EXPECT_EQ(run({"--set", "settings.step=0.02"})["steps"], 5);
    EXPECT_EQ(run({"--form", "saddle"})["form"], "saddle");
    EXPECT_EQ(run({"--threads", "2"})["state_hash"], run({})["state_hash"]);
}

TEST(Run, ContinuesFromASavedState) {
    const auto folder = test_folder();
    const auto hash = [&](const char* file) {
        return json::parse(read_text(folder / file))["state_hash"];
    };
    ASSERT_EQ(run_program({"run", kMooring, "--duration", "2", "--quiet", "--summary",
                           folder / "whole.json", "--save-at", "1", folder / "one.hws"})
                  .code,
              0);
    ASSERT_EQ(
        run_program({"run", kMooring, "--duration", "2", "--quiet", "--restore", folder / "one.hws",
                     "--summary", folder / "rest.json", "--record", folder / "rest.hwr"})
            .code,
        0);
    EXPECT_EQ(hash("whole.json"), hash("rest.json"));
    EXPECT_EQ(run_program({"replay", "--quiet", folder / "rest.hwr"}).code, 0);
    const Outcome other = run_program({"run", kPendulum, "--restore", folder / "one.hws"});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("mooring"), std::string::npos) << other.err;
    const Outcome late =
        run_program({"run", kMooring, "--duration", "0.5", "--restore", folder / "one.hws"});
    EXPECT_EQ(late.code, 1);
    EXPECT_NE(late.err.find("--duration"), std::string::npos) << late.err;
}

TEST(Run, ControlMovesInputsAndReplays) {
    const auto folder = test_folder();
    write_text(folder / "tug.json", tug_scene());
    write_text(folder / "c.csv", "time,tug.thrust\n0,1000\n1,2000\n1.5,1e9\n");
    const Outcome run =
        run_program({"run", folder / "tug.json", "--duration", "1.4", "--control", folder / "c.csv",
                     "--record", folder / "r.hwr", "--summary", folder / "s.json"});
    ASSERT_EQ(run.code, 0) << run.err;
    const json s = json::parse(read_text(folder / "s.json"));
    // The line balances the thrust; its elements and their damping let the tension vibrate about
    // it.
    EXPECT_GT(s["tensions"]["line"]["max"].get<double>(), 1000.0);
    EXPECT_LT(s["tensions"]["line"]["max"].get<double>(), 5000.0);
    EXPECT_GT(s["energy"]["applied"].get<double>(), 0.0);
    EXPECT_EQ(run_program({"replay", "--quiet", folder / "r.hwr"}).code, 0);
    // Beyond its range the input is clamped to 100 kN, and the line breaks.
    const Outcome pulled =
        run_program({"run", folder / "tug.json", "--control", folder / "c.csv", "--quiet",
                     "--summary", folder / "s.json", "--record", folder / "r.hwr"});
    ASSERT_EQ(pulled.code, 0) << pulled.err;
    const json p = json::parse(read_text(folder / "s.json"));
    EXPECT_GE(p["event_counts"]["line_break"].get<int>(), 1);
    EXPECT_EQ(p["event_counts"]["input_clamped"].get<int>(), 1);
    EXPECT_EQ(run_program({"replay", "--quiet", folder / "r.hwr"}).code, 0);

    write_text(folder / "c.csv", "time,tug.trust\n0,1\n");
    const Outcome wrong = run_program({"run", folder / "tug.json", "--control", folder / "c.csv"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.err.find("c.csv:1:6"), std::string::npos) << wrong.err;
    EXPECT_NE(wrong.err.find("\"tug.thrust\""), std::string::npos) << wrong.err;
}

TEST(Run, ControlTakesOperations) {
    const auto folder = test_folder();
    const std::string part = folder / "ops.json", scene = folder / "tug.json";
    write_text(scene, tug_scene());
    write_text(folder / "c.csv", "time,tug.thrust\n0,1000\n");
    write_text(part,
               R"([{"at": 0.5, "cut": "line", "s": 4}, {"at": 0.2, "set": {"tug.thrust": 500}}])");
    const std::vector<std::string> run{"run", scene,       "--duration",
                                       "1",   "--quiet",   "--control",
                                       part,  "--control", folder / "c.csv"};
    std::vector<std::string> all = run;
    for (const std::string& more : {std::string("--record"), std::string(folder / "r.hwr"),
                                    std::string("--summary"), std::string(folder / "s.json")})
        all.push_back(more);
    ASSERT_EQ(run_program(all).code, 0);
    const json s = json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(s["event_counts"]["cut"].get<int>(), 1);
    EXPECT_TRUE(s["wires"].contains("line/2")) << s["wires"].dump();
    EXPECT_EQ(run_program({"replay", "--quiet", folder / "r.hwr"}).code, 0);
    // Messages give the position in the included file.
    write_text(part,
               R"([{"at": 0.2, "set": {"tug.thrust": 500}}, {"at": 0.5, "cut": "lien", "s": 4}])");
    const Outcome unknown = run_program(run);
    EXPECT_EQ(unknown.code, 1);
    EXPECT_NE(unknown.err.find("ops.json: /1/cut: "), std::string::npos) << unknown.err;
    EXPECT_NE(unknown.err.find("\"line\""), std::string::npos) << unknown.err;
    write_text(part, R"([{"at": 0.5, "cutt": "line", "s": 4}])");
    const Outcome misspelt = run_program(run);
    EXPECT_EQ(misspelt.code, 1);
    EXPECT_NE(misspelt.err.find("ops.json: /0"), std::string::npos) << misspelt.err;
    const Outcome two = run_program({"run", scene, "--control", part, "--control", part});
    EXPECT_EQ(two.code, 1);
    EXPECT_NE(two.err.find("one JSON file at most"), std::string::npos) << two.err;
    write_text(part, "[]");
    const Outcome over = run_program({"run", scene, "--control", part, "--csv", part});
    EXPECT_EQ(over.code, 1);
    EXPECT_NE(over.err.find("would overwrite"), std::string::npos) << over.err;
}

TEST(Run, CtrlCWritesWhatThereIs) {
    const auto folder = test_folder();
    const Outcome run = run_program(
        {"run", kMooring, "--duration", "100000", "--realtime", "--record", folder / "r.hwr",
         "--csv", folder / "r.csv", "--summary", folder / "s.json", "--trace", folder / "t.json"},
        1.5);
    EXPECT_EQ(run.code, 130) << run.err;
    EXPECT_NE(run.out.find("interrupted"), std::string::npos);
    const json summary = json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(summary["outcome"], "interrupted");
    EXPECT_GT(summary["steps"].get<int>(), 5);
    EXPECT_TRUE(summary.contains("realtime"));
    const Outcome replay = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(replay.code, 0) << replay.err << replay.out;
    EXPECT_EQ(replay.out.find("not complete"), std::string::npos) << replay.out;
    EXPECT_EQ(read_text(folder / "r.csv").back(), '\n');
    const json trace = json::parse(read_text(folder / "t.json"));
    EXPECT_GE(trace["otherData"]["steps"].get<int>(), 5);
}

TEST(Run, TracesTheLastSteps) {
    const auto folder = test_folder();
    const Outcome run = run_program({"run", kMooring, "--duration", "0.5", "--threads", "2",
                                     "--trace", folder / "t.json", "--trace", folder / "t.svg",
                                     "--trace-steps", "3", "--trace-step", "2"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("timeline     step 2: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("linear algebra"), std::string::npos);
    const json trace = json::parse(read_text(folder / "t.json"));
    EXPECT_EQ(trace["otherData"]["steps"], 3);
    EXPECT_NE(read_text(folder / "t.svg").find("thread 1"), std::string::npos);
    // The state is the same with and without a trace. Simulated schedules for several threads come
    // from a run on one thread.
    const Outcome one = run_program({"run", kMooring, "--duration", "0.5", "--trace",
                                     folder / "t.svg", "--save-at", "0.5", folder / "a.hws"});
    EXPECT_NE(one.out.find("simulated    2 threads"), std::string::npos) << one.out;
    (void)run_program({"run", kMooring, "--duration", "0.5", "--save-at", "0.5", folder / "b.hws"});
    EXPECT_EQ(read_text(folder / "a.hws"), read_text(folder / "b.hws"));
    EXPECT_EQ(run_program({"run", kMooring, "--trace", folder / "t.txt"}).code, 1);
    EXPECT_EQ(run_program({"run", kMooring, "--trace", "/proc/none/t.json"}).code, 1);
}

TEST(Run, RealtimeKeepsPace) {
    const auto folder = test_folder();
    const Outcome run = run_program({"run", kPendulum, "--duration", "0.5", "--step", "0.02",
                                     "--realtime", "--rt", "--summary", folder / "s.json"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("--rt:"), std::string::npos);
    const json s = json::parse(read_text(folder / "s.json"));
    EXPECT_GE(s["wall_seconds"].get<double>(), 0.5);
    EXPECT_GE(s["realtime"]["missed_frames"].get<int>(), 0);
}

TEST(Run, AFailedStepIsCode2) {
    const auto folder = test_folder();
    // The condensed form adds a stiffness of 1e24 times the mass: the mass is lost in rounding and
    // the matrix becomes singular. The automatic form would keep the row.
    write_text(folder / "bad.json", R"({"version": 1, "name": "bad",
        "settings": {"duration": 1, "form": "condensed", "on_diverged": "warn"},
        "bodies": [{"name": "a", "kind": "lump", "position": [0, 0, 0], "mass": 1e-9},
                   {"name": "b", "kind": "lump", "position": [1, 0, 0], "mass": 1e-9}],
        "interactions": [{"name": "j", "kind": "stretch", "bodies": ["a", "b"], "length": 0.9,
                          "EA": 1e15}]})");
    const Outcome run = run_program(
        {"run", folder / "bad.json", "--summary", folder / "s.json", "--record", folder / "r.hwr"});
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_NE(run.err.find("failed: wrong_pivot"), std::string::npos) << run.err;
    const json summary = json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(summary["outcome"], "failed");
    EXPECT_EQ(summary["status"], "wrong_pivot");
    // The steps before the failed one are recorded, and replay reproduces them.
    EXPECT_EQ(run_program({"replay", "--quiet", folder / "r.hwr"}).code, 0);
}

// A recording whose thrust was changed afterwards, with valid checksums.
TEST(Replay, NoticesAChangedCommand) {
    const auto folder = test_folder();
    write_text(folder / "tug.json", tug_scene());
    write_text(folder / "c.csv", "time,tug.thrust\n0.5,1000\n");
    ASSERT_EQ(run_program({"run", folder / "tug.json", "--duration", "1", "--quiet", "--control",
                           folder / "c.csv", "--record", folder / "r.hwr"})
                  .code,
              0);
    const std::string text = read_text(folder / "r.hwr");
    std::vector<std::byte> bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    const std::size_t at = text.find("INPT");
    ASSERT_NE(at, std::string::npos);
    const double changed = 1001.0;
    std::memcpy(bytes.data() + at + 8 + 4 + 12, &changed, sizeof changed);
    const std::uint32_t crc = record::crc32(std::span(bytes).subspan(at, 8 + 24));
    std::memcpy(bytes.data() + at + 8 + 24, &crc, sizeof crc);
    write_text(folder / "r.hwr", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const Outcome replay = run_program({"replay", folder / "r.hwr"});
    EXPECT_EQ(replay.code, 3) << replay.out << replay.err;
    EXPECT_NE(replay.out.find("first difference at step 51"), std::string::npos) << replay.out;
    EXPECT_NE(replay.out.find("(tug)"), std::string::npos) << replay.out;
}

TEST(Replay, SaysWhereItDiffers) {
    const auto folder = test_folder();
    ASSERT_EQ(run_program(
                  {"run", kPendulum, "--duration", "0.2", "--quiet", "--record", folder / "r.hwr"})
                  .code,
              0);
    const Outcome other = run_program({"replay", folder / "r.hwr"}, -1.0, {"HAWSER_ISA=sse2"});
    if (other.code != 0) {  // The processor may have no other instruction set.
        EXPECT_EQ(other.code, 3);
        EXPECT_NE(other.err.find("HAWSER_ISA="), std::string::npos) << other.err;
    }
    damage(folder / "r.hwr", 3);
    EXPECT_EQ(run_program({"replay", folder / "r.hwr"}).code, 1);
    EXPECT_EQ(run_program({"plot", folder / "r.hwr"}).code, 1);
    EXPECT_EQ(run_program({"replay", "no_such.hwr"}).code, 1);
}

TEST(Inspect, PrintsSizesAndDrawsTheMatrix) {
    const auto folder = test_folder();
    const Outcome hull = run_program({"inspect", "scenes/floating_box.json", "--hydrostatics"});
    ASSERT_EQ(hull.code, 0) << hull.err;
    // 10 x 10 x 4 m, draught 2 m, G at the waterline.
    for (const char* line : {"205000 kg at a draught of 2 m", "KB               1 m",
                             "BM               4.16666667 m", "GM               3.16666667 m"})
        EXPECT_NE(hull.out.find(line), std::string::npos) << line << hull.out;
    // With the tide at the start; the box lies 2 m deep in it.
    std::string tide = read_text("scenes/floating_box.json");
    tide.replace(tide.find("[0, 0, 0]"), 9, "[0, 0, 6]");
    tide.replace(tide.find("\"depth\": 150"), 12,
                 R"("depth": 150, "level": [{"time": 0, "level": 6}])");
    write_text(folder / "tide.json", tide);
    const Outcome high = run_program({"inspect", folder / "tide.json", "--hydrostatics"});
    ASSERT_EQ(high.code, 0) << high.err;
    for (const char* line : {"205000 kg of water, 200 m³, under z = 6 m",
                             "205000 kg at a draught of 2 m", "centre of mass at z = 6 m"})
        EXPECT_NE(high.out.find(line), std::string::npos) << line << high.out;
    EXPECT_EQ(run_program({"inspect", kMooring, "--hydrostatics"}).code, 1);
    const Outcome inspect = run_program({"inspect", kMooring, "-o", folder});
    ASSERT_EQ(inspect.code, 0) << inspect.err;
    for (const char* word : {"islands", "equations", "nonzeros", "fronts", "critical path"})
        EXPECT_NE(inspect.out.find(word), std::string::npos) << word;
    EXPECT_TRUE(std::filesystem::exists(folder / "spy.svg"));
    EXPECT_TRUE(std::filesystem::exists(folder / "spy.png"));
}

TEST(Settle, FindsTheRestOfAHangingWeight) {
    const auto folder = test_folder();
    write_text(folder / "hang.json", R"({"version": 1, "name": "hang",
        "line_types": {"rope": {"mass_per_length": 1, "EA": 1e5}},
        "bodies": [{"name": "w", "position": [3, 0, -4], "mass": 50, "box": [0.2, 0.2, 0.2]}],
        "cables": [{"name": "r", "line_type": "rope", "from": {"at": [0, 0, 0]},
                    "to": {"body": "w", "point": [0, 0, 0]}, "length": 5, "elements": 5}]})");
    const Outcome settle = run_program({"settle", folder / "hang.json", "--tolerance", "1e-7"});
    ASSERT_EQ(settle.code, 0) << settle.err << settle.out;
    const json state = json::parse(read_text(folder / "hang.settled.json"));
    const auto p = state["bodies"]["w"]["p"];
    // 5 m, stretched by the weight of the 50 kg and of the nodes of 1 kg. Each element carries the
    //   nodes below it, two of four on average. The ends' fraction of the rope's mass belongs to
    //   the bodies there.
    const double rest = -5.0 * (1.0 + (50.0 + 2.0) * 9.81 / 1e5);
    // At 1e-7 m/s and a stop time of 15 s the position stays within x = v / (ω² T) of its rest.
    EXPECT_NEAR(p[0].get<double>(), 0.0, 1e-6);
    EXPECT_NEAR(p[2].get<double>(), rest, 1e-6);
    EXPECT_EQ(state["bodies"]["w"]["v"], json({0.0, 0.0, 0.0}));
    const Outcome never = run_program({"settle", folder / "hang.json", "-o", folder / "n.json",
                                       "--max-time", "0.1", "--tolerance", "1e-12"});
    EXPECT_EQ(never.code, 2);
    EXPECT_TRUE(std::filesystem::exists(folder / "n.json"));
}

}  // namespace hawser::test
