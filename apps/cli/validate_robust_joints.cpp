// SPDX-License-Identifier: Apache-2.0
// Rigid joints at the user's step: repeated joints, overconstrained loops, heavy ships on chains,
// motions that keep their energy and momentum.
#include "validate_reference.h"
#include "validate_robust.h"
#include "validate_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace hawser::cli {
namespace {

constexpr double kStep = 1.0 / 60.0;

/// @param half  Half edges [m].
BodyDef solid_box(const Vec3& position, double mass, const Vec3& half) {
    const Vec3 s = half.cwiseProduct(half);
    return {.position = position,
            .mass = mass,
            .inertia =
                Vec3(mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal()};
}

/// Joint at a world point; of hinges, about a world axis.
InteractionDef joint(const World& w, InteractionKind kind, BodyId a, BodyId b, const Vec3& at,
                     const Vec3& axis = Vec3::UnitZ()) {
    InteractionDef d{.kind = kind, .body = {a, b}};
    for (std::size_t k = 0; k < 2; ++k) {
        const Pose pose = w.pose(d.body[k]);
        d.point[k] = pose.orientation.conjugate() * (at - pose.position);
        d.frame[k] =
            pose.orientation.conjugate() * Quat::FromTwoVectors(Vec3::UnitZ(), axis.normalized());
    }
    return d;
}

/// A figure that is to be small.
void below(Report& report, const std::string& what, double value, double limit,
           const std::string& reason) {
    report.compare(what, {0.0}, {value}, limit, reason, 1.0);
}

/// Factorisations and substitutions a step, means.
struct Cost {
    double factorisations = 0.0, substitutions = 0.0;
    long steps = 0;
    void count(const World& w) {
        factorisations += w.stats().factorisations;
        substitutions += w.stats().substitutions;
        ++steps;
    }
    void report(Report& r, const std::string& what) const {
        const auto n = static_cast<double>(steps);
        below(r, what + ": factorisations a step", factorisations / n, 1.05, "mean");
        below(r, what + ": substitutions a step, filter included", substitutions / n, 6.0, "mean");
    }
};

void run_counted(World& w, long steps, Cost& cost) {
    for (long k = 0; k < steps; ++k) {
        advance(w, 1);
        cost.count(w);
    }
}

/// Σ of the bodies' angular momentum about the origin, at the step's middle.
Vec3 angular_momentum(const World& w) {
    Vec3 sum = Vec3::Zero();
    const double h = w.settings().step;
    for (int i = 0; i < w.body_count(); ++i) {
        const BodyDef& def = w.body_def(BodyId{i});
        if (def.kind != BodyKind::rigid) continue;
        const Pose pose = w.pose(BodyId{i});
        const Twist v = w.velocity(BodyId{i});
        const Vec3 spin = pose.orientation.conjugate() * v.angular, m = def.inertia * spin;
        sum += def.mass * pose.position.cross(v.linear) +
               pose.orientation * (m - 0.5 * h * spin.cross(m));
    }
    return sum;
}

// ---- a boom on a slewing platform
// ----------------------------------------------------------------

constexpr double kArm = 3.0, kBoom = 120.0;  ///< [m], [kg].
const Vec3 kBoomHalf{3.0, 0.3, 0.2}, kPlatformHalf{1.0, 1.0, 0.3};

/// Where the boom's centre is after `time`, from Lagrange's equations in slew and luff by RK4.
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
    constexpr int kSlices = 20'000;
    const double h = time / kSlices;
    for (int i = 0; i < kSlices; ++i) {
        const State a = slope(s), b = slope(plus(s, 0.5 * h, a)), c = slope(plus(s, 0.5 * h, b)),
                    d = slope(plus(s, h, c));
        for (std::size_t k = 0; k < 3; ++k) s[k] += h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]);
    }
    const double reach = kArm * std::cos(s[0]);
    return {reach * std::cos(s[2]), reach * std::sin(s[2]), 0.3 - kArm * std::sin(s[0])};
}

