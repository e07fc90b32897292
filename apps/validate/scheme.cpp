// SPDX-License-Identifier: Apache-2.0
// Properties of the time stepper. With a compliance e and a damping time n h a row g obeys e f =
// −(mean of g + n h r). Here r = t G v₊ + (1 − t) G v is the rate for its damper. If n is that of
// the scheme, t = 1 (docs/theory/step.md).
#include "validate/cases.h"
#include "validate/reference.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace hawser::validate {
namespace {

std::string set_value(const std::string& path, double value) {
    return fmt::format("{}={:.17g}", path, value);
}

/// Factors of x_{k+1}, x_k, x_{k−1} in the step of x'' + c x' + k x = 0, W = h sqrt(k/m).
struct Recurrence {
    double next, now, last;
};
Recurrence recurrence(double w, double n) {
    const double z = n * w * w + 0.25 * w * w, s = 0.25 * w * w;
    const double t = z < 1e-3 ? 0.5 + z / 12.0 : -1.0 / std::expm1(-z) - 1.0 / z;
    return {1.0 + s * (1.0 + 4.0 * n * t), -2.0 + s * (2.0 + 4.0 * n * (1.0 - 2.0 * t)),
            1.0 + s * (1.0 - 4.0 * n * (1.0 - t))};
}

/// Return the largest root of the recurrence that the integration scheme makes of a linear
/// oscillation.
double largest_root(double w, double n) {
    const auto [a, b, c] = recurrence(w, n);
    const std::complex<double> root = std::sqrt(std::complex<double>(b * b - 4.0 * a * c));
    return std::max(std::abs((-b + root) / (2.0 * a)), std::abs((-b - root) / (2.0 * a)));
}

double pendulum_error(double step, bool staggered) {
    scene::Scene s = open_scene(
        "pendulum", step,
        {staggered ? "settings.staggered_start=true" : "settings.staggered_start=false"});
    advance(s.world, steps_to(s.world, 2.0));
    const Vec3 p = s.world.pose(body(s.world, "bob")).position;
    return std::hypot(p.x() - kA01[2], p.z() - kA01[3]);
}

}  // namespace

void case_static_violation(Report& report) {
    for (const double step : {1.0 / 60.0, 1.0 / 1000.0}) {
        for (const double damping : {0.02, 0.2}) {
            scene::Scene s = open_scene("scheme_static", step,
                                        {set_value("interactions.spring.damping_time", damping)});
            advance(s.world, steps_to(s.world, s.duration));
            const InteractionId spring = interaction(s.world, "spring");
            const double force = s.world.force(spring)[0];
            const double g = s.world.violation(spring)[0];
            report.compare(fmt::format("g, h = 1/{:.0f}, tau = {} s [m]", 1.0 / step, damping),
                           {-1e-3 * force}, {g}, 1e-9, "exact at rest; rest of the settling");
            report.compare("force at rest [N]", {-kGravity}, {force}, 1e-9,
                           "weight of 1 kg; rest of the settling");
        }
    }
}

void case_violation_decay(Report& report) {
    // The row is too soft for a rigid joint, which would be closed at the end of the first step.
    scene::Scene s =
        open_scene("scheme_decay", 1.0 / 60.0, {"interactions.spring.compliance=1e-12"});
    const InteractionId row = interaction(s.world, "spring");
    // g_{k+1} = (1 − 3Y) g_k − Y g_{k−1} with n = 2, Y = 1/9: 1, 5/9, 7/27, 1/9, …
    double before = 1.0, now = 5.0 / 9.0;
    std::vector<double> exact, ours;
    for (int k = 0; k < 8; ++k) {
        advance(s.world, 1);
        exact.push_back(now);
        ours.push_back(s.world.violation(row)[0]);
        const double next = (2.0 / 3.0) * now - before / 9.0;
        before = now;
        now = next;
    }
    report.compare("g after 1 to 8 steps [m]", exact, ours, 1e-8,
                   "the compliance is some billionths of the body's mobility", 1.0);
    scene::Scene rigid = open_scene("scheme_decay", 1.0 / 60.0);
    const InteractionId rod = interaction(rigid.world, "spring");
    std::vector<double> held;
    for (int k = 0; k < 8; ++k) {
        advance(rigid.world, 1);
        held.push_back(rigid.world.violation(rod)[0]);
    }
    report.compare("g of a rigid row after 1 to 8 steps [m]", std::vector<double>(8, 0.0), held,
                   1e-8, "its compliance is raised to some billionths of the body's mobility", 1.0);
}

