// SPDX-License-Identifier: Apache-2.0
// A box of 10 × 10 × 4 m, and one of the size of a ship that waves press on.
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kBoxWater = 1025.0, kBoxSide = 10.0, kBoxHeight = 4.0, kBoxDraught = 2.0;
constexpr double kBoxMass = kBoxWater * kBoxSide * kBoxSide * kBoxDraught;

/// The box with its centre of mass `up` above that of its volume.
struct FloatingBox {
    World w;
    BodyId body{};
    HullMesh mesh = box_hull({0.5 * kBoxSide, 0.5 * kBoxSide, 0.5 * kBoxHeight});

    FloatingBox(double step, const Vec3& at, double heel, double up, double heave_damping)
        : w(WorldDef{.step = step}) {
        for (Vec3& v : mesh.vertices) v.z() -= up;
        const double i = kBoxMass * (kBoxSide * kBoxSide + kBoxHeight * kBoxHeight) / 12.0;
        body =
            w.add_body({.name = "box",
                        .position = at,
                        .orientation = Quat(std::cos(0.5 * heel), std::sin(0.5 * heel), 0, 0),
                        .mass = kBoxMass,
                        .inertia = Vec3(i, i, kBoxMass * kBoxSide * kBoxSide / 6.0).asDiagonal()});
        SeaDef sea{.depth = 100.0};
        sea.hulls.push_back(
            {.body = body, .mesh = mesh, .damping = {0, 0, heave_damping, 0, 0, 0}});
        w.add(sea);
    }
};

/// Return ω of x_{k+1} + x_{k−1} = 2 cos(ωh) x_k, about its mean.
double discrete_frequency(const std::vector<double>& x, double h) {
    double above = 0.0, below = 0.0;
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
        above += (x[k + 1] + x[k - 1]) * x[k];
        below += 2.0 * x[k] * x[k];
    }
    return std::acos(above / below) / h;
}

void check_heave(Report& report) {
    // ω² = ρ g A/m; the scheme has tan(ω_h h/2) = ω h/2, and keeps ½ m v² + ½ k (z − h v/2)².
    const double h = 1.0 / 60.0, omega = std::sqrt(kGravity / kBoxDraught);
    FloatingBox box(h, {0, 0, 0.5}, 0.0, 0.0, 0.0);
    const double stiffness = kBoxWater * kGravity * kBoxSide * kBoxSide;
    std::vector<double> z;
    double low = 1e300, high = 0.0;
    const long steps = std::lround(1000.0 * 2.0 * kPi / omega / h);
    for (long i = 0; i < steps; ++i) {
        advance(box.w, 1);
        const double x = box.w.pose(box.body).position.z(), v = box.w.velocity(box.body).linear.z();
        const double mean = x - 0.5 * h * v;
        const double energy = 0.5 * kBoxMass * v * v + 0.5 * stiffness * mean * mean;
        low = std::min(low, energy);
        high = std::max(high, energy);
        if (i < 6000) z.push_back(x);
    }
    report.compare("heave period at h = 1/60 [s]", {kPi * h / std::atan(0.5 * omega * h)},
                   {2.0 * kPi / discrete_frequency(z, h)}, 1e-5, "tan(w_h h/2) = w h/2");
    report.compare("its invariant over 1,000 periods, spread", {0.0}, {(high - low) / high}, 1e-9,
                   "rounding", 1.0);
}

void check_roll(Report& report) {
    // I ω² = ρ g V GM, with G 0.3 m above the centre of the volume.
    const double h = 1.0 / 240.0, up = 0.3;
    const double gm =
        0.5 * kBoxDraught + kBoxSide * kBoxSide / (12.0 * kBoxDraught) - (kBoxDraught + up);
    const double inertia = kBoxMass * (kBoxSide * kBoxSide + kBoxHeight * kBoxHeight) / 12.0;
    const double omega = std::sqrt(kBoxMass * kGravity * gm / inertia);
    FloatingBox box(h, {0, 0, up}, 1e-4, up, 0.0);
    std::vector<double> angle;
    const long steps = std::lround(20.0 * 2.0 * kPi / omega / h);
    for (long i = 0; i < steps; ++i) {
        advance(box.w, 1);
        angle.push_back(2.0 * box.w.pose(box.body).orientation.x());
    }
    report.compare("roll period, GM = 1.867 m [s]", {2.0 * kPi / omega},
                   {2.0 * kPi / discrete_frequency(angle, h)}, 1e-3,
                   "0.1 %; second order in the step");
}

}  // namespace

void case_sea_box(Report& report) {
    FloatingBox box(1.0 / 60.0, {0, 0, 0.4}, 0.0, 0.0, 1e6);
    advance(box.w, 60 * 120);
    report.compare("draught [m]", {kBoxDraught},
                   {0.5 * kBoxHeight - box.w.pose(box.body).position.z()}, 1e-10, "rounding", 1.0);
    for (Vec3& v : box.mesh.vertices) v.z() -= 1.0;
    const double bm = kBoxSide * kBoxSide / (12.0 * kBoxDraught);
    const double gm = 0.5 * kBoxDraught + bm - (0.5 * kBoxHeight + 1.0);
    for (const double degrees : {5.0, 15.0}) {
        const double phi = degrees * kPi / 180.0, t = std::tan(phi);
        report.compare(fmt::format("GZ at {:.0f} degrees, wall-sided [m]", degrees),
                       {std::sin(phi) * (gm + 0.5 * bm * t * t)},
                       {righting_lever(box.mesh, kBoxMass, kBoxWater, phi)}, 1e-9, "rounding", 1.0);
    }
}

void case_sea_periods(Report& report) {
    check_heave(report);
    check_roll(report);
}

void case_sea_froude_krylov(Report& report) {
    // λ = 160 m in deep water, a = 0.5 m, over one period.
    constexpr double kLong = 80.0, kWide = 18.0, kDeep = 5.0, kWave = 0.5, kDepth = 1000.0;
    const double k = 2.0 * kPi / 160.0, omega = std::sqrt(kGravity * k * std::tanh(k * kDepth));
    const double period = 2.0 * kPi / omega;
    World w(WorldDef{.step = period / 200.0});
    const BodyId box = w.add_body({.name = "box", .kind = BodyKind::fixed});
    // A world needs at least one moving body.
    w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 1.0, .gravity = false});
    HullMesh mesh = box_hull({0.5 * kLong, 0.5 * kWide, kDeep}, 40, 6, 10);
    SeaDef sea{.depth = kDepth};
    sea.waves.push_back({.height = 2.0 * kWave, .period = period});
    sea.hulls.push_back({.body = box, .mesh = std::move(mesh)});
    w.add(sea);
    // The first harmonic of the force up, of which ρgV is the mean.
    std::complex<double> sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double t = w.time();
        advance(w, 1);
        for (const LoadView& load : sea_loads(w))
            if (load.body == box) sum += load.force[2] * std::polar(1.0, omega * t) / 100.0;
    }
    const double half = 0.5 * k * kLong;
    const double expected =
        kBoxWater * kGravity * kWave * kWide * kLong * std::exp(-k * kDeep) * std::sin(half) / half;
    report.compare("Froude-Krylov force up on a box of 80 x 18 m, 5 m deep [N]", {expected},
                   {std::abs(sum)}, 5e-3, "0.5 %: panels of 2 m, stretching of second order");
}

}  // namespace hawser::validate
