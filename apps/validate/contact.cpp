// SPDX-License-Identifier: Apache-2.0
// Contact and friction of rigid bodies and wires against closed forms.
#include "validate/cases.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace hawser::validate {
namespace {

constexpr int kHeadingCount = 8;

std::array<BodyId, kHeadingCount> bodies(const World& world, const char* name) {
    std::array<BodyId, kHeadingCount> ids;
    for (int i = 0; i < kHeadingCount; ++i) {
        ids[static_cast<std::size_t>(i)] = body(world, fmt::format("{}{}", name, i));
    }
    return ids;
}

/// Return the value with the largest distance from `wanted` among all headings.
double farthest_from(double wanted, const std::array<double, kHeadingCount>& values) {
    return *std::max_element(values.begin(), values.end(), [&](double a, double b) {
        return std::abs(a - wanted) < std::abs(b - wanted);
    });
}

/// Solver statistics of the steps.
struct Figures {
    double worst_map = 0.0;             ///< Largest natural map.
    std::vector<double> work, sliding;  ///< Work and number of sliding contacts of each step.
};

/// Run `steps` steps and collect statistics of the solver.
void run(World& world, long steps, Figures& figures) {
    for (long k = 0; k < steps; ++k) {
        advance(world, 1);
        const StepStats& stats = world.stats();
        figures.worst_map = std::max(figures.worst_map, stats.natural_map);
        figures.work.push_back(stats.factor_work);
        const auto contacts = world.contacts();
        figures.sliding.push_back(static_cast<double>(std::count_if(
            contacts.begin(), contacts.end(), [](const ContactView& c) { return c.sliding; })));
    }
}

double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    return values.at(static_cast<std::size_t>(q * static_cast<double>(values.size() - 1)));
}

}  // namespace

void case_incline(Report& report) {
    scene::Scene stay = open_scene("incline", 1.0 / 60.0);
    const auto boxes = bodies(stay.world, "box");
    advance(stay.world, steps_to(stay.world, 1.0));
    std::array<Vec3, kHeadingCount> at;
    for (std::size_t i = 0; i < boxes.size(); ++i) at[i] = stay.world.pose(boxes[i]).position;
    double drift = 0.0;
    for (int second = 2; second <= 1000; ++second) {
        advance(stay.world, 60);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            drift = std::max(drift, (stay.world.pose(boxes[i]).position - at[i]).norm());
        }
    }
    report.compare("drift, 95 % of the limit, 8 headings, 1 to 1000 s [m]", {0.0}, {drift}, 1e-9,
                   "absolute: friction is a spring, nothing creeps", 1.0);

    constexpr double kSlope = 0.75, kFriction = 0.5;  // of the scene
    const double angle = std::atan(kSlope);
    const double exact = kGravity * (std::sin(angle) - kFriction * std::cos(angle));
    scene::Scene slide = open_scene("incline_slide", 1.0 / 60.0);
    const auto sliding = bodies(slide.world, "box");
    std::array<Vec3, kHeadingCount> before;
    advance(slide.world, 30);
    for (std::size_t i = 0; i < before.size(); ++i) {
        before[i] = slide.world.velocity(sliding[i]).linear;
    }
    advance(slide.world, 60);
    std::array<double, kHeadingCount> along, across;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec3 a = slide.world.velocity(sliding[i]).linear - before[i];  // in 1 s
        const double fall = static_cast<double>(i) * kPi / 4.0;
        const Vec3 down{std::cos(angle) * std::cos(fall), std::cos(angle) * std::sin(fall),
                        -std::sin(angle)};
        along[i] = a.dot(down);
        across[i] = (a - along[i] * down).norm();
    }
    report.compare("sliding, worst of 8 headings [m/s^2]", {exact}, {farthest_from(exact, along)},
                   1e-3, "relative; g (sin a - mu cos a)");
    report.compare("acceleration off its heading [m/s^2]", {0.0}, {farthest_from(0.0, across)},
                   1e-3, "of the acceleration: friction is isotropic", exact);
}

void case_belt(Report& report) {
    constexpr double kSpeed = 2.0, kFriction = 0.4;  // of the scene
    scene::Scene s = open_scene("belt", 1.0 / 240.0);
    const BodyId box = body(s.world, "box");
    advance(s.world, steps_to(s.world, 0.25));
    const double t = 0.25 - 0.5 / 240.0;  // velocities are half a step behind
    report.compare("speed of a box after 0.25 s [m/s]", {kFriction * kGravity * t},
                   {s.world.velocity(box).linear.x()}, 1e-3, "relative; mu g t");
    double stack = 0.0;  // it leans, but its centre does not move
    for (const char* name : {"stack0", "stack1", "stack2"}) {
        stack += s.world.velocity(body(s.world, name)).linear.x() / 3.0;
    }
    report.compare("speed of the centre of a stack [m/s]", {kFriction * kGravity * t}, {stack},
                   1e-3, "relative; mu g t");
    advance(s.world, steps_to(s.world, s.duration));
    report.compare("speed when carried [m/s]", {kSpeed}, {s.world.velocity(box).linear.x()}, 1e-9,
                   "relative; the box sticks");
    const double slid = kSpeed * s.duration - s.world.pose(box).position.x();
    report.compare("way slid on the belt [m]", {kSpeed * kSpeed / (2.0 * kFriction * kGravity)},
                   {slid}, 5e-3, "relative; v^2/(2 mu g), first order where it comes to rest");
}