void case_linear_invariant(Report& report) {
    scene::Scene s = open_scene("scheme_chain", 1.0 / 60.0);
    const InteractionId rows[] = {interaction(s.world, "s1"), interaction(s.world, "s2"),
                                  interaction(s.world, "s3")};
    const BodyId masses[] = {body(s.world, "m1"), body(s.world, "m2"), body(s.world, "m3")};
    const double step = s.world.settings().step;
    const auto invariant = [&] {
        double sum = 0.0, last = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double v = s.world.velocity(masses[i]).linear.x();
            const double rate = v - last;
            const double g = s.world.violation(rows[i])[0] - 0.5 * step * rate;
            sum += 0.5 * s.world.body_def(masses[i]).mass * v * v +
                   0.5 * g * g / s.world.interaction_def(rows[i]).compliance[0];
            last = v;
        }
        return sum;
    };
    advance(s.world, 1);
    const double start = invariant();
    double low = start, high = start;
    for (int k = 0; k < 100'000; ++k) {
        advance(s.world, 1);
        low = std::min(low, invariant());
        high = std::max(high, invariant());
    }
    // Positions of 2 to 4 m are rounded by 1.3e-16 m (one standard deviation) a step, against up to
    // 1e3 N in the stiffest spring. In 1e5 steps this is a random walk of 4e-11 J, 6e-12 of the
    // energy.
    report.compare("spread over 1e5 steps, three masses [J]", {0.0}, {high - low}, 5e-11,
                   "rounding of positions, 1e5 steps at random", start);

    // One mass: x_{k+1} + x_{k−1} = 2 cos(w h) x_k with tan(w h/2) = W/2.
    for (const double rate : {60.0, 240.0}) {
        scene::Scene one = open_scene("scheme_oscillator", 1.0 / rate);
        const BodyId bob = body(one.world, "bob");
        std::vector<double> x{one.world.pose(bob).position.x() - 100.0};
        for (int k = 0; k < 2000; ++k) {
            advance(one.world, 1);
            x.push_back(one.world.pose(bob).position.x() - 100.0);
        }
        double above = 0.0, below = 0.0;
        for (std::size_t k = 1; k + 1 < x.size(); ++k) {
            above += (x[k + 1] + x[k - 1]) * x[k];
            below += 2.0 * x[k] * x[k];
        }
        const double w = std::sqrt(1000.0) / rate;
        report.compare(fmt::format("frequency at h = 1/{:.0f} [rad/s]", rate),
                       {2.0 * rate * std::atan(0.5 * w)}, {rate * std::acos(above / below)}, 1e-10,
                       "round-off");
    }
}

