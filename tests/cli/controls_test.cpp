// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

namespace hawser::test {

namespace {

std::string random_tug(const char* limits) {
    return std::string(R"({"version": 1, "name": "random_tug",
        "settings": {"step": 0.02, "duration": 20},
        "bodies": [{"name": "tug", "position": [0, 0, 0], "mass": 1000, "box": [1, 0.5, 0.5]}],
        "inputs": [{"name": "push", "body": "tug", "component": "force_x")") +
           limits + "}]}";
}

std::vector<std::string> controls(const std::string& scene, const std::string& out,
                                  std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"controls", scene, "--duration", "10", "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

TEST(Controls, RunTakesWhatTheyWrite) {
    const auto folder = test_folder();
    const std::string a = folder / "a.csv", b = folder / "b.csv", c = folder / "c.csv";
    for (const char* scene : {"scenes/tackle.json", "scenes/wire_slide.json"}) {
        ASSERT_EQ(run_program(controls(scene, a, {"--seed", "7"})).code, 0);
        ASSERT_EQ(run_program(controls(scene, b, {"--seed", "7"})).code, 0);
        ASSERT_EQ(run_program(controls(scene, c, {"--seed", "8"})).code, 0);
        EXPECT_EQ(read_text(a), read_text(b));
        EXPECT_NE(read_text(a), read_text(c));
        const Outcome run = run_program(
            {"run", scene, "--duration", "0.2", "--quiet", "--unchecked", "--control", a});
        EXPECT_EQ(run.code, 0) << run.err;
    }
}

TEST(Controls, ExercisesHaveTheInputsOfTheirStations) {
    const auto folder = test_folder();
    const std::string file = folder / "a.csv";
    ASSERT_EQ(run_program(controls("exercises/tow_out.json", file)).code, 0);
    EXPECT_EQ(read_text(file).substr(0, read_text(file).find('\n')),
              "time,thrust,winch_mode,winch_speed,winch_brake");
}

TEST(Controls, WithoutARangeSaysSo) {
    const auto folder = test_folder();
    const std::string scene = folder / "tug.json", file = folder / "a.csv";
    write_text(scene, random_tug(""));
    const Outcome none = run_program(controls(scene, file));
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("\"push\" has no range"), std::string::npos) << none.err;
    EXPECT_EQ(run_program(controls(scene, file, {"--range", "push=-5:5"})).code, 0);
    write_text(scene, random_tug(R"(, "nominal": 100)"));
    EXPECT_EQ(run_program(controls(scene, file)).code, 0);
    const Outcome wrong = run_program(controls(scene, file, {"--range", "pusch=-5:5"}));
    EXPECT_NE(wrong.err.find("nearest: \"push\""), std::string::npos) << wrong.err;
    write_text(scene, random_tug(R"(, "min": -10, "max": 10)"));
    EXPECT_EQ(run_program(controls(scene, file, {"--range", "push=-50:5"})).code, 1);
    EXPECT_EQ(run_program(controls(scene, file, {"--range", "push=5"})).code, 1);
}

TEST(Controls, SignalsOfSystems) {
    const auto folder = test_folder();
    const std::string file = folder / "a.csv", scene = "scenes/tow_payout.json";
    const Outcome none = run_program(controls("scenes/pendulum.json", file));
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("no inputs"), std::string::npos) << none.err;
    // The scene defines no inputs: its systems' signals are used without an option.
    const Outcome whole = run_program(controls(scene, file));
    EXPECT_EQ(whole.code, 0) << whole.err;
    EXPECT_NE(whole.err.find("signals of its systems"), std::string::npos) << whole.err;
    EXPECT_NE(read_text(file).find("winch.speed"), std::string::npos);
    const Outcome some = run_program(
        controls(scene, file,
                 {"--signals", "--range", "winch.speed=-2:2", "--range", "winch.tension=0:1e5"}));
    EXPECT_EQ(some.code, 0) << some.err;
    const Outcome run =
        run_program({"run", scene, "--duration", "0.1", "--quiet", "--control", file});
    EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Exercise, VerifiesItsSteps) {
    const auto folder = test_folder();
    // The exercise fails because no role acts; each step passes the verifier.
    const Outcome good = run_program({"exercise", "exercises/crane_lift.json", "--verify"});
    EXPECT_EQ(good.code, 4) << good.err;
    EXPECT_NE(good.out.find("verified"), std::string::npos) << good.out;
    const Outcome wrong =
        run_program({"exercise", "exercises/crane_lift.json", "--verify", "--replay", "r.hwr"});
    EXPECT_EQ(wrong.code, 1);
}

}  // namespace hawser::test
