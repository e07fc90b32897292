// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resistance.h
/// Resistance of one contact to rolling and to spinning, as rows beside those of its cone.
///
/// The relative angular velocity u = E (ω₁ − ω₀) [rad/s] along the contact's axes (0: the normal,
/// 1 and 2: the tangents) is opposed by a torque with the impulse λ [N m s], whose bounds are
/// lengths times the normal impulse λ_n of the contact. With r = u + Σλ − b
/// ```
///   |λ_0| ≤ μ_s λ_n     ‖(λ_1, λ_2)‖ ≤ μ_r λ_n     each: r = 0 inside, λ against r on the rim
/// ```
/// As for friction (cone.h) Σ and b are those of a spring, which holds without creep below the
/// bound, and the law is λ = P(λ − ρ r) with P onto the interval and the disk. Newton's method
/// takes
/// ```
///   λ = p − S u − c u_n
/// ```
/// with u_n the normal velocity of the contact: c = μ ŷ/Σ_n on the rim, where λ = μ λ_n ŷ. It makes
/// the matrix unsymmetric; lagged coupling leaves it out (Cone::coupling holds here too).
///
/// Sliding and rolling do not share a bound: contact patches that carry both at once (J.
/// Vollebregt, Contensou) are not modelled.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

struct Resistance {
    // The problem.
    double b[3];                ///< [rad/s].
    double sigma;               ///< Σ [1/(kg m²)].
    double mobility;            ///< Mean diagonal entry of E M⁻¹ Eᵀ over rotations [1/(kg m²)].
    double torsional, rolling;  ///< μ_s, μ_r [m]; 0: that part is free.
    // The iterate.
    double u[3];       ///< [rad/s].
    double lambda[3];  ///< [N m s].
    // The linear law in the matrix as last factored.
    double s[9];         ///< Row-major [kg m²].
    double column[3];    ///< c [kg m].
    double p[3];         ///< [N m s].
    Touch spins, rolls;  ///< Of each part; open: without normal impulse, or free.
};

/// A linear law λ = p − S u − c u_n.
struct ResistanceLaw {
    double s[9];
    double column[3];
    double p[3];
};

/// Linearise about the iterate of both, with ρ = 1/(W + Σ) as in cone.h.
[[nodiscard]] ResistanceLaw linearise(const Resistance& resistance, const Cone& cone, Touch& spins,
                                      Touch& rolls) noexcept;

/// p such that the linear law gives λ at u and u_n.
void take_impulse(Resistance& resistance, double u_n) noexcept;

/// λ within its bounds at a normal impulse.
void limit(const Resistance& resistance, double normal, double lambda[3]) noexcept;

/// λ − P(λ − ρ r), the bounds those of the law's normal impulse at (u_n, λ_n) [N m s].
void residual(const Resistance& resistance, const Cone& cone, double u_n, double lambda_n,
              const double u[3], const double lambda[3], double out[3]) noexcept;

/// Relative residual of the law: ‖λ − P(λ − ρ r)‖ / max(‖λ‖, ρ‖q‖), bounds those of the contact's
/// λ_n, q what the angular velocity would be without this torque. `floor` [N s] as for the cone.
[[nodiscard]] double natural_map(const Resistance& resistance, const Cone& cone,
                                 double floor) noexcept;

}  // namespace hawser::nonsmooth
