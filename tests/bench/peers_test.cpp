// SPDX-License-Identifier: Apache-2.0
// The parts of `hawser-bench peers` that judge engines: scenes, spanning forests, measures.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
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
    } cases[] = {{heavy_hook(), 101, 101}, {tow_zigzag(), 202, 201}, {mooring(), 903, 910}};
    for (const auto& c : cases) {
        EXPECT_EQ(c.scene.bodies.size(), c.bodies) << c.scene.name;
        EXPECT_EQ(c.scene.joints.size(), c.joints) << c.scene.name;
        // Rounding in sums of 200 links of 2 m, and the tolerance 1e-11 of the catenary.
        const Reference none;
        EXPECT_LT(Meter(c.scene, none, false).largest_gap(start_of(c.scene)), 1e-8);
    }
    EXPECT_NEAR(*tow_zigzag().tension, 249.688e3, 0.5);  // given with six digits
}

TEST(Scenes, TowLinesOfMooringStartAtRest) {
    // Slopes of neighbouring links differ by w / H in equilibrium; 500 kN of thrust is H. Ships
    // are placed to 0.5 mm, worth 70 N of a tow line of 7.5e-6 m/N.
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

/// One towed ship under thrust, nothing else.
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

/// Three seconds in which the ship gains `acceleration` against the pull of the line.
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
    // 300 N of thrust, 0.2 m/s2 of 1000 kg: the line pulls back with 100 N.
    EXPECT_NEAR(*towed_at(0.2).tension_error, 0.0, 1e-9);
    EXPECT_NEAR(*towed_at(0.197).tension_error, 0.03, 1e-9);
    EXPECT_FALSE(towed_at(0.2, 30).tension_error) << "the first second does not count";
}

TEST(Meter, EnergyDriftIsWhatNoLoadExplains) {
    // The line is no load of the scene: it takes 100 N over x = 0.1 t^2 = 0.9 m, scale 200 J.
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
        return meter.why_not(600);
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
    EXPECT_NE(meter.why_not(600).find("block"), std::string::npos);
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
