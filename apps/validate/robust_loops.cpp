// SPDX-License-Identifier: Apache-2.0
// Overconstrained loops, and the flyball governor.
#include "validate/loops.h"
#include "validate/reference.h"
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

// ---- Bennett's linkage
// -----------------------------------------------------------------------------

double bennett_error(std::mt19937& random, Cost& cost, double& closing) {
    std::uniform_real_distribution<double> length(0.3, 2.0), twist(0.4, 1.2), speed(0.5, 2.0);
    Bennett m{length(random), length(random), twist(random), 0.0};
    if (m.a > m.b) std::swap(m.a, m.b);
    m.beta = std::asin(std::min(0.999, m.b / m.a * std::sin(m.alpha) *
                                           std::min(1.0, 0.95 * m.a / (m.b * std::sin(m.alpha)))));
    m.alpha = std::asin(m.a / m.b * std::sin(m.beta));
    const double theta0 = 1.0, d = 1e-6;
    World w({.step = kRobustStep, .gravity = {0, 0, 0}});
    std::vector<BodyId> body{w.add_body({.kind = BodyKind::fixed})};
    auto half = [&](std::size_t link) {
        return Vec3(0.5 * (link % 2 == 0 ? m.a : m.b), 0.05, 0.05);
    };
    // T = ½ J(θ) θ̇², by differences of the exact poses.
    auto twist_of = [&](std::size_t link, double theta) -> Twist {
        const Pose p = link_pose(m, link, theta - d), q = link_pose(m, link, theta + d);
        const Eigen::AngleAxisd turn(q.orientation * p.orientation.conjugate());
        return {(q.position - p.position) / (2.0 * d), turn.angle() / (2.0 * d) * turn.axis()};
    };
    auto inertia = [&](double theta) {
        double sum = 0.0;
        for (std::size_t link = 1; link < 4; ++link) {
            const Twist t = twist_of(link, theta);
            const BodyDef box = solid_box(Vec3::Zero(), 10.0, half(link));
            const Vec3 spin = link_pose(m, link, theta).orientation.conjugate() * t.angular;
            sum += box.mass * t.linear.squaredNorm() + spin.dot(box.inertia * spin);
        }
        return sum;
    };
    double fastest = 0.0;
    for (std::size_t link = 1; link < 4; ++link)
        fastest = std::max(fastest, twist_of(link, theta0).linear.norm());
    const double rate = speed(random) / fastest;
    for (std::size_t link = 1; link < 4; ++link) {
        const Pose pose = link_pose(m, link, theta0);
        BodyDef box = solid_box(pose.position, 10.0, half(link));
        const Twist t = twist_of(link, theta0);
        box.orientation = pose.orientation;
        box.velocity = rate * t.linear;
        box.angular_velocity = rate * t.angular;
        body.push_back(w.add_body(box));
    }
    const auto f = m.frames(theta0);
    closing = m.closing;
    for (std::size_t i = 0; i < 4; ++i)
        w.add_interaction(joint(w, InteractionKind::Hinge, body[(i + 3) % 4], body[i],
                                f[i].translation(), f[i].rotation().col(2)));
    run_counted(w, 60, cost);
    // θ̇ = rate √(J(θ₀)/J(θ)).
    const double j0 = inertia(theta0);
    auto slope = [&](double theta) { return rate * std::sqrt(j0 / inertia(theta)); };
    double theta = theta0;
    constexpr int kSlices = 500;
    for (int i = 0; i < kSlices; ++i) {
        const double h = 1.0 / kSlices, a = slope(theta), b = slope(theta + 0.5 * h * a),
                     c = slope(theta + 0.5 * h * b), e = slope(theta + h * c);
        theta += h / 6.0 * (a + 2.0 * (b + c) + e);
    }
    double worst = 0.0;
    for (std::size_t link = 1; link < 4; ++link)
        worst = std::max(worst,
                         (w.pose(body[link]).position - link_pose(m, link, theta).position).norm());
    return worst;
}

// ---- the flyball governor
// -------------------------------------------------------------------------

