// SPDX-License-Identifier: Apache-2.0
// Water on lines, bodies and hulls against closed forms, and effects in a world.
#include <hawser/hawser.h>

#include "verify/sea_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kRho = 1025.0, kGravity = 9.81;

void take(World& w, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
}

SeaDef still() { return {.depth = 1000.0}; }

/// A straight horizontal chain without fixed ends that sinks.
struct Chain {
    World w{WorldDef{}};
    WireId wire{};
    explicit Chain(const LineWater& water, double mass, SeaDef sea = still()) {
        const BodyId first =
            w.add_body({.kind = BodyKind::lump, .position = {0, 0, -100}, .mass = 2.5 * mass});
        std::vector<Vec3> path;
        for (int i = 1; i <= 10; ++i) path.emplace_back(5.0 * i, 0.0, -100.0);
        wire = w.wires().add({.name = "chain",
                              .from = first,
                              .elements = 10,
                              .length = 50.0,
                              .EA = 5e8,
                              .mass_per_length = mass,
                              .path = path});
        sea.lines.push_back(
            {.wire = wire, .sections = {{10, water}}, .free_first = true, .free_last = true});
        w.add(sea);
    }
};

TEST(Water, ChainSinksAtItsTerminalSpeed) {
    // 76 mm stud chain: 0.87 of its weight against drag with coefficient 2.6.
    Chain c({.diameter = 0.076, .volume = 0.13 * 126.5 / kRho, .cd_normal = 2.6}, 126.5);
    take(c.w, 60 * 20);
    const double expected = std::sqrt(2.0 * 0.87 * 126.5 * kGravity / (kRho * 2.6 * 0.076));
    EXPECT_NEAR(expected, 3.265, 1e-3);
    for (const BodyId b : c.w.wires().nodes(c.wire))
        EXPECT_NEAR(-c.w.velocity(b).linear.z(), expected, 1e-6 * expected);
}

TEST(Water, LineFollowsAcceleratedWaterByItsAddedMass) {
    // Without drag: (m + C_a ρA) v̇ = (1 + C_a) ρA a in a small wave, across a line.
    SeaDef sea = still();
    sea.waves.push_back({.height = 2e-4, .period = 8.0});
    const double area = 0.01, mass = 30.0, ca = 0.7;
    Chain c({.diameter = 0.1, .volume = area, .cd_normal = 0.0, .ca_normal = ca}, mass, sea);
    // Remove the net weight by hand, so that only the motion of the water acts.
    for (const BodyId b : c.w.wires().nodes(c.wire)) {
        const double length = c.w.body_def(b).mass / mass;
        c.w.set_force(b, {0, 0, (mass - kRho * area) * length * kGravity}, Vec3::Zero());
    }
    // v changes by this fraction of the change of the water's velocity, at each node.
    const Sea water(sea, kGravity);
    const double share = (1.0 + ca) * kRho * area / (mass + ca * kRho * area);
    const auto nodes = c.w.wires().nodes(c.wire);
    const auto flow = [&](BodyId b, double t) {
        return water.water(water.at(t), c.w.pose(b).position).velocity.z();
    };
    take(c.w, 1);
    std::vector<double> start, at_start;
    const double begin = c.w.time() - 0.5 * c.w.settings().step;
    for (const BodyId b : nodes) {
        start.push_back(c.w.velocity(b).linear.z());
        at_start.push_back(flow(b, begin));
    }
    const double largest = 1e-4 * 2.0 * std::numbers::pi / 8.0 * std::exp(-0.0629 * 100.0);
    for (int i = 0; i < 8; ++i) {
        take(c.w, 37);
        const double now = c.w.time() - 0.5 * c.w.settings().step;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            EXPECT_NEAR(c.w.velocity(nodes[k]).linear.z() - start[k],
                        share * (flow(nodes[k], now) - at_start[k]), 2e-3 * largest)
                << k << " at " << now;
    }
}

