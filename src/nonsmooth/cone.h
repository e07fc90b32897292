// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cone.h
/// One contact point with dry friction, as rows: the law, its linearisation, its residual.
///
/// Rows n (normal), t₁, t₂ (tangents) of a contact have velocities u = J v₊ [m/s] and impulses
/// λ [N s] on side 1. With r = u + Σλ − b the law is (Coulomb's disk, exact)
/// ```
///   0 ≤ λ_n ⊥ r_n ≥ 0        ‖λ_t‖ ≤ μ λ_n;   r_t = 0 inside,   λ_t = −μ λ_n r_t/‖r_t‖ on the rim
/// ```
/// Σ > 0 is the contact's compliance (SPOOK: 4ε Υ/h²), b brings the gap and the bristle to zero.
/// A number ρ > 0 turns it into an equation (P. Alart, A. Curnier, "A mixed formulation for
/// frictional contact problems prone to Newton like solution methods", 1991): with y = λ − ρ r,
/// ```
///   λ = P(y):   open   y_n ≤ 0             λ = 0
///               stick  ‖y_t‖ ≤ μ y_n       r = 0
///               slip   else                r_n = 0,  λ_t = μ λ_n ŷ,  ŷ = y_t/‖y_t‖
/// ```
/// *Tangent.* Newton's method replaces λ by its tangent there, λ = p − S u. S (3×3) is the
/// contribution of the contact to the matrix as JᵀS J, p that to the right-hand side. With κ = μ
/// λ_n/‖y_t‖ < 1 and the tangent q ⟂ ŷ of a slipping contact
/// ```
///       open     stick          slip
///   S   0        diag(Σ)⁻¹      ⎡ 1/Σ_n        0  ⎤    s = κρ/(1 − κ + κρΣ_t) ≤ 1/Σ_t
///                               ⎣ μŷ/Σ_n   s q qᵀ ⎦
/// ```
/// The entry μŷ/Σ_n makes S unsymmetric. Coupling::lagged leaves it out. The disk then keeps the
/// radius of the last iterate, and S is symmetric and positive. Each iteration solves a convex
/// problem, but more iterations are needed.
///
/// The numbers ρ = 1/(W + Σ) of the normal and 1/(W/10 + Σ) of the tangents, with W the diagonal of
/// J M⁻¹ Jᵀ, do not depend on the stiffness of the contact. If W = 0, y depends on u alone.
/// Residual and linear law have the same ρ, so that Newton's direction is that of the residual.
///
/// *Reversal.* The law of slip has no stiffness along ŷ. If the friction force reverses, the point
/// jumps from one side of its solution to the other, with sticking between both. So if ŷ turns by
/// more than 90° from one law to the next, the law of sticking replaces it for an iteration
/// (sticking_law()). Then λ_t has the right direction, and the contact slides next if λ_t exceeds
/// the disk.

#include <cstdint>

namespace hawser::nonsmooth {

enum class Touch : std::uint8_t { open, stick, slip };

/// How the radius of the friction disk follows the normal impulse within one iteration.
enum class Coupling : std::uint8_t {
    exact,   ///< With it: unsymmetric.
    lagged,  ///< It stays that of the last iterate: symmetric.
};

struct Cone {
    // The problem.
    double b[3];              ///< [m/s].
    double sigma_n, sigma_t;  ///< Σ [1/kg].
    double mobility;          ///< W: mean diagonal entry of J M⁻¹ Jᵀ [1/kg].
    double friction;          ///< μ.
    // The iterate.
    double u[3];       ///< J v₊ [m/s].
    double lambda[3];  ///< Impulse: p − S u [N s].
    // The linear law in the matrix as last factored.
    double s[9];  ///< Row-major [kg].
    double p[3];  ///< [N s].
    Touch touch;
    Coupling coupling;  ///< Coupling of this contact, which may fall back to lagged.
};

/// A linear law λ = p − S u.
struct Law {
    double s[9];  ///< Row-major [kg].
    double p[3];  ///< [N s].
};

/// Linearise about (u, λ).
[[nodiscard]] Law linearise(const Cone& cone, Touch& touch) noexcept;

/// Project an impulse to the nearest one in the cone K: λ_n ≥ 0, ‖λ_t‖ ≤ μ λ_n.
void project(double friction, double lambda[3]) noexcept;

/// Return the law of sticking, r = 0.
[[nodiscard]] Law sticking_law(const Cone& cone) noexcept;

/// True if two sliding laws with exact coupling have directions ŷ more than 90° apart.
[[nodiscard]] bool sliding_reversed(const Law& before, const Law& after) noexcept;

/// Return μ y_n about (u, λ), the radius of the friction disk [N s]; 0 if open.
[[nodiscard]] double disk_radius(const Cone& cone, const double u[3],
                                 const double lambda[3]) noexcept;

/// Compute λ − P(λ − ρ r) with the ρ of linearise(): zero exactly if the law holds [N s]. P
/// shortens λ_t to the disk of radius μ P(y)_n.
void residual(const Cone& cone, const double u[3], const double lambda[3], double out[3]) noexcept;

/// Return ‖λ − y‖ / max(‖λ‖, ρ‖q‖, floor), see natural_map().
[[nodiscard]] double relative_distance(const Cone& cone, const double y[3], double rho,
                                       double floor) noexcept;

/// Return the relative residual of the law, independent of units and of how stiff the contact is:
/// ‖λ − P_K(λ − ρ ũ)‖ / max(‖λ‖, ρ‖q‖), with ũ = r + (μ‖r_t‖, 0, 0) (G. De Saxcé, Z.-Q. Feng,
/// 1998) and q the velocity that the point would have without its own impulse.
/// 0/0 counts as 0. A contact with λ far below `floor` [N s] is measured against floor.
[[nodiscard]] double natural_map(const Cone& cone, double floor) noexcept;

}  // namespace hawser::nonsmooth
