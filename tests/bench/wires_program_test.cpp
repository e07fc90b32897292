// SPDX-License-Identifier: Apache-2.0
// `hawser-bench wires --quick` as a program: its JSON, and Euler's ratio of routes and of a guide.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace hawser::bench {
namespace {

TEST(WiresProgram, OursSlipWhereEulerSays_full) {
    namespace fs = std::filesystem;
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const std::string program = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
    if (!fs::exists(program)) GTEST_SKIP() << "hawser-bench is not in this build";
    const fs::path file =
        fs::temp_directory_path() / ("hawser_wires_" + std::to_string(::getpid()) + ".json");
    const std::string command = program + " wires --quick --engines hawser --json " +
                                file.string() + " > /dev/null 2> /dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    std::ifstream stream(file);
    const nlohmann::json out = nlohmann::json::parse(stream, nullptr, false);
    fs::remove(file);
    ASSERT_FALSE(out.is_discarded());
    EXPECT_EQ(out.at("units").at("creep_m"), "m");
    EXPECT_TRUE(out.at("good").get<bool>());
    int routes = 0, guides = 0, segments = 0;
    for (const nlohmann::json& row : out.at("rows")) {
        const std::string method = row.at("method");
        ASSERT_TRUE(row.at("holds").get<bool>()) << row.dump();
        EXPECT_EQ(row.at("substeps"), 1) << "ours needs none";
        EXPECT_GT(row.at("ms_per_frame").get<double>(), 0.0);
        const double euler = std::exp(0.25 * 2.0 * M_PI * row.at("turns").get<double>());
        const double error = row.at("slip_ratio").get<double>() / euler - 1.0;
        EXPECT_NEAR(row.at("capstan_error").get<double>(), error, 1e-12);
        if (method.rfind("hawser-route", 0) == 0) {
            ++routes;
            EXPECT_LE(std::abs(error), 1e-4) << method;
            EXPECT_LE(row.at("creep_m").get<double>(), 1e-9) << method;
        } else if (method == "hawser-guide") {
            ++guides;
            EXPECT_LE(std::abs(error), 1e-4) << method;
        } else {
            ++segments;
            // A polygon slips at the force balance of its nodes, which differs from Euler's ratio.
            // At three turns each of the 16 elements turns by 67 degrees, and its nodes have moved
            // before they slip: 4 %.
            const double own = row.at("capstan_error_of_geometry");
            EXPECT_LT(own, 0.0) << method;
            EXPECT_NEAR((1.0 + error) / (1.0 + own), 1.0, 0.06) << method;
        }
    }
    EXPECT_EQ(routes, 9) << "three routes on half a turn, one and a half and three";
    EXPECT_EQ(guides, 3);
    EXPECT_EQ(segments, 3);
}

TEST(WiresProgram, RefusesEnginesThatThereAreNot_full) {
    namespace fs = std::filesystem;
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const std::string program = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
    if (!fs::exists(program)) GTEST_SKIP() << "hawser-bench is not in this build";
    const int status =
        std::system((program + " wires --engines hauser > /dev/null 2> /dev/null").c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
}

}  // namespace
}  // namespace hawser::bench
