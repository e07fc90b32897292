// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resistance.h
/// Resistance of one contact to rolling and spinning, as rows in addition to those of its cone.
///
/// A torque opposes the relative angular velocity u = E (ω₁ − ω₀) [rad/s] along the axes of the
/// contact (0: the normal, 1 and 2: the tangents). Its impulse λ [N m s] has bounds of a length
/// times the normal impulse λ_n of the contact. With r = u + Σλ − b
/// ```
///   |λ_0| ≤ μ_s λ_n     ‖(λ_1, λ_2)‖ ≤ μ_r λ_n     each: r = 0 inside, λ against r on the rim
/// ```
/// As for friction (cone.h), Σ and b belong to a spring that holds without creep below the bound.
/// The law is λ = P(λ − ρ r), with P the projection onto the interval and the disk. Newton's method
/// uses
/// ```
///   λ = p − S u − c u_n
/// ```
/// with u_n the normal velocity of the contact. On the rim, where λ = μ λ_n ŷ, c = μ ŷ/Σ_n. It
/// makes the matrix unsymmetric; lagged coupling omits it (Cone::coupling applies here, too).
///
/// Limit: sliding and rolling have separate bounds. Contact patches that carry both at once (J.
/// Vollebregt, Contensou) are not modelled.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

struct Resistance {
    // The problem.
    double b[3];                ///< Right-hand side [rad/s].
    double sigma;               ///< Σ [1/(kg m²)].
    double mobility;            ///< Mean diagonal entry of E M⁻¹ Eᵀ over rotations [1/(kg m²)].
    double torsional, rolling;  ///< Friction lengths μ_s, μ_r [m]; 0: that part is free.
    // The iterate.
    double u[3];       ///< Relative angular velocity [rad/s].
    double lambda[3];  ///< Impulse [N m s].
    // The linear law in the matrix as last factorised.
    double s[9];         ///< S, row-major [kg m²].
    double column[3];    ///< c [kg m].
    double p[3];         ///< [N m s].
    Touch spins, rolls;  ///< State of each part; open: no normal impulse, or free.
};

/// A linear law λ = p − S u − c u_n.
struct ResistanceLaw {
    double s[9];
    double column[3];
    double p[3];
};

/// Linearise the resistance law about the iterate of resistance and contact, with ρ = 1/(W + Σ) as
/// in cone.h.
[[nodiscard]] ResistanceLaw linearise(const Resistance& resistance, const Cone& cone, Touch& spins,
                                      Touch& rolls) noexcept;

/// Set p so that the linear law gives λ at u and u_n.
void set_law_offset(Resistance& resistance, double u_n) noexcept;

/// Limit the impulses λ of a resistance to its bounds for a normal impulse of the contact.
void limit(const Resistance& resistance, double normal, double lambda[3]) noexcept;

/// Compute λ − P(λ − ρ r), with bounds from the normal impulse of the law at (u_n, λ_n) [N m s].
void residual(const Resistance& resistance, const Cone& cone, double u_n, double lambda_n,
              const double u[3], const double lambda[3], double out[3]) noexcept;

/// Return the relative residual of the law: ‖λ − P(λ − ρ r)‖ / max(‖λ‖, ρ‖q‖), with bounds from λ_n
/// of the contact. Here q is the angular velocity without this torque. @param floor  Smallest
/// denominator [N s], as for the cone.
[[nodiscard]] double natural_map(const Resistance& resistance, const Cone& cone,
                                 double floor) noexcept;

}  // namespace hawser::nonsmooth