struct Slew {
    Vec3 boom;
    double unexplained;  ///< Largest energy out of nothing, of what was exchanged.
};
Slew slew(double rate, bool two, Cost& cost) {
    World w({.step = kStep});
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

// ---- Bennett's linkage
// -----------------------------------------------------------------------------

/// Four links a, b, a, b [m] twisted by α, β with sin α/a = sin β/b: a closed chain of four hinges
/// that moves although its rows ask for less than nothing (G. T. Bennett, 1903).
struct Bennett {
    double a, b, alpha, beta;
    /// Frames of the hinges 1-4, z along the axis, for the first joint's angle; link k is between
    /// the hinges k and k + 1.
    [[nodiscard]] std::array<Eigen::Isometry3d, 4> frames(double theta) const {
        const double k = std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha));
        const double phi = 2.0 * std::atan2(k * std::cos(0.5 * theta), std::sin(0.5 * theta));
        const double angle[4] = {theta, phi, -theta, -phi}, length[4] = {a, b, a, b},
                     twist[4] = {alpha, beta, alpha, beta};
        std::array<Eigen::Isometry3d, 4> out;
        // The first link is at rest: joint 1 turns the last one against it.
        Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
        for (std::size_t i = 0; i < 4; ++i) {
            out[i] = t;
            t = t * Eigen::Translation3d(length[i], 0, 0) *
                Eigen::AngleAxisd(twist[i], Vec3::UnitX()) *
                Eigen::AngleAxisd(angle[(i + 1) % 4], Vec3::UnitZ());
        }
        closing = (t.translation()).norm();
        return out;
    }
    mutable double closing = 0.0;  ///< By how much the last one misses the first [m].
    [[nodiscard]] Vec3 end(std::size_t link, const std::array<Eigen::Isometry3d, 4>& f) const {
        const double length[4] = {a, b, a, b};
        return f[link] * Vec3(length[link], 0, 0);
    }
};

/// Poses of the three links that move: centre between the hinges, axes those of the first hinge.
Pose link_pose(const Bennett& m, std::size_t link, double theta) {
    const auto f = m.frames(theta);
    return {0.5 * (f[link].translation() + m.end(link, f)), Quat(f[link].rotation())};
}

