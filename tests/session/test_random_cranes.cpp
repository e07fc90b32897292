// SPDX-License-Identifier: Apache-2.0
/// Random lifts: cranes of the scenes with other falls, losses, loads and steps, with random
/// controls, whose hooks take and release loads. Separate code verifies all steps. States saved in
/// between continue to the same end, and recordings reproduce both.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/random.h"
#include "support/repeat.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

using Json = nlohmann::json;
constexpr double kLiftSeconds = 12.0;

struct LiftFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hawser_lifts_" + std::to_string(::getpid()));
    LiftFolder() { std::filesystem::create_directories(path); }
    ~LiftFolder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string file(const char* name) const { return (path / name).string(); }
};

/// Return the largest speeds that signals of a crane can set.
std::vector<std::pair<std::string, double>> motions(const Json& crane) {
    std::vector<std::pair<std::string, double>> out{{"crane.slew", crane["slew"]["speed"]},
                                                    {"crane.hoist", crane["hoist"]["speed"]}};
    if (crane.contains("luffing")) {
        out.emplace_back("crane.luff", crane["luffing"]["speed"]);
    } else {
        out.emplace_back("crane.luff", crane["boom_cylinder"]["speed"]);
        out.emplace_back("crane.knuckle", crane["jib_cylinder"]["speed"]);
    }
    return out;
}

Json random_orders_of(Random& random, const Json& crane) {
    Json out = Json::array();
    for (double t = 0.0; t < kLiftSeconds; t += random.uniform(0.5, 3.0)) {
        Json set = Json::object();
        for (const auto& [signal, most] : motions(crane))
            if (random.chance(0.5))
                set[signal] = random.chance(0.3) ? 0.0 : random.uniform(-most, most);
        if (t == 0.0 || random.chance(0.3)) set["crane.take"] = random.integer(0, 1);
        if (!set.empty()) out.push_back({{"at", t}, {"set", set}});
    }
    return out;
}

Json random_lift(std::uint32_t seed) {
    Random random(seed);
    const bool knuckle = random.chance(0.6);
    Json scene = Json::parse(
        std::ifstream(knuckle ? "scenes/crane_knuckle.json" : "scenes/crane_lattice.json"));
    scene.erase("$schema");
    scene.erase("outputs");
    const double steps[] = {1.0 / 120, 1.0 / 60, 1.0 / 60, 1.0 / 30};
    scene["settings"] = {{"duration", kLiftSeconds}, {"step", steps[random.integer(0, 3)]}};
    if (random.chance(0.5)) scene["settings"]["sleep_after"] = random.uniform(0.3, 1.5);
    Json& crane = scene["cranes"][0];
    const double losses[] = {1.0, 0.98, 0.95, 0.9};
    crane["hoist"]["efficiency"] = losses[random.integer(0, 3)];
    if (!knuckle) crane["luffing"]["efficiency"] = losses[random.integer(0, 3)];
    if (knuckle) crane["hoist"]["falls"] = random.integer(1, 6);
    crane["rating"]["cut_out"] = random.chance(0.5);
    for (Json& body : scene["bodies"])
        if (body["name"] == "load" || body["name"] == "module")
            body["mass"] = random.uniform(0.05, 1.3) * body["mass"].get<double>();
    scene["timeline"] = random_orders_of(random, crane);
    return scene;
}

/// Run a lift. @param save  File for the state before step `at`; "": none. @return the hash at the
/// end.
std::uint64_t run_lift(const SessionDef& def, const std::string& save = "", std::int64_t at = 0) {
    Session session(def);
    Status status = Status::ok;
    while (status == Status::ok && session.time() < kLiftSeconds - 1e-9) {
        if (!save.empty() && session.world().step_count() == at) session.save(save);
        status = session.step();
    }
    EXPECT_EQ(status, Status::ok) << session.time();
    EXPECT_EQ(session.objection(), "") << session.time();
    session.finish();
    return session.world().state().hash();
}

TEST(RandomCranes, AreVerifiedRepeatedAndGoOn) {
    const LiftFolder folder;
    const std::uint32_t first = first_seed(1);
    const std::uint32_t last =
        first + static_cast<std::uint32_t>(seed_count(kSanitized ? 1 : 2, 12, 200)) - 1;
    for (std::uint32_t seed = first; seed <= last; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string scene = folder.file("lift.json"), state = folder.file("at.hws");
        const Json lift = random_lift(seed);
        std::ofstream(scene) << lift;
        const double step = lift["settings"]["step"];
        const auto at = static_cast<std::int64_t>((2.0 + seed % 9) / step);
        const std::string whole = folder.file("whole.hwr"), rest = folder.file("rest.hwr");
        const std::uint64_t end =
            run_lift({.scene = scene, .record = whole, .verify = true}, state, at);
        EXPECT_EQ(run_lift({.scene = scene, .restore = state, .record = rest, .verify = true}),
                  end);
        for (const std::string& file : {whole, rest})
            expect_repeats(record::Recording::open(file), 1 + static_cast<int>(seed % 2));
        if (HasFailure()) break;
    }
    std::printf("%u lifts\n", last - first + 1);
}

}  // namespace
}  // namespace hawser::test
