// SPDX-License-Identifier: Apache-2.0
// Spinning bodies: the gyroscopic update.
#include "validate/cases.h"
#include "validate/reference.h"
#include "validate/tools.h"

#include <cmath>

namespace hawser::validate {

void case_dzhanibekov(Report& report) {
    // Velocities belong to the time half a step before that of positions. The mean of two
    // neighbours, in the body's frame between them, is the velocity at that time to second order.
    const auto simulate = [](double step) -> Result {
        scene::Scene s = open_scene("dzhanibekov", step);
        const BodyId nut = body(s.world, "nut");
        std::vector<double> middle{s.world.body_def(nut).angular_velocity.y()};
        Vec3 at_two = Vec3::Zero();
        const long two = steps_to(s.world, 2.0);
        advance(s.world, 1);
        for (long k = 1; s.world.time() < 3.0; ++k) {
            const Quat turn = s.world.pose(nut).orientation.conjugate();
            const Vec3 before = s.world.velocity(nut).angular;
            advance(s.world, 1);
            const Vec3 w = turn * (0.5 * (before + s.world.velocity(nut).angular));
            middle.push_back(-w.y());
            if (k == two) at_two = w;
        }
        middle[0] = -middle[0];
        return {list(at_two), {upward_zeros(middle, step).at(0)}};
    };
    report.converge(
        {{"angular velocity at 2 s [rad/s]", {kDzhanibekov[0], kDzhanibekov[1], kDzhanibekov[2]}},
         {"time of the first flip [s]", {kDzhanibekov[3]}}},
        simulate);
}

void case_heavy_top(Report& report) {
    // Slow root of I1 p² cos a − I3 s p + m g l = 0 for the spin s of the scene.
    scene::Scene s = open_scene("heavy_top", 1.0 / 120.0);
    const BodyDef def = s.world.body_def(body(s.world, "top"));
    const Vec3 axis = def.orientation * Vec3{0, 0, 1};
    const double l = def.position.norm(), c = axis.z();
    const double i1 = def.inertia(0, 0) + def.mass * l * l;
    const double spin = def.inertia(2, 2) * def.angular_velocity.dot(axis);
    const double root = std::sqrt(spin * spin - 4.0 * i1 * c * def.mass * kGravity * l);
    const double rate = (spin - root) / (2.0 * i1 * c);
    constexpr double kTime = 5.0;

    const auto simulate = [&](double step) -> Result {
        scene::Scene run = open_scene("heavy_top", step);
        const BodyId top = body(run.world, "top");
        double azimuth = 0.0, last = 0.0, nutation = 0.0;
        for (long n = steps_to(run.world, kTime); n > 0; --n) {
            advance(run.world, 1);
            const Vec3 p = run.world.pose(top).orientation * Vec3{0, 0, 1};
            const double now = std::atan2(p.y(), p.x());
            azimuth += std::remainder(now - last, 2.0 * kPi);
            last = now;
            nutation = std::max(nutation, std::abs(std::acos(p.z()) - std::acos(c)));
        }
        return {{azimuth}, {nutation}};
    };
    report.converge({{"precession in 5 s [rad]", {rate * kTime}},
                     {"largest nutation [rad]", {0.0}, 1.0, 1e-3, 1.9, "absolute"}},
                    simulate);
}

}  // namespace hawser::validate
