// SPDX-License-Identifier: Apache-2.0
// Run `hawser validate` like a user and read its JSON.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string program() {
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    return (fs::path(folder != nullptr ? folder : "build/release/bin") / "hawser").string();
}

/// A folder, removed by the destructor.
struct Scratch {
    fs::path path = fs::temp_directory_path() / fmt::format("hawser_validate_{}", ::getpid());
    Scratch() { fs::create_directories(path); }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

struct Outcome {
    int code = -1;
    nlohmann::json results;
};

Outcome validate(const std::string& cases, const std::string& environment = "") {
    const Scratch scratch;
    const fs::path file = scratch.path / "results.json";
    const std::string command =
        fmt::format("{} '{}' validate {} --json '{}' > '{}' 2>&1", environment, program(), cases,
                    file.string(), (scratch.path / "log.txt").string());
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (fs::exists(file)) outcome.results = nlohmann::json::parse(std::ifstream(file));
    return outcome;
}

void expect_pass(const std::string& cases, std::size_t least_checks) {
    const Outcome outcome = validate(cases);
    EXPECT_EQ(outcome.code, 0);
    ASSERT_TRUE(outcome.results.contains("checks"));
    EXPECT_GE(outcome.results["checks"].size(), least_checks);
    for (const auto& check : outcome.results["checks"]) {
        EXPECT_TRUE(check["passed"].get<bool>()) << check.dump(2);
    }
}

}  // namespace

TEST(Validate, pendulum) { expect_pass("pendulum a01", 7); }
TEST(Validate, mechanisms) { expect_pass("n_four_bar bricard slider_crank", 10); }
TEST(Validate, andrews_squeezer) { expect_pass("andrews_squeezer", 7); }
TEST(Validate, spinning_bodies) { expect_pass("dzhanibekov heavy_top", 4); }
TEST(Validate, catenary) { expect_pass("catenary", 4); }
TEST(Validate, taut_string) { expect_pass("14", 3); }
TEST(Validate, hanging_chain) { expect_pass("hanging_chain", 4); }
TEST(Validate, buckling) { expect_pass("euler_column", 3); }
TEST(Validate, beams) { expect_pass("beams", 4); }
TEST(Validate, winches_full) { expect_pass("winches", 16); }
TEST(Validate, cranes) { expect_pass("cranes", 8); }
TEST(Validate, first_day_lines) { expect_pass("first_chains first_lines", 24); }
TEST(Validate, first_day_hulls_full) { expect_pass("first_waves", 15); }
TEST(Validate, first_day_rest) { expect_pass("first_drag first_memory first_warnings", 34); }
TEST(Validate, first_day_winches) { expect_pass("first_winches", 8); }
TEST(Validate, compliant_joints_full) { expect_pass("untuned", 30); }
TEST(Validate, first_day_routes) { expect_pass("first_routes", 9); }
TEST(Validate, momentum) { expect_pass("momentum", 3); }
TEST(Validate, scheme) { expect_pass("A.2.1 A.2.2 A.2.3 A.2.4 A.2.5 A.2.6 A.2.7", 20); }

TEST(Validate, friction) {
    expect_pass("incline belt rolling_sphere rolling_resistance spinning_disk painleve", 34);
}
TEST(Validate, capstan_full) { expect_pass("capstan", 7); }
TEST(Validate, tackle) { expect_pass("tackle", 3); }
TEST(Validate, bollard) { expect_pass("bollard", 3); }
TEST(Validate, joints_at_their_bounds) {
    expect_pass("joint_friction joint_limits motor_limits", 17);
}
TEST(Validate, bouncing_ball) { expect_pass("20", 6); }
TEST(Validate, stacks_and_walls) { expect_pass("stacks walls", 14); }

TEST(Validate, robust_wires) { expect_pass("long_wire wire_sway wires_come_taut", 72); }
TEST(Validate, zigzag_wires_full) { expect_pass("zigzag_wires", 41); }
TEST(Validate, joints) {
    expect_pass("repeated_joints overconstrained ships_on_chain long_motions governor", 37);
}
TEST(Validate, wires) {
    expect_pass("wire_catenary wire_touchdown wire_events wire_pulse tow_payout wire_resolution",
                145);
}
TEST(Validate, wires_that_part_full) { expect_pass("wire_parting wire_cross_parting", 32); }
TEST(Validate, payout_full) { expect_pass("payout", 82); }
TEST(Validate, sea) {
    expect_pass("sea_waves sea_box sea_periods sea_froude_krylov sea_drag sea_stability sea_sphere",
                37);
}
TEST(Validate, sea_statistics_full) { expect_pass("sea_statistics", 5); }
TEST(Validate, damping_orders) { expect_pass("damping_orders", 3); }

TEST(Validate, unknown_case_is_refused) { EXPECT_EQ(validate("no_such_case").code, 1); }

// A scene that differs from the description of its case must be detected: the rod is 1 % too long.
TEST(Validate, notices_a_wrong_scene) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("hawser_wrong_{}", ::getpid());
    fs::create_directories(folder);
    std::ifstream in("scenes/pendulum.json");
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const std::string right = "\"length\": 1,", start = "[-1, 0, 0]";
    ASSERT_NE(text.find(right), std::string::npos);
    ASSERT_NE(text.find(start), std::string::npos);
    text.replace(text.find(right), right.size(), "\"length\": 1.01,");
    text.replace(text.find(start), start.size(), "[-1.01, 0, 0]");
    std::ofstream(folder / "pendulum.json") << text;
    const Outcome outcome = validate("a01", "HAWSER_SCENES='" + folder.string() + "'");
    EXPECT_EQ(outcome.code, 3);
    ASSERT_TRUE(outcome.results.contains("checks"));
    EXPECT_FALSE(outcome.results["passed"].get<bool>());
    fs::remove_all(folder);
}