/// Build IFToMM A05: two arms with balls of 5 kg on a freely turning shaft, connected to a slider
/// by stiff springs with dampers. @return the slider, a body of `w`.
BodyId build_governor(World& w) {
    constexpr double kSpin = 2.0 * kPi, kOpen = kPi / 6.0, kRodMass = 0.3, kBallMass = 5.0;
    auto add = [&](BodyDef d) {
        d.angular_velocity = {0, 0, kSpin};
        d.velocity = Vec3(0, 0, kSpin).cross(d.position);
        return w.add_body(d);
    };
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId shaft = add(solid_box({0, 0, -0.5}, kRodMass, {0.005, 0.005, 0.5}));
    const double mass = kRodMass + kBallMass, centre = (0.5 * kRodMass + kBallMass) / mass;
    const double across = kRodMass * (1.0 + 1e-4) / 12.0 + kRodMass * std::pow(centre - 0.5, 2) +
                          kBallMass * std::pow(1.0 - centre, 2);
    BodyId arm[2];
    Vec3 along[2];
    for (int i = 0; i < 2; ++i) {
        along[i] = {(i == 0 ? 1.0 : -1.0) * std::sin(kOpen), 0, -std::cos(kOpen)};
        arm[i] = add({.position = centre * along[i],
                      .orientation = turn_between(Vec3::UnitZ(), along[i]),
                      .mass = mass,
                      .inertia = Vec3(across, across, kRodMass * 2e-4 / 12.0 + 1e-6).asDiagonal()});
    }
    const double down = std::cos(kOpen);
    const BodyId slider = add(solid_box({0, 0, -down}, 3.0, {0.05, 0.05, 0.05}));
    w.add_interaction(joint(w, InteractionKind::Hinge, ground, shaft, {0, 0, 0}));
    for (const BodyId a : arm)
        w.add_interaction(joint(w, InteractionKind::Hinge, shaft, a, {0, 0, 0}, Vec3::UnitY()));
    w.add_interaction(joint(w, InteractionKind::Prismatic, shaft, slider, {0, 0, -down}));
    for (int i = 0; i < 2; ++i) {
        constexpr double kStiffness = 8e5, kDamper = 4e4;
        InteractionDef spring = joint(w, InteractionKind::Distance, arm[i], slider, {0, 0, -down});
        spring.point[0] =
            w.pose(arm[i]).orientation.conjugate() * (0.5 * along[i] - w.pose(arm[i]).position);
        spring.set("length", 0.5);
        spring.compliance[0] = 1.0 / kStiffness;
        spring.damping_time[0] = kDamper / kStiffness;
        w.add_interaction(spring);
    }
    return slider;
}

/// Return the downward displacement of the governor's slider at every tenth of a second for 10 s
/// [m].
std::vector<double> governor_course(double step) {
    World w({.step = step});
    const BodyId slider = build_governor(w);
    std::vector<double> out;
    for (int k = 0; k < 100; ++k) {
        advance(w, steps_to(w, 0.1));
        out.push_back(-w.pose(slider).position.z());
    }
    return out;
}
double separation(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace

void case_governor(Report& report) {
    const std::vector<double> exact = governor_course(1.0 / 3840.0);
    const double coarse = separation(governor_course(kRobustStep), exact);
    const double fine = separation(governor_course(0.25 * kRobustStep), exact);
    const double finer = separation(governor_course(1.0 / 960.0), exact);
    require_below(report, "governor: slider over 10 s against 1/3840 s [m]", coarse, 2e-3,
                  "1/60 s");
    require_below(report,
                  fmt::format("governor: slider over 10 s at 1/240 s; orders {:.2f} and {:.2f} [m]",
                              std::log(coarse / fine) / std::log(4.0),
                              std::log(fine / finer) / std::log(4.0)),
                  fine, 2e-3, "orders are printed");
    World w({.step = kRobustStep});
    build_governor(w);
    advance(w, 1);
    const double before = angular_momentum(w).z();
    Cost cost;
    run_counted(w, steps_to(w, 600.0), cost);
    require_below(report, "governor on a free bearing, 600 s: |dL_z|/L_z",
                  std::abs(angular_momentum(w).z() / before - 1.0), 1e-4, "no torque about z");
    cost.report(report, "governor");
}

void case_overconstrained(Report& report) {
    const auto bricard = [](double step, double time, Cost& cost) {
        scene::Scene s = open_scene("bricard", step);
        run_counted(s.world, steps_to(s.world, time), cost);
        return s.world.world_point(body(s.world, "rod2"), {0, 0, 0.5});
    };
    Cost cost, fine;
    const Vec3 at1(kBricardCorner[3], kBricardCorner[4], kBricardCorner[5]);
    const Vec3 at10(kBricardCornerLate[0], kBricardCornerLate[1], kBricardCornerLate[2]);
    require_below(report, "Bricard at 1 s [m]", (bricard(kRobustStep, 1.0, cost) - at1).norm(),
                  5e-4, "1/60 s");
    require_below(report, "Bricard at 1 s, 1/240 s [m]",
                  (bricard(0.25 * kRobustStep, 1.0, fine) - at1).norm(), 5e-5, "1/240 s");
    require_below(report, "Bricard at 10 s [m]", (bricard(kRobustStep, 10.0, cost) - at10).norm(),
                  5e-3, "1/60 s");
    cost.report(report, "Bricard");
    std::mt19937 random(18);
    double worst = 0.0, open = 0.0;
    Cost bennett;
    for (int i = 0; i < 12; ++i) {
        double closing = 0.0;
        worst = std::max(worst, bennett_error(random, bennett, closing));
        open = std::max(open, closing);
    }
    require_below(report, "Bennett linkages as drawn: gap of the loop [m]", open, 1e-9,
                  "closed form");
    require_below(report, "12 Bennett linkages after 1 s, links 0.3-2 m, to 2 m/s [m]", worst, 5e-3,
                  "energy integral by RK4");
    bennett.report(report, "Bennett");
}

}  // namespace hawser::validate
