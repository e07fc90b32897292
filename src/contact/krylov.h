// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file krylov.h
/// Changed contacts without a new factorisation.
///
/// The matrix K was factored with the laws λ = p − S u; now λ = p' − S' u is wanted. Let w be
/// impulses beyond those of the laws in the matrix. Momentum and joints hold whatever w is, with
/// ```
///   δv = K⁻¹ Jᵀ w,   δλ = w − S J δv,    and    w + (S' − S) J K⁻¹ Jᵀ w = p' − S' u − λ
/// ```
/// is what w has to satisfy, three unknowns a contact, solved by GMRES with one substitution an
/// iteration. Where few contacts changed, or all by little, the operator is the identity but for a
/// few directions.

#include "context/context.h"

namespace hawser::stepper {

inline constexpr int kKrylovLimit = 4;  ///< Substitutions; beyond, factoring is as cheap.

/// Impulses for the laws about the iterate; they go into the contacts' p.
/// @return false: not within kKrylovLimit substitutions.
[[nodiscard]] bool find_impulses(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
