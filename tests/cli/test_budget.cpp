// SPDX-License-Identifier: Apache-2.0
// Budgets and verification of the program.
#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hawser::test {
namespace {

using Json = nlohmann::json;

TEST(Budget, CutStepsAreRecordedAndReplayed) {
    const auto folder = test_folder();
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"run",       "scenes/arch.json", "--duration", "0.5",
                                       "--summary", folder / "s.json",  "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return Json::parse(read_text(folder / "s.json"));
    };
    for (const auto& budget :
         {std::pair{"--budget", "0.001"}, std::pair{"--budget-work", "0.01"}}) {
        const Json s = run({budget.first, budget.second, "--record", folder / "r.hwr"});
        EXPECT_GT(s["budget"]["cut_steps"].get<int>(), 5) << budget.first;
        EXPECT_GE(s["budget"]["residual"]["max"], s["budget"]["residual"]["p50"]);
        const Json& d = s["degradations"];
        EXPECT_EQ(d["steps"], s["budget"]["cut_steps"]);
        EXPECT_EQ(d["steps"].get<int>(), d["causes"]["prediction"].get<int>() +
                                             d["causes"]["clock"].get<int>() +
                                             d["causes"]["work"].get<int>());
        std::int64_t listed = 0;
        for (const Json& span : d["list"])
            listed +=
                span["last_step"].get<std::int64_t>() - span["first_step"].get<std::int64_t>() + 1;
        EXPECT_EQ(listed, d["steps"].get<std::int64_t>());
        EXPECT_EQ(d["friction"]["first_step"], d["list"][0]["first_step"]);
        const Outcome replay = run_program({"replay", folder / "r.hwr", "--threads", "2"});
        EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
    }
    const Json one = run({"--budget-work", "0.01"});
    EXPECT_EQ(one["state_hash"], run({"--budget-work", "0.01", "--threads", "2"})["state_hash"]);
    // Run in two parts.
    (void)run({"--budget-work", "0.01", "--save-at", "0.25", folder / "half.hws"});
    EXPECT_EQ(one["state_hash"],
              run({"--budget-work", "0.01", "--restore", folder / "half.hws"})["state_hash"]);
}

TEST(Budget, OpensCutsWhereNothingElseFitsAndReplaysThem) {
    const auto folder = test_folder();
    // No step fits the budget. A cut is made only if the cut matrix is 5 % cheaper, which holds for
    // these lines.
    const Outcome outcome = run_program(
        {"run", "bench/scenes/frozen/anchor_lines.json", "--duration", "0.6", "--budget", "0.001",
         "--coupling", "deadline", "--record", folder / "r.hwr", "--summary", folder / "s.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("degraded"), std::string::npos) << outcome.out;
    const Json d = Json::parse(read_text(folder / "s.json"))["degradations"];
    EXPECT_GT(d["coupling"]["steps"].get<int>(), 5);
    EXPECT_GE(d["coupling"]["interfaces"].get<int>(), 1);
    EXPECT_EQ(d["coupling"]["steps"], d["causes"]["prediction"]);
    EXPECT_EQ(d["friction"]["steps"], 0);
    const Outcome replay = run_program({"replay", folder / "r.hwr", "--threads", "2"});
    EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
}

/// Also for a scene without cuts: mooring is one group.
TEST(Verify, NeedsExactCoupling) {
    for (const char* coupling : {"kinematic", "compliant", "deadline"}) {
        const Outcome outcome = run_program({"run", "scenes/mooring.json", "--duration", "0.1",
                                             "--coupling", coupling, "--verify"});
        EXPECT_EQ(outcome.code, 1) << coupling;
        EXPECT_NE(outcome.err.find("use --coupling exact"), std::string::npos) << outcome.err;
    }
    const Outcome exact = run_program({"run", "scenes/mooring.json", "--duration", "0.1", "--quiet",
                                       "--coupling", "exact", "--verify"});
    EXPECT_EQ(exact.code, 0) << exact.err;
}

TEST(Budget, IsRefusedByOtherMethods) {
    for (const auto* method : {"pivoting", "split", "pgs", "convex"}) {
        const Outcome outcome = run_program({"run", "scenes/arch.json", "--duration", "0.1",
                                             "--budget", "5", "--nonsmooth", method});
        EXPECT_EQ(outcome.code, 1) << method;
        EXPECT_NE(outcome.err.find("a budget needs the nonsmooth method newton"), std::string::npos)
            << outcome.err;
    }
}

TEST(Verify, SaysWhatItComputed) {
    const auto folder = test_folder();
    const Outcome outcome = run_program({"run", "scenes/belt.json", "--duration", "0.5", "--verify",
                                         "--summary", folder / "s.json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("verified"), std::string::npos);
    const Json s = Json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(s["verified"]["verified_steps"], 30);
    EXPECT_EQ(s["verified"]["covered_bodies"], 4);
}

}  // namespace
}  // namespace hawser::test
