// SPDX-License-Identifier: Apache-2.0
// `hawser-bench interface` as a program, in a short form: its JSON, and the bar that does not
// depend on time.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace hawser::bench {
namespace {

TEST(InterfaceProgram, TellsWhatReadingCosts_full) {
    namespace fs = std::filesystem;
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const std::string program = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
    if (!fs::exists(program)) GTEST_SKIP() << "hawser-bench is not in this build";
    const fs::path file =
        fs::temp_directory_path() / ("hawser_interface_" + std::to_string(::getpid()) + ".json");
    const std::string command =
        program + " interface scenes/box_stack.json --steps 5 --rounds 3 --outputs 20 --json " +
        file.string() + " > /dev/null 2> /dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    ASSERT_LE(WEXITSTATUS(status), 1);  // 1: a bar of time is missed
    std::ifstream stream(file);
    const nlohmann::json out = nlohmann::json::parse(stream, nullptr, false);
    fs::remove(file);
    ASSERT_FALSE(out.is_discarded());
    EXPECT_EQ(out.at("outputs"), 20);
    EXPECT_GT(out.at("contacts"), 0);
    EXPECT_GT(out.at("bytes"), 0);
    for (const char* time :
         {"state_ns", "outputs_us", "contacts_us", "save_ms", "restore_ms", "hash_ms", "step_ms"})
        EXPECT_GE(out.at(time).get<double>(), 0.0) << time;
    // A thousand idle systems cost more than none, by far more than the resolution of the clock.
    EXPECT_GT(out.at("idle_system_us").get<double>(), 0.0);
    bool no_copy = false, idle = false, good = true;
    for (const nlohmann::json& bar : out.at("bars")) {
        if (bar.at("bar") == "state") no_copy = bar.at("met");
        idle = idle || bar.at("bar") == "idle system";
        good = good && bar.at("met").get<bool>();
    }
    EXPECT_TRUE(no_copy);
    EXPECT_TRUE(idle);
    EXPECT_EQ(WEXITSTATUS(status), good ? 0 : 1);
}

}  // namespace
}  // namespace hawser::bench