void case_rolling_sphere(Report& report) {
    constexpr double kSpeed = 7.0, kFriction = 0.2;  // of the scene
    constexpr double kStep = 1.0 / 240.0;
    scene::Scene s = open_scene("rolling_sphere", kStep);
    const auto balls = bodies(s.world, "ball");
    advance(s.world, steps_to(s.world, 0.5));
    std::array<double, kHeadingCount> slowing;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        slowing[i] = s.world.velocity(balls[i]).linear.norm();
    }
    advance(s.world, steps_to(s.world, s.duration));
    std::array<double, kHeadingCount> rolling, since, off;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec3 v = s.world.velocity(balls[i]).linear;
        rolling[i] = v.norm();
        // Time at which the line through v(0) and v(0.5 s − h/2) reaches the rolling speed.
        since[i] = (kSpeed - rolling[i]) * (0.5 - 0.5 * kStep) / (kSpeed - slowing[i]);
        const double heading = static_cast<double>(i) * kPi / 4.0;
        off[i] = std::abs(std::remainder(std::atan2(v.y(), v.x()) - heading, 2.0 * kPi));
    }
    const double exact = 5.0 * kSpeed / 7.0, time = 2.0 * kSpeed / (7.0 * kFriction * kGravity);
    report.compare("rolling, worst of 8 headings [m/s]", {exact}, {farthest_from(exact, rolling)},
                   1e-3, "relative; 5 v0/7");
    report.compare("time at which it rolls, worst of 8 headings [s]", {time},
                   {farthest_from(time, since)}, 1e-3, "relative; 2 v0/(7 mu g)");
    report.compare("heading, worst of 8 [rad]", {0.0}, {farthest_from(0.0, off)}, 1e-3,
                   "absolute: friction is isotropic", 1.0);
}

void case_spinning_disk(Report& report) {
    constexpr double kSpin = 20.0, kFriction = 0.2, kRadius = 0.5;  // of the scene
    scene::Scene s = open_scene("spinning_disk", 1.0 / 240.0);
    const BodyId spin = body(s.world, "spin"), both = body(s.world, "both");
    const double until = 1.0;
    advance(s.world, steps_to(s.world, until));
    const double exact = kSpin - 2.0 * kFriction * kGravity / kRadius * (until - 0.5 / 240.0);
    report.compare("spin after 1 s [rad/s]", {exact}, {s.world.velocity(spin).angular.z()}, 1e-3,
                   "relative; points on the rim: 2 mu g/R");
    // A disk stops sliding and spinning at the same time: when one has all but ended, so has the
    // other (Z. Farkas, G. Bartels, T. Unger, D. E. Wolf, Phys. Rev. Lett. 90, 248302, 2003).
    double last_slide = 0.0, last_spin = 0.0;
    while (s.world.time() < s.duration) {
        advance(s.world, 1);
        const Twist v = s.world.velocity(both);
        if (v.linear.head<2>().norm() > 1e-3) last_slide = s.world.time();
        if (std::abs(v.angular.z()) * kRadius > 1e-3) last_spin = s.world.time();
    }
    report.compare("end of spinning, that of sliding [s]", {last_slide}, {last_spin}, 1e-2,
                   "relative; they end together, to 3 steps");
}

void case_stacks(Report& report) {
    for (const char* name : {"box_stack", "box_stack_1e6"}) {
        scene::Scene s = open_scene(name, 1.0 / 60.0);
        const BodyId top = body(s.world, "box9");
        const Vec3 start = s.world.pose(top).position;
        Figures figures;
        double drop = 0.0, sideways = 0.0;
        for (int second = 0; second < 10; ++second) {
            run(s.world, 60, figures);
            const Vec3 moved = s.world.pose(top).position - start;
            drop = std::max(drop, std::abs(moved.z()));
            sideways = std::max(sideways, moved.head<2>().norm());
        }
        report.compare(fmt::format("{}: drop of the top in 10 s [m]", name), {0.0}, {drop}, 1e-3,
                       "absolute; its contacts give 0.25 mm", 1.0);
        report.compare(fmt::format("{}: sideways [m]", name), {0.0}, {sideways}, 1e-3, "absolute",
                       1.0);
        report.compare(fmt::format("{}: certificate", name), {0.0}, {figures.worst_map}, 1e-8,
                       "offline", 1.0);
    }
}

