// SPDX-License-Identifier: Apache-2.0
/// `hawser-bench random` in a short form: cases have the stated kinds and repeat exactly, and the
/// monitor detects impossible motions.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace hawser::bench {
namespace {

class RandomProgram : public testing::Test {
  protected:
    void SetUp() override {
        const char* folder = std::getenv("HAWSER_BIN_DIR");
        program_ = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
        if (!std::filesystem::exists(program_)) GTEST_SKIP() << "hawser-bench is not in this build";
        stem_ = (std::filesystem::temp_directory_path() /
                 ("hawser_random_program_" + std::to_string(::getpid())))
                    .string();
    }
    void TearDown() override {
        for (const char* end : {".csv", ".json", ".scene", ".txt"})
            std::filesystem::remove(stem_ + end);
    }
    /// Run the program; its output goes to stem_ + ".txt". @return its exit code.
    [[nodiscard]] int run(const std::string& arguments) const {
        const std::string command =
            program_ + " random " + arguments + " > " + stem_ + ".txt 2> /dev/null";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    [[nodiscard]] std::string text(const char* end) const {
        std::ifstream in(stem_ + end);
        std::stringstream out;
        out << in.rdbuf();
        return out.str();
    }
    std::string program_, stem_;
};

TEST_F(RandomProgram, CountsWhatItMade_full) {
    const int code = run("--count 200 --seed 3 --json " + stem_ + ".json");
    ASSERT_TRUE(code == 0 || code == 1);
    const auto out = nlohmann::json::parse(text(".json"));
    const auto& all = out.at("categories").at("all");
    EXPECT_EQ(all.at("cases"), 200);
    EXPECT_EQ(all.at("ok").get<int>() + all.at("doubtful").get<int>() +
                  all.at("failed").get<int>() + all.at("refused").get<int>(),
              200);
    // At least a fifth of each kind, less three standard deviations of a sample of 200.
    for (const char* kind : {"repeated joints", "contradictory joints", "wires", "ratios of 1e6"})
        EXPECT_GE(out.at("categories").at(kind).at("cases").get<int>(), 28) << kind;
    EXPECT_EQ(out.at("wrong").size(), all.at("wrong").get<std::size_t>());
    const bool met = all.at("wrong") == 0 && all.at("consistent_ok").get<double>() >=
                                                 0.9 * all.at("consistent").get<double>();
    EXPECT_EQ(code, met ? 0 : 1);
}

TEST_F(RandomProgram, SaysWhyCasesDidNotEndOk_full) {
    (void)run("--count 200 --seed 3 --json " + stem_ + ".json --list " + stem_ + ".csv");
    const auto out = nlohmann::json::parse(text(".json"));
    const auto& all = out.at("categories").at("all");
    int reported = 0;
    for (const auto& reason : out.at("reasons")) {
        const int cases = reason.at("all");
        EXPECT_GT(cases, 0);
        EXPECT_LE(reason.at("unseen").get<int>(), cases);
        EXPECT_EQ(reason.at("contradictory joints"), 0);
        reported += cases;
    }
    int lines = 0, not_ok = 0, all_not_ok = 0;
    std::istringstream list(text(".csv"));
    std::string line;
    ASSERT_TRUE(std::getline(list, line));
    EXPECT_TRUE(line.starts_with("case,kinds,outcome,reason,")) << line;
    const auto commas = std::count(line.begin(), line.end(), ',');
    for (; std::getline(list, line); ++lines) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
        EXPECT_TRUE(line.starts_with(std::to_string(lines) + ",")) << line;
        const std::string kinds = line.substr(line.find(',') + 1, 5);
        const bool ok = line.find(",ok,,") != std::string::npos;
        not_ok += !ok && kinds[2] != 'C';
        all_not_ok += !ok;
    }
    EXPECT_EQ(lines, 200);
    EXPECT_EQ(not_ok, reported);
    EXPECT_EQ(all_not_ok, 200 - all.at("ok").get<int>());
    EXPECT_EQ(run("--count 1 --list /nowhere/at/all.csv"), 1);
}

TEST_F(RandomProgram, OneCaseComesOutTheSameAndIsAScene_full) {
    (void)run("--seed 9 --only 4");
    const std::string once = text(".txt");
    (void)run("--seed 9 --only 4");
    EXPECT_EQ(text(".txt"), once);
    EXPECT_NE(once.find("     4 "), std::string::npos) << once;
    ASSERT_EQ(run("--seed 9 --save 4 " + stem_ + ".scene"), 0);
    const auto scene = nlohmann::json::parse(text(".scene"));
    EXPECT_EQ(scene.at("version"), 1);
    const double step = scene.at("settings").at("step").get<double>();
    EXPECT_GE(step, 1.0 / 240.0);
    EXPECT_LE(step, 0.2);
    EXPECT_EQ(run("--save four " + stem_ + ".scene"), 1);
}

TEST_F(RandomProgram, RunsFamiliesOfGear_full) {
    for (const std::string family : {"winches", "guides", "hulls"}) {
        const std::string json_path = stem_ + ".json";
        const int code = run("--family " + family + " --count 12 --seed 5 --json " + json_path);
        const auto out = nlohmann::json::parse(text(".json"));
        EXPECT_EQ(out.at("cases"), 12);
        EXPECT_EQ(out.at("ok").get<int>() + out.at("suspect").get<int>() +
                      out.at("failed").get<int>() + out.at("refused").get<int>(),
                  12);
        EXPECT_EQ(code == 0, out.at("ok_but_wrong") == 0 && out.at("ok").get<int>() >= 11)
            << family;
        ASSERT_EQ(run("--family " + family + " --seed 5 --save 3 " + stem_ + ".scene"), 0);
        EXPECT_EQ(nlohmann::json::parse(text(".scene")).at("version"), 2);
    }
    EXPECT_EQ(run("--family boats"), 2);
}

/// Passive wires: cases repeat exactly, and steps come in turn.
TEST_F(RandomProgram, MakesPassiveWires) {
    for (const std::string family : {"passive_posts", "passive_guides", "passive_hanging"}) {
        std::string before;
        for (const char* number : {"4", "5", "4"}) {
            ASSERT_EQ(
                run("--family " + family + " --seed 2 --save " + number + " " + stem_ + ".scene"),
                0);
            const auto scene = nlohmann::json::parse(text(".scene"));
            const double step = scene.at("settings").at("step");
            EXPECT_DOUBLE_EQ(step, number[0] == '4' ? 1.0 / 30.0 : 0.05);
            EXPECT_FALSE(scene.contains("winches"));
            EXPECT_FALSE(scene.contains("sea"));
            if (before.empty()) before = scene.dump();
            EXPECT_EQ(scene.dump() == before, number[0] == '4');
        }
        const int code =
            run("--family " + family + " --seed 2 --count 3 --json " + stem_ + ".json");
        const auto out = nlohmann::json::parse(text(".json"));
        EXPECT_EQ(out.at("cases"), 3);
        EXPECT_EQ(out.at("refused"), 0);
        EXPECT_GE(out.at("wrong_by_energy"), 0);
        ASSERT_TRUE(code == 0 || code == 1);
    }
}

}  // namespace
}  // namespace hawser::bench
