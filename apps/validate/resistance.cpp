// SPDX-License-Identifier: Apache-2.0
// Resistance to rolling and spinning against closed forms.
#include "validate/cases.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::validate {
namespace {

// Constants of the scene.
constexpr double kBallRadius = 0.5, kRollingFriction = 0.05, kTorsionalFriction = 0.02,
                 kSlopeOfRolling = 0.2;

std::vector<BodyId> group(const World& world, const char* name, int count) {
    std::vector<BodyId> ids;
    for (int i = 0; i < count; ++i) ids.push_back(body(world, fmt::format("{}{}", name, i)));
    return ids;
}

/// Return the value with the largest distance from `wanted`.
double farthest_from_wanted(double wanted, const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end(), [&](double a, double b) {
        return std::abs(a - wanted) < std::abs(b - wanted);
    });
}

/// Check balls at rest on a slope. Report their displacement and rotation after the first second.
void report_hold(Report& report) {
    scene::Scene s = open_scene("rolling_resistance", 1.0 / 60.0);
    const std::vector<BodyId> balls = group(s.world, "hold", 8);
    advance(s.world, steps_to(s.world, 1.0));
    std::vector<Pose> start;
    for (const BodyId b : balls) start.push_back(s.world.pose(b));
    double drift = 0.0, turn = 0.0;
    for (int second = 0; second < 100; ++second) {
        advance(s.world, 60);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const Pose now = s.world.pose(balls[i]);
            drift = std::max(drift, (now.position - start[i].position).norm());
            turn =
                std::max(turn, (now.orientation.coeffs() - start[i].orientation.coeffs()).norm());
        }
    }
    report.compare("drift at 95 % of the slope that rolls, 8 headings, 1 to 101 s [m]", {0.0},
                   {drift}, 1e-9, "absolute: the resistance is a spring, nothing creeps", 1.0);
    report.compare("turn at 95 % of the slope that rolls, 8 headings, 1 to 101 s [rad]", {0.0},
                   {2.0 * turn}, 1e-9, "absolute", 1.0);
}

}  // namespace

void case_rolling_resistance(Report& report) {
    report_hold(report);
    constexpr double kStep = 1.0 / 240.0;
    scene::Scene s = open_scene("rolling_resistance", kStep);
    const std::vector<BodyId> rolling = group(s.world, "roll", 8);
    const std::vector<BodyId> stopping = group(s.world, "stop", 8);
    const std::vector<BodyId> spinning = group(s.world, "spin", 2);
    std::vector<Vec3> from, start;
    for (const BodyId b : stopping) start.push_back(s.world.pose(b).position);

    advance(s.world, steps_to(s.world, 0.25));
    std::vector<double> spin;
    for (const BodyId b : spinning) spin.push_back(std::abs(s.world.velocity(b).angular.z()));
    const double torsion =
        2.5 * kTorsionalFriction * kGravity / (kBallRadius * kBallRadius);  // of I = 2/5 m R²
    const double left = 2.0 - torsion * (0.25 - 0.5 * kStep);
    report.compare("spin after 0.25 s [rad/s]", {left}, {farthest_from_wanted(left, spin)}, 1e-3,
                   "relative; w - 5 mu_s g t/(2 R^2)");

    for (const BodyId b : rolling) from.push_back(s.world.velocity(b).linear);
    for (const BodyId b : stopping) from.push_back(s.world.velocity(b).linear);
    advance(s.world, steps_to(s.world, 1.5));
    double spun = 0.0;
    for (const BodyId b : spinning) spun = std::max(spun, s.world.velocity(b).angular.norm());
    report.compare("spin after 1.5 s [rad/s]", {0.0}, {spun}, 1e-9,
                   "absolute; it stops at 2 R^2 w/(5 mu_s g) = 1.02 s", 1.0);

    const double angle = std::atan(kSlopeOfRolling), bound = kRollingFriction / kBallRadius;
    const double down = 5.0 / 7.0 * kGravity * (std::sin(angle) - bound * std::cos(angle));
    const double slower = 5.0 / 7.0 * kGravity * bound;
    std::vector<double> gained, lost, off, way;
    for (std::size_t i = 0; i < 8; ++i) {
        const double fall = static_cast<double>(i) * kPi / 4.0;
        const Vec3 heading{std::cos(fall), std::sin(fall), 0.0};
        const Vec3 a = (s.world.velocity(rolling[i]).linear - from[i]) / 1.25;
        gained.push_back(a.norm());
        off.push_back((a - a.dot(heading) * heading).head<2>().norm());
        lost.push_back((from[8 + i] - s.world.velocity(stopping[i]).linear).dot(heading) / 1.25);
    }
    report.compare("rolling down, worst of 8 headings [m/s^2]", {down},
                   {farthest_from_wanted(down, gained)}, 1e-3,
                   "relative; 5/7 (g sin a - mu_r/R g cos a)");
    report.compare("off its heading [m/s^2]", {0.0}, {farthest_from_wanted(0.0, off)}, 1e-3,
                   "of the acceleration: a disk, not a box", down);
    report.compare("rolling on the level, worst of 8 headings [m/s^2]", {slower},
                   {farthest_from_wanted(slower, lost)}, 1e-3, "relative; 5/7 mu_r g/R");
    advance(s.world, steps_to(s.world, 4.0));
    for (std::size_t i = 0; i < 8; ++i)
        way.push_back((s.world.pose(stopping[i]).position - start[i]).norm());
    const double stop = 2.0 * 2.0 / (2.0 * slower);
    report.compare("way until it stops, worst of 8 headings [m]", {stop},
                   {farthest_from_wanted(stop, way)}, 1e-3, "relative; v^2/(2 a)");
}

}  // namespace hawser::validate