TEST(Water, DrifterAndMooredBody) {
    // A body in a current: slip u₀/(1 + c u₀ t/m).
    SeaDef sea = still();
    sea.current = {{0.0, 1.5, 0.0}};
    const double mass = 500.0, area = 0.8;
    World w{WorldDef{}};
    const BodyId body = w.add_body(
        {.kind = BodyKind::lump, .position = {0, 0, -10}, .mass = mass, .gravity = false});
    const BodyId fixed = w.add_body({.kind = BodyKind::fixed, .position = {50, 0, -10}});
    const BodyId held = w.add_body(
        {.kind = BodyKind::lump, .position = {50, 0, -10}, .mass = 100.0, .gravity = false});
    const double stiffness = 400.0;
    InteractionDef hold;
    hold.kind = InteractionKind::Ball;
    hold.body = {fixed, held};
    hold.compliance.fill(1.0 / stiffness);
    hold.damping_time.fill(1.0);
    w.add_interaction(hold);
    sea.bodies.push_back({.body = body, .drag_area = Vec3::Constant(area), .height = 1.0});
    sea.bodies.push_back({.body = held, .drag_area = Vec3::Constant(area), .height = 1.0});
    w.add(sea);
    const double c = 0.5 * kRho * area;
    for (const double t : {5.0, 20.0, 60.0}) {
        while (w.time() < t - 1e-9) take(w, 1);
        // Velocities are half a step before time().
        const double slip = 1.5 - w.velocity(body).linear.x();
        const double at = w.time() - 0.5 * w.settings().step;
        EXPECT_NEAR(slip / (1.5 / (1.0 + c * 1.5 * at / mass)), 1.0, 1e-3) << t;
    }
    EXPECT_NEAR(w.pose(held).position.x() - 50.0, c * 1.5 * 1.5 / stiffness,
                1e-3 * c * 2.25 / stiffness);
    EXPECT_LE(std::abs(w.energy().mechanical() - w.energy().applied - w.energy().driven -
                       w.energy().system + w.energy().dissipated + w.energy().damped),
              1.0);
}

TEST(Water, NeutralLumpCirclesAsTheWater) {
    // ka = 0.01: a e^{kz}.
    const double period = 8.0, omega = 2 * std::numbers::pi / period, k = omega * omega / kGravity;
    const double a = 0.01 / k, z = -5.0;
    SeaDef sea{.depth = 3000.0};
    sea.waves.push_back({.height = 2 * a, .period = period});
    World w{WorldDef{}};
    const double volume = 0.1, radius = a * std::exp(k * z);
    // It starts with the velocity of the water at its position.
    const Sea water(sea, kGravity);
    const BodyId body = w.add_body({.kind = BodyKind::lump,
                                    .position = {0, 0, z},
                                    .velocity = water.water(water.at(0.0), {0, 0, z}).velocity,
                                    .mass = kRho * volume});
    sea.bodies.push_back({.body = body,
                          .drag_area = Vec3::Constant(0.1),
                          .volume = volume,
                          .added_mass = Vec3::Constant(0.5)});
    w.add(sea);
    double low = 1e9, high = -1e9;
    for (int i = 0; i < 480; ++i) {
        take(w, 1);
        low = std::min(low, w.pose(body).position.z());
        high = std::max(high, w.pose(body).position.z());
    }
    EXPECT_NEAR(0.5 * (high - low), radius, 5e-3 * radius);
}

TEST(Water, FrictionHasNoStepThatIsTooLong) {
    // Drag area over mass of 5 m²/kg at 40 m/s, in waves; a line in a current of 40 m/s.
    for (const double step : {1.0 / 60.0, 0.2}) {
        World w{WorldDef{.step = step}};
        const BodyId light = w.add_body(
            {.kind = BodyKind::lump, .position = {0, 0, -3}, .velocity = {40, 0, 0}, .mass = 1.0});
        SeaDef sea{.depth = 50.0};
        sea.waves.push_back({.kind = WaveKind::jonswap, .height = 4.0, .period = 8.0});
        sea.bodies.push_back(
            {.body = light, .drag_area = Vec3::Constant(5.0), .volume = 1e-3, .height = 0.5});
        w.add(sea);
        for (int i = 0; i < 2000; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_LT(w.velocity(light).linear.norm(), 41.0);
        }
        EXPECT_LT(w.velocity(light).linear.norm(), 10.0);
    }
}

TEST(Water, HullFloatsByItsDisplacement) {
    World w{WorldDef{}};
    const double mass = kRho * 200.0;
    const BodyId box = w.add_body(
        {.name = "box",
         .position = {0, 0, 0.6},
         .mass = mass,
         .inertia = Vec3(mass * 116 / 12, mass * 116 / 12, mass * 200 / 12).asDiagonal()});
    SeaDef sea = still();
    sea.hulls.push_back(
        {.body = box, .mesh = box_hull({5, 5, 2}), .damping = {0, 0, 2e6, 0, 0, 0}});
    w.add(sea);
    take(w, 60 * 60);
    EXPECT_NEAR(w.pose(box).position.z(), 0.0, 1e-10);
    // Sum of the forces that water alone carries.
    double up = 0.0;
    for (const LoadView& l : sea_loads(w)) up += l.force[2];
    EXPECT_NEAR(up, mass * kGravity, 1e-7 * mass);
}

