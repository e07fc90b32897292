// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace hawser::test {

using nlohmann::json;

/// Whether it holds 0 … n − 1, each once.
bool is_permutation_of(std::vector<int> order, std::size_t n) {
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < order.size(); ++k)
        if (order[k] != static_cast<int>(k)) return false;
    return order.size() == n;
}

class Figures : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder =
            std::filesystem::temp_directory_path() / ("hawser_figures_" + std::to_string(getpid()));
        std::filesystem::remove_all(folder);
        outcome = run_program(
            {"figures", "scenes/mooring.json", "-o", folder, "--at", "0.2", "--samples", "3"});
    }
    static void TearDownTestSuite() { std::filesystem::remove_all(folder); }

    static json data(const std::string& name) {
        return json::parse(read_text(folder / (name + ".json")));
    }
    static std::filesystem::path folder;
    static Outcome outcome;
};
std::filesystem::path Figures::folder;
Outcome Figures::outcome;

TEST_F(Figures, WriteAPictureInTwoFormsAndItsDataForEachPanel) {
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    int panels = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        ++panels;
        for (const char* extension : {".svg", ".png"}) {
            const auto picture = std::filesystem::path(entry.path()).replace_extension(extension);
            ASSERT_TRUE(std::filesystem::exists(picture)) << picture;
            EXPECT_GT(std::filesystem::file_size(picture), 2000u) << picture;
        }
        const json d = data(entry.path().stem().string());
        SCOPED_TRACE(entry.path().string());
        EXPECT_EQ(d["scene"], "mooring");
        EXPECT_EQ(d["scene_hash"].get<std::string>().size(), 16u);
        EXPECT_NE(d["command"].get<std::string>().find("hawser figures scenes/mooring.json"),
                  std::string::npos);
        for (const char* key : {"figure", "panel", "title", "instruction_set", "version", "time"})
            EXPECT_TRUE(d.contains(key)) << key;
    }
    EXPECT_GE(panels, 5);
    for (const char* page : {"fig1.svg", "fig1.png", "fig2.svg", "fig2.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / page)) << page;
}

TEST_F(Figures, MatricesAreWhatTheirNumbersSay) {
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* name : {"fig2_full_natural", "fig2_full_amd", "fig2_full_metis"}) {
        SCOPED_TRACE(name);
        const json d = data(name);
        if (d.contains("missing")) continue;  // a build without METIS
        const auto size = d["node_size"].get<std::vector<int>>();
        EXPECT_TRUE(is_permutation_of(d["permutation"], size.size()));
        long n = 0, nnz = 0;
        for (const int s : size) n += s, nnz += s * (s + 1) / 2;
        for (const auto& e : d["edges"])
            nnz += size[e[0].get<std::size_t>()] * size[e[1].get<std::size_t>()];
        EXPECT_EQ(d["n"].get<long>(), n);
        EXPECT_EQ(d["nnz"].get<long>(), nnz);
        EXPECT_EQ(d["nnz"], d["solver"]["nnz"]);
        EXPECT_LE(d["nnz"], d["factor_nnz"]);
        EXPECT_LE(d["factor_nnz"], d["solver"]["factor_nnz"]);
        EXPECT_LE(d["flops"], d["solver"]["flops"]);
        EXPECT_GT(d["factor_ms"].get<double>(), 0.0);
        EXPECT_EQ(d["nnz"], data("fig1_matrix")["nnz"]);
    }
    // Of an order that keeps rows after bodies, AMD's has the least fill on a line.
    EXPECT_LE(data("fig2_full_amd")["factor_nnz"], data("fig2_full_natural")["factor_nnz"]);
}

TEST(FiguresCommand, SaysWhatIsMissing) {
    const Outcome o = run_program({"figures", "scenes/no_such.json"});
    EXPECT_EQ(o.code, 1);
    EXPECT_NE(o.err.find("no_such.json"), std::string::npos);
}

}  // namespace hawser::test
