// SPDX-License-Identifier: Apache-2.0
// `hawser-bench factor` as a program: a file in, every solver's figures out.
#include <gtest/gtest.h>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
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

TEST(FactorProgram, EverySolverSolvesAMatrixFromAFile) {
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const std::string program = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
    if (!std::filesystem::exists(program)) GTEST_SKIP() << "hawser-bench is not in this build";
    const auto stem = std::filesystem::temp_directory_path() /
                      ("hawser_factor_program_" + std::to_string(::getpid()));
    const std::string matrix = stem.string() + ".mtx", json = stem.string() + ".json";
    write_matrix_market(tree_of_chains(4, 6).lower(), matrix);
    const std::string command = program + " factor --matrix " + matrix +
                                " --rounds 1 --threads 2 --json " + json + " > " + stem.string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    const nlohmann::json result = nlohmann::json::parse(std::ifstream(json)).at("matrices").at(0);
    std::set<std::string> solvers;
    for (const auto& tried : result.at("tried")) {
        EXPECT_FALSE(tried.contains("failure")) << tried.dump();
        solvers.insert(tried.at("solver"));
        // Bodies of 10 kg with rows of compliance 1e-9: the condition allows 1e-16 / 1e-9 / 1e3,
        // refinement included, and another three digits for 90 links in a row.
        EXPECT_LT(tried.value("error", 1.0), 1e-9) << tried.dump();
        EXPECT_GT(tried.value("total_ms", 0.0), 0.0);
    }
    EXPECT_EQ(solvers.count("hawser"), 1u);
    EXPECT_EQ(solvers.count("Eigen SimplicialLDLT"), 1u);
    for (const std::string& file : {matrix, json, stem.string()}) std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser::bench