void case_walls(Report& report) {
    struct Wall {
        const char* name;
        double contacts;
    };
    for (const Wall& wall : {Wall{"wall_648", 648}, Wall{"wall_976", 976}}) {
        scene::Scene s = open_scene(wall.name, 1.0 / 60.0);
        Figures cold, warm;
        run(s.world, 1, cold);
        run(s.world, 60, warm);
        report.compare(fmt::format("{}: contact points", wall.name), {wall.contacts},
                       {static_cast<double>(s.world.stats().contacts)}, 0.02,
                       "relative; pushed bricks reach others");
        report.compare(fmt::format("{}: certificate", wall.name), {0.0},
                       {std::max(cold.worst_map, warm.worst_map)}, 1e-6, "tolerance", 1.0);
        // LU counts double: 12 is six unsymmetric factorisations.
        report.compare(fmt::format("{}: factorisations, excess over 6", wall.name), {0.0},
                       {std::max(0.0, quantile(warm.work, 0.5) - 6.0)}, 1e-12,
                       fmt::format("median of 60 warm steps is {:.2f}, in flops of one LDLT",
                                   quantile(warm.work, 0.5)),
                       1.0);
        report.compare(fmt::format("{}: sliding points", wall.name), {105.0},
                       {quantile(warm.sliding, 0.5)}, 0.25, "median between 80 and 130", 105.0);

        scene::Scene offline =
            open_scene(wall.name, 1.0 / 60.0, {"settings.contact_tolerance=1e-8"});
        Figures start, going;
        run(offline.world, 1, start);
        run(offline.world, 60, going);
        report.compare(fmt::format("{}: certificate, tolerance 1e-8", wall.name), {0.0},
                       {std::max(start.worst_map, going.worst_map)}, 1e-8, "offline", 1.0);
        report.compare(fmt::format("{}: factorisations, tolerance 1e-8, excess over 6", wall.name),
                       {0.0}, {std::max(0.0, quantile(going.work, 0.5) - 6.0)}, 1e-12,
                       fmt::format("median is {:.2f}", quantile(going.work, 0.5)), 1.0);
    }
}

void case_capstan(Report& report) {
    constexpr double kFriction = 0.3;  // of the scene
    scene::Scene s = open_scene("wire_cylinder", 1.0 / 240.0);
    const scene::Cable& wire = s.cables.at(0);
    advance(s.world, steps_to(s.world, 2.0));
    // Elements enter and leave the arc, so mean over the passage of two of them.
    const double element = wire.length / static_cast<double>(wire.stretch.size());
    const long steps = std::lround(2.0 * element / 0.05 * 240.0);
    double loaded = 0.0, pulled = 0.0;
    for (long k = 0; k < steps; ++k) {
        advance(s.world, 1);
        loaded += tension(s.world, wire.stretch[1]);
        pulled += tension(s.world, wire.stretch[wire.stretch.size() - 2]);
    }
    // Elements touch at their middles. A node between two elements at an angle d has half the force
    // of each. With r = (T2 − T1)/(T2 + T1), s = sin d/2, c = cos d/2 its balance is r + mu² r² c s
    // − mu s c = 0.
    const double turn = kPi / 32.0;
    const double sc = std::sin(0.5 * turn) * std::cos(0.5 * turn);
    double r = kFriction * sc;
    for (int i = 0; i < 20; ++i) r = kFriction * sc * (1.0 - kFriction * r * r);
    const double polygon = std::pow((1.0 + r) / (1.0 - r), 32);
    report.compare("pull over load, half a turn", {std::exp(kFriction * kPi)}, {pulled / loaded},
                   5e-3, "relative; e^(mu pi); 32 elements are 0.15 % below");
    report.compare("pull over load, wire of 32 elements", {polygon}, {pulled / loaded}, 1e-3,
                   "relative; contacts give, tensions ripple as elements pass");
    check_posts(report);
}

void case_bouncing_ball(Report& report) {
    constexpr double kRestitution = 0.8, kRadius = 0.1, kHeight = 1.0;  // of the scene
    constexpr double kEndTime = 5.0;  // the last bounce ends at 4.06 s
    scene::Scene s = open_scene("bouncing_ball", 1.0 / 9600.0);
    const BodyId ball = body(s.world, "ball");
    std::vector<double> tops;
    double before = 0.0, lowest = 0.0, last = kHeight;
    while (s.world.time() < kEndTime) {
        advance(s.world, 1);
        const double v = s.world.velocity(ball).linear.z();
        const double z = s.world.pose(ball).position.z() - kRadius;
        lowest = std::min(lowest, z);
        if (before > 0.0 && v <= 0.0) tops.push_back(std::max(z, last));
        before = v;
        last = z;
    }
    for (std::size_t n = 1; n <= 4 && n <= tops.size(); ++n)
        report.compare(fmt::format("top of bounce {} [m]", n),
                       {std::pow(kRestitution, 2.0 * static_cast<double>(n)) * kHeight},
                       {tops[n - 1]}, 5e-3,
                       "relative; first order: it bounces where the step begins in which it would "
                       "touch, up to v h high");
    report.compare("penetration [m]", {0.0}, {std::min(0.0, lowest)}, 1e-5,
                   "absolute: m g/k = 1e-6 m", 1.0);
    report.compare("speed at the end [m/s]", {0.0}, {last > 1e-3 ? 1.0 : before}, 1e-9,
                   "absolute; it has come to rest", 1.0);
}

}  // namespace hawser::validate
