// SPDX-License-Identifier: Apache-2.0
// Ends of ranges, restitution, and contacts without friction, at 1/60 and 1/240 s.
#include "validate/robust_tools.h"
#include "validate/untuned.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::validate {
namespace {

constexpr double kStopSteps[] = {1.0 / 60.0, 1.0 / 240.0};

std::string at_step(const char* what, double step) {
    return fmt::format("{}, 1/{:.0f} s: ", what, 1.0 / step);
}

/// An arm of 10 kg whose motor drives it against the end of its range at 0.5 rad.
struct Arm {
    World world;
    InteractionId range;
};
Arm make_arm(double step, double torque) {
    Arm out{World({.step = step}), {}};
    World& w = out.world;
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId arm = w.add_body(solid_box({0.5, 0, 0}, 10.0, {0.5, 0.05, 0.05}));
    const auto add = [&](InteractionKind kind) {
        return joint(w, kind, ground, arm, {0, 0, 0}, -Vec3::UnitY());
    };
    w.add_interaction(add(InteractionKind::Hinge));
    InteractionDef range = add(InteractionKind::HingeRange);
    out.range = w.add_interaction(range.set("min", -0.5).set("max", 0.5));
    InteractionDef motor = add(InteractionKind::HingeMotor);
    motor.set("speed", 20.0).set("force_min", -torque).set("force_max", torque);
    w.add_interaction(motor);
    return out;
}

void report_arm(Report& report, double step) {
    double overshoot = 0.0, rest = 0.0, gained = 0.0, good = 1.0;
    for (const double torque : {60.0, 500.0, 5e3, 1e5, 1e6}) {
        Arm a = make_arm(step, torque);
        advance(a.world, 2);  // the work of the first step belongs to both sides of the start
        const double start = a.world.energy().mechanical() - a.world.energy().driven;
        for (long k = steps_to(a.world, 10.0); k > 0; --k) {
            advance(a.world, 1);
            const Energy e = a.world.energy();
            overshoot = std::max(overshoot, a.world.coordinate(a.range) - 0.5);
            gained = std::max(gained, (e.mechanical() - e.driven - start) / torque);
        }
        rest = std::max(rest, std::abs(a.world.coordinate(a.range) - 0.5));
        good = std::min(good, a.world.verdict().grade == Grade::good ? 1.0 : 0.0);
    }
    const std::string at = at_step("motor of 60 N m to 1 MN m against a range", step);
    // The compliance of an end is 1e-12 rad/(N m): 1e-6 rad under 1 MN m.
    require_below(report, at + "beyond the end [rad]", overshoot, 2e-6, "compliance of the end");
    require_below(report, at + "distance from the end at rest [rad]", rest, 2e-6,
                  "compliance of the end");
    require_below(report, at + "energy gained [J/(N m)]", gained, 1e-3, "second order in the step");
    report.compare(at + "results of the monitors, 1: all good", {1.0}, {good}, 0.0, "exact");
}

World make_ball(double step, double drop, double restitution) {
    World w({.step = step});
    const MaterialId rubber =
        w.add_material({.name = "rubber", .friction = 0.0, .restitution = restitution});
    ShapeDef plane{.kind = ShapeKind::plane, .body = w.add_body({.kind = BodyKind::fixed})};
    plane.material = rubber;
    w.add_shape(plane);
    BodyDef b = solid_box({0, 0, drop + 0.1}, 1.0, {0.06, 0.06, 0.06});
    ShapeDef ball{.kind = ShapeKind::sphere, .body = w.add_body(b), .radius = 0.1};
    ball.material = rubber;
    w.add_shape(ball);
    return w;
}

/// Return the height of a ball that falls from `drop` and bounces.
double bounced_height(double drop, double restitution, double time) {
    double speed = std::sqrt(2.0 * kGravity * drop), left = time - speed / kGravity;
    if (left < 0.0) return drop - 0.5 * kGravity * time * time;
    speed *= restitution;
    for (; left > 2.0 * speed / kGravity; speed *= restitution) left -= 2.0 * speed / kGravity;
    return speed * left - 0.5 * kGravity * left * left;
}

void report_bounces(Report& report, double step) {
    for (const double e : {1.0, 0.9, 0.6}) {
        double most = 0.0, energy = 0.0, good = 1.0;
        for (const double drop : {10.0, 7.3, 2.1}) {
            World w = make_ball(step, drop, e);
            // Bounces slower than 2 g h are inelastic. These are faster.
            const long steps = std::lround((e == 1.0 ? 60.0 : e == 0.9 ? 5.0 : 1.8) / step);
            advance(w, 1);
            const double start = w.energy().mechanical();
            for (long k = 2; k <= steps; ++k) {
                advance(w, 1);
                const double exact = bounced_height(drop, e, static_cast<double>(k) * step) + 0.1;
                most = std::max(most, std::abs(w.pose(BodyId{1}).position.z() - exact) / drop);
                const Energy now = w.energy();
                const double held = now.mechanical() + now.contact;
                energy = std::max(energy, std::abs(held - start) / start);
            }
            good = std::min(good, w.verdict().grade == Grade::good ? 1.0 : 0.0);
        }
        const std::string at = at_step(fmt::format("restitution {}", e).c_str(), step);
        require_below(report, at + "error of the height, of the drop", most, 1e-3,
                      "closed form, drops of 2.1 to 10 m");
        require_below(report, at + "energy that nothing explains", energy, 1e-3, "of the start");
        report.compare(at + "results of the monitors, 1: all good", {1.0}, {good}, 0.0, "exact");
    }
}

/// A capsule without friction between a fixed body, `gap` above a plane, and a mass on it.
World make_skid(double step, double gap) {
    World w({.step = step});
    const MaterialId ice = w.add_material({.name = "ice", .friction = 0.0});
    ShapeDef plane{.kind = ShapeKind::plane, .body = w.add_body({.kind = BodyKind::fixed})};
    plane.material = ice;
    w.add_shape(plane);
    const BodyId end = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, 0.1 + gap}});
    const BodyId mass = w.add_body({.kind = BodyKind::lump, .position = {2, 0, 0.1}, .mass = 10.0});
    ShapeDef capsule{.kind = ShapeKind::capsule, .body = mass, .body_b = end, .radius = 0.1};
    capsule.material = ice;
    w.add_shape(capsule);
    InteractionDef line{.kind = InteractionKind::Stretch, .body = {end, mass}};
    w.add_interaction(line.set("length", 2.0).set("EA", 1e6));
    return w;
}

}  // namespace