TEST(Water, HullsAgreeWithSeparateCodeInWaves) {
    World w{WorldDef{}};
    const double mass = kRho * 200.0;
    const BodyId box = w.add_body({.name = "box",
                                   .position = {0, 0, 0.3},
                                   .orientation = Quat(0.96, 0.2, -0.15, 0.1).normalized(),
                                   .velocity = {1, 2, 0},
                                   .mass = mass,
                                   .inertia = Vec3(mass * 10, mass * 11, mass * 17).asDiagonal()});
    SeaDef sea{.depth = 40.0};
    sea.waves.push_back({.kind = WaveKind::jonswap,
                         .height = 4.0,
                         .period = 7.0,
                         .spreading = 4.0,
                         .components = 16});
    sea.current = {{0.0, 1.0, 0.3}, {10.0, 0.2, 1.0}};
    sea.level = {{0.0, 0.0}, {100.0, 2.0}};
    sea.wind = {.speed = 15.0, .direction = 2.0, .gusts = true};
    sea.hulls.push_back({.body = box,
                         .mesh = box_hull({5, 5, 2}, 4, 5, 3),
                         .added_mass = {1e4, 2e4, 5e4, 1e5, 2e5, 3e5},
                         .damping = {1e4, 2e4, 3e4, 1e5, 1e5, 1e5},
                         .drag_area = {10, 20, 50},
                         .wind_area = {5, 6, 0}});
    const BodyId fixed = w.add_body({.name = "fixed", .kind = BodyKind::fixed});
    const WireId wire = w.wires().add({.name = "rope",
                                       .from = box,
                                       .from_point = {5, 0, 0},
                                       .elements = 8,
                                       .length = 20.0,
                                       .EA = 1e7,
                                       .mass_per_length = 10.0});
    static_cast<void>(fixed);
    sea.lines.push_back(
        {.wire = wire,
         .sections =
             {{3, {.diameter = 0.1, .cd_tangential = 0.02}},
              {5, {.diameter = 0.05, .cd_normal = 2.0, .ca_normal = 0.5, .ca_tangential = 0.1}}},
         .free_last = true});
    const BodyId buoy = w.add_body(
        {.name = "buoy", .kind = BodyKind::lump, .position = {20, 5, 0.2}, .mass = 300.0});
    sea.bodies.push_back({.body = buoy,
                          .drag_area = {0.5, 0.7, 1.0},
                          .wind_area = {0.3, 0.3, 0.1},
                          .volume = 0.6,
                          .added_mass = {0.5, 0.6, 0.7}});
    w.add(sea);
    verify::SeaVerifier verifier(w);
    double worst = 0.0;
    std::vector<Pose> pose(4 + 8);
    std::vector<Twist> twist(pose.size());
    pose.resize(static_cast<std::size_t>(w.body_count()));
    twist.resize(pose.size());
    for (int i = 0; i < 600; ++i) {
        for (const BodyId b : w.bodies()) {
            pose[static_cast<std::size_t>(b.index)] = w.pose(b);
            twist[static_cast<std::size_t>(b.index)] = w.velocity(b);
        }
        if (i == 300) w.set_system_signal("sea.waves", 0.5);
        verifier.before_step(w);
        take(w, 1);
        worst = std::max(worst, verifier.after_step(w, pose, twist));
    }
    EXPECT_LT(worst, 1e-9);
    std::printf("separate code differs by %.2g\n", worst);
}

TEST(Water, SavedStateGoesOnWithTheSameBits) {
    const auto make = [] {
        SeaDef sea{.depth = 60.0};
        sea.waves.push_back({.kind = WaveKind::jonswap, .height = 3.0, .period = 8.0});
        return Chain({.diameter = 0.076, .cd_normal = 2.0}, 30.0, sea);
    };
    Chain a = make(), b = make();
    take(a.w, 50);
    a.w.set_system_signal("sea.waves", 1.5);
    const auto saved = a.w.state().save();
    World twin = a.w.twin();
    b.w.state().restore(saved);
    for (int i = 0; i < 50; ++i) {
        take(a.w, 1);
        take(b.w, 1);
        take(twin, 1);
        ASSERT_EQ(a.w.state().hash(), b.w.state().hash());
        ASSERT_EQ(a.w.state().hash(), twin.state().hash());
    }
}

