// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file relax.h
/// Update of the impulse of one contact in a sweep of projected Gauss-Seidel.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

/// Return max(0, λ_n − r_n/(W_n + Σ_n)). @param mobility  Diagonal entry of J M⁻¹ Jᵀ [1/kg].
[[nodiscard]] double relax_normal(const Cone& cone, double mobility) noexcept;

/// Project λ_t − r_t/(W_t + Σ_t) onto the disk of radius μ λ_n, both tangents at once. @param
/// mobility W_t: at least the largest eigenvalue of their 2×2 block of J M⁻¹ Jᵀ, so that no step
/// overshoots [1/kg]. @param out  Two entries.
void relax_tangents(const Cone& cone, double mobility, double out[2]) noexcept;

/// Return open, sliding or sticking by λ: on the rim the contact slides.
[[nodiscard]] Touch touch_by_impulse(const Cone& cone) noexcept;

}  // namespace hawser::nonsmooth