void case_stops(Report& report) {
    for (const double step : kStopSteps) report_arm(report, step);
}

void case_restitution(Report& report) {
    for (const double step : kStopSteps) report_bounces(report, step);
}

void case_frictionless(Report& report) {
    for (const double step : kStopSteps) {
        double map = 0.0, factorisations = 0.0, height = 0.0;
        for (const double gap : {1e-14, 1e-12, 1e-8, 1e-4, 1e-2}) {
            World w = make_skid(step, gap);
            const long steps = steps_to(w, 2.0);
            long all = 0;
            for (long k = 0; k < steps; ++k) {
                advance(w, 1);
                map = std::max(map, w.stats().natural_map);
                all += w.stats().factorisations;
            }
            factorisations =
                std::max(factorisations, static_cast<double>(all) / static_cast<double>(steps));
            height = std::max(height, std::abs(w.pose(BodyId{2}).position.z() - 0.1));
        }
        const std::string at = at_step("fixed end 1e-14 to 1e-2 m over a bed", step);
        require_below(report, at + "natural map", map, 1e-6, "tolerance of contacts");
        require_below(report, at + "factorisations a step", factorisations, 2.0, "mean");
        require_below(report, at + "height of the mass [m]", height, 1e-5, "compliance");
    }
}

}  // namespace hawser::validate
