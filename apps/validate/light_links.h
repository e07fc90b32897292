// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file light_links.h
/// Four-bar windows (IFToMM benchmark A02), and a pendulum of a heavy bob on a light rod.

#include "validate/robust_tools.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::validate {

/// Make a row of N four-bar windows of links of 1 m and 1 kg, upright, whose top moves at 1 m/s.
/// All bars are in line twice a turn: this pose is singular.
inline World make_windows(double step, int windows) {
    World w({.step = step});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const Vec3 upright(1.0 / 12.0, 1.0 / 12.0, 1e-3), level(1e-3, 1.0 / 12.0, 1.0 / 12.0);
    std::vector<BodyId> post, bar;
    for (int i = 0; i <= windows; ++i) {
        BodyDef d{.position = {1.0 * i, 0, 0.5}, .mass = 1.0, .inertia = upright.asDiagonal()};
        d.velocity = {0.5, 0, 0};
        d.angular_velocity = {0, 1, 0};
        post.push_back(w.add_body(d));
    }
    for (int i = 0; i < windows; ++i) {
        BodyDef d{.position = {i + 0.5, 0, 1}, .mass = 1.0, .inertia = level.asDiagonal()};
        d.velocity = {1, 0, 0};
        bar.push_back(w.add_body(d));
    }
    const auto pin = [&](BodyId a, BodyId b, const Vec3& at) {
        w.add_interaction(joint(w, InteractionKind::Hinge, a, b, at, Vec3::UnitY()));
    };
    for (std::size_t i = 0; i < post.size(); ++i) {
        const auto x = static_cast<double>(i);
        pin(ground, post[i], {x, 0, 0});
        if (i < bar.size()) pin(post[i], bar[i], {x, 0, 1});
        if (i > 0) pin(bar[i - 1], post[i], {x, 0, 1});
    }
    return w;
}

/// Pendulum of a bob of 10 t at 1 m on a rod that is `ratio` times lighter, released at rest.
struct LightPendulum {
    static constexpr double kBob = 1e4, kRadius = 0.2, kAngle = 40.0 * kPi / 180.0;
    World world;
    BodyId bob;
    double inertia = 0.0;  ///< Moment of inertia about the pivot [kg m²].
    double torque = 0.0;   ///< Torque of gravity at 90 degrees [N m].
    [[nodiscard]] double angle() const {
        const Vec3 at = world.pose(bob).position;
        return std::atan2(at.x(), -at.z());
    }
};

/// Make a pendulum. @param welded  True if the bob turns with the rod, false if it hangs on a hinge
/// at its centre.
inline LightPendulum make_light_pendulum(double step, double ratio, bool welded) {
    constexpr double kBob = LightPendulum::kBob, kAngle = LightPendulum::kAngle;
    LightPendulum out{World({.step = step}), {}};
    World& w = out.world;
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const Vec3 along(std::sin(kAngle), 0, -std::cos(kAngle));
    BodyDef rod = solid_box(0.5 * along, kBob / ratio, {0.025, 0.025, 0.5});
    BodyDef bob{.position = along, .mass = kBob};
    bob.inertia = 0.4 * kBob * std::pow(LightPendulum::kRadius, 2) * Mat3::Identity();
    rod.orientation = bob.orientation = Quat(Eigen::AngleAxisd(-kAngle, Vec3::UnitY()));
    const BodyId r = w.add_body(rod);
    out.bob = w.add_body(bob);
    w.add_interaction(joint(w, InteractionKind::Hinge, ground, r, {0, 0, 0}, Vec3::UnitY()));
    w.add_interaction(joint(w, welded ? InteractionKind::Lock : InteractionKind::Hinge, r, out.bob,
                            along, Vec3::UnitY()));
    // The rod turns about its end; a bob on a hinge does not turn.
    out.inertia = kBob + (welded ? bob.inertia(0, 0) : 0.0) + rod.mass / 3.0;
    out.torque = kGravity * (kBob + 0.5 * rod.mass);
    return out;
}

}  // namespace hawser::validate
