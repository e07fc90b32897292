// SPDX-License-Identifier: Apache-2.0
/// Figures of short runs of all shipped scenes, compared with those of an earlier commit
/// (CONTRIBUTING.md, "Golden files"). Any change of results fails here; review it, then run
/// scripts/write_golden.sh.
#include "golden/figure_file.h"
#include "golden/scene_run.h"
#include "scene/good_scenes.h"

#include <hawser/hawser.h>
#include <hawser/machine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string_view>

namespace hawser::golden {
namespace {

const std::filesystem::path kFile = "tests/golden/scene_figures.json";

/// Return the names of the entries: "format_<n>" for scenes that use all parts of the format,
/// otherwise the name of a file in scenes/.
std::vector<std::string> scene_names() {
    // Scenes with more bodies take longer to load than a quick test allows.
    const std::set<std::string> too_large{"anchor_run_fine"};
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& file : std::filesystem::directory_iterator("scenes", ignored)) {
        const std::string name = file.path().stem().string();
        if (file.path().extension() == ".json" && !name.ends_with(".settled") &&
            !too_large.contains(name))
            names.push_back(name);
    }
    for (std::size_t i = 0; i < scene::test::kGoodScenes.size(); ++i)
        names.push_back("format_" + std::to_string(i + 1));
    std::sort(names.begin(), names.end());
    return names;
}

scene::Scene load(const std::string& name) {
    constexpr std::string_view kFormat = "format_";
    if (!name.starts_with(kFormat)) return scene::load_file("scenes/" + name + ".json");
    const std::size_t number = std::stoul(name.substr(kFormat.size()));
    scene::Options options;
    options.set = {"settings.on_diverged=warn"};  // Some of them start with open joints.
    return scene::load_text(scene::test::kGoodScenes.at(number - 1), "scenes/" + name, options);
}

const Entries& references() {
    static const Entries entries = read_entries(kFile);
    return entries;
}

/// Write the figures instead of comparing them: a new reference with SSE2, its tolerances with any
/// other instruction set.
void write(const std::string& name, const Figures& figures, int steps) {
    static Entries entries = read_entries(kFile);
    if (std::string_view(instruction_set()) == "sse2") {
        entries[name] = entry_of(figures, steps);
    } else {
        const auto [figure, most] = widen(entries.at(name), figures);
        constexpr double kReported = 1e-9;
        if (most > kReported)
            std::printf("%-26s %-7s differs by %.1e of the scale in %s\n", name.c_str(),
                        instruction_set(), most, figure.c_str());
        constexpr double kMaxDifference = 2e-5;
        EXPECT_LE(most, kMaxDifference) << name << ": give it fewer steps in the file";
    }
    write_entries(kFile, entries);
}

class SceneFigures : public testing::TestWithParam<std::string> {};

TEST_P(SceneFigures, AreThoseOfTheFile) {
    const std::string& name = GetParam();
    scene::Scene scene = load(name);
    const auto found = references().find(name);
    const int steps =
        found != references().end() ? found->second.steps : default_steps(scene.world);
    const Figures figures = run_scene(std::move(scene), steps);
    if (std::getenv("HAWSER_WRITE_GOLDEN") != nullptr) return write(name, figures, steps);
    ASSERT_NE(found, references().end())
        << "the scene has no figures yet; run scripts/write_golden.sh";
    const std::string differences = compare(found->second, figures);
    EXPECT_TRUE(differences.empty())
        << name << " with " << instruction_set() << ", " << steps << " steps:\n"
        << differences << "If this change is meant, run scripts/write_golden.sh.";
}

INSTANTIATE_TEST_SUITE_P(All, SceneFigures, testing::ValuesIn(scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(SceneFigureFile, HasNoEntryWithoutScene) {
    const std::vector<std::string> names = scene_names();
    for (const auto& [name, entry] : references())
        EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
}

TEST(SceneFigureFile, CompareFindsEachDifference) {
    Figures figures;
    figures.texts["status"] = "ok";
    figures.counts["bodies"] = 3;
    figures.reals["force"] = {5.0, 10.0};
    const Entry entry = entry_of(figures, 1);
    EXPECT_EQ(compare(entry, figures), "");
    Figures other = figures;
    other.reals["force"].value += 2e-8;
    EXPECT_NE(compare(entry, other), "");
    other = figures;
    other.counts["bodies"] = 4;
    EXPECT_NE(compare(entry, other), "");
    other = figures;
    other.texts.clear();
    EXPECT_NE(compare(entry, other), "");
    Entry wider = entry;
    other = figures;
    other.reals["force"].value += 2e-8;
    other.counts["bodies"] = 4;
    EXPECT_NEAR(widen(wider, other).second, 2e-9, 1e-15);
    EXPECT_EQ(compare(wider, other), "");
}

}  // namespace
}  // namespace hawser::golden
