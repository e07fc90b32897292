// SPDX-License-Identifier: Apache-2.0
// Rods in a world: threads, saved states, verification by separate code, energy in a storm,
// rejected definitions.
#include "support/sanitizer.h"
#include "support/tier.h"
#include "verify/sea_loads.h"

#include "floater.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace hawser::test {
namespace {

SeaDef storm(double height = 8.0) {
    SeaDef sea{.depth = 80.0};
    sea.waves.push_back({.kind = WaveKind::jonswap,
                         .height = height,
                         .period = 11.0,
                         .spreading = 4.0,
                         .components = 16});
    sea.current = {{0.0, 1.0, 0.3}, {40.0, 0.2, 1.0}};
    sea.convective = true;
    return sea;
}

/// A platform of four legs and two braces, 400 t with 4 × 176 m³ of legs, on a spring.
struct Platform {
    World w;
    BodyId body{};

    explicit Platform(const WorldDef& def = {}, double brace = 0.8, SeaDef sea = storm()) : w(def) {
        const double mass = 4e5;
        body = w.add_body({.name = "platform",
                           .position = {0, 0, -4.0},
                           .orientation = Quat(0.99, 0.05, -0.03, 0.02).normalized(),
                           .velocity = {0.5, 0.2, 0.0},
                           .angular_velocity = {0.02, -0.03, 0.05},
                           .mass = mass,
                           .inertia = Vec3(mass * 200, mass * 180, mass * 250).asDiagonal()});
        const LineWater leg{.diameter = 3.0,
                            .cd_normal = 0.9,
                            .cd_tangential = 0.1,
                            .ca_normal = 1.0,
                            .ca_tangential = 0.3};
        for (const double x : {-10.0, 10.0})
            for (const double y : {-10.0, 10.0})
                sea.rods.push_back({.body = body,
                                    .from = {x, y, -9},
                                    .to = {x, y, 16},
                                    .water = leg,
                                    .segments = 37});
        for (const double y : {-10.0, 10.0})
            sea.rods.push_back({.body = body,
                                .from = {-10, y, -8},
                                .to = {10, y, 12},
                                .water = {.diameter = brace, .cd_tangential = 0.02},
                                .segments = 20});
        const BodyId ground =
            w.add_body({.name = "ground", .kind = BodyKind::fixed, .position = {0, 0, -12}});
        InteractionDef hold;
        hold.kind = InteractionKind::Ball;
        hold.body = {ground, body};
        hold.point[1] = {0, 0, -8};
        hold.compliance.fill(1.0 / 5e4);
        hold.damping_time.fill(1.0);
        w.add_interaction(hold);
        w.add(sea);
    }
};

TEST(RodsWorld, AStormMakesNoEnergyOfNothing) {
    HAWSER_SKIP_IF_SAMPLED();
    Platform p;
    double fastest = 0.0;
    for (int i = 0; i < (kSanitized ? 300 : 3'600); ++i) {
        go(p.w, 1);
        fastest = std::max(fastest, p.w.velocity(p.body).linear.norm());
    }
    std::printf("platform: at most %.2f m/s, at (%.2f, %.2f, %.2f) m\n", fastest,
                p.w.pose(p.body).position.x(), p.w.pose(p.body).position.y(),
                p.w.pose(p.body).position.z());
    EXPECT_EQ(p.w.verdict().grade, Grade::good);
    // Water of this sea moves at up to 4.5 m/s, the current at 1 m/s.
    EXPECT_LT(fastest, 8.0);
}

// A pipe of a twentieth of its water's weight, without axial added mass. An unstable step would
// throw it out of the water.
TEST(RodsWorld, ALightPipeStaysAtTheWater) {
    for (const double step : {1.0 / 60.0, 0.1}) {
        World w{WorldDef{.step = step}};
        const double d = 0.5, length = 12.0, water = 1025.0 * 0.25 * kPi * d * d * length;
        const double mass = 0.05 * water;
        const BodyId pipe =
            w.add_body({.name = "pipe",
                        .position = {0, 0, -8},
                        .orientation = Quat(0.8, 0.1, 0.5, 0.0).normalized(),
                        .mass = mass,
                        .inertia = Vec3(mass * 0.06, mass * 12, mass * 12).asDiagonal()});
        SeaDef sea = storm();
        sea.rods.push_back({.body = pipe,
                            .from = {-6, 0, 0},
                            .to = {6, 0, 0},
                            .water = {.diameter = d, .cd_tangential = 0.02},
                            .segments = 24});
        w.add(sea);
        double fastest = 0.0, highest = -1e9;
        const int steps = static_cast<int>(std::lround(60.0 / step));
        for (int i = 0; i < steps; ++i) {
            go(w, 1);
            fastest = std::max(fastest, w.velocity(pipe).linear.norm());
            highest = std::max(highest, w.pose(pipe).position.z());
        }
        std::printf("pipe, steps of %.3f s: at most %.2f m/s, %.2f m up\n", step, fastest, highest);
        EXPECT_EQ(w.verdict().grade, Grade::good) << step;
        // From a depth of 8 m, full buoyancy without axial drag would give sqrt(2 · 19 g · 8) = 55
        // m/s.
        EXPECT_LT(fastest, 55.0);
    }
}

TEST(RodsWorld, ThreadsDoNotMatter) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 4}) {
        Platform p(WorldDef{.threads = threads});
        go(p.w, 200);
        if (threads == 1) hash = p.w.state().hash();
        EXPECT_EQ(p.w.state().hash(), hash) << threads;
    }
}

