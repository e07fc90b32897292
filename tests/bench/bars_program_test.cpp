// SPDX-License-Identifier: Apache-2.0
// `hawser-bench partition`, `coupling` and `deadline` as programs, in a short form: their JSON, and
// the bars that do not depend on time.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace hawser::bench {
namespace {

using Figures = nlohmann::json;

class BarsProgram : public testing::Test {
  protected:
    void SetUp() override {
        const char* folder = std::getenv("HAWSER_BIN_DIR");
        program_ = std::string(folder == nullptr ? "." : folder) + "/hawser-bench";
        if (!std::filesystem::exists(program_)) GTEST_SKIP() << "hawser-bench is not in this build";
    }

    /// Run the program. @return its JSON. The exit code is 0 if all bars are met and 1 otherwise.
    [[nodiscard]] Figures run(const std::string& arguments) const {
        const auto stem = std::filesystem::temp_directory_path() /
                          ("hawser_bars_program_" + std::to_string(::getpid()));
        const std::string file = stem.string() + ".json";
        const std::string command =
            program_ + " " + arguments + " --json " + file + " > /dev/null 2> /dev/null";
        const int status = std::system(command.c_str());
        EXPECT_TRUE(WIFEXITED(status)) << arguments;
        std::ifstream stream(file);
        Figures out = Figures::parse(stream, nullptr, false);
        std::filesystem::remove(file);
        EXPECT_FALSE(out.is_discarded()) << arguments;
        if (out.is_discarded()) return {};
        bool good = true;
        for (const Figures& v : out.at("verdicts")) {
            good = good && v.at("met").get<bool>();
            EXPECT_FALSE(v.at("what").get<std::string>().empty()) << v.dump();
        }
        EXPECT_EQ(WEXITSTATUS(status), good ? 0 : 1) << out.at("verdicts").dump();
        return out;
    }

    /// Return for each quantity of a bar whether it is met.
    [[nodiscard]] static std::map<std::string, bool> bar(const Figures& out,
                                                         const std::string& name) {
        std::map<std::string, bool> met;
        for (const Figures& v : out.at("verdicts"))
            if (v.at("bar") == name) met[v.at("of")] = v.at("met");
        return met;
    }

    std::string program_;
};

TEST_F(BarsProgram, PartitionJudgesThePapersGraphs_full) {
    const Figures out = run("partition --quick");
    const std::map<std::string, bool> both{{"paper lumped", true}, {"paper rigid", true}};
    EXPECT_EQ(bar(out, "imbalance"), both);
    EXPECT_EQ(bar(out, "fill"), both);
    ASSERT_EQ(out.at("cases").size(), 2U);
    for (const Figures& c : out.at("cases")) {
        std::set<std::string> methods;
        for (const Figures& row : c.at("rows")) {
            methods.insert(row.at("method"));
            EXPECT_GT(row.at("seconds").get<double>(), 0.0) << row.dump();
            EXPECT_GT(row.at("factor_ms").get<double>(), 0.0) << row.dump();
            EXPECT_GE(row.at("imbalance").get<double>(), 1.0) << row.dump();
        }
        for (const char* m : {"AMD", "ours, model cost", "ours, exact cost"})
            EXPECT_EQ(methods.count(m), 1U) << m;
        EXPECT_GT(c.at("times").at("graph_seconds").get<double>(), 0.0);
        EXPECT_GT(c.at("update_seconds").get<double>(), 0.0);
        if (methods.count("METIS k-way") == 0) continue;
        for (const char* threads : {"1", "2"}) {
            const Figures& t = c.at("factor_and_solve").at(threads);
            for (const char* who : {"ours_seconds", "metis_seconds", "amd_seconds"})
                EXPECT_GT(t.at(who).get<double>(), 0.0) << who;
        }
        // Bars for two threads exist only if the machine had a second processor.
        for (const char* b : {"full_partition", "update", "factor_and_solve_1"})
            EXPECT_EQ(bar(out, b).count(c.at("name")), 1U) << b;
    }
    ASSERT_EQ(out.at("scenes").size(), 2U);
    for (const Figures& s : out.at("scenes")) {
        EXPECT_GT(s.at("cuts").get<int>(), 0) << s.dump();
        for (const char* stage : {"graph_seconds", "weight_seconds", "cut_seconds"})
            EXPECT_GT(s.at(stage).get<double>(), 0.0) << stage;
    }
}

TEST_F(BarsProgram, CouplingTellsWhatItMeasuredAndNothingElse_full) {
    const Figures out = run("coupling scenes/heavy_hook.json --quick");
    const std::map<std::string, bool> boundary{{"two bodies", true}},
        hook{{"scenes/heavy_hook.json", true}};
    EXPECT_EQ(bar(out, "stability_boundary"), boundary);
    EXPECT_EQ(bar(out, "momentum_defect"), hook);
    EXPECT_EQ(bar(out, "exact_step_time").size(), 1U);
    const Figures& modes = out.at("scenes").at(0).at("modes");
    ASSERT_EQ(modes.size(), 7U);
    for (const Figures& m : modes) {
        const bool exact = m.at("mode") == "exact", lost = !m.at("lost_at").is_null();
        for (const char* threads : {"1", "2"})
            EXPECT_GT(m.at("threads").at(threads).at("step_ms").get<double>(), 0.0) << m.dump();
        for (const char* threads : {"4", "8", "16"})
            EXPECT_GT(m.at("simulated_step_ms").at(threads).get<double>(), 0.0) << m.dump();
        EXPECT_EQ(m.at("cuts").get<int>() == 0, exact) << m.dump();
        EXPECT_EQ(m.at("interface_residual").is_null(), exact);
        EXPECT_EQ(m.at("tension_error").at("rms").is_null(), exact);
        EXPECT_EQ(m.at("jerk").at("difference").is_null(),
                  exact || m.at("jerk").at("run").is_null());
        EXPECT_EQ(m.at("spectral_radius").is_null(), lost);
        EXPECT_TRUE(m.at("largest_stable_stiffness").at("stable").is_null());  // not requested
        if (exact) {
            EXPECT_FALSE(lost);
            EXPECT_GT(m.at("jerk").at("run").get<double>(), 0.0);
        } else {
            EXPECT_GT(m.at("momentum_defect").at("max").get<double>(), 1e-12) << m.dump();
        }
    }
}

/// A budget of 0.1 ms is less than a full step of the load takes on any machine.
TEST_F(BarsProgram, DeadlineJudgesAShortRun_full) {
    const Figures out =
        run("deadline scenes/heavy_hook.json --control '' --stacks 10 --steps 100 --budget 0.1");
    EXPECT_EQ(out.at("verdicts").size(), 9U);
    const std::map<std::string, bool> met{{"", true}};
    for (const char* b : {"degraded_under_load", "momentum", "joints", "penetration", "speed",
                          "energy", "repeatable"})
        EXPECT_EQ(bar(out, b), met) << b;
    for (const char* run : {"exact", "budget"})
        for (const char* phase : {"before", "load", "after"}) {
            const Figures& f = out.at(run).at(phase);
            EXPECT_GT(f.at("solver_cpu_ms").at("p50").get<double>(), 0.0);
            EXPECT_EQ(f.at("contacts").get<int>() >= 80, std::string(phase) == "load")
                << "ten stacks of two boxes have 80 contact points";
        }
    EXPECT_EQ(out.at("exact").at("load").at("degraded"), 0);
}

}  // namespace
}  // namespace hawser::bench
