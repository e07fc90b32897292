// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

namespace hawser::test {

TEST(Messages, FilesOfAnotherKindAreNamed) {
    const auto folder = test_folder();
    const std::string scene = "scenes/pendulum.json", run = folder / "r.hwr", state = folder / "s";
    ASSERT_EQ(run_program({"run", scene, "--duration", "0.1", "--quiet", "--record", run,
                           "--save-at", "0.1", state})
                  .code,
              0);
    const auto says = [](const std::vector<std::string>& line, const std::string& words) {
        const Outcome o = run_program(line);
        EXPECT_EQ(o.code, 1) << words;
        EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
    };
    says({"run", run}, "this is a recording, not a scene; `hawser view " + run + "` plays it");
    says({"check", run}, "this is a recording, not a scene");
    says({"exercise", run}, "this is a recording, not an exercise");
    says({"run", "exercises/crane_lift.json"}, "`hawser exercise exercises/crane_lift.json`");
    says({"exercise", scene}, "this is a scene, not an exercise; `hawser run " + scene + "`");
    says({"replay", scene}, "this is a scene, not a recording; `hawser run " + scene + "`");
    says({"replay", state}, "this is a saved state, not a recording");
    says({"run", scene, "--restore", run}, "this is a recording, not a saved state");
    says({"run", scene, "--control", run}, "this is a recording, not a control file");
    says({"run", scene, "--restore", scene}, "this is a scene, not a saved state");
}

}  // namespace hawser::test
