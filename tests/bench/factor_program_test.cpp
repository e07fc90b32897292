// SPDX-License-Identifier: Apache-2.0
// `hawser-bench factor` as a program: reads a file and writes the figures of every solver.
#include <gtest/gtest.h>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <regex>
#include <set>
#include <string>

#include "paper_matrix/structures.h"

namespace hawser::bench {
namespace {

void write_matrix_market(const Sparse& lower, const std::string& file) {
    std::ofstream out(file);
    out << "%%MatrixMarket matrix coordinate real symmetric\n"
        << lower.rows() << ' ' << lower.cols() << ' ' << lower.nonZeros() << '\n'
        << std::setprecision(17);
    for (int j = 0; j < lower.outerSize(); ++j)
        for (Sparse::InnerIterator it(lower, j); it; ++it)
            out << it.row() + 1 << ' ' << j + 1 << ' ' << it.value() << '\n';
}

class FactorProgram : public testing::Test {
  protected:
    /// Presets with sanitizers build no hawser-bench.
    void SetUp() override {
        const char* folder = std::getenv("HAWSER_BIN_DIR");
        program_ = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
        if (!std::filesystem::exists(program_)) GTEST_SKIP() << "hawser-bench is not in this build";
    }
    std::string program_;
};

TEST_F(FactorProgram, EverySolverSolvesAMatrixFromAFile_full) {
    const auto stem = std::filesystem::temp_directory_path() /
                      ("hawser_factor_program_" + std::to_string(::getpid()));
    const std::string matrix = stem.string() + ".mtx", json = stem.string() + ".json";
    write_matrix_market(tree_of_chains(4, 6).lower(), matrix);
    const std::string command = program_ + " factor --matrix " + matrix +
                                " --rounds 1 --threads 2 --json " + json + " > " + stem.string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    const nlohmann::json result = nlohmann::json::parse(std::ifstream(json)).at("matrices").at(0);
    std::set<std::string> solvers;
    for (const auto& tried : result.at("tried")) {
        EXPECT_FALSE(tried.contains("failure")) << tried.dump();
        solvers.insert(tried.at("solver"));
        // Bodies of 10 kg with rows of compliance 1e-9: the condition allows 1e-16 / 1e-9 / 1e3
        // with refinement, and three digits more for a chain of 90 links.
        EXPECT_LT(tried.value("error", 1.0), 1e-9) << tried.dump();
        EXPECT_GT(tried.value("total_ms", 0.0), 0.0);
    }
    EXPECT_EQ(solvers.count("hawser"), 1u);
    EXPECT_EQ(solvers.count("Eigen SimplicialLDLT"), 1u);
    for (const std::string& file : {matrix, json, stem.string()}) std::filesystem::remove(file);
}

/// The parts add up to the sum printed above them, the marked ones to the line below.
TEST_F(FactorProgram, SharesAddUp_full) {
    const std::string out = (std::filesystem::temp_directory_path() /
                             ("hawser_factor_shares_" + std::to_string(::getpid())))
                                .string();
    const std::string command =
        program_ + R"( factor --only "paper lumped" --shares --rounds 3 > )" + out;
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::regex head(".*condensed: ([0-9.]+) us"),
        part("  ([^*]+?) +([0-9.]+) +[0-9.]+ %( .*)?"),
        every("  \\* every solver runs it +([0-9.]+) .*"), update("  50 contacts changed: .* us");
    double all = 0.0, sum = 0.0, marked = 0.0, common = 0.0;
    int parts = 0, updates = 0;
    std::ifstream in(out);
    std::smatch m;
    for (std::string line; std::getline(in, line);) {
        if (std::regex_match(line, m, head)) {
            all = std::stod(m[1]);
        } else if (std::regex_match(line, m, every)) {
            common = std::stod(m[1]);
        } else if (std::regex_match(line, m, part)) {
            ++parts;
            sum += std::stod(m[2]);
            if (m[3].length() > 0) marked += std::stod(m[2]);
        }
        updates += std::regex_match(line, update) ? 1 : 0;
    }
    EXPECT_EQ(parts, 9);
    EXPECT_EQ(updates, 1);
    EXPECT_GT(common, 0.0);
    const double digits = 0.05 * (parts + 1);  // every figure is rounded to a tenth
    EXPECT_NEAR(sum, all, digits);
    EXPECT_NEAR(marked, common, digits);
    std::filesystem::remove(out);
}

}  // namespace
}  // namespace hawser::bench
