// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kinetic.h
/// Compute the kinetic energy of bodies.

#include "assembly/view.h"
#include "base/index.h"
#include "model/bodies.h"

#include <cstdint>

namespace hawser::assembly {

/// Return ½ vᵀ M v [J]; M excludes damping and geometric stiffness. @param velocity  Packed.
[[nodiscard]] double kinetic_energy(const model::Bodies& bodies, const double* velocity) noexcept;

/// Return ½ ωᵀ I ω of a rigid body [J]. Inline, because monitors call it twice for each body in
/// each step.
/// @param r  Rotation from the body's to the world frame.
/// @param w  Angular velocity, world frame [rad/s].
[[nodiscard]] inline double spin_energy(const double* inertia, const double* r,
                                        const double* w) noexcept {
    double v[3];
    for (int k = 0; k < 3; ++k) v[k] = r[k] * w[0] + r[3 + k] * w[1] + r[6 + k] * w[2];
    const double* s = inertia;
    return 0.5 * (v[0] * (s[0] * v[0] + s[1] * v[1] + s[2] * v[2]) +
                  v[1] * (s[3] * v[0] + s[4] * v[1] + s[5] * v[2]) +
                  v[2] * (s[6] * v[0] + s[7] * v[1] + s[8] * v[2]));
}

/// Return the kinetic energy of one moving body [J]. @param velocity  Packed.
[[nodiscard]] inline double kinetic_energy_of(const model::Bodies& bodies, std::int32_t body,
                                              const double* velocity) noexcept {
    const auto i = at(body);
    const double* v = velocity + bodies.dof_begin[i];
    const double mass = bodies.mass[i];
    double sum = 0.5 * mass * v[0] * v[0];
    const int dof = bodies.dof(body);
    if (dof == 1) return sum;
    sum += 0.5 * mass * v[1] * v[1];
    sum += 0.5 * mass * v[2] * v[2];
    return dof < 6 ? sum : sum + spin_energy(&bodies.inertia[9 * i], &bodies.r[9 * i], v + 3);
}

/// Return the kinetic energy of the mass of an element on its two end nodes, minus that of a
/// straight bar with this mass [J]: ½ μ |v₁ − v₀|². See View::pair_mass. @param velocity  Packed.
[[nodiscard]] double pair_energy(const assembly::View& view, std::int32_t id,
                                 const double* velocity) noexcept;

}  // namespace hawser::assembly
