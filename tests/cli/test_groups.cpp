// SPDX-License-Identifier: Apache-2.0
// Groups that follow the state, through the program.
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hawser::test {
namespace {

using Json = nlohmann::json;

TEST(Groups, ThatChangeInARunAreReplayedAndRestored) {
    const auto folder = test_folder();
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"run",        "bench/scenes/frozen/anchor_lines.json",
                                       "--duration", "0.6",
                                       "--coupling", "kinematic",
                                       "--parts",    "4",
                                       "--set",      "settings.regroup_every=10",
                                       "--summary",  folder / "s.json",
                                       "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return Json::parse(read_text(folder / "s.json"));
    };
    const Json one = run({"--predictor", "clique", "--record", folder / "r.hwr", "--threads", "1"});
    EXPECT_GT(one["groups"]["regroupings"].get<int>(), 0);
    EXPECT_GT(one["groups"]["bodies_moved"].get<int>(), 0);
    for (const char* threads : {"1", "2"}) {
        const Outcome replay = run_program({"replay", folder / "r.hwr", "--threads", threads});
        EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
    }
    // Run in two parts, with an update of groups in each.
    (void)run({"--predictor", "clique", "--save-at", "0.25", folder / "half.hws"});
    EXPECT_EQ(one["state_hash"],
              run({"--predictor", "clique", "--restore", folder / "half.hws"})["state_hash"]);
}

}  // namespace
}  // namespace hawser::test
