// SPDX-License-Identifier: Apache-2.0
// Random tows in a random sea. Two hulls in waves and current, a wire over a stern roller whose
// winch runs through its modes, cut or not. Separate code verifies all steps, and recordings
// reproduce them. Covers waves for functions that were first tested in calm water.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/random.h"
#include "support/repeat.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace hawser::test {
namespace {

using Json = nlohmann::json;
constexpr double kSeconds = 15.0, kWater = 1025.0;

/// Write a closed box from z = −4 m to 4 m about its body's centre.
void write_box(const std::filesystem::path& file, double length, double beam) {
    std::ofstream out(file);
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            for (const double z : {-4.0, 4.0})
                out << "v " << x * length << ' ' << y * beam << ' ' << z << '\n';
    for (const char* face : {"1 2 4", "1 4 3", "5 7 8", "5 8 6", "1 5 6", "1 6 2", "3 4 8", "3 8 7",
                             "1 3 7", "1 7 5", "2 6 8", "2 8 4"})
        out << "f " << face << '\n';
}

/// Folder of the scenes and hulls of a test.
class TowFolder {
  public:
    TowFolder() {
        std::filesystem::create_directories(path_ / "parts");
        std::filesystem::copy_file("scenes/parts/lines.json", path_ / "parts/lines.json",
                                   std::filesystem::copy_options::overwrite_existing);
        write_box(path_ / "tug.obj", 60.0, 14.0);
        write_box(path_ / "barge.obj", 90.0, 25.0);
    }
    ~TowFolder() { std::filesystem::remove_all(path_); }
    TowFolder(const TowFolder&) = delete;
    TowFolder& operator=(const TowFolder&) = delete;
    [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                  ("hawser_random_tows_" + std::to_string(::getpid()));
};

/// Return scenes/tow_payout.json with hulls that float by displacement instead of springs.
Json tow_afloat() {
    Json scene = Json::parse(std::ifstream("scenes/tow_payout.json"));
    scene.erase("$schema");
    const double tug = 4.0 - 1.5e6 / kWater / (60.0 * 14.0),
                 barge = 4.0 - 6e6 / kWater / (90.0 * 25.0);
    Json joints = Json::array();
    double up = 0.0, up_barge = 0.0;
    for (Json& body : scene["bodies"]) {
        body.erase("gravity");
        if (body["name"] != "roller")
            for (const char* key : {"linear_damping", "angular_damping"}) body.erase(key);
        const double z = body["position"][2].get<double>();
        if (body["name"] == "tug") up = tug - z;
        if (body["name"] == "barge") up_barge = barge - z;
    }
    for (Json& body : scene["bodies"])
        body["position"][2] =
            body["position"][2].get<double>() + (body["name"] == "barge" ? up_barge : up);
    for (Json& joint : scene["interactions"])
        if (joint["kind"] != "hydrostatic") {
            joint["at"][2] = joint["at"][2].get<double>() + up;
            joints.push_back(joint);
        }
    scene["interactions"] = joints;
    for (Json& node : scene["cables"][0]["shape"]) {
        const double share = std::clamp((-28.0 - node[0].get<double>()) / 302.0, 0.0, 1.0);
        node[2] = node[2].get<double>() + up + share * (up_barge - up);
    }
    return scene;
}

Json random_sea(Random& random) {
    const auto hull = [](const char* body, const char* mesh, double mass) {
        return Json{{"body", body},
                    {"mesh", mesh},
                    {"added_mass", {0.07 * mass, 0.7 * mass, 1.4 * mass, 0, 0, 0}},
                    {"damping", {0.02 * mass, 0, 0.7 * mass, 10 * mass, 300 * mass, 0}},
                    {"drag_area", {20, 200, 0}}};
    };
    const double depth = random.chance(0.3) ? 20.0 : random.uniform(50.0, 1000.0);
    const double course = random.uniform(0, 360);
    const auto current = [&](double at) {
        return Json{{"depth", at}, {"speed", random.uniform(0, 2)}, {"direction_deg", course}};
    };
    return {{"depth", depth},
            {"density", kWater},
            {"waves",
             {{{"kind", "jonswap"},
               {"height", random.uniform(0.5, 7)},
               {"period", random.uniform(6, 14)},
               {"components", 40},
               {"seed", random.integer(1, 9999)},
               {"direction_deg", random.uniform(0, 360)},
               {"spreading", 10}}}},
            {"current", {current(0), current(depth)}},
            {"hulls", {hull("tug", "tug.obj", 1.5e6), hull("barge", "barge.obj", 6e6)}}};
}

Json random_orders(Random& random) {
    Json out = Json::array();
    for (double t = 1.0; t < kSeconds; t += random.uniform(1.0, 4.0)) {
        const char* modes[] = {"speed", "tension", "render", "brake", "free", "release"};
        const std::string mode = modes[random.integer(0, 5)];
        Json set{{"winch.mode", mode}};
        if (mode == "speed") set["winch.speed"] = random.uniform(-2, 2);
        if (mode == "tension") set["winch.tension"] = random.uniform(1e4, 8e5);
        out.push_back({{"at", t}, {"set", set}});
    }
    if (random.chance(0.4)) {
        out.push_back(
            {{"at", random.uniform(2, kSeconds)}, {"cut", "tow"}, {"s", random.uniform(30, 250)}});
        std::stable_sort(out.begin(), out.end(),
                         [](const Json& a, const Json& b) { return a["at"] < b["at"]; });
    }
    return out;
}

Json random_tow(std::uint32_t seed) {
    Random random(seed);
    Json scene = tow_afloat();
    const double steps[] = {1.0 / 240, 1.0 / 120, 1.0 / 60, 1.0 / 60, 1.0 / 30};
    scene["settings"] = {{"duration", kSeconds}, {"step", steps[random.integer(0, 4)]}};
    scene["sea"] = random_sea(random);
    if (random.chance(0.5)) {
        const double least = random.uniform(3, 6);
        scene["cables"][0]["resolution"] = {
            {"min_length", least}, {"max_length", std::max(2.0 * least, random.uniform(8, 40))}};
    }
    scene["timeline"] = random_orders(random);
    return scene;
}

TEST(RandomTows, InASeaAreVerifiedAndRepeated) {
    const TowFolder folder;
    int refused = 0, cut = 0;
    double water = 0.0;  // work of water in the run [J]
    std::int64_t steps = 0;
    const std::uint32_t first = first_seed(1);
    const std::uint32_t last =
        first + static_cast<std::uint32_t>(seed_count(kSanitized ? 1 : 2, 12, 200)) - 1;
    for (std::uint32_t seed = first; seed <= last; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string file = folder.file("tow.json"), record = folder.file("tow.hwr");
        std::ofstream(file) << random_tow(seed);
        {
            Session session({.scene = file, .record = record, .verify = true});
            Status status = Status::ok;
            while (status == Status::ok && session.time() < kSeconds - 1e-9)
                status = session.step();
            EXPECT_EQ(session.objection(), "") << session.time();
            refused += status == Status::ok ? 0 : 1;
            steps += session.world().step_count();
            water = session.world().energy().water;
            EXPECT_NE(water, 0.0);
            cut += session.world().events().extremes(EventKind::cut).count > 0 ? 1 : 0;
            session.finish();
        }
        // With one step less if the last one was rejected: it has no frame.
        if (refused == 0) {
            const Repeated again =
                expect_repeats(record::Recording::open(record), 1 + static_cast<int>(seed % 2));
            EXPECT_EQ(again.scene.world.energy().water, water);
        }
        if (HasFailure()) break;
    }
    std::printf("%u tows, %lld steps, %d wires cut, %d refused\n", last - first + 1,
                static_cast<long long>(steps), cut, refused);
    EXPECT_LE(refused, static_cast<int>(last - first + 1) / 20);
}

}  // namespace
}  // namespace hawser::test