TEST(RodsWorld, SavedStateAndTwinGoOnWithTheSameBits) {
    Platform a, b;
    go(a.w, 50);
    a.w.set_system_signal("sea.waves", 0.7);
    World twin = a.w.twin();
    b.w.state().restore(a.w.state().save());
    for (int i = 0; i < 50; ++i) {
        go(a.w, 1);
        go(b.w, 1);
        go(twin, 1);
        ASSERT_EQ(a.w.state().hash(), b.w.state().hash());
        ASSERT_EQ(a.w.state().hash(), twin.state().hash());
    }
}

/// Return the largest difference between the loads of `p` and the loads that separate code computes
/// with the sea of `reported`.
double difference(Platform& p, const World& reported, int steps) {
    verify::SeaVerifier verifier(reported);
    double worst = 0.0;
    std::vector<Pose> pose(static_cast<std::size_t>(p.w.body_count()));
    std::vector<Twist> twist(pose.size());
    for (int i = 0; i < steps; ++i) {
        for (const BodyId b : p.w.bodies()) {
            pose[static_cast<std::size_t>(b.index)] = p.w.pose(b);
            twist[static_cast<std::size_t>(b.index)] = p.w.velocity(b);
        }
        verifier.before_step(p.w);
        go(p.w, 1);
        worst = std::max(worst, verifier.after_step(p.w, pose, twist));
    }
    return worst;
}

TEST(RodsWorld, SeparateCodeAgreesInWaves) {
    Platform p;
    const double worst = difference(p, p.w, kSanitized ? 20 : by_tier(200, 600, 6000));
    std::printf("separate code differs by %.2g\n", worst);
    EXPECT_GT(worst, 0.0) << "some load was compared";
    EXPECT_LT(worst, 1e-9);
    // The difference shows a brace that is 0.1 % thicker.
    Platform again, thicker({}, 0.8008);
    EXPECT_GT(difference(again, thicker.w, 10), 1e-9);
}

TEST(RodsWorld, NothingWetNothingLoaded) {
    World w{WorldDef{}};
    const BodyId boom = w.add_body(
        {.name = "boom", .position = {0, 0, 5}, .mass = 100, .inertia = Mat3::Identity()});
    SeaDef sea{.depth = 50.0};
    sea.rods.push_back(
        {.body = boom, .from = {-3, 0, 0}, .to = {3, 0, 0}, .water = {.diameter = 0.4}});
    w.add(sea);
    go(w, 1);
    EXPECT_TRUE(sea_loads(w).empty());
    while (w.pose(boom).position.z() > -0.1) go(w, 1);
    go(w, 1);
    EXPECT_EQ(sea_loads(w).size(), 1U);
    EXPECT_THROW(w.remove_body(boom), DefError);
}

TEST(RodsWorld, BadDefinitionsAreRefusedByTheirField) {
    World w{WorldDef{}};
    const BodyId body = w.add_body({.mass = 1.0, .inertia = Mat3::Identity()});
    const BodyId lump = w.add_body({.kind = BodyKind::lump, .mass = 1.0});
    const WaterRod good{.body = body, .to = {0, 0, 5}, .water = {.diameter = 0.5}};
    const auto refused = [&](auto&& change) {
        WaterRod rod = good;
        change(rod);
        try {
            w.add(SeaDef{.depth = 50.0, .rods = {good, rod}});
        } catch (const SeaError& error) {
            return error.field + ": " + error.what();
        }
        return std::string("taken");
    };
    const auto says = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    const std::string of_lump = refused([&](WaterRod& r) { r.body = lump; });
    EXPECT_TRUE(says(of_lump, "rods/1/body: ")) << of_lump;
    EXPECT_TRUE(says(of_lump, "bodies") && says(of_lump, "lines")) << of_lump;
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.body = BodyId{99}; }), "rods/1/body: "));
    const std::string short_one = refused([](WaterRod& r) { r.to = r.from; });
    EXPECT_TRUE(says(short_one, "rods/1/to: ") && says(short_one, "length")) << short_one;
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.from.x() = std::nan(""); }), "rods/1/from: "));
    for (const int n : {0, 1001}) {
        const std::string many = refused([n](WaterRod& r) { r.segments = n; });
        EXPECT_TRUE(says(many, "rods/1/segments: ") && says(many, "from 1 to 1000")) << many;
    }
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.water.diameter = 0; }), "rods/1/diameter: "));
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.water.volume = -1; }), "rods/1/volume: "));
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.water.cd_normal = -1; }), "rods/1/cd_normal: "));
    EXPECT_TRUE(
        says(refused([](WaterRod& r) { r.water.cd_tangential = 2e3; }), "rods/1/cd_tangential: "));
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.water.ca_normal = -1; }), "rods/1/ca_normal: "));
    EXPECT_TRUE(says(refused([](WaterRod& r) { r.water.ca_tangential = std::nan(""); }),
                     "rods/1/ca_tangential: "));
    EXPECT_EQ(w.system_count(), 0);
    EXPECT_EQ(refused([](WaterRod&) {}), "taken");
}

}  // namespace
}  // namespace hawser::test