void case_linear_stability(Report& report) {
    constexpr double kStep = 1.0 / 60.0;
    double worst_root = 0.0, worst_residual = 0.0, worst_growth = 0.0;
    for (const double n : {0.0, 0.0625, 0.5, 2.0, 10.0}) {
        for (const double w : {0.01, 0.1, 1.0, 10.0, 1000.0}) {
            worst_root = std::max(worst_root, largest_root(w, n) - 1.0);
            scene::Scene s =
                open_scene("scheme_oscillator", kStep,
                           {set_value("interactions.spring.compliance", kStep * kStep / (w * w)),
                            set_value("interactions.spring.damping_time", n * kStep),
                            "settings.staggered_start=false"});
            const BodyId bob = body(s.world, "bob");
            double a = 0.0, b = s.world.pose(bob).position.x() - 100.0;  // the last two values
            const double start = b;
            for (int k = 0; k < 1000; ++k) {
                advance(s.world, 1);
                const double c = s.world.pose(bob).position.x() - 100.0;
                const double q = 0.25 * w * w;
                const Recurrence by = recurrence(w, n);
                const double residual = by.next * c + by.now * b + by.last * a;
                if (k > 0) {
                    worst_residual = std::max(worst_residual,
                                              std::abs(residual) / (start * (1.0 + q * (1.0 + n))));
                }
                a = b;
                b = c;
            }
            if (n > 0.0) worst_growth = std::max(worst_growth, std::abs(b) / start);
        }
    }
    report.compare("largest root modulus - 1, 25 cases", {0.0}, {std::max(worst_root, 0.0)}, 1e-12,
                   "round-off of a root of modulus 1", 1.0);
    report.compare("residual of the recurrence, 25 cases", {0.0}, {worst_residual}, 1e-11,
                   "round-off of x = 100 + g over g = 0.05", 1.0);
    report.compare("largest |g| / start after 1000 steps", {0.0}, {worst_growth}, 1.0,
                   "with damping nothing grows, 20 cases", 1.0);
}

void case_curvature_violation(Report& report) {
    for (const double rate : {120.0, 1920.0}) {
        // Other methods than newton linearise the rod once per step.
        scene::Scene s = open_scene("pendulum", 1.0 / rate, {"settings.nonsmooth=pgs"});
        const InteractionId rod = interaction(s.world, "rod");
        double worst = 0.0;
        while (s.world.time() < 2.0) {
            advance(s.world, 1);
            worst = std::max(worst, std::abs(s.world.violation(rod)[0]));
        }
        // h² v² (1 + 2n)/(4L) with n = 2 and v² = 2 g L at the lowest point
        const double predicted = 2.0 * kGravity * 5.0 / (4.0 * rate * rate);
        report.compare(fmt::format("largest length error, h = 1/{:.0f} [m]", rate), {predicted},
                       {worst}, rate < 1000.0 ? 1e-2 : 1e-3,
                       "leading term in h; the next is of relative order h");
    }
}

void case_order(Report& report) {
    for (const bool staggered : {true, false}) {
        std::vector<double> errors, steps;
        for (double rate = 120.0; rate < 2000.0; rate *= 2.0) {
            steps.push_back(1.0 / rate);
            errors.push_back(pendulum_error(1.0 / rate, staggered));
        }
        double least = 10.0, most = 0.0;
        for (std::size_t i = 1; i < errors.size(); ++i) {
            const double order = std::log2(errors[i - 1] / errors[i]);
            least = std::min(least, order);
            most = std::max(most, order);
        }
        Check& c = report.compare(
            staggered ? "order at 2 s, staggered start" : "order at 2 s, plain start",
            {staggered ? 2.0 : 1.0}, {staggered ? least : most}, 0.1,
            staggered ? "least of four halvings to 1/1920" : "largest of four halvings to 1/1920",
            1.0);
        c.steps = steps;
        c.errors = errors;
    }
}

void case_energy_loss(Report& report) {
    for (const auto& row : kPendulumLoss) {
        for (std::size_t i = 1; i < 3; ++i) {
            const double rate = i == 1 ? 60.0 : 240.0;
            scene::Scene s =
                open_scene("pendulum", 1.0 / rate,
                           {set_value("interactions.rod.damping_time", row[0] / rate),
                            "settings.geometric_stiffness=0", "settings.solution_tolerance=1e-13"});
            advance(s.world, steps_to(s.world, 10.0));
            report.compare(
                fmt::format("energy lost in 10 s, n = {}, h = 1/{:.0f} [J]", row[0], rate),
                {row[i]}, {-s.world.energy().mechanical()}, 5e-6,
                "the scheme written a second time, without the correction of the start");
        }
    }
}

}  // namespace hawser::validate
