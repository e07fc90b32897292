// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_bounds.h
/// Which elements of a wire pull: settled along the wire, all at once.
///
/// Newton's method for bounded rows (bounds.h) moves the end of the slack part of a wire by one
/// element an iteration: an element that comes taut loads its lump, which pulls at the next one
/// only in the solution that follows. But elements between lumps are a small problem of their own.
/// With λ = −z of the elements of a wire, all else as it is, and about the iterate
/// ```
///   r = r₀ + M (z − z₀) ≥ 0   ⊥   z ≥ 0                r = c − G v − Σλ
///   M_ii = Σ_i + Σ_n G_in Â_n⁻¹ G_inᵀ     M_ij = G_in Â_n⁻¹ G_jnᵀ, n the lump between i and j
///   Â_n = m_n E + Σ w² Eᵀ S E             its contacts with their laws S and weights w
/// ```
/// M is tridiagonal, symmetric and positive definite. Bodies that are no lumps count as held, and
/// of a sliding contact the part of S that the disk's radius adds is left out, so that Â stays
/// symmetric. nonsmooth/tridiagonal.h solves it at the cost of some sweeps along the wire. The
/// result decides statuses only, for the next iteration: the test for convergence is that of
/// bounds.h.

#include "context/context.h"

namespace hawser::stepper {

/// Find the chains of elements among the bounded rows. @throws std::bad_alloc.
void reserve_wire_bounds(const Model& model, Newton& newton);

/// Settle the statuses of each chain of which a row has switched since the matrix was factored.
/// Call after switch_bounds().
void settle_wire_bounds(Model& model, Work& work) noexcept;

}  // namespace hawser::stepper
