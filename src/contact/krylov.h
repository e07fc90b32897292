// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file krylov.h
/// Treatment of changed contacts without a new factorisation.
///
/// The matrix K was factored with the laws λ = p − S u, and the laws λ = p' − S' u are required.
/// Let w be impulses beyond those of the laws in the matrix. Momentum and joints hold for any w,
/// with
/// ```
///   δv = K⁻¹ Jᵀ w,   δλ = w − S J δv,    and    w + (S' − S) J K⁻¹ Jᵀ w = p' − S' u − λ
/// ```
/// which determines w: three unknowns per contact, solved by GMRES with one substitution per
/// iteration. If few contacts changed, or all by little, the operator is the identity except for a
/// few directions.

#include "context/context.h"

namespace hawser::contact {

inline constexpr int kKrylovLimit = 4;  ///< Substitutions; beyond, factoring costs as little.

/// Find the impulses that satisfy the laws about the iterate by GMRES, and add them to the offsets
/// p of the contacts.
/// @return false if kKrylovLimit substitutions do not suffice.
[[nodiscard]] bool find_impulses(context::StepContext& ctx) noexcept;

}  // namespace hawser::contact