double bennett_error(std::mt19937& random, Cost& cost, double& closing) {
    std::uniform_real_distribution<double> length(0.3, 2.0), twist(0.4, 1.2), speed(0.5, 2.0);
    Bennett m{length(random), length(random), twist(random), 0.0};
    if (m.a > m.b) std::swap(m.a, m.b);
    m.beta = std::asin(std::min(0.999, m.b / m.a * std::sin(m.alpha) *
                                           std::min(1.0, 0.95 * m.a / (m.b * std::sin(m.alpha)))));
    m.alpha = std::asin(m.a / m.b * std::sin(m.beta));
    const double theta0 = 1.0, d = 1e-6;
    World w({.step = kStep, .gravity = {0, 0, 0}});
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

/// IFToMM A05: two arms with balls of 5 kg on a shaft that turns freely, held to a slider by stiff
/// springs with dampers. @return the slider, a body of `w`.
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
                      .orientation = Quat::FromTwoVectors(Vec3::UnitZ(), along[i]),
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

/// The slider's way down each tenth of a second for ten.
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
double apart(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace

void case_governor(Report& report) {
    const std::vector<double> exact = governor_course(1.0 / 3840.0);
    const double coarse = apart(governor_course(kStep), exact);
    const double fine = apart(governor_course(0.25 * kStep), exact);
    const double finer = apart(governor_course(1.0 / 960.0), exact);
    below(report, "governor: slider over 10 s against 1/3840 s [m]", coarse, 2e-3, "1/60 s");
    below(report,
          fmt::format("likewise at 1/240 s; orders {:.2f} and {:.2f} [m]",
                      std::log(coarse / fine) / std::log(4.0),
                      std::log(fine / finer) / std::log(4.0)),
          fine, 2e-3, "orders are printed");
    World w({.step = kStep});
    build_governor(w);
    advance(w, 1);
    const double before = angular_momentum(w).z();
    Cost cost;
    run_counted(w, steps_to(w, 600.0), cost);
    below(report, "governor on a free bearing, 600 s: |dL_z|/L_z",
          std::abs(angular_momentum(w).z() / before - 1.0), 1e-4, "no torque about z");
    cost.report(report, "governor");
}

void case_repeated_joints(Report& report) {
    Cost cost;
    for (const double rate : {0.2, 0.6, 1.5}) {
        const Slew one = slew(rate, false, cost), two = slew(rate, true, cost);
        const Vec3 exact = boom_exact(rate, 2.0);
        const std::string at = fmt::format(", {} rad/s", rate);
        below(report, "boom on two hinges against one [m]" + at, (two.boom - one.boom).norm(), 1e-4,
              "the same motion");
        below(report, "boom against the exact motion [m]" + at,
              std::max((one.boom - exact).norm(), (two.boom - exact).norm()), 3e-3,
              "Lagrange's equations by RK4");
        below(report, "energy that nothing explains" + at,
              std::max(one.unexplained, two.unexplained), 1e-2, "of what was exchanged");
    }
    cost.report(report, "boom");
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
    below(report, "Bricard at 1 s [m]", (bricard(kStep, 1.0, cost) - at1).norm(), 5e-4, "1/60 s");
    below(report, "Bricard at 1 s, 1/240 s [m]", (bricard(0.25 * kStep, 1.0, fine) - at1).norm(),
          5e-5, "1/240 s");
    below(report, "Bricard at 10 s [m]", (bricard(kStep, 10.0, cost) - at10).norm(), 5e-3,
          "1/60 s");
    cost.report(report, "Bricard");
    std::mt19937 random(18);
    double worst = 0.0, open = 0.0;
    Cost bennett;
    for (int i = 0; i < 12; ++i) {
        double closing = 0.0;
        worst = std::max(worst, bennett_error(random, bennett, closing));
        open = std::max(open, closing);
    }
    below(report, "Bennett linkages as drawn: gap of the loop [m]", open, 1e-9, "closed form");
    below(report, "12 Bennett linkages after 1 s, links 0.3-2 m, to 2 m/s [m]", worst, 5e-3,
          "energy integral by RK4");
    bennett.report(report, "Bennett");
}

void case_long_motions(Report& report) {
    World w({.step = kStep});
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
    below(report, "double pendulum, 600 s: mean energy error",
          std::abs(sum) / static_cast<double>(steps), 5e-3, "of weight times depth");
    below(report, "double pendulum, 600 s: momentary", most, 5e-2, "of weight times depth");
    cost.report(report, "double pendulum");

    World chain({.step = 1.0 / 240.0, .gravity = {0, 0, 0}});
    BodyId last{};
    for (int i = 0; i < 7; ++i) {
        BodyDef rod = solid_box({0.8 * (i + 0.5), 0, 0}, 10.0, {0.4, 0.04, 0.04});
        // Each turns about its own centre so that the joints' points agree.
        const double w0 = i % 2 == 0 ? 12.0 : -12.0;
        rod.angular_velocity = {0, 0, w0};
        rod.velocity = {0, i % 2 == 0 ? 0.0 : 0.0, 0};
        const BodyId id = chain.add_body(rod);
        if (i > 0)
            chain.add_interaction(joint(chain, InteractionKind::Ball, last, id, {0.8 * i, 0, 0}));
        last = id;
    }
    chain.set_velocity(BodyId{0}, {{0, 0, 20}, {0, 25, 12}});
    chain.set_velocity(BodyId{6}, {{0, 15, -20}, {0, 25, -12}});
    Cost chained;
    run_counted(chain, 2, chained);  // the start is made to fit the joints
    const Vec3 before = angular_momentum(chain);
    double tip = 0.0;
    for (long k = 0; k < 4800; ++k) {
        run_counted(chain, 1, chained);
        const Twist t = chain.velocity(last);
        const Vec3 arm = chain.pose(last).orientation * Vec3(0.4, 0, 0);
        tip = std::max(tip, (t.linear + t.angular.cross(arm)).norm());
    }
    below(report, fmt::format("chain of 7 rods, tips to {:.0f} m/s: |dL|/L", tip),
          (angular_momentum(chain) - before).norm() / before.norm(), 1e-5, "20 s at 1/240 s");
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
        below(report, "first tension of 20 links of 50 kg between 3,300 t" + at,
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
    below(report, "means of 1 s at 1/60, 1/240, 1/960 s, apart", *high / *low - 1.0, 2e-3,
          "relative");
    std::vector<double> first;
    for (const char* compliance : {"", "defaults.compliance=0"}) {
        scene::Scene s = open_scene(
            "mooring", kStep,
            *compliance ? std::vector<std::string>{compliance} : std::vector<std::string>{});
        advance(s.world, 1);
        first.push_back(tension(s.world, interaction(s.world, "tow_east/j0")));
    }
    below(report, "mooring: first tow tension against compliance 0",
          std::abs(first[0] / first[1] - 1.0), 5e-3, "relative");
}

}  // namespace hawser::cli
