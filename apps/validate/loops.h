// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file loops.h
/// Closed loops and redundant joints with a given compliance and damping time: a boom on two
/// hinges, a planar four-bar linkage, Bennett's linkage.

#include "validate/robust_tools.h"

#include <array>
#include <cmath>

namespace hawser::validate {

/// Compliance [m/N, rad/(N m)] and damping time [s] of all rows of a joint.
struct JointLaw {
    double compliance = 0.0;
    double damping_time = kDefault;  ///< kDefault: two steps, damping of the scheme.
};

/// Add a joint at a world point with a compliance and a damping time.
inline InteractionId add_joint(World& w, InteractionKind kind, BodyId a, BodyId b, const Vec3& at,
                               const Vec3& axis, const JointLaw& law) {
    InteractionDef d = joint(w, kind, a, b, at, axis);
    d.compliance.fill(law.compliance);
    d.damping_time.fill(law.damping_time);
    return w.add_interaction(d);
}

/// Four links a, b, a, b [m] twisted by α, β with sin α/a = sin β/b. This closed chain of four
/// hinges moves although a count of its rows leaves a negative number of freedoms (G. T. Bennett,
/// 1903).
struct Bennett {
    double a, b, alpha, beta;
    /// Return the frames of the hinges 1-4, z along the axis, for the first joint's angle; link k
    /// is between the hinges k and k + 1.
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
    mutable double closing = 0.0;  ///< Distance between the last link and the first [m].
    [[nodiscard]] Vec3 end(std::size_t link, const std::array<Eigen::Isometry3d, 4>& f) const {
        const double length[4] = {a, b, a, b};
        return f[link] * Vec3(length[link], 0, 0);
    }
};

/// Return the pose of a moving link of Bennett's linkage: its centre is between its two hinges, its
/// axes are those of the first hinge.
inline Pose link_pose(const Bennett& m, std::size_t link, double theta) {
    const auto f = m.frames(theta);
    return {0.5 * (f[link].translation() + m.end(link, f)), Quat(f[link].rotation())};
}

/// Make a boom of 120 kg on two hinges of one axis, on a platform that slews at 0.6 rad/s. The boom
/// falls. Bodies: world, platform, boom.
inline World compliant_slew(double step, const JointLaw& law) {
    constexpr double kRate = 0.6, kArm = 3.0;
    World w({.step = step});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    BodyDef platform = solid_box({0, 0, 0}, 500.0, {1.0, 1.0, 0.3});
    BodyDef boom = solid_box({kArm, 0, 0.3}, 120.0, {3.0, 0.3, 0.2});
    platform.angular_velocity = boom.angular_velocity = {0, 0, kRate};
    boom.velocity = {0, kArm * kRate, 0};
    const BodyId p = w.add_body(platform), b = w.add_body(boom);
    add_joint(w, InteractionKind::Hinge, ground, p, {0, 0, 0}, Vec3::UnitZ(), law);
    for (const double y : {-0.4, 0.4})
        add_joint(w, InteractionKind::Hinge, p, b, {0, y, 0.3}, Vec3::UnitY(), law);
    return w;
}

/// Make a planar four-bar linkage in a plane that is not along the axes. Its crank starts at
/// 4 rad/s. Each pin is a hinge, so that nine of its twenty rows are redundant or hold the plane.
/// Bodies: world, crank, coupler, rocker.
inline World compliant_four_bar(double step, const JointLaw& law) {
    constexpr double kRate = 4.0;
    World w({.step = step});
    const Vec3 normal = Vec3(0.25, -0.3, 0.92).normalized(), e = normal.unitOrthogonal(),
               f = normal.cross(e);
    const auto at = [&](double x, double y) { return Vec3(x * e + y * f); };
    const std::array<Vec3, 4> pin{at(0, 0), at(0.1, 0.5), at(1.1, 1.2), at(1.1, 0)};
    // Closure of the velocities: ω₀ × AB + ω₁ × BC = ω₂ × DC.
    const Vec3 bc = normal.cross(pin[2] - pin[1]), dc = normal.cross(pin[2] - pin[3]);
    const Vec3 v_b = kRate * normal.cross(pin[1] - pin[0]);
    Eigen::Matrix2d m;
    m << e.dot(bc), -e.dot(dc), f.dot(bc), -f.dot(dc);
    const Eigen::Vector2d rest = m.inverse() * Eigen::Vector2d(-e.dot(v_b), -f.dot(v_b));
    const double rate[3] = {kRate, rest[0], rest[1]}, mass[3] = {2.0, 3.0, 4.0};
    const Vec3 speed[3] = {Vec3::Zero(), v_b, Vec3::Zero()};  // of the first pin of each link
    const Vec3 first[3] = {pin[0], pin[1], pin[3]}, last[3] = {pin[1], pin[2], pin[2]};
    std::array<BodyId, 4> link{w.add_body({.kind = BodyKind::fixed})};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 along = last[i] - first[i];
        BodyDef bar =
            solid_box(0.5 * (first[i] + last[i]), mass[i], {0.5 * along.norm(), 0.1, 0.05});
        bar.orientation = turn_between(Vec3::UnitX(), along.normalized());
        bar.angular_velocity = rate[i] * normal;
        bar.velocity = speed[i] + bar.angular_velocity.cross(0.5 * along);
        link[i + 1] = w.add_body(bar);
    }
    for (std::size_t i = 0; i < 4; ++i)
        add_joint(w, InteractionKind::Hinge, link[i], link[(i + 1) % 4], pin[i], normal, law);
    return w;
}

/// Make Bennett's linkage of 1.1 m and 0.74 m, released from rest. Bodies: world and three links.
inline World compliant_bennett(double step, const JointLaw& law) {
    constexpr double kLong = 1.1, kTwist = 1.0, kOther = 0.6, kAngle = 0.9;
    World w({.step = step, .gravity = {3, -4, -8}});
    const Bennett m{kLong * std::sin(kOther) / std::sin(kTwist), kLong, kOther, kTwist};
    std::array<BodyId, 4> link{w.add_body({.kind = BodyKind::fixed})};
    const double mass[4] = {0.0, 2.0, 1.0, 2.0};
    for (std::size_t i = 1; i < 4; ++i) {
        const Pose pose = link_pose(m, i, kAngle);
        const double half = 0.5 * (i % 2 == 0 ? m.a : m.b);
        BodyDef box = solid_box(pose.position, mass[i], {half, 0.05, 0.05});
        box.orientation = pose.orientation;
        link[i] = w.add_body(box);
    }
    const auto f = m.frames(kAngle);
    for (std::size_t i = 0; i < 4; ++i)
        add_joint(w, InteractionKind::Hinge, link[(i + 3) % 4], link[i], f[i].translation(),
                  f[i].rotation().col(2), law);
    return w;
}

/// Builders of the worlds above.
struct CompliantLoop {
    const char* name;
    World (*make)(double step, const JointLaw& law);
};
inline constexpr CompliantLoop kCompliantLoops[] = {{"boom on two hinges", compliant_slew},
                                                    {"four-bar linkage", compliant_four_bar},
                                                    {"Bennett's linkage", compliant_bennett}};

/// Return the largest distance between the centres of equal bodies of two worlds [m].
inline double largest_distance(const World& a, const World& b) {
    double most = 0.0;
    for (std::int32_t i = 0; i < a.body_count(); ++i)
        most = std::max(most, (a.pose(BodyId{i}).position - b.pose(BodyId{i}).position).norm());
    return most;
}

}  // namespace hawser::validate
