// SPDX-License-Identifier: Apache-2.0
// Dry friction in joints, ends of travel and motors of limited force against closed forms.
#include "validate/cases.h"
#include "validate/tools.h"

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

double speed(const World& world, const char* name) {
    return world.velocity(body(world, name)).linear.norm();
}
double spin_rate(const World& world, const char* name) {
    return world.velocity(body(world, name)).angular.x();
}
double force(const World& world, const char* name) {
    return world.force(interaction(world, name))[0];
}

/// Return the largest distance of a body from its present position, over a time.
double largest_drift(World& world, const char* name, double time) {
    const Vec3 from = world.pose(body(world, name)).position;
    double most = 0.0;
    const long steps = steps_to(world, world.time() + time);
    for (long k = 0; k < steps; ++k) {
        advance(world, 1);
        most = std::max(most, (world.pose(body(world, name)).position - from).norm());
    }
    return most;
}

/// Return the time to which the velocities belong: half a step before the time of the poses [s].
double middle(const World& world) { return world.time() - 0.5 * world.settings().step; }

}  // namespace

void case_joint_friction(Report& report) {
    // Past its own two seconds the weight that runs is pulled into its bollard, which does not
    // count.
    scene::Scene s = open_scene("joint_friction", 1.0 / 240.0, {"settings.on_diverged=warn"});
    World& w = s.world;
    const double slope = std::atan(0.4), cosine = std::cos(slope), sine = std::sin(slope);
    advance(w, 60);
    const double t0 = middle(w);
    report.compare("sliding block, friction 0.3 of the slide's force, slope 0.4 [m/s]",
                   {kGravity * (sine - 0.3 * cosine) * t0}, {speed(w, "slips")}, 1e-6,
                   "relative, that of the solve; g (sin a - mu cos a) t");
    report.compare("block at 2 m/s against 300 N on 100 kg [m/s]", {2.0 - 3.0 * t0},
                   {speed(w, "stops")}, 1e-9, "relative; v - F t/m");
    report.compare("wheel at 10 rad/s against 12 N m on 3 kg m2 [rad/s]", {10.0 - 4.0 * t0},
                   {spin_rate(w, "coasts")}, 1e-9, "relative; w - T t/I");
    report.compare("wheel of 20 kg in a bearing, 0.02 m of its force [rad/s]",
                   {10.0 - 0.02 * 20.0 * kGravity / 3.0 * t0}, {spin_rate(w, "bearing")}, 1e-9,
                   "relative; w - mu r m g t/I");
    // Both stop, at 2/3 s and 2.5 s, and stay at rest.
    advance(w, steps_to(w, 3.0));
    report.compare("speed of the block and of the wheel after they stopped", {0.0, 0.0},
                   {speed(w, "stops"), spin_rate(w, "coasts")}, 1e-12,
                   "absolute: dry friction holds", 1.0);
    report.compare("way of the block until it stopped [m]", {2.0 / 3.0},
                   {w.pose(body(w, "stops")).position.x()}, 1e-6,
                   "relative; v0^2 m/(2 F), which is a whole number of steps");
    report.compare("drift of a block held by friction 0.42 on a slope of 0.4, 10 s [m]", {0.0},
                   {largest_drift(w, "held", 10.0)}, 1e-9, "absolute: friction is a spring", 1.0);
}

