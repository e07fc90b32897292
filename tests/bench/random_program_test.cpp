// SPDX-License-Identifier: Apache-2.0
/// `hawser-bench random` in a short form: its cases are what it says, come out the same, and its
/// judge tells motions that cannot be.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

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
        for (const char* end : {".json", ".scene", ".txt"}) std::filesystem::remove(stem_ + end);
    }
    /// @return its exit code; what it says is in stem_ + ".txt".
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

TEST_F(RandomProgram, CountsWhatItMade) {
    const int code = run("--count 200 --seed 3 --json " + stem_ + ".json");
    ASSERT_TRUE(code == 0 || code == 1);
    const auto out = nlohmann::json::parse(text(".json"));
    const auto& all = out.at("categories").at("all");
    EXPECT_EQ(all.at("cases"), 200);
    EXPECT_EQ(all.at("ok").get<int>() + all.at("doubtful").get<int>() +
                  all.at("failed").get<int>() + all.at("refused").get<int>(),
              200);
    // A fifth of each at least, less what chance takes of 200 (three standard deviations).
    for (const char* kind : {"repeated joints", "contradictory joints", "wires", "ratios of 1e6"})
        EXPECT_GE(out.at("categories").at(kind).at("cases").get<int>(), 28) << kind;
    EXPECT_EQ(out.at("wrong").size(), all.at("wrong").get<std::size_t>());
    const bool met = all.at("wrong") == 0 && all.at("consistent_ok").get<double>() >=
                                                 0.9 * all.at("consistent").get<double>();
    EXPECT_EQ(code, met ? 0 : 1);
}

TEST_F(RandomProgram, OneCaseComesOutTheSameAndIsAScene) {
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

}  // namespace
}  // namespace hawser::bench
