// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file associated.h
/// The convex model of contact: impulses that are normal to Coulomb's cone.
///
/// ```
///   λ = argmin over λ in K of ½ λᵀΣλ − λᵀ(b − u) = P_K(y),   y = Σ⁻¹(b − u), nearest in the norm Σ
/// ```
/// (M. Anitescu, "Optimization-based simulation of nonsmooth rigid multibody dynamics", 2006; with
/// compliance: A. Castro, F. Permenter, X. Han, "An unconstrained convex formulation of compliant
/// contact", 2022.) It is the law of cone.h without De Saxcé's shift: the velocity r is in the dual
/// cone, so that a point that slides at ‖u_t‖ also lifts at μ‖u_t‖: the price of convexity. What
/// sticks is the same. P is the gradient of a convex function, so S = −∂λ/∂u is symmetric and
/// positive semidefinite, and Newton's method with a line search always ends.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

/// P_K(y) at velocity u [N s].
void associated_impulse(const Cone& cone, const double u[3], double lambda[3]) noexcept;

/// Linearise about u: λ = p − S u with λ = P_K(y) there.
[[nodiscard]] Law linearise_associated(const Cone& cone, Touch& touch) noexcept;

/// natural_map() of this model: without the shift.
[[nodiscard]] double associated_map(const Cone& cone, double floor) noexcept;

}  // namespace hawser::nonsmooth