TEST(Water, ThreadsDoNotMatter) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 4, 8}) {
        World w{WorldDef{.threads = threads}};
        const double mass = kRho * 200.0;
        const BodyId box =
            w.add_body({.name = "box",
                        .mass = mass,
                        .inertia = Vec3(mass * 10, mass * 11, mass * 17).asDiagonal()});
        SeaDef sea{.depth = 40.0};
        sea.waves.push_back(
            {.kind = WaveKind::jonswap, .height = 4.0, .period = 7.0, .spreading = 4.0});
        sea.hulls.push_back({.body = box, .mesh = box_hull({5, 5, 2}, 12, 11, 9)});
        for (int i = 0; i < 3; ++i) {
            const WireId wire = w.wires().add({.name = std::to_string(i),
                                               .from = box,
                                               .from_point = {5, 4.0 * i - 4.0, 0},
                                               .elements = 40,
                                               .length = 60.0,
                                               .EA = 1e7,
                                               .mass_per_length = 10.0});
            sea.lines.push_back(
                {.wire = wire, .sections = {{40, {.diameter = 0.1}}}, .free_last = true});
        }
        w.add(sea);
        take(w, 200);
        if (threads == 1) hash = w.state().hash();
        EXPECT_EQ(w.state().hash(), hash) << threads;
    }
}

TEST(Water, LinesKeepTheirSortsWhenNodesComeAndWiresAreCut) {
    // A wire of two types: new parts of an element have its type, and a part cut off keeps its own.
    // Measured by buoyancy of a line at rest: ρ g A times half of each element.
    const double thin = 0.001, thick = 0.004;
    World w{WorldDef{}};
    const BodyId top = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, -10}});
    const WireId wire = w.wires().add({.name = "line",
                                       .from = top,
                                       .elements = 10,
                                       .length = 50.0,
                                       .EA = 1e7,
                                       .mass_per_length = 20.0,
                                       .consistent_mass = true});
    SeaDef sea = still();
    sea.lines.push_back({.wire = wire,
                         .sections = {{6, {.diameter = 0.05, .volume = thin}},
                                      {4, {.diameter = 0.05, .volume = thick}}},
                         .free_last = true});
    w.add(sea);
    const auto carried = [&] {
        take(w, 1);
        double up = 0.0;
        for (const LoadView& l : sea_loads(w)) up += l.force[2];
        return up / (kRho * kGravity);
    };
    // The fixed body carries half of the first element.
    const double whole = 27.5 * thin + 20.0 * thick;
    take(w, 600);
    EXPECT_NEAR(carried(), whole, 1e-3 * whole);  // it still moves slightly
    w.wires().insert_node(w.wires().elements(wire)[2], 0.4);
    w.wires().insert_node(w.wires().elements(wire)[9], 0.5);
    EXPECT_NEAR(carried(), whole, 1e-3 * whole);
    const WireId off = w.wires().cut(wire, 20.0);
    ASSERT_TRUE(off.valid());
    EXPECT_NEAR(carried(), whole, 2e-3 * whole);
}

TEST(Water, BadDefinitionsAreRefusedByTheirField) {
    World w{WorldDef{}};
    const BodyId body = w.add_body({.mass = 1.0, .inertia = Mat3::Identity()});
    const auto field = [&](const SeaDef& def) {
        try {
            w.add(def);
        } catch (const SeaError& error) {
            return error.field + ": " + error.what();
        }
        return std::string("none");
    };
    SeaDef open = still();
    HullMesh mesh = box_hull({1, 1, 1});
    mesh.triangles.pop_back();
    open.hulls.push_back({.body = body, .mesh = mesh});
    EXPECT_NE(field(open).find("hulls/0/mesh: "), std::string::npos);
    EXPECT_NE(field(open).find("alone: the mesh is open there"), std::string::npos) << field(open);
    EXPECT_NE(field(open).find("edge from vertex"), std::string::npos);
    mesh = box_hull({1, 1, 1});
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    open.hulls[0].mesh = mesh;
    EXPECT_NE(field(open).find("one of them is inverted"), std::string::npos) << field(open);
    mesh = box_hull({1, 1, 1});
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
    open.hulls[0].mesh = mesh;
    EXPECT_NE(field(open).find("inverted: the volume is -8"), std::string::npos) << field(open);
    SeaDef fast = still();
    fast.waves.push_back({.height = 1e-4, .period = 0.03});
    EXPECT_NE(field(fast).find("waves/0/period"), std::string::npos);
    EXPECT_NE(field(fast).find("alias"), std::string::npos);
    SeaDef nobody = still();
    nobody.bodies.push_back({.body = BodyId{99}, .height = 1.0});
    EXPECT_NE(field(nobody).find("bodies/0/body"), std::string::npos);
    EXPECT_EQ(w.system_count(), 0);
    w.add(still());
    EXPECT_THROW(w.add(still()), DefError);
}

}  // namespace
}  // namespace hawser::test
