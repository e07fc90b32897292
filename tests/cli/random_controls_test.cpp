// SPDX-License-Identifier: Apache-2.0
/// Shipped scenes under random controls within their declared ranges (`hawser controls`), verified.
///
/// Failures are: a crash, an end with "ok" although the verifier rejects a step, or another end
/// without a physical cause. Physical causes are a line above its breaking load, an empty drum, and
/// an open stopper or hook.
#include "program.h"
#include "support/tier.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

using Summary = nlohmann::json;
namespace fs = std::filesystem;

std::vector<std::string> shipped_scenes() {
    std::vector<std::string> out;
    for (const char* folder : {"scenes", "exercises"})
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            const bool scene = std::string(folder) == "scenes"
                                   ? name.ends_with(".json") && !name.ends_with(".settled.json")
                                   : name.ends_with(".scene.json");
            if (scene) out.push_back(entry.path().string());
        }
    std::sort(out.begin(), out.end());
    return out;
}

bool has_physical_cause(const Summary& summary) {
    for (const char* kind : {"line_break", "weak_link", "drum_empty", "overload"})
        if (summary["event_counts"].value(kind, 0) > 0) return true;
    return false;
}

/// Run a scene under the controls of a seed. @return number of equations; 0 if it has no inputs.
std::int64_t run_controlled(const std::string& scene, std::uint32_t seed, const char* seconds) {
    const fs::path folder = test_folder(), controls = folder / "controls.csv",
                   summary = folder / "summary.json";
    const Outcome drawn = run_program(
        {"controls", scene, "--seed", std::to_string(seed), "--duration", seconds, "-o", controls});
    if (drawn.code != 0) {  // a scene without inputs
        EXPECT_NE(drawn.err.find("input"), std::string::npos) << scene << drawn.err;
        return 0;
    }
    fs::remove(summary);
    const Outcome run = run_program({"run", scene, "--control", controls, "--duration", seconds,
                                     "--verify", "--quiet", "--summary", summary});
    const std::string where = scene + " seed " + std::to_string(seed) + ": " + run.err;
    EXPECT_TRUE(run.code >= 0 && run.code <= 2) << where;
    if (!fs::exists(summary)) {
        ADD_FAILURE() << where << " (no summary)";
        return 0;
    }
    const Summary reported = Summary::parse(read_text(summary));
    const bool good = reported["verdict"]["grade"] == "good" && reported["status"] == "ok";
    EXPECT_FALSE(run.code != 0 && good) << "ok, but refused by the verifier: " << where;
    EXPECT_TRUE(run.code == 0 || good || has_physical_cause(reported)) << where;
    return reported["equations"].get<std::int64_t>();
}

TEST(RandomControls, LeaveASampleOfScenesValid_full) {
    const std::vector<std::string> all = shipped_scenes();
    const std::uint32_t seed = first_seed(1);
    constexpr std::size_t kSample = 10;
    std::size_t done = 0;
    for (std::size_t i = 0; i < all.size() && done < kSample; ++i) {
        // A stride that is coprime to the number of scenes visits each scene once.
        const std::string& scene = all[(seed + 101 * i) % all.size()];
        if (scene.find("1e6") != std::string::npos) continue;  // above 50,000 equations
        if (run_controlled(scene, seed + static_cast<std::uint32_t>(i), "20") > 0) ++done;
    }
    EXPECT_GE(done, kSample);
}

TEST(RandomControls, LeaveAllScenesValid_long) {
    const std::uint32_t seed = first_seed(1);
    for (const std::string& scene : shipped_scenes()) {
        if (scene.find("1e6") != std::string::npos) continue;  // above 50,000 equations
        const std::int64_t equations = run_controlled(scene, seed, "60");
        const std::uint32_t files = equations == 0 ? 1 : equations < 3000 ? 20 : 3;
        for (std::uint32_t i = 1; i < files && equations < 50'000; ++i)
            run_controlled(scene, seed + i, "60");
    }
}

}  // namespace
}  // namespace hawser::test
