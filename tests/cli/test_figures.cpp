// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace hawser::test {

using nlohmann::json;

/// True if it contains 0 … n − 1, each once.
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
        outcome = run_program({"figures", "scenes/mooring.json", "-o", folder, "--at", "0.2",
                               "--samples", "3", "--most-gflop", "0.5"});
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
        const json d = data(entry.path().stem().string());
        // A panel of an ordering that this build lacks contains one line with the reason.
        const std::uintmax_t least = d.contains("missing") ? 500 : 2000;
        for (const char* extension : {".svg", ".png"}) {
            const auto picture = std::filesystem::path(entry.path()).replace_extension(extension);
            ASSERT_TRUE(std::filesystem::exists(picture)) << picture;
            EXPECT_GT(std::filesystem::file_size(picture), least) << picture;
        }
        SCOPED_TRACE(entry.path().string());
        EXPECT_EQ(d["scene"], "mooring");
        EXPECT_EQ(d["scene_hash"].get<std::string>().size(), 16u);
        EXPECT_NE(d["command"].get<std::string>().find("hawser figures scenes/mooring.json"),
                  std::string::npos);
        for (const char* key : {"figure", "panel", "title", "instruction_set", "version", "time"})
            EXPECT_TRUE(d.contains(key)) << key;
    }
    EXPECT_EQ(panels, 11);
    for (const char* page : {"fig1.svg", "fig1.png", "fig2.svg", "fig2.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / page)) << page;
}

TEST_F(Figures, MatricesAreWhatTheirNumbersSay) {
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* name : {"fig2_full_natural", "fig2_full_amd", "fig2_full_metis",
                             "fig2_split_natural", "fig2_split_amd", "fig2_split_metis"}) {
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
        EXPECT_LE(d["nnz"], d["factor_nnz"]);
        const bool whole = std::string(name).find("full") != std::string::npos;
        EXPECT_EQ(d["nnz"], data(whole ? "fig1_matrix" : "fig1_split_matrix")["nnz"]);
        if (d["ordering"] == "natural" && d["factor_samples"] == 0) continue;  // too much work
        EXPECT_EQ(d["nnz"], d["solver"]["nnz"]);
        EXPECT_LE(d["factor_nnz"], d["solver"]["factor_nnz"]);
        EXPECT_LE(d["flops"], d["solver"]["flops"]);
        EXPECT_GT(d["factor_ms"].get<double>(), 0.0);
        EXPECT_EQ(d["part_factor_ms"].size(), whole ? 1u : 4u);
    }
    // Among orders that keep rows after bodies, AMD has the least fill on a line.
    EXPECT_LE(data("fig2_full_amd")["factor_nnz"], data("fig2_full_natural")["factor_nnz"]);
}

// Every body is in the part shown by the cut graph. Cut rows are in several parts, and no block
// joins two parts.
TEST_F(Figures, SplitMatrixIsBlockDiagonal) {
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json split = data("fig1_split_matrix"), whole = data("fig1_matrix");
    const auto part = split["node_part"].get<std::vector<int>>();
    const auto origin = split["node_origin"].get<std::vector<std::size_t>>();
    for (const auto& e : split["edges"])
        EXPECT_EQ(part[e[0].get<std::size_t>()], part[e[1].get<std::size_t>()]);
    std::vector<int> copies(whole["node_size"].size(), 0);
    for (const std::size_t node : origin) ++copies[node];
    int cut = 0;
    for (std::size_t v = 0; v < copies.size(); ++v) {
        if (whole["node_sign"][v].get<int>() > 0)
            EXPECT_EQ(copies[v], 1) << v;
        else
            EXPECT_GE(copies[v], 1) << v;
        cut += copies[v] > 1;
    }
    const json graph = data("fig1_cut_graph");
    EXPECT_EQ(graph["cut_count"].get<int>(), cut);
    EXPECT_EQ(graph["cuts"].size(), static_cast<std::size_t>(cut));
    EXPECT_GT(cut, 0);
    EXPECT_EQ(graph["bodies"].size(), data("fig1_graph")["bodies"].size());
}

TEST_F(Figures, TimelinesSayWhatIsSimulated) {
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    int simulated = 0;
    const json timelines = data("fig2_timelines")["timelines"];
    for (const auto& t : timelines) {
        if (t.contains("missing")) continue;
        EXPECT_EQ(t["simulated"].get<bool>(),
                  t["name"].get<std::string>().find("SIMULATED") != std::string::npos);
        simulated += t["simulated"].get<bool>();
        EXPECT_GT(t["ms"].get<double>(), 0.0);
        for (const auto& s : t["segments"]) {
            EXPECT_LT(s[0].get<int>(), t["threads"].get<int>());
            EXPECT_LE(s[1].get<double>(), s[2].get<double>());
            EXPECT_LE(s[2].get<double>(), t["ms"].get<double>() + 1e-9);  // rounding of ms
        }
    }
    EXPECT_GE(simulated, 1);
}

TEST(FiguresCommand, SaysWhatIsMissing) {
    const Outcome o = run_program({"figures", "scenes/no_such.json"});
    EXPECT_EQ(o.code, 1);
    EXPECT_NE(o.err.find("no_such.json"), std::string::npos);
}

}  // namespace hawser::test
