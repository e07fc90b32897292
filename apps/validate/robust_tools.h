// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file robust_tools.h
/// Shared parts of the robust cases of rigid joints.

#include "validate/tools.h"

#include <string>

namespace hawser::validate {

inline constexpr double kRobustStep = 1.0 / 60.0;  ///< The user's step [s].

/// Return the definition of a solid box. @param half  Half edges [m].
inline BodyDef solid_box(const Vec3& position, double mass, const Vec3& half) {
    const Vec3 s = half.cwiseProduct(half);
    return {.position = position,
            .mass = mass,
            .inertia =
                Vec3(mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal()};
}

/// Return a joint at a world point; for hinges, about a world axis.
inline InteractionDef joint(const World& w, InteractionKind kind, BodyId a, BodyId b,
                            const Vec3& at, const Vec3& axis = Vec3::UnitZ()) {
    InteractionDef d{.kind = kind, .body = {a, b}};
    for (std::size_t k = 0; k < 2; ++k) {
        const Pose pose = w.pose(d.body[k]);
        d.point[k] = pose.orientation.conjugate() * (at - pose.position);
        d.frame[k] = pose.orientation.conjugate() * turn_between(Vec3::UnitZ(), axis.normalized());
    }
    return d;
}

/// Add a check that a value is below a limit.
inline void require_below(Report& report, const std::string& what, double value, double limit,
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
        require_below(r, what + ": factorisations a step", factorisations / n, 1.05, "mean");
        require_below(r, what + ": substitutions a step, filter included", substitutions / n, 6.0,
                      "mean");
    }
};

inline void run_counted(World& w, long steps, Cost& cost) {
    for (long k = 0; k < steps; ++k) {
        advance(w, 1);
        cost.count(w);
    }
}

/// Return Σ of the bodies' angular momentum about the origin, at the middle of the step.
inline Vec3 angular_momentum(const World& w) {
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

}  // namespace hawser::validate
