// SPDX-License-Identifier: Apache-2.0
// Bounds of scenes, signals within a step, and invalid environment variables.
#include "cli/program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace hawser::test {
namespace {

/// Return a scene of balls at one point.
std::string heap_of_balls(int count, const std::string& settings) {
    std::string bodies;
    for (int i = 0; i < count; ++i)
        bodies += fmt::format(
            R"({}{{"name": "b{}", "position": [{}, {}, 0], "mass": 1, "sphere": 1,
                "shapes": [{{"kind": "sphere", "radius": 1}}]}})",
            i > 0 ? "," : "", i, 0.001 * i, 0.0007 * (i % 17));
    return fmt::format(R"({{"version": 1, "name": "heap", "settings": {{{}}}, "bodies": [{}]}})",
                       settings, bodies);
}

TEST(Limits, OfContactsAndMemoryFailARunAndAreNamed) {
    const auto folder = test_folder();
    const std::string scene = folder / "heap.json";
    write_text(scene, heap_of_balls(16, R"("max_contacts": 100)"));
    const Outcome run = run_program({"run", scene, "--unchecked", "--duration", "0.1"});
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_NE(run.err.find("120 contact points exceed max_contacts = 100"), std::string::npos)
        << run.err;
    EXPECT_NE(run.err.find("raise it"), std::string::npos) << run.err;
    const Outcome raised =
        run_program({"run", scene, "--unchecked", "--duration", "0.02", "--set",
                     "settings.max_contacts=120", "--set", "settings.on_diverged=\"warn\""});
    EXPECT_EQ(raised.code, 0) << raised.err;
    const Outcome small = run_program(
        {"run", "scenes/anchor_lines.json", "--set", "settings.max_memory=1e6", "--quiet"});
    EXPECT_EQ(small.code, 1) << small.err;
    EXPECT_NE(small.err.find("bytes exceed max_memory = 1000000"), std::string::npos) << small.err;
}

TEST(Limits, OfElementsRefuseASceneBeforeItIsBuilt) {
    const auto folder = test_folder();
    const std::string scene = folder / "many.json";
    write_text(scene, R"({"version": 1, "name": "many", "settings": {"max_bodies": 50},
        "line_types": {"t": {"mass_per_length": 1, "EA": 1e6}},
        "bodies": [{"name": "b", "position": [10, 0, 0], "mass": 1, "box": [1, 1, 1]}],
        "cables": [{"name": "l", "line_type": "t", "from": {"at": [0, 0, 0]},
                    "to": {"body": "b"}, "elements": 20}],
        "repeat": {"copies": 2, "offset": [0, 10, 0]}})");
    const auto with = [&](const char* set) {
        return run_program({"run", scene, "--duration", "0.02", "--quiet", "--set", set});
    };
    EXPECT_EQ(with("repeat.copies=2").code, 0);
    for (const char* set : {"repeat.copies=3", "cables.0.elements=30", "settings.max_bodies=20"}) {
        const Outcome run = with(set);
        EXPECT_EQ(run.code, 1) << set;
        EXPECT_NE(run.err.find("settings.max_bodies"), std::string::npos) << set << run.err;
    }
}

TEST(Limits, AnUnknownInstructionSetIsAnError) {
    for (const char* name : {"AVX2", "neon", "avx-512"}) {
        const Outcome run = run_program({"run", "scenes/pendulum.json", "--duration", "0.1"}, -1.0,
                                        {std::string("HAWSER_ISA=") + name});
        EXPECT_EQ(run.code, 1) << name;
        EXPECT_NE(run.err.find(name), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("sse2"), std::string::npos) << run.err;
    }
    EXPECT_EQ(run_program({"run", "scenes/pendulum.json", "--duration", "0.1", "--quiet"}, -1.0,
                          {"HAWSER_ISA=sse2"})
                  .code,
              0);
}

/// The first step with this many balls takes many seconds; the interrupt arrives within it.
TEST(Limits, AnInterruptEndsTheStepUnderWay) {
    const auto folder = test_folder();
    const std::string scene = folder / "heap.json";
    write_text(scene, heap_of_balls(500, R"("max_contacts": 400000)"));
    const auto begin = std::chrono::steady_clock::now();
    const Outcome run = run_program(
        {"run", scene, "--unchecked", "--summary", folder / "s.json", "--duration", "1"}, 2.0);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(run.code, 130) << run.err;
    const auto summary = nlohmann::json::parse(read_text(folder / "s.json"));
    EXPECT_EQ(summary["outcome"], "interrupted");
    EXPECT_EQ(summary["steps"], 0) << "or no step was under way";
    fmt::print("interrupted after 2 s, ended after {:.2f} s\n", took.count());
}

}  // namespace
}  // namespace hawser::test
