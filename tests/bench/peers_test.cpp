// SPDX-License-Identifier: Apache-2.0
// Parts of `hawser-bench peers` that assess engines: scenes, spanning forests, measures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "peers/forest.h"
#include "peers/meter.h"

namespace hawser::bench {
namespace {

constexpr const char* kReferences = "bench/peers/reference";

std::vector<BodyState> start_of(const Scene& scene) {
    std::vector<BodyState> s;
    for (const Body& b : scene.bodies) s.push_back(b.start);
    return s;
}

TEST(Scenes, HaveTheStatedSizesAndAreClosed) {
    const struct {
        Scene scene;
        std::size_t bodies, joints;
    } cases[] = {{heavy_hook(), 101, 101},     {tow_zigzag(), 202, 201}, {mooring(), 903, 910},
                 {mooring_seabed(), 903, 910}, {box_stack(), 10, 0},     {box_stack_1e6(), 10, 0}};
    for (const auto& c : cases) {
        EXPECT_EQ(c.scene.bodies.size(), c.bodies) << c.scene.name;
        EXPECT_EQ(c.scene.joints.size(), c.joints) << c.scene.name;
        // Rounding in sums of 200 links of 2 m, and the tolerance 1e-11 of the catenary.
        const Reference none;
        EXPECT_LT(Meter(c.scene, none, false).largest_gap(start_of(c.scene)), 1e-8);
    }
    EXPECT_NEAR(*tow_zigzag().tension, 249.688e3, 0.5);  // published with six digits
}

TEST(Scenes, TowLinesOfMooringStartAtRest) {
    // Slopes of neighbouring links differ by w / H in equilibrium; H is the thrust of 500 kN. Ships
    // are placed to 0.5 mm, which equals 70 N of a tow line of 7.5e-6 m/N.
    const Scene s = mooring();
    const auto slope = [&](std::size_t body) {
        const Vec3 d = s.bodies[body].start.q * Vec3::UnitX();
        return d.z() / std::hypot(d.x(), d.y());
    };
    for (const std::size_t first : {s.bodies.size() - 180, s.bodies.size() - 90})
        for (std::size_t i = first; i + 1 < first + 90; ++i)
            EXPECT_NEAR(200.0 * 9.81 / (slope(i + 1) - slope(i)), 500e3, 150.0);
}

TEST(Forest, PlacesEveryBodyOnceParentsFirst) {
    for (const Scene& s : {heavy_hook(), tow_zigzag(), mooring()})
        for (const TreeLayout& layout : s.layouts) {
            std::set<int> seen;
            std::size_t joints = 0;
            for (const auto& tree : spanning_forest(s, layout))
                for (const TreeNode& n : tree) {
                    EXPECT_TRUE(n.parent < 0 || seen.count(n.parent)) << s.name << layout.name;
                    EXPECT_TRUE(seen.insert(n.body).second);
                    joints += n.joint >= 0;
                }
            EXPECT_EQ(seen.size(), s.bodies.size());
            EXPECT_EQ(joints + layout.closures.size(), s.joints.size());
        }
    EXPECT_THROW((void)spanning_forest(mooring(), {"none cut", {}}), std::invalid_argument);
}

/// Make a scene of one towed ship under thrust.
Scene lone_ship() {
    Scene s;
    s.name = "lone";
    s.gravity = 0.0;
    s.duration = 3.0;
    Body ship;
    ship.mass = 1000.0;
    ship.inertia = Vec3::Ones();
    s.bodies = {ship};
    s.thrusts = {{0, Vec3(300.0, 0.0, 0.0)}};
    s.towed = {0};
    s.tension = 100.0;
    s.energy_scale = 200.0;
    return s;
}

/// Simulate three seconds in which the ship moves with `acceleration` against the pull of the line.
Measures towed_at(double acceleration, int frames = 180) {
    const Scene s = lone_ship();
    const Reference none;
    Meter meter(s, none, false);
    std::vector<BodyState> now = start_of(s), before;
    std::vector<Load> loads(1);
    for (int i = 1; i <= frames; ++i) {
        before = now;
        external_loads(s, before, loads);
        now[0].x += kFrame * now[0].v + 0.5 * acceleration * kFrame * kFrame * Vec3::UnitX();
        now[0].v += kFrame * acceleration * Vec3::UnitX();
        meter.substep(before, loads, now, kFrame, nullptr);
        meter.frame(before, now, i * kFrame);
    }
    return meter.measures();
}

TEST(Meter, TensionIsTheForceMissingInTheMomentumBalance) {
    // 300 N of thrust, 0.2 m/s² of 1000 kg: the line pulls back with 100 N.
    EXPECT_NEAR(*towed_at(0.2).tension_error, 0.0, 1e-9);
    EXPECT_NEAR(*towed_at(0.197).tension_error, 0.03, 1e-9);
    EXPECT_FALSE(towed_at(0.2, 30).tension_error) << "the first second does not count";
}

TEST(Meter, EnergyDriftIsWhatNoLoadExplains) {
    // The line is not a load of the scene: it absorbs 100 N over x = 0.1 t² = 0.9 m, scale 200 J.
    EXPECT_NEAR(towed_at(0.2).energy_end, -100.0 * 0.9 / 200.0, 1e-9);
    EXPECT_NEAR(towed_at(0.3).energy_end, 0.0, 1e-9);
}

TEST(Meter, BreaksOnGapPathAndNan) {
    const Scene s = heavy_hook();
    const Reference ref = load_reference(kReferences, s);
    ASSERT_TRUE(ref.covers(s.duration));
    const std::vector<BodyState> start = start_of(s);
    const auto why = [&](auto change) {
        Meter meter(s, ref, false);
        std::vector<BodyState> now = start;
        change(now);
        meter.frame(start, now, 0.0);
        return meter.reason_unusable(600);
    };
    EXPECT_EQ(why([](auto&) {}), "");
    EXPECT_NE(why([](auto& b) { b[50].x.y() += 1.1e-3; }).find("gap"), std::string::npos);
    EXPECT_EQ(why([](auto& b) { b[50].x.y() += 0.9e-3; }), "");
    EXPECT_NE(why([](auto& b) { b[7].v.y() = 1000.0; }).find("energy"), std::string::npos);
    EXPECT_NE(why([](auto& b) { b[3].x.x() = std::numeric_limits<double>::quiet_NaN(); }), "");
    Reference shifted = ref;
    for (Vec3& x : shifted.block) x.z() += 0.11;
    Meter meter(s, shifted, false);
    meter.frame(start, start, 0.0);
    EXPECT_NE(meter.reason_unusable(600).find("block"), std::string::npos);
}

/// Read the file of the scene with this name.
nlohmann::json scene_file(const std::string& name) {
    return nlohmann::json::parse(std::ifstream("scenes/" + name + ".json"));
}

TEST(ContactScenes, SeabedIsThatOfTheSceneFile) {
    const Scene s = mooring_seabed();
    const nlohmann::json file = scene_file(s.name);
    // Nodes of the first line from its anchor at (302.109, 208.462) are its joints 1, 2, ...
    std::size_t compared = 0;
    for (const auto& cable : file["cables"]) {
        if (!cable["shape"].is_array()) continue;  // shapes of tow lines are solved, not listed
        std::set<std::size_t> found;
        for (const auto& node : cable["shape"]) {
            const Vec3 at(node[0], node[1], node[2]);
            for (std::size_t j = 0; j < s.joints.size(); ++j)
                if ((s.joints[j].anchor - at).norm() < 1e-9) found.insert(j);
        }
        EXPECT_EQ(found.size(), 89U) << cable["name"];
        ++compared;
    }
    EXPECT_EQ(compared, 8U);
    std::size_t capsules = 0;
    for (const Body& b : s.bodies) capsules += b.shape.kind == BodyShape::Kind::capsule ? 1 : 0;
    EXPECT_EQ(capsules, 8U * 90U);
    const auto& pair = file["material_pairs"][0];
    ASSERT_TRUE(s.touching.has_value());
    EXPECT_EQ(s.touching->friction, pair["friction"]);
    EXPECT_EQ(s.touching->stiffness, pair["stiffness"]);
    EXPECT_EQ(s.touching->floor, file["bodies"].back()["position"][2]);
}

TEST(ContactScenes, StacksAreThoseOfTheSceneFiles) {
    for (const Scene& s : {box_stack(), box_stack_1e6()}) {
        const nlohmann::json file = scene_file(s.name);
        ASSERT_EQ(file["bodies"].size(), s.bodies.size() + 1);
        for (std::size_t i = 0; i < s.bodies.size(); ++i) {
            const auto& body = file["bodies"][i + 1];
            EXPECT_EQ(s.bodies[i].mass, body["mass"]);
            EXPECT_EQ(s.bodies[i].start.x.z(), body["position"][2]);
            EXPECT_EQ(s.bodies[i].shape.half_size.x(), body["shapes"][0]["half_size"][0]);
        }
        const auto& pair = file["material_pairs"][0];
        EXPECT_NEAR(s.touching->stiffness / pair["stiffness"].get<double>(), 1.0, 1e-12);
        EXPECT_EQ(s.touching->friction, pair["friction"]);
    }
}

TEST(Meter, MeasuresTheTopOfAStackAndHowDeepACapsuleSinks) {
    const Reference none;
    const Scene stack = box_stack();
    Meter tower(stack, none, false);
    auto state = start_of(stack);
    const auto before = state;
    state[9].x += Vec3(3e-4, -4e-4, -2e-4);
    tower.frame(before, state, 0.1);
    tower.frame(state, before, 0.2);  // reports the largest value, not the last
    EXPECT_NEAR(tower.measures().drop.value(), 2e-4, 1e-12);
    EXPECT_NEAR(tower.measures().sideways.value(), 5e-4, 1e-12);
    EXPECT_EQ(tower.reason_unusable(600), "");
    state[9].x.z() -= 1e-3;
    tower.frame(before, state, 0.3);
    EXPECT_NE(tower.reason_unusable(600).find("dropped"), std::string::npos);

    const Scene bed = mooring_seabed();
    Meter meter(bed, none, false);
    auto links = start_of(bed);
    meter.frame(links, links, 0.1);
    // The line starts on the floor. A capsule is as long as its arc, not its chord, so that the
    // first rising link dips by 2e-8 m.
    EXPECT_NEAR(meter.measures().sink.value(), 0.0, 1e-7);
    links[3].x.z() -= 2e-3;  // first link of the first line, horizontal
    meter.frame(links, links, 0.2);
    EXPECT_NEAR(meter.measures().sink.value(), 2e-3, 1e-9);
}

TEST(References, OfTheSeabedIsConverged) {
    // Both columns are runs of Hawser, at h/16 and h/32 (make_reference.h). Their difference bounds
    // the error of the finer run if errors at least halve with the step.
    const std::string path = std::string(kReferences) + "/mooring_seabed.csv";
    std::ifstream in(path);
    std::string line;
    ASSERT_TRUE(std::getline(in, line)) << path;
    ASSERT_EQ(line, "t,tension_1,tension_2,coarse_1,coarse_2");
    double sum = 0.0;
    int count = 0;
    while (std::getline(in, line)) {
        double t = 0.0, fine[2], coarse[2];
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &t, &fine[0], &fine[1],
                              &coarse[0], &coarse[1]),
                  5);
        for (int k = 0; k < 2 && t >= kSettle; ++k, ++count)
            sum += std::pow(coarse[k] / fine[k] - 1.0, 2);
    }
    EXPECT_GT(count, 2 * 1100);
    // A twentieth of the 0.5 % limit for engines.
    EXPECT_LT(std::sqrt(sum / count), 0.05 * mooring_seabed().wanted.tension);
    EXPECT_TRUE(load_reference(kReferences, mooring_seabed()).covers(19.9));
}

TEST(References, CoverTheirScenesAndRefuseDamage) {
    EXPECT_TRUE(load_reference(kReferences, mooring()).covers(19.9));
    EXPECT_TRUE(load_reference("no/such/folder", mooring()).t.empty());
    const auto folder = std::filesystem::temp_directory_path() / "hawser_peers_test";
    std::filesystem::create_directories(folder);
    for (const char* text : {"", "t,x,y\n0,1,2\n1,1,2\n", "t,x,y,z\n0,1,2,3\n", "t,x,y,z\n0,1,2\n",
                             "t,x,y,z\n0,1,2,3\n0,1,2,3\n", "t,x,y,z\n0,1,2,a\n1,1,2,3\n"}) {
        std::ofstream(folder / "heavy_hook.csv") << text;
        EXPECT_THROW((void)load_reference(folder.string(), heavy_hook()), std::runtime_error)
            << text;
    }
    std::ofstream(folder / "heavy_hook.csv") << "t,x,y,z\n0,0,0,0\n2,2,0,-4\n";
    EXPECT_NEAR(load_reference(folder.string(), heavy_hook()).block_at(0.5).z(), -1.0, 1e-12);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace hawser::bench
