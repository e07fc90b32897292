// SPDX-License-Identifier: Apache-2.0
// Bending: sag under own weight, buckling.
#include "validate/cases.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

/// Return the sag at a node after settling [m]. The mean of two steps removes remaining
/// under-resolved waves.
double sag(const std::string& name, std::size_t node, double* speed) {
    scene::Scene s = open_scene(name, 1.0 / 60.0);
    advance(s.world, steps_to(s.world, s.duration));
    const BodyId id = s.cables.at(0).nodes.at(node);
    const double first = s.world.pose(id).position.z();
    advance(s.world, 1);
    *speed = s.world.velocity(id).linear.norm();
    return -0.5 * (first + s.world.pose(id).position.z());
}

/// Return the buckling load P of a column of n elements [N]. The column starts in the first mode
/// with 1 µm. Bisection around the load π² EI/L² of a continuous column finds the least load at
/// which the mode grows.
double buckling_load(int elements) {
    constexpr double kLength = 10.0, kStiffness = 1e9, kBending = 1e5;
    constexpr double kEulerLoad = kPi * kPi * kBending / (kLength * kLength);
    const auto grows = [&](double load) {
        const double length = kLength / (1.0 - load / kStiffness);
        scene::Scene s = open_scene("euler_column", 1.0 / 480.0,
                                    {fmt::format("cables.column.elements={}", elements),
                                     fmt::format("cables.column.length={:.17g}", length)});
        const std::vector<BodyId>& nodes = s.cables.at(0).nodes;
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
            Pose pose = s.world.pose(nodes[i]);
            pose.position.x() += 1e-6 * std::sin(kPi * static_cast<double>(i) / elements);
            s.world.set_pose(nodes[i], pose);
        }
        const BodyId middle = nodes[nodes.size() / 2];
        const long half = steps_to(s.world, 0.5 * s.duration);
        advance(s.world, half);
        const double before = std::abs(s.world.pose(middle).position.x());
        advance(s.world, half);
        const double after = std::abs(s.world.pose(middle).position.x());
        // Below the load the bow dies away to round-off; above, it grows until it has buckled.
        return after > 1e-5 || after > std::max(before, 1e-8);
    };
    double low = 0.9 * kEulerLoad, high = 1.05 * kEulerLoad;
    if (grows(low) || !grows(high)) return 0.0;  // outside the bracket: report 0
    for (int i = 0; i < 11; ++i) {               // to 7e-5 of the load
        const double middle = 0.5 * (low + high);
        (grows(middle) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

void case_beams(Report& report) {
    constexpr double kWeight = 980.665, kLength = 10.0, kStiffness = 1e7;
    const double scale = kWeight * std::pow(kLength, 4) / kStiffness;
    double speed = 0.0;
    const double tip = sag("cantilever", 40, &speed);
    report.compare("tip of the cantilever, wL4/8EI [m]", {scale / 8.0}, {tip}, 1e-2, "40 elements");
    report.compare("speed of the tip after settling [m/s]", {0.0}, {speed}, 1e-6,
                   "absolute: the beam is at rest", 1.0);
    const double middle = sag("simply_supported", 20, &speed);
    report.compare("middle of the beam, 5wL4/384EI [m]", {5.0 * scale / 384.0}, {middle}, 1e-2,
                   "40 elements");
    report.compare("speed of the middle after settling [m/s]", {0.0}, {speed}, 1e-6,
                   "absolute: the beam is at rest", 1.0);
}

void case_euler_column(Report& report) {
    constexpr double kLength = 10.0, kBending = 1e5;
    for (const int n : {5, 10, 20}) {
        const double l = kLength / n;
        // Discrete chain: P = (4 EI/l²) sin²(π/2N)
        const double exact = 4.0 * kBending / (l * l) * std::pow(std::sin(kPi / (2.0 * n)), 2);
        report.compare(fmt::format("buckling load of {} elements [N]", n), {exact},
                       {buckling_load(n)}, 1e-3, "relative, against the lumped form");
    }
}

}  // namespace hawser::validate