void case_bollard(Report& report) {
    // Past its own two seconds the weight that runs is pulled into its bollard, which does not
    // count.
    scene::Scene s = open_scene("joint_friction", 1.0 / 240.0, {"settings.on_diverged=warn"});
    World& w = s.world;
    advance(w, steps_to(w, 3.0));  // the lines ring
    report.compare("drift of weights 100 : 250, 5 s [m]", {0.0},
                   {largest_drift(w, "grips_heavy", 5.0)}, 1e-6,
                   "absolute: below exp(mu pi) = 2.566; what is left of the ringing", 1.0);
    scene::Scene again = open_scene("joint_friction", 1.0 / 240.0);
    World& runs = again.world;
    advance(runs, steps_to(runs, 1.0));
    const double before = runs.velocity(body(runs, "runs_heavy")).linear.z();
    advance(runs, steps_to(runs, 2.0));
    const double a = before - runs.velocity(body(runs, "runs_heavy")).linear.z();
    const double light = -force(runs, "runs_light_end"), heavy = -force(runs, "runs_heavy_end");
    report.compare("ratio of the tensions of a line that runs", {std::exp(0.3 * kPi)},
                   {heavy / light}, 1e-5, "relative; exp(mu d), Euler and Eytelwein");
    const double ratio = std::exp(0.3 * kPi);
    report.compare("acceleration of weights 100 : 290 [m/s^2]",
                   {kGravity * (2.9 - ratio) / (2.9 + ratio)}, {a}, 5e-3,
                   "relative; tensions strain the line by up to 0.3 %");
}

void case_joint_limits(Report& report) {
    scene::Scene s = open_scene("joint_limits", 1.0 / 240.0);
    World& w = s.world;
    advance(w, 1);
    // Measure from the last step before the contact with a stop to the first step after it. Free
    // rotation keeps its energy only to second order in the step.
    const double start = w.energy().mechanical();
    double free = start, most = 0.0;
    bool was_met = false;
    for (int k = 1; k < 240 * 4; ++k) {
        advance(w, 1);
        const bool met = force(w, "block_slide_range") != 0.0 || force(w, "arm_range") != 0.0;
        const double now = w.energy().mechanical();
        if (was_met || met) most = std::max(most, now - free);
        if (!met) free = now;
        was_met = met;
    }
    report.compare("force of a slide's end on 100 kg at a slope of 0.5 rad [N]",
                   {-100.0 * kGravity * std::sin(0.5)}, {force(w, "block_slide_range")}, 1e-6,
                   "relative; m g sin a, at rest");
    report.compare("where the block rests [m]", {0.5}, {w.pose(body(w, "block")).position.norm()},
                   1e-6, "absolute", 1.0);
    report.compare("torque of a stop on an arm of 10 kg, 1 m, 0.5 rad below level [N m]",
                   {-10.0 * kGravity * std::cos(0.5)}, {force(w, "arm_range")}, 1e-6,
                   "relative; m g r cos a, at rest");
    report.compare("energy gained at the stops [J]", {0.0}, {std::max(most, 0.0)}, 1e-9,
                   "of what falls, 286 J", 286.0);
}

void case_motor_limits(Report& report) {
    scene::Scene s = open_scene("motor_limits", 1.0 / 240.0);
    World& w = s.world;
    const Vec3 from = w.pose(body(w, "stays")).position;
    advance(w, 120);
    const double t = middle(w);
    report.compare("block of 100 kg pushed by 150 N [m/s]", {1.5 * t}, {speed(w, "starts")}, 1e-9,
                   "relative; F t/m");
    report.compare("wheel of 3 kg m2 turned by 6 N m [rad/s]", {2.0 * t}, {spin_rate(w, "spins")},
                   1e-9, "relative; T t/I");
    const double sinks = kGravity * std::sin(0.5) - 4.0;
    report.compare("block let down by 400 N on a slope of 0.5 rad [m/s]", {sinks * t},
                   {speed(w, "sinks")}, 1e-9, "relative; (g sin a - F/m) t");
    report.compare("its force [N]", {-400.0}, {force(w, "sinks_slide_motor")}, 1e-12, "relative");
    advance(w, steps_to(w, 5.0));
    report.compare("speeds reached [m/s, rad/s]", {2.0, 8.0},
                   {speed(w, "starts"), spin_rate(w, "spins")}, 1e-9,
                   "relative: what was asked for");
    report.compare("way of a block held by 480 N, 5 s [m]", {0.0},
                   {(w.pose(body(w, "stays")).position - from).norm()}, 1e-6,
                   "absolute: a motor is a speed of 0 with a compliance of 1e-12 m/s/N", 1.0);
}

}  // namespace hawser::validate
