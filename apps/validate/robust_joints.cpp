// SPDX-License-Identifier: Apache-2.0
// Rigid joints at the user's step: repeated joints, heavy ships on chains, motions that keep their
// energy and momentum.
#include "validate/robust.h"
#include "validate/robust_tools.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace hawser::validate {
namespace {

// ---- a boom on a slewing platform
// ----------------------------------------------------------------

constexpr double kArm = 3.0, kBoom = 120.0;  ///< Arm [m] and mass of the boom [kg].
const Vec3 kBoomHalf{3.0, 0.3, 0.2}, kPlatformHalf{1.0, 1.0, 0.3};

/// Return the position of the boom's centre after `time`, from Lagrange's equations for slewing and
/// luffing, integrated by a fourth-order Runge-Kutta method.
Vec3 boom_exact(double rate, double time) {
    const Mat3 ib = solid_box(Vec3::Zero(), kBoom, kBoomHalf).inertia;
    const double ip = solid_box(Vec3::Zero(), 500.0, kPlatformHalf).inertia(2, 2);
    const double far = kBoom * kArm * kArm, wide = far + ib(2, 2), luff = far + ib(1, 1);
    auto about = [&](double t) {
        return ip + wide * std::cos(t) * std::cos(t) + ib(0, 0) * std::sin(t) * std::sin(t);
    };
    const double momentum = about(0.0) * rate;
    using State = std::array<double, 3>;  // luff down, its rate, slew
    auto slope = [&](const State& s) -> State {
        const double omega = momentum / about(s[0]);
        const double turn = -(wide - ib(0, 0)) * std::sin(s[0]) * std::cos(s[0]) * omega * omega;
        return {s[1], (turn + kBoom * kGravity * kArm * std::cos(s[0])) / luff, omega};
    };
    auto plus = [](const State& a, double t, const State& b) -> State {
        return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
    };
    State s{0.0, 0.0, 0.0};
    constexpr int kIntegrationSlices = 20'000;
    const double h = time / kIntegrationSlices;
    for (int i = 0; i < kIntegrationSlices; ++i) {
        const State a = slope(s), b = slope(plus(s, 0.5 * h, a)), c = slope(plus(s, 0.5 * h, b)),
                    d = slope(plus(s, h, c));
        for (std::size_t k = 0; k < 3; ++k) s[k] += h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]);
    }
    const double reach = kArm * std::cos(s[0]);
    return {reach * std::cos(s[2]), reach * std::sin(s[2]), 0.3 - kArm * std::sin(s[0])};
}

struct Slew {
    Vec3 boom;
    double unexplained;  ///< Largest energy without a source, relative to the exchanged energy.
};
Slew slew(double rate, bool two, Cost& cost) {
    World w({.step = kRobustStep});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    BodyDef platform = solid_box({0.0, 0.0, 0.0}, 500.0, kPlatformHalf);
    BodyDef boom = solid_box({kArm, 0.0, 0.3}, kBoom, kBoomHalf);
    platform.angular_velocity = boom.angular_velocity = {0.0, 0.0, rate};
    boom.velocity = {0.0, kArm * rate, 0.0};
    const BodyId p = w.add_body(platform), b = w.add_body(boom);
    w.add_interaction(joint(w, InteractionKind::Hinge, ground, p, {0, 0, 0}));
    for (const double y : two ? std::vector<double>{-0.4, 0.4} : std::vector<double>{0.0})
        w.add_interaction(joint(w, InteractionKind::Hinge, p, b, {0.0, y, 0.3}, Vec3::UnitY()));
    advance(w, 1);
    const Energy start = w.energy();
    double most = 0.0, exchanged = 1e-9;
    for (int k = 1; k < 120; ++k) {
        run_counted(w, 1, cost);
        const Energy e = w.energy();
        most =
            std::max(most, std::abs(e.mechanical() - start.mechanical() + e.damped - start.damped));
        exchanged = std::max(exchanged, std::abs(e.kinetic - start.kinetic));
    }
    return {w.pose(b).position, most / exchanged};
}

}  // namespace

void case_repeated_joints(Report& report) {
    Cost cost;
    for (const double rate : {0.2, 0.6, 1.5}) {
        const Slew one = slew(rate, false, cost), two = slew(rate, true, cost);
        const Vec3 exact = boom_exact(rate, 2.0);
        const std::string at = fmt::format(", {} rad/s", rate);
        require_below(report, "boom on two hinges against one [m]" + at,
                      (two.boom - one.boom).norm(), 1e-4, "the same motion");
        require_below(report, "boom against the exact motion [m]" + at,
                      std::max((one.boom - exact).norm(), (two.boom - exact).norm()), 3e-3,
                      "Lagrange's equations by RK4");
        require_below(report, "energy that nothing explains" + at,
                      std::max(one.unexplained, two.unexplained), 1e-2, "of what was exchanged");
    }
    cost.report(report, "boom");
}

