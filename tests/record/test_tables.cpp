// SPDX-License-Identifier: Apache-2.0
#include "record/control.h"
#include "record/csv.h"
#include "record/names.h"
#include "record/small_scene.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace hawser::test {

const std::vector<std::string> kInputs{"winch1.speed", "winch2.speed", "thrust"};

std::string refusal(const std::string& text) {
    try {
        (void)record::parse_control(text, "c.csv", kInputs);
    } catch (const record::ControlError& e) {
        return e.what();
    }
    return "accepted";
}

TEST(Control, ReadsStepwiseValues) {
    const auto changes = record::parse_control(
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
    EXPECT_THROW((void)record::read_control("no_such.csv", kInputs), record::ControlError);
}

TEST(Control, ValuesKeepToTheRangesThereAre) {
    const record::ControlRange ranges[] = {{0.0, 5.0}, {-1.0, 1.0}, {}};
    const auto read = [&](const char* text) {
        return record::parse_control(text, "c.csv", kInputs, ranges);
    };
    EXPECT_EQ(read("time,winch1.speed,thrust\n0,5,1e9\n").size(), 2U);
    try {
        (void)read("time,winch1.speed,winch2.speed\n0,5,1\n1,,-1.5\n");
        ADD_FAILURE();
    } catch (const record::ControlError& error) {
        EXPECT_STREQ(
            error.what(),
            "c.csv:3:4: -1.5 is not within the range of the input \"winch2.speed\", -1 to 1");
    }
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
    EXPECT_EQ(record::nearest_name("thrus", kInputs), "thrust");
    EXPECT_EQ(record::nearest_name("winch2speed", kInputs), "winch2.speed");
    EXPECT_EQ(record::nearest_name("x", {}), "");
}

// Drums and resolutions replace the elements at the ends of wires.
TEST(Csv, TensionsAreThoseAtTheEndsThatAWireHasNow) {
    World w({.step = 0.01});
    const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed, .position = {0, 0, 10}});
    const BodyId load =
        w.add_body({.name = "load", .mass = 100.0, .inertia = 100.0 * Mat3::Identity()});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = top,
                                       .to = load,
                                       .elements = 4,
                                       .length = 10.0,
                                       .EA = 1e6,
                                       .mass_per_length = 1.0,
                                       .consistent_mass = true});
    record::SceneInfo info;
    info.cables.push_back(
        {.name = "wire",
         .line_type = "",
         .nodes = {w.wires().nodes(wire).begin(), w.wires().nodes(wire).end()},
         .elements = {w.wires().elements(wire).begin(), w.wires().elements(wire).end()}});
    const auto file = fresh_folder() / "ends.csv";
    record::CsvWriter csv(file, info, w);
    ASSERT_EQ(w.step(), Status::ok);
    (void)w.wires().insert_node(w.wires().elements(wire).back(), 0.5);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(w.step(), Status::ok);
    csv.add_row(w);
    csv.finish();
    std::ifstream in(file);
    std::string row;
    for (int line = 0; line < 2; ++line) std::getline(in, row);
    EXPECT_NE(w.wires().elements(wire).back(), info.cables[0].elements.back());
    std::istringstream numbers(row);
    double time = 0.0, first = 0.0, last = 0.0;
    char comma = 0;
    numbers >> time >> comma >> first >> comma >> last;
    // Nine digits.
    EXPECT_NEAR(first, w.wires().tension(wire, 0.0), 1e-8 * first);
    EXPECT_NEAR(last, w.wires().tension(wire, w.wires().length(wire)), 1e-8 * last);
    EXPECT_GT(first, last) << "it hangs";
    EXPECT_GT(last, 0.0);
}

TEST(Csv, HasOneColumnPerNameAndOneRowPerTime) {
    const auto file = fresh_folder() / "r.csv";
    SmallScene scene;
    scene.info.cables[0].name = "wire, \"old\"";
    record::CsvWriter csv(file, scene.info, scene.world);
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
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 2 + 6 + 1)
            << "tensions, motion, output";
    }
    EXPECT_EQ(rows, 3);
    EXPECT_THROW(record::CsvWriter("/proc/none/r.csv", scene.info, scene.world),
                 std::runtime_error);
}

}  // namespace hawser::test
