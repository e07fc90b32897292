// SPDX-License-Identifier: Apache-2.0
// Hulls with constant added mass and damping in short waves, drag at several draughts, and the ends
// of radiation memories.
#include "validate/firstday.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kSteps60[] = {1.0 / 60.0, 1.0 / 240.0};
constexpr double kSeaDensity = 1025.0;

/// Head waves on a barge of 60 x 20 x 3 m in deep water by linear diffraction theory. Method: 540
/// source panels on the wet surface with the Green function of deep water. Damping agrees with that
/// from the exciting forces in 24 directions (Haskind's relation) to 2 %.
struct Diffraction {
    double ratio;  ///< Wavelength over length.
    double a33, b33, a55,
        b55;              ///< Added mass and damping in heave and pitch [kg, N s/m, kg m², N m s].
    double heave, pitch;  ///< Amplitude over that of the wave, and over its slope.
};
constexpr Diffraction kBargeDiffraction[] = {
    {0.65, 7.68e6, 3.07e6, 1.83e9, 6.72e8, 0.118, 0.085},
    {1.50, 9.19e6, 5.09e6, 2.53e9, 7.54e8, 0.444, 0.663},
    {3.00, 1.28e7, 4.36e6, 3.00e9, 2.88e8, 0.855, 0.929},
};

WaterHull barge_hull(BodyId body, double a33, double b33, double a55, double b55) {
    HullMesh mesh = box_hull({30, 10, 2.5}, 20, 6, 4);
    for (Vec3& v : mesh.vertices) v.z() -= 1.5;
    return {.body = body,
            .mesh = std::move(mesh),
            .added_mass = {3.7e5, 1.1e6, a33, 6e7, a55, 2e8},
            .damping = {5e4, 1e5, b33, 1.5e8, b55, 2e8}};
}

BodyDef barge_body() {
    return {.name = "barge",
            .position = {0, 0, 1},
            .mass = kSeaDensity * 60.0 * 20.0 * 3.0,
            .inertia = Vec3(2.1e8, 8.3e8, 8.3e8).asDiagonal()};
}

double deep_period(double lambda) { return std::sqrt(2.0 * kPi * lambda / kGravity); }

struct Motion {
    double heave = 0.0, pitch = 0.0;
};

Motion barge_motion(const Diffraction& d, double step, double amplitude) {
    World w(WorldDef{.step = step, .gravity = Vec3(0, 0, -kGravity)});
    const BodyId body = w.add_body(barge_body());
    const double lambda = 60.0 * d.ratio, period = deep_period(lambda), k = 2.0 * kPi / lambda;
    SeaDef sea{.depth = 1000.0};
    sea.waves.push_back({.height = 2.0 * amplitude, .period = period});
    sea.hulls.push_back(barge_hull(body, d.a33, d.b33, d.a55, d.b55));
    w.add(sea);
    const long settle = std::lround(10.0 * period / step), count = std::lround(8.0 * period / step);
    advance(w, settle);
    std::complex<double> heave = 0.0, pitch = 0.0;
    for (long i = 0; i < count; ++i) {
        advance(w, 1);
        const auto turn =
            std::polar(2.0 / static_cast<double>(count), 2.0 * kPi * w.time() / period);
        heave += (w.pose(body).position.z() - 1.0) * turn;
        pitch += 2.0 * w.pose(body).orientation.y() * turn;
    }
    return {std::abs(heave) / amplitude, std::abs(pitch) / (k * amplitude)};
}

/// Return the mean force in a soft spring that holds the barge against the drift in waves [N].
double mean_drift(double period, double amplitude, double a33, double b33) {
    World w(WorldDef{.step = 1.0 / 30.0, .gravity = Vec3(0, 0, -kGravity)});
    const BodyId body = w.add_body(barge_body());
    const BodyId earth = w.add_body({.name = "earth", .kind = BodyKind::fixed});
    SeaDef sea{.depth = 50.0};
    sea.waves.push_back({.height = 2.0 * amplitude, .period = period});
    sea.hulls.push_back(barge_hull(body, a33, b33, 6e8, 1.2e9));
    w.add(sea);
    InteractionDef spring{.kind = InteractionKind::Distance, .body = {earth, body}};
    spring.point = {Vec3(-2000, 0, 1), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    spring.compliance[0] = 2e-5;
    spring.damping_time[0] = 20.0;
    w.add_interaction(spring);
    const long count = std::lround(10.0 * period * 30.0);
    advance(w, std::lround(240.0 * 30.0));
    double sum = 0.0;
    for (long i = 0; i < count; ++i) {
        advance(w, 1);
        sum += w.pose(body).position.x();
    }
    return sum / static_cast<double>(count) / spring.compliance[0];
}

/// Return the drag force of a current on a box of 20 x 10 x 8 m at a draught, divided by ½ρ C_dA
/// u².
Vec3 current_drag(double draught, double mass, double design, double step, const Vec3& flow) {
    World w(WorldDef{.step = step, .gravity = Vec3(0, 0, -kGravity)});
    const bool held = mass <= 0.0;
    const BodyId body =
        w.add_body({.name = "box",
                    .kind = held ? BodyKind::fixed : BodyKind::rigid,
                    .position = {0, 0, 4.0 - draught},
                    .mass = held ? 0.0 : mass,
                    .inertia = Vec3::Constant(held ? 1.0 : mass * 30.0).asDiagonal()});
    w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 1.0, .gravity = false});
    SeaDef sea{.depth = 100.0};
    sea.current.push_back({0.0, flow.norm(), std::atan2(flow.y(), flow.x())});
    WaterHull hull{.body = body, .mesh = box_hull({10, 5, 4}, 4, 4, 4), .drag_area = {40, 80, 0}};
    if (design > 0.0) hull.design_draught = design;
    sea.hulls.push_back(std::move(hull));
    w.add(sea);
    advance(w, 1);
    Vec3 force = Vec3::Zero();
    for (const LoadView& load : sea_loads(w))
        if (load.body == body) force = Vec3(load.force[0], load.force[1], 0.0);
    return force / (0.5 * kSeaDensity * flow.squaredNorm());
}

