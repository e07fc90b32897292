// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_bounds.h
/// Pulling elements of a wire, found along the whole wire at once.
///
/// Newton's method for bounded rows (bounds.h) moves the end of the slack part of a wire by one
/// element per iteration. An element that becomes taut loads its node, which loads the next element
/// only in the following solution. But elements between nodes are a small problem of their own.
/// With λ = −z of the elements of a wire and the rest of the world fixed at the iterate,
/// ```
///   r = r₀ + M (z − z₀) ≥ 0   ⊥   z ≥ 0                r = c − G v − Σλ
///   M_ii = Σ_i + Σ_n G_in Â_n⁻¹ G_inᵀ     M_ij = G_in Â_n⁻¹ G_jnᵀ, n the node between i and j
///   Â_n = m_n E + Σ w² Eᵀ S E             its contacts with their laws S and weights w
/// ```
/// M is tridiagonal, symmetric and positive definite. Bodies other than nodes count as fixed. For a
/// sliding contact, the part of S from the disk's radius is left out, so that Â stays symmetric.
/// nonsmooth/tridiagonal.h solves it by some sweeps along the wire. The result only sets statuses
/// for the next iteration. The test for convergence is that of bounds.h.

#include "context/context.h"

namespace hawser::solve {

/// Find the chains of elements among the bounded rows.
/// @throws std::bad_alloc.
void reserve_wire_bounds(const context::Model& model, context::Newton& newton);

/// Determine which elements are taut in each chain with a row that has switched since the matrix
/// was factored. Call after switch_bounds().
void settle_wire_bounds(context::Model& model, context::Work& work) noexcept;

}  // namespace hawser::solve
