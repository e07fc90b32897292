// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file associated.h
/// The convex model of contact: impulses that are normal to Coulomb's cone.
///
/// ```
///   λ = argmin over λ in K of ½ λᵀΣλ − λᵀ(b − u) = P_K(y),   y = Σ⁻¹(b − u), nearest in the norm Σ
/// ```
/// Sources: M. Anitescu, "Optimization-based simulation of nonsmooth rigid multibody dynamics",
/// 2006; with compliance: A. Castro, F. Permenter, X. Han, "An unconstrained convex formulation of
/// compliant contact", 2022.
///
/// It is the law of cone.h without De Saxcé's shift: the velocity r is in the dual cone. As a
/// result of convexity, a point that slides at ‖u_t‖ also lifts at μ‖u_t‖. Sticking points are
/// unaffected. P is the gradient of a convex function, so that S = −∂λ/∂u is symmetric and positive
/// semidefinite. Newton's method with a line search therefore always terminates.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

/// Compute the impulse P_K(y) of the associated law at relative velocity u, the projection of y
/// onto the cone K [N s].
void associated_impulse(const Cone& cone, const double u[3], double lambda[3]) noexcept;

/// Linearise the associated law about u: λ = p − S u, which equals P_K(y) at u.
[[nodiscard]] Law linearise_associated(const Cone& cone, Touch& touch) noexcept;

/// Return natural_map() for the associated law, in which r is not shifted by μ‖r_t‖.
[[nodiscard]] double associated_map(const Cone& cone, double floor) noexcept;

}  // namespace hawser::nonsmooth
