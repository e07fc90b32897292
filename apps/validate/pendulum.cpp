// SPDX-License-Identifier: Apache-2.0
// The simple pendulum against elliptic functions.
#include "validate/cases.h"
#include "validate/reference.h"
#include "validate/tools.h"

#include <cmath>

namespace hawser::validate {
namespace {

constexpr double kNaturalFrequency = 3.1320919526731650;  // √(9.81/1) [rad/s]

/// Return the period of the pendulum of 1 m released at `angle` [rad]: 4 √(L/g) K(sin(angle/2)).
double exact_period(double angle) {
    return 4.0 * elliptic_k(std::sin(0.5 * angle)) / kNaturalFrequency;
}

/// Return the position (x, z) of a pendulum that is released from rest at −90 degrees: sin(θ/2) =
/// −k sn(ω t + K, k), k = sin 45°.
std::vector<double> exact_position(double time) {
    const double k = std::sin(0.25 * kPi);
    const double half = std::asin(-k * jacobi_sn(kNaturalFrequency * time + elliptic_k(k), k));
    return {std::sin(2.0 * half), -std::cos(2.0 * half)};
}

double measured_period(const std::string& name, double step) {
    scene::Scene s = open_scene(name, step);
    const BodyId bob = body(s.world, "bob");
    std::vector<double> x{s.world.pose(bob).position.x()};
    while (s.world.time() < 4.0) {
        advance(s.world, 1);
        x.push_back(s.world.pose(bob).position.x());
    }
    const std::vector<double> zeros = upward_zeros(x, step);
    return zeros.at(1) - zeros.at(0);
}

}  // namespace

void case_pendulum_period(Report& report) {
    const struct {
        const char* scene;
        const char* quantity;
        double degrees;
    } variants[] = {{"pendulum", "period from 90 deg [s]", 90.0},
                    {"pendulum_30", "period from 30 deg [s]", 30.0},
                    {"pendulum_small", "period from 0.1 deg [s]", 0.1}};
    for (const auto& v : variants) {
        report.converge({{v.quantity, {exact_period(v.degrees * kPi / 180.0)}}},
                        [&](double step) -> Result { return {{measured_period(v.scene, step)}}; });
    }
}

void case_pendulum_a01(Report& report) {
    const double times[] = {1.0, 2.0, 5.0, 10.0};
    std::vector<Target> targets;
    for (const double t : times) {
        Target target;
        target.quantity = "position (x, z) at " + std::to_string(static_cast<int>(t)) + " s [m]";
        target.reference = exact_position(t);
        target.reason = "relative to the rod of 1 m";
        targets.push_back(target);
    }
    report.converge(targets, [&](double step) {
        scene::Scene s = open_scene("pendulum", step);
        const BodyId bob = body(s.world, "bob");
        Result result;
        for (const double t : times) {
            advance(s.world, steps_to(s.world, t));
            const Vec3 p = s.world.pose(bob).position;
            result.push_back({p.x(), p.z()});
        }
        return result;
    });
    // The closed form against the integrated equation: the reference is itself checked.
    for (std::size_t i = 0; i < 4; ++i) {
        report.compare("closed form against integration", {kA01[2 * i], kA01[2 * i + 1]},
                       targets[i].reference, 1e-11, "round-off of two independent references");
    }
}

}  // namespace hawser::validate
