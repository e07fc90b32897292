// SPDX-License-Identifier: Apache-2.0
// The sphere of IEA OES Task 10, released 1 m above rest, with the coefficients of A. Hulme (1982).
// Source: F. Wendt and others, "Ocean energy systems wave energy modelling task: modelling,
// verification and validation of wave energy converters", 2019.
#include <hawser/hydro_files.h>

#include "validate/data.h"
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kSphereStep = 0.01, kSphereBelow = 2.0;

/// Run a world, and return the height of the centre of the sphere after each step.
std::vector<double> heights(World& w, double duration) {
    const BodyId sphere = body(w, "sphere");
    std::vector<double> out;
    for (long i = std::lround(duration / kSphereStep); i > 0; --i) {
        advance(w, 1);
        out.push_back(w.pose(sphere).position.z() + kSphereBelow);
    }
    return out;
}

/// Find the times at which a signal passes 0 in either direction, and its extremes between them.
void find_crossings(const std::vector<double>& z, std::vector<double>& at,
                    std::vector<double>& extreme) {
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const double t = kSphereStep * static_cast<double>(i + 1);
        if (z[i] * z[i + 1] < 0.0) at.push_back(t + kSphereStep * z[i] / (z[i] - z[i + 1]));
        if (i > 0 && (z[i] - z[i - 1]) * (z[i + 1] - z[i]) < 0.0) extreme.push_back(z[i]);
    }
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (!std::isnan(a[i]) && !std::isnan(b[i])) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Simulate the sphere of the scene with the wave coefficients `c`. Return its heights.
std::vector<double> with_coefficients(WaveCoefficients c) {
    World w(WorldDef{.step = kSphereStep});
    const double mass = 261.8e3;
    const BodyId sphere = w.add_body({.name = "sphere",
                                      .position = {0, 0, 1.0 - kSphereBelow},
                                      .mass = mass,
                                      .inertia = Vec3::Constant(1e7).asDiagonal()});
    c.reference = {0, 0, kSphereBelow};
    const double plane = 1000.0 * kGravity * kPi * 25.0;
    c.stiffness.setZero();
    c.stiffness(2, 2) = plane;
    c.stiffness(3, 3) = c.stiffness(4, 4) = mass * kGravity * kSphereBelow;
    c.has_stiffness = true;
    SeaDef sea{.depth = 1000.0, .density = 1000.0};
    WaterHull hull{.body = sphere, .wave_pressure = false, .memory = 40.0};
    hull.coefficients = std::make_shared<const WaveCoefficients>(std::move(c));
    hull.linear = {.on = true, .height = -kSphereBelow};
    sea.hulls.push_back(hull);
    w.add(sea);
    return heights(w, 40.0);
}

}  // namespace

void case_sea_sphere(Report& report) {
    auto scene = open_scene("sphere_decay", kSphereStep);
    const std::vector<double> z = heights(scene.world, 40.0);
    std::vector<double> at, extreme;
    find_crossings(z, at, extreme);
    const double when[] = {1.139, 3.390, 5.579, 7.748}, peak[] = {-0.866, 0.636, -0.464, 0.346};
    for (std::size_t i = 0; i < 4; ++i)
        report.compare(fmt::format("sphere let go, {}. crossing [s]", i + 1), {when[i]}, {at.at(i)},
                       0.01, "0.01 s", 1.0);
    for (std::size_t i = 0; i < 4; ++i)
        report.compare(fmt::format("sphere let go, {}. extreme [m]", i + 1), {peak[i]},
                       {extreme.at(i)}, 0.01, "1 %");
    auto states = open_scene("sphere_decay", kSphereStep, {"sea.hulls.0.radiation=state_space"});
    report.compare("8 states beside the convolution, 40 s [m]", {0.0},
                   {largest_difference(z, heights(states.world, 40.0))}, 2e-3, "2 mm", 1.0);
    if (data_folder().empty()) return;
    const auto others = data_columns("sphere_ref.txt");
    report.compare("beside InWave+H, 40 s [m]", {0.0}, {largest_difference(z, others.at(6))}, 0.02,
                   "0.02 m", 1.0);
    for (const char* name : {"sphere.h5", "capytaine_sphere.nc"}) {
        WaveCoefficients c = read_coefficients(data_file(name), {.density = 1000.0});
        report.compare(fmt::format("with coefficients of {} beside InWave+H [m]", name), {0.0},
                       {largest_difference(with_coefficients(std::move(c)), others.at(6))}, 0.02,
                       "0.02 m", 1.0);
    }
}

}  // namespace hawser::validate
