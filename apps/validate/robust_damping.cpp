// SPDX-License-Identifier: Apache-2.0
// Orders of dampers at steps that resolve them: a body on a spring and a damper, one with drag, a
// heaving hull. All have closed forms.
#include "validate/robust.h"
#include "validate/tools.h"

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

/// Return x(t) of x'' + 2 d x' + w² x = 0 from x(0) = 1, x'(0) = 0, d < w.
double damped_oscillation(double d, double w, double t) {
    const double rate = std::sqrt(w * w - d * d);
    return std::exp(-d * t) * (std::cos(rate * t) + d / rate * std::sin(rate * t));
}

/// Return the largest |reference − value| over 2 s, sampled every 1/60 s.
template <class Value, class Reference>
double largest_error(World& world, Value&& value, Reference&& reference) {
    const long each = std::lround(1.0 / 60.0 / world.settings().step);
    double worst = 0.0;
    for (int k = 1; k <= 120; ++k) {
        advance(world, each);
        worst = std::max(worst, std::abs(value(world) - reference(k / 60.0)));
    }
    return worst;
}

World still_world(double step) {
    WorldDef def;
    def.step = step;
    def.gravity = Vec3::Zero();
    return World(def);
}

/// Return the error of 1 kg on 100 N/m and 2 N s/m, from 0.1 m away [m].
double damper_error(double step) {
    World w = still_world(step);
    const BodyId wall = w.add_body({.name = "wall", .kind = BodyKind::fixed});
    const BodyId bob = w.add_body(
        {.name = "bob", .kind = BodyKind::lump, .position = Vec3(1.1, 0, 0), .mass = 1.0});
    InteractionDef spring;
    spring.kind = InteractionKind::Distance;
    spring.body = {wall, bob, BodyId{}};
    spring.set("length", 1.0);
    spring.compliance[0] = 0.01;
    spring.damping_time[0] = 0.02;
    w.add_interaction(spring);
    return largest_error(
        w, [&](const World& now) { return now.pose(bob).position.x() - 1.0; },
        [](double t) { return 0.1 * damped_oscillation(1.0, 10.0, t); });
}

/// Return the error of 2 kg thrown at 3 m/s against 4 N s/m, under 1 N along its path [m].
double drag_error(double step) {
    World w = still_world(step);
    const BodyId ball = w.add_body({.name = "ball",
                                    .kind = BodyKind::lump,
                                    .velocity = Vec3(3, 0, 0),
                                    .mass = 2.0,
                                    .force = Vec3(1, 0, 0),
                                    .linear_damping = Vec3::Constant(4.0)});
    return largest_error(
        w, [&](const World& now) { return now.pose(ball).position.x(); },
        [](double t) { return 0.25 * t + (3.0 - 0.25) / 2.0 * (1.0 - std::exp(-2.0 * t)); });
}

/// Return the error of a hull of 2,000 t, heave period 6 s, damped by a tenth of critical, from 1 m
/// too high [m].
double heave_error(double step) {
    constexpr double kMass = 2e6, kRate = 2.0 * kPi / 6.0, kShare = 0.1;
    World w = still_world(step);
    BodyDef hull;
    hull.name = "hull";
    hull.position = Vec3(0, 0, 1);
    hull.mass = kMass;
    hull.inertia = Vec3(1e8, 1e9, 1e9).asDiagonal().toDenseMatrix();
    hull.gravity = false;
    const BodyId id = w.add_body(hull);
    InteractionDef water;
    water.kind = InteractionKind::Hydrostatic;
    water.body = {id, BodyId{}, BodyId{}};
    water.set("heave_stiffness", kMass * kRate * kRate);
    water.set("roll_stiffness", 1e8);
    water.set("pitch_stiffness", 1e9);
    water.set("heave_damping", 2.0 * kShare * kMass * kRate);
    water.set("rest_height", 0.0);
    w.add_interaction(water);
    return largest_error(
        w, [&](const World& now) { return now.pose(id).position.z(); },
        [](double t) { return damped_oscillation(kShare * kRate, kRate, t); });
}

void study(Report& report, const char* quantity, double scale, double limit, const char* reason,
           double (*error)(double)) {
    std::vector<double> steps{1.0 / 60, 1.0 / 240, 1.0 / 960}, errors;
    errors.reserve(steps.size());
    for (const double h : steps) errors.push_back(error(h));
    Check& c = report.compare(quantity, {0.0}, {errors.front()}, limit, reason, scale);
    c.steps = steps;
    c.errors = errors;
    // Over both quarterings together.
    c.order = std::log(errors.front() / errors.back()) / std::log(16.0);
    c.min_order = 1.9;
    c.passed = c.passed && c.order >= c.min_order;
}

}  // namespace

void case_damping_orders(Report& report) {
    study(report, "spring and damper, error at 1/60 [m]", 0.1, 1e-2, "of the first swing",
          damper_error);
    study(report, "drag, error at 1/60 [m]", 1.375, 1e-3, "of the way until it is steady",
          drag_error);
    study(report, "heave of a hull, error at 1/60 [m]", 1.0, 1e-2, "of the first swing",
          heave_error);
}

}  // namespace hawser::validate
