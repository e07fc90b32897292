// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_newton.h
/// Newton's method on one wire: contacts and elements of a line solved together.
///
/// When a line begins to slide on a deck, its contacts and its pulling elements determine each
/// other in sequence along the line. In the global iteration each node responds one factorisation
/// after its neighbour. A line by itself, however, is a small problem: a block tridiagonal matrix
/// of 3×3 blocks. It is solved about the current iterate, at which momentum balances. Hulls and all
/// bodies other than nodes of the line are fixed:
/// ```
///   K δv = Σ Gᵀ(λ' − λ) + Σ Jᵀ(λ' − λ)     elements:  g' = g − G δv, g = c − G v
///                                                     pulling: λ' = g'/Σ,  slack: λ' = 0
///   K: masses, drag, geometric stiffness   contacts:  u' = u + J δv,  λ' = p − S u'
/// ```
/// The relative error of fixing them is of the order of the mass of a node over that of a hull. The
/// iteration is that of newton.h: exact laws first, the convex phase (convex_phase.h) if they do
/// not converge, and then exact laws again. An iteration costs about 300 multiplications per node,
/// which is some hundredths of a factorisation of the whole matrix.
///
/// Its result is a guess: the laws of the line's contacts and the statuses of its elements are used
/// in the next global iteration, whose own tests decide. A line that does not converge here is left
/// unchanged.
///
/// *Limits.* Nodes with interactions other than elements of the line (bending, a winch, a shackle)
/// count as fixed. A line with bending stiffness is therefore solved by the global iteration only.

#include "context/context.h"

namespace hawser::contact {

/// Reserve arrays for the contacts of this step.
/// @throws std::bad_alloc.
void reserve_wire_newton(const context::Model& model, context::Newton& newton);

/// Solve each line by itself in two cases: an element has switched since the matrix was factored,
/// or the residual of a contact law exceeds that of converged lines. Call after linearise(); the
/// laws are replaced.
void settle_wire_contacts(context::Model& model, context::Work& work) noexcept;

}  // namespace hawser::contact