WaveCoefficients peak_of_damping(double at, double half_width) {
    WaveCoefficients c;
    for (const double w : {at - half_width, at, at + half_width, at + 2.0 * half_width}) {
        c.frequency.push_back(w);
        c.added_mass.push_back(1e6 * Matrix6::Identity());
        c.damping.push_back((w == at ? 1e5 : 0.0) * Matrix6::Identity());
    }
    c.infinite = 1e6 * Matrix6::Identity();
    c.has_infinite = true;
    return c;
}

}  // namespace

void case_first_waves(Report& report) {
    for (const Diffraction& d : kBargeDiffraction)
        for (const double step : kSteps60) {
            const Motion m = barge_motion(d, step, 0.05);
            const std::string at =
                fmt::format("wavelength {:.2f} lengths, step 1/{:.0f}", d.ratio, 1.0 / step);
            report.compare("heave of a barge, " + at, {d.heave}, {m.heave}, 0.05,
                           "absolute, beside diffraction theory", 1.0);
            report.compare("its pitch over slope, " + at, {d.pitch}, {m.pitch}, 0.1,
                           "absolute: strips of the mean motion", 1.0);
        }
    for (const double period : {5.0, 6.0, 8.0}) {
        const double a = 0.5, most = 0.5 * kSeaDensity * kGravity * a * a * 20.0;
        const double drift = mean_drift(period, a, 4.4e6, 3.8e6);
        report.compare(fmt::format("mean drift at {:.0f} s over that of full reflection", period),
                       {0.5}, {drift / most}, 0.5, "between 0 and 1", 1.0);
    }
}

void case_first_drag(Report& report) {
    for (const double step : kSteps60) {
        const std::string at = fmt::format(", step 1/{:.0f}", 1.0 / step);
        for (const double draught : {1.5, 3.0, 4.5}) {
            const Vec3 x = current_drag(draught, 0.0, 3.0, step, {1.5, 0, 0});
            const Vec3 y = current_drag(draught, 0.0, 3.0, step, {0, -1.5, 0});
            report.compare(
                fmt::format("C_dA along x and y at {:.1f} of 3 m design draught{}", draught, at),
                {40.0 * draught / 3.0, -80.0 * draught / 3.0}, {x.x(), y.y()}, 1e-9, "rounding");
        }
        const double mass = kSeaDensity * 20.0 * 10.0 * 3.2;
        const Vec3 x = current_drag(3.2, mass, 0.0, step, {1.0, 0, 0});
        report.compare("C_dA of a box that floats, design draught by its mass" + at, {40.0},
                       {x.x()}, 1e-9, "rounding");
    }
}

void case_first_memory(Report& report) {
    // Triangle of damping about w0 of half width d: K(t)/K(0) = sinc²(d t/2) cos w0 t.
    const double w0 = 1.0, d = 0.1;
    const WaveCoefficients c = peak_of_damping(w0, d);
    for (const double memory : {20.0, 60.0, 400.0}) {
        double expected = 0.0;
        for (double t = 0.8 * memory; t <= memory; t += 1e-3) {
            const double x = 0.5 * d * t, s = std::sin(x) / x;
            expected = std::max(expected, std::abs(s * s * std::cos(w0 * t)));
        }
        report.compare(fmt::format("K(T)/K(0) of a peak of damping, T = {:.0f} s", memory),
                       {expected}, {memory_end(c, memory).ratio}, 0.05,
                       "5 %: sampled 25 times in the shortest period");
    }
    const MemoryEnd end = memory_end(c, 20.0);
    report.compare("K(T)/K(0) where the memory is as long as advised, at most 0.01", {0.0},
                   {memory_end(c, end.enough).ratio}, 0.0101, "limit of the warning", 1.0);
    WaveCoefficients bad = c;
    bad.damping[3] = -3e4 * Matrix6::Identity();
    const std::string fault = coefficients_fault(bad);
    report.compare("negative damping is refused, with the remedy", {1.0},
                   {fault.find("negative_damping") != std::string::npos ? 1.0 : 0.0}, 0.0, "words");
    for (const NegativeDamping how : {NegativeDamping::truncate, NegativeDamping::fit})
        report.compare(how == NegativeDamping::fit ? "\"fit\": no fault is left"
                                                   : "\"truncate\": no fault is left",
                       {1.0}, {coefficients_fault(repaired_damping(bad, how)).empty() ? 1.0 : 0.0},
                       0.0, "words");
}

}  // namespace hawser::validate
