// SPDX-License-Identifier: Apache-2.0
// Drag, buoyancy and waves on nodes and lines.
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

constexpr double kSeaWater = 1025.0;

void check_sinking_chain(Report& report) {
    scene::Scene s = open_scene("wire_sink", 1.0 / 60.0);
    advance(s.world, steps_to(s.world, s.duration));
    const double expected = std::sqrt(2.0 * 0.87 * 126.5 * kGravity / (kSeaWater * 2.6 * 0.076));
    double most = expected;
    for (int i = 0; i <= 10; ++i) {
        const double speed =
            -s.world.velocity(body(s.world, fmt::format("chain/{}", i))).linear.z();
        if (std::abs(speed - expected) >= std::abs(most - expected)) most = speed;
    }
    report.compare("76 mm stud chain sinks, farthest of its lumps [m/s]", {expected}, {most}, 1e-3,
                   "0.1 %; 3.265 m/s");
}

void check_drifters(Report& report) {
    scene::Scene s = open_scene("drifter", 1.0 / 60.0);
    const double flow = 1.5, c = 0.5 * kSeaWater * 0.8;
    for (const double t : {5.0, 20.0, 60.0}) {
        advance(s.world, steps_to(s.world, t) - s.world.step_count());
        // Velocities are those of half a step earlier.
        const double at = s.world.time() - 0.5 * s.world.settings().step;
        report.compare(fmt::format("slip of a drifter after {:.0f} s [m/s]", t),
                       {flow / (1.0 + c * flow * at / 500.0)},
                       {flow - s.world.velocity(body(s.world, "drifter")).linear.x()}, 1e-3,
                       "0.1 %");
    }
    report.compare("a body on a spring in a current lies off by [m]", {c * flow * flow / 400.0},
                   {s.world.pose(body(s.world, "held")).position.x() - 50.0}, 1e-3, "0.1 %");
}

void check_circles(Report& report) {
    const double period = 8.0, omega = 2.0 * kPi / period, k = omega * omega / kGravity;
    for (const double z : {-2.0, -10.0}) {
        const double a = 0.01 / k, radius = a * std::exp(k * z);
        SeaDef sea{.depth = 3000.0};
        sea.waves.push_back({.height = 2.0 * a, .period = period});
        World w(WorldDef{});
        const Sea water(sea, kGravity);
        const BodyId lump = w.add_body({.name = "lump",
                                        .kind = BodyKind::lump,
                                        .position = {0, 0, z},
                                        .velocity = water.water(water.at(0.0), {0, 0, z}).velocity,
                                        .mass = 0.1 * kSeaWater});
        sea.bodies.push_back({.body = lump,
                              .drag_area = Vec3::Constant(0.1),
                              .volume = 0.1,
                              .added_mass = Vec3::Constant(0.5)});
        w.add(sea);
        double low = 1e300, high = -1e300;
        for (int i = 0; i < 480; ++i) {
            advance(w, 1);
            low = std::min(low, w.pose(lump).position.z());
            high = std::max(high, w.pose(lump).position.z());
        }
        report.compare(fmt::format("circle of a neutral lump at {:.0f} m, ka = 0.01 [m]", z),
                       {radius}, {0.5 * (high - low)}, 5e-3, "0.5 %: waves of first order");
    }
}

}  // namespace

void case_sea_drag(Report& report) {
    check_sinking_chain(report);
    check_drifters(report);
    check_circles(report);
}

}  // namespace hawser::validate
