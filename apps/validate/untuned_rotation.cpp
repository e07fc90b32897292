// SPDX-License-Identifier: Apache-2.0
// Rotation of fast bodies at 1/60 and 1/240 s: angle of steady rotation, free asymmetric top.
#include "validate/robust_tools.h"
#include "validate/untuned.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

constexpr double kRotationSteps[] = {1.0 / 60.0, 1.0 / 240.0};

/// Report the angle of a rotor whose motor keeps a speed, at 0.01 to 1.9 rad a step.
void report_rotor(Report& report, double step) {
    double most = 0.0;
    for (const double turn : {0.01, 0.1, 0.5, 1.0, 1.9}) {
        World w({.step = step, .gravity = Vec3::Zero()});
        const BodyId ground = w.add_body({.kind = BodyKind::fixed});
        // About an axis that is no principal one up to 1 rad a step: the bearing then carries a
        // rotating torque.
        const Vec3 axis = turn > 1.0 ? Vec3(0, 0, 1) : Vec3(1.0, 2.0, -0.5).normalized();
        const BodyId rotor = w.add_body(solid_box({0, 0, 0}, 10.0, {0.5, 0.1, 0.2}));
        const InteractionId hinge =
            w.add_interaction(joint(w, InteractionKind::Hinge, ground, rotor, {0, 0, 0}, axis));
        InteractionDef motor =
            joint(w, InteractionKind::HingeMotor, ground, rotor, {0, 0, 0}, axis);
        w.add_interaction(motor.set("speed", turn / step));
        advance(w, 2);  // to the speed of the motor
        const auto angle = [&] { return w.coordinate(hinge); };
        double last = angle(), sum = 0.0;
        const long steps = steps_to(w, w.time() + 10.0) - 2;
        for (long k = 0; k < steps; ++k) {
            advance(w, 1);
            sum += std::remainder(angle() - last, 2.0 * kPi);
            last = angle();
        }
        const double exact = turn * static_cast<double>(steps);
        most = std::max(most, std::abs(std::abs(sum) / exact - 1.0));
    }
    // The compliance of the motor is 1e-12; angles are read with 1e-15 in each step.
    require_below(report,
                  fmt::format("motor at 0.01 to 1.9 rad a step, 1/{:.0f} s: angle", 1.0 / step),
                  most, 1e-9, "speed x time, relative");
}

/// Free rotation in the body frame by Euler's equations, with the orientation as a quaternion.
struct Top {
    Quat q;
    Vec3 w;
};
Top rate(const Top& t, const Vec3& inertia) {
    const Vec3 m = inertia.cwiseProduct(t.w);
    const Quat spin(0.0, 0.5 * t.w.x(), 0.5 * t.w.y(), 0.5 * t.w.z());
    return {t.q * spin, (-t.w.cross(m)).cwiseQuotient(inertia)};
}
Top moved(const Top& t, const Top& r, double h) {
    return {Quat(t.q.coeffs() + h * r.q.coeffs()), t.w + h * r.w};
}
/// Integrate by Runge's and Kutta's method of fourth order.
Top integrated(Top t, const Vec3& inertia, double time, int steps) {
    const double h = time / steps;
    for (int k = 0; k < steps; ++k) {
        const Top a = rate(t, inertia), b = rate(moved(t, a, 0.5 * h), inertia),
                  c = rate(moved(t, b, 0.5 * h), inertia), d = rate(moved(t, c, h), inertia);
        for (const auto& [r, share] : {std::pair(a, 1.0), {b, 2.0}, {c, 2.0}, {d, 1.0}})
            t = moved(t, r, share * h / 6.0);
        t.q.normalize();
    }
    return t;
}

constexpr double kTopTime = 2.0, kTopSpeed = 5.0;

struct FreeTop {
    World world;
    BodyId body;
    Vec3 inertia{1.0, 2.0, 2.9};
};
FreeTop make_top(double step, double speed) {
    FreeTop out{World({.step = step, .gravity = Vec3::Zero(), .staggered_start = false}), {}};
    BodyDef def{.kind = BodyKind::rigid, .mass = 4.0};
    def.inertia = out.inertia.asDiagonal();
    def.angular_velocity = speed * Vec3(0.3, 0.9, -0.2).normalized();
    out.body = out.world.add_body(def);
    return out;
}

/// Return the angle between the orientations after two seconds [rad].
double top_error(double step) {
    FreeTop t = make_top(step, kTopSpeed);
    // The velocity belongs to half a step before the pose.
    const Top half = integrated({Quat::Identity(), t.world.body_def(t.body).angular_velocity},
                                t.inertia, 0.5 * step, 10);
    const Top start{Quat::Identity(), half.w};
    advance(t.world, steps_to(t.world, kTopTime));
    const Top end = integrated(start, t.inertia, t.world.time(), 20000);
    return end.q.angularDistance(t.world.pose(t.body).orientation);
}

/// Return the largest deviation of the kinetic energy in the first and last tenth of a minute,
/// relative, for h|ω| = 0.3.
std::pair<double, double> top_energy(double step) {
    FreeTop t = make_top(step, 0.3 / step);
    const long steps = steps_to(t.world, 60.0);
    advance(t.world, 1);  // energies are those of the last step
    const double start = t.world.energy().kinetic;
    double first = 0.0, last = 0.0;
    for (long k = 0; k < steps; ++k) {
        advance(t.world, 1);
        const double off = std::abs(t.world.energy().kinetic / start - 1.0);
        if (k < steps / 10) first = std::max(first, off);
        if (k >= steps - steps / 10) last = std::max(last, off);
    }
    return {first, last};
}

}  // namespace

void case_rotation(Report& report) {
    for (const double step : kRotationSteps) report_rotor(report, step);
    const double coarse = top_error(kRotationSteps[0]), fine = top_error(kRotationSteps[1]);
    require_below(report, "free asymmetric top, 5 rad/s, 1/60 s: orientation after 2 s [rad]",
                  coarse, 5e-3, "Runge-Kutta");
    require_below(report, "the same: error at 1/240 s over that at 1/60 s", fine / coarse,
                  1.0 / 14.0, "1/16 for order 2");
    for (const double step : kRotationSteps) {
        const auto [first, last] = top_energy(step);
        const std::string at =
            fmt::format("free asymmetric top, 0.3 rad a step, 1/{:.0f} s: ", 1.0 / step);
        require_below(report, at + "kinetic energy, relative", last, 2e-2, "constant");
        require_below(report, at + "its deviation in the last over that in the first tenth",
                      last / first, 1.05, "no drift");
    }
}

}  // namespace hawser::validate
