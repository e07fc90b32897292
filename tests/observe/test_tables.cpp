// SPDX-License-Identifier: Apache-2.0
#include "observe/control.h"
#include "observe/csv.h"
#include "observe/names.h"
#include "observe/samples.h"
#include "observe/small_scene.h"
#include "observe/summary.h"

#include <nlohmann/json.hpp>

namespace hawser::test {

const std::vector<std::string> kInputs{"winch1.speed", "winch2.speed", "thrust"};

std::string refusal(const std::string& text) {
    try {
        (void)observe::parse_control(text, "c.csv", kInputs);
    } catch (const observe::ControlError& e) {
        return e.what();
    }
    return "accepted";
}

/// What is asked for and held shut by contacts is exact and no degradation; of what was in force
/// the largest defect stays.
TEST(Degradations, CountWhatWasInForceWithItsDefect) {
    observe::Degradations d;
    StepStats s;
    s.degradation.cuts = 3;
    s.momentum_defect = 1e-13;
    for (s.step = 1; s.step <= 5; ++s.step) d.after_step(s);
    EXPECT_EQ(d.all.steps, 0);
    EXPECT_EQ(d.spans, 0);
    s.compliant = 2;
    s.degraded_by = DegradedBy::prediction;
    for (const double defect : {0.1, 0.3, 0.2}) {
        s.momentum_defect = defect;
        s.cut_defect = 10.0 * defect;
        d.after_step(s);
        ++s.step;
    }
    EXPECT_EQ(d.coupling.steps, 3);
    EXPECT_EQ(d.coupling.interfaces, 1);
    EXPECT_EQ(d.coupling.momentum_defect, 0.3);
    EXPECT_EQ(d.coupling.cut_defect, 3.0);
    EXPECT_EQ(d.by_cause[static_cast<std::size_t>(DegradedBy::prediction)], 3);
    EXPECT_EQ(d.list.size(), 1U);
    observe::Summary summary;
    summary.budget_ms = 5.0;
    summary.degradations = d;
    const auto json = nlohmann::json::parse(observe::to_json(summary));
    EXPECT_EQ(json["degradations"]["coupling"]["momentum_defect_max"], 0.3);
    EXPECT_EQ(json["degradations"]["coupling"]["cut_defect_max"], 3.0);
    EXPECT_NE(observe::report(summary).find("momentum defect of compliant cuts"),
              std::string::npos);
}

TEST(Control, ReadsStepwiseValues) {
    const auto changes = observe::parse_control(
        "# levers\r\ntime, thrust ,winch1.speed\r\n0,1e5,\n\n2.5, ,-0.5\n2.5,0,0\n", "c.csv",
        kInputs);
    ASSERT_EQ(changes.size(), 4u);
    EXPECT_EQ(changes[0].input, 2);
    EXPECT_EQ(changes[0].value, 1e5);
    EXPECT_EQ(changes[1].time, 2.5);
    EXPECT_EQ(changes[1].input, 0);
    EXPECT_EQ(changes[1].value, -0.5);
    EXPECT_EQ(changes[3].value, 0.0);
}

TEST(Control, ErrorsNameLineColumnAndNearestName) {
    EXPECT_EQ(refusal("time,winch1.sped\n"),
              "c.csv:1:6: unknown input \"winch1.sped\"; nearest: \"winch1.speed\"");
    EXPECT_EQ(refusal("t,thrust\n"), "c.csv:1:1: the first column is \"t\", expected \"time\"");
    EXPECT_EQ(refusal("time,thrust\n0,1\n1,abc\n"), "c.csv:3:3: \"abc\" is not a finite number");
    EXPECT_EQ(refusal("time,thrust\n0,nan\n"), "c.csv:2:3: \"nan\" is not a finite number");
    EXPECT_EQ(refusal("time,thrust\n0,1e999\n"), "c.csv:2:3: \"1e999\" is not a finite number");
    EXPECT_EQ(refusal("time,thrust\n1,0\n0.5,0\n"),
              "c.csv:3:1: time 0.5 is before the previous line's 1");
    EXPECT_EQ(refusal("time,thrust\n0,1,2\n"), "c.csv:2:5: 3 fields, the first line has 2");
    EXPECT_EQ(refusal("time,thrust,thrust\n"), "c.csv:1:13: the input \"thrust\" has two columns");
    EXPECT_NE(refusal("").find("the first line must be"), std::string::npos);
    EXPECT_NE(refusal("time\n").find("thrust"), std::string::npos);
    EXPECT_THROW((void)observe::read_control("no_such.csv", kInputs), observe::ControlError);
}

TEST(Control, SurvivesRandomText) {
    std::uint32_t state = 1;
    const std::string alphabet = "time,thrust0123456789.e-\n\r \t#\"\xFF";
    for (int round = 0; round < 3000; ++round) {
        std::string text = round % 2 == 0 ? "time,thrust\n" : "";
        for (int i = 0; i < 60; ++i) {
            state = state * 1664525u + 1013904223u;
            text += alphabet[(state >> 16) % alphabet.size()];
        }
        (void)refusal(text);
    }
}

TEST(Names, NearestIsTheFewestEditsAway) {
    EXPECT_EQ(observe::nearest_name("thrus", kInputs), "thrust");
    EXPECT_EQ(observe::nearest_name("winch2speed", kInputs), "winch2.speed");
    EXPECT_EQ(observe::nearest_name("x", {}), "");
}

TEST(Samples, QuantilesOfAFewAndOfMany) {
    observe::Samples few;
    for (const double v : {5.0, 1.0, 3.0}) few.add(v);
    EXPECT_EQ(few.median(), 3.0);
    EXPECT_EQ(few.quantile(0), 1.0);
    EXPECT_EQ(few.quantile(0.75), 4.0);
    EXPECT_EQ(few.max(), 5.0);
    observe::Samples many(64);
    for (int i = 0; i < 10000; ++i) many.add(i == 4999 ? 1e9 : i);
    EXPECT_EQ(many.count(), 10000);
    EXPECT_EQ(many.max(), 1e9);
    // 32 to 64 evenly spaced numbers are kept: the median is off by less than one spacing.
    EXPECT_NEAR(many.median(), 5000, 10000 / 32.0);
    EXPECT_EQ(observe::Samples().median(), 0.0);
}

TEST(Summary, JsonHasAllFields) {
    SmallScene scene;
    observe::SummaryCollector collector(scene.info, scene.world);
    const int steps = 100;
    double top = 0.0;
    for (int i = 0; i < steps; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
        collector.after_step(scene.world, scene.world.take_events());
        for (const auto e : scene.info.cables[0].elements)
            top = std::max(top, observe::element_tension(scene.world, e));
    }
    const observe::Summary summary = collector.result(scene.world);
    const auto json = nlohmann::json::parse(observe::to_json(summary));
    for (const char* key : {"scene",           "scene_hash",
                            "bodies",          "interactions",
                            "equations",       "islands",
                            "contacts",        "nnz",
                            "flops",           "steps",
                            "step_ms",         "solver_ms",
                            "solver_cpu_ms",   "stage_ms",
                            "residuals",       "violation_max",
                            "violation_where", "stretch_error_max",
                            "energy",          "event_counts",
                            "events",          "state_hash",
                            "threads",         "instruction_set",
                            "processor",       "load_average",
                            "version",         "peak_memory_bytes",
                            "tensions",        "motions"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["steps"], steps);
    EXPECT_EQ(json["timed_steps"], steps - observe::kWarmUpSteps);
    EXPECT_EQ(json["bodies"], 2);
    EXPECT_EQ(json["equations"], 3 + 6 + 2);
    EXPECT_GT(json["step_ms"]["median"].get<double>(), 0.0);
    EXPECT_GE(json["step_ms"]["max"].get<double>(), json["step_ms"]["p99"].get<double>());
    EXPECT_EQ(json["stage_ms"].size(), std::size_t(kStageCount));
    EXPECT_DOUBLE_EQ(json["tensions"]["wire"]["max"].get<double>(), top);
    EXPECT_DOUBLE_EQ(json["tensions"]["wire"]["fraction_of_breaking_load"].get<double>(),
                     top / 1e4);
    const auto& motion = json["motions"]["box & <friends>"];
    EXPECT_GT(motion["displacement_max"].get<double>(), 0.0);
    EXPECT_EQ(json["state_hash"].get<std::string>().size(), 16u);
    // The box swings: what the elements and the step's damping take is small.
    EXPECT_LT(std::abs(json["energy"]["drift_relative"].get<double>()), 0.1);
    EXPECT_NE(observe::report(summary).find("wire"), std::string::npos);
}

TEST(Csv, HasOneColumnPerNameAndOneRowPerTime) {
    const auto file = fresh_folder() / "r.csv";
    SmallScene scene;
    scene.info.cables[0].name = "wire, \"old\"";
    observe::CsvWriter csv(file, scene.info, scene.world);
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
        csv.add_row(scene.world);
    }
    csv.finish();
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    EXPECT_NE(line.find("\"wire, \"\"old\"\" tension at first end [N]\""), std::string::npos);
    int rows = 0;
    while (std::getline(in, line)) {
        ++rows;
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 2 + 6);
    }
    EXPECT_EQ(rows, 3);
    EXPECT_THROW(observe::CsvWriter("/proc/none/r.csv", scene.info, scene.world),
                 std::runtime_error);
}

}  // namespace hawser::test