void case_long_motions(Report& report) {
    World w({.step = kRobustStep});
    BodyId above = w.add_body({.kind = BodyKind::fixed});
    for (int i = 0; i < 2; ++i) {
        const BodyId rod = w.add_body({.position = {i + 0.5, 0, 0},
                                       .mass = 1.0,
                                       .inertia = Vec3(1e-3, 1.0 / 12.0, 1.0 / 12.0).asDiagonal()});
        w.add_interaction(joint(w, InteractionKind::Hinge, above, rod,
                                {static_cast<double>(i), 0, 0}, Vec3::UnitY()));
        above = rod;
    }
    Cost cost;
    advance(w, 1);
    const double start = w.energy().mechanical(), depth = kGravity * 2.0;  // Σ m g r
    double sum = 0.0, most = 0.0;
    const long steps = steps_to(w, 600.0);
    for (long k = 0; k < steps; ++k) {
        run_counted(w, 1, cost);
        const double error = (w.energy().mechanical() - start) / depth;
        sum += error;
        most = std::max(most, std::abs(error));
    }
    require_below(report, "double pendulum, 600 s: mean energy error",
                  std::abs(sum) / static_cast<double>(steps), 5e-3, "of weight times depth");
    require_below(report, "double pendulum, 600 s: momentary", most, 5e-2, "of weight times depth");
    cost.report(report, "double pendulum");

    World chain({.step = 1.0 / 240.0, .gravity = {0, 0, 0}});
    BodyId last{};
    for (int i = 0; i < 7; ++i) {
        BodyDef rod = solid_box({0.8 * (i + 0.5), 0, 0}, 10.0, {0.4, 0.04, 0.04});
        // Each rotates about its own centre so that the joints' points agree.
        const double w0 = i % 2 == 0 ? 12.0 : -12.0;
        rod.angular_velocity = {0, 0, w0};
        const BodyId id = chain.add_body(rod);
        if (i > 0)
            chain.add_interaction(joint(chain, InteractionKind::Ball, last, id, {0.8 * i, 0, 0}));
        last = id;
    }
    chain.set_velocity(BodyId{0}, {{0, 0, 20}, {0, 25, 12}});
    chain.set_velocity(BodyId{6}, {{0, 15, -20}, {0, 25, -12}});
    Cost chained;
    run_counted(chain, 2, chained);  // the start is made consistent with the joints
    const Vec3 before = angular_momentum(chain);
    double tip = 0.0;
    for (long k = 0; k < 4800; ++k) {
        run_counted(chain, 1, chained);
        const Twist t = chain.velocity(last);
        const Vec3 arm = chain.pose(last).orientation * Vec3(0.4, 0, 0);
        tip = std::max(tip, (t.linear + t.angular.cross(arm)).norm());
    }
    require_below(report, fmt::format("chain of 7 rods, tips to {:.0f} m/s: |dL|/L", tip),
                  (angular_momentum(chain) - before).norm() / before.norm(), 1e-5,
                  "20 s at 1/240 s");
    chained.report(report, "chain of rods");
}

void case_ships_on_chain(Report& report) {
    constexpr int kLinks = 20;
    constexpr double kPull = 2.5e6, kLength = 2.0;
    std::vector<double> means;
    for (const double step : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
        World w({.step = step, .gravity = {0, 0, 0}});
        auto ship = [&](double x, double force) {
            BodyDef d = solid_box({x, 0, 0}, 3.3e6, {5, 5, 5});
            d.force = {force, 0, 0};
            return w.add_body(d);
        };
        const BodyId first = ship(-5.0, -kPull), second = ship(kLinks * kLength + 5.0, kPull);
        BodyId last = first;
        InteractionId middle{};
        for (int i = 0; i <= kLinks; ++i) {
            const BodyId next =
                i == kLinks
                    ? second
                    : w.add_body(solid_box({kLength * (i + 0.5), 0, 0}, 50.0, {1, 0.05, 0.05}));
            const InteractionId id =
                w.add_interaction(joint(w, InteractionKind::Ball, last, next, {kLength * i, 0, 0}));
            if (i == kLinks / 2) middle = id;
            last = next;
        }
        const double expected = kPull * (1.0 - kLinks * 50.0 / (2.0 * 3.3e6 + kLinks * 50.0));
        advance(w, 1);
        const std::string at = fmt::format(", h = 1/{:.0f}", 1.0 / step);
        require_below(report, "first tension of 20 links of 50 kg between 3,300 t" + at,
                      std::abs(-w.force(middle)[0] / expected - 1.0), 5e-3, "relative");
        double sum = 0.0;
        const long steps = steps_to(w, 1.0) - 1;
        for (long k = 0; k < steps; ++k) {
            advance(w, 1);
            sum -= w.force(middle)[0];
        }
        means.push_back(sum / static_cast<double>(steps));
    }
    const auto [low, high] = std::minmax_element(means.begin(), means.end());
    require_below(report, "means of 1 s at 1/60, 1/240, 1/960 s, apart", *high / *low - 1.0, 2e-3,
                  "relative");
    std::vector<double> first;
    for (const char* compliance : {"", "defaults.compliance=0"}) {
        scene::Scene s = open_scene(
            "mooring", kRobustStep,
            *compliance ? std::vector<std::string>{compliance} : std::vector<std::string>{});
        advance(s.world, 1);
        first.push_back(tension(s.world, interaction(s.world, "tow_east/j0")));
    }
    require_below(report, "mooring: first tow tension against compliance 0",
                  std::abs(first[0] / first[1] - 1.0), 5e-3, "relative");
}

}  // namespace hawser::validate
