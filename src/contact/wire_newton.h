// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_newton.h
/// Newton's method on one wire: contacts and elements of a line settled together.
///
/// Where a line begins to slide on a deck, its contacts and its elements that only pull decide each
/// other, one after the other along the line. The global iteration sees a lump's answer a
/// factorisation later. But a line by itself is a small problem: a block tridiagonal matrix of 3×3
/// blocks. About the iterate at hand, at which momentum balances, with hulls and all that is no
/// lump of the line held,
/// ```
///   K δv = Σ Gᵀ(λ' − λ) + Σ Jᵀ(λ' − λ)     elements:  g' = g − G δv, g = c − G v
///                                                     pulling: λ' = g'/Σ,  slack: λ' = 0
///   K: masses, drag, geometric stiffness   contacts:  u' = u + J δv,  λ' = p − S u'
/// ```
/// The error of what is held is the ratio of the masses of lump and hull. The iteration is that of
/// newton.h: exact laws first, the convex phase (convex_phase.h) if they do not end, and the exact
/// laws again. Per iteration and lump it costs about 300 multiplications: some hundredths of a
/// factorisation of the whole.
///
/// Its result is a guess: the laws of the line's contacts and the statuses of its elements go into
/// the next global iteration, whose own tests decide. A line that does not end here is left alone.
///
/// **Limits.** Lumps that anything but elements of the line holds (bending, a winch, a shackle)
/// count as held; a line with bending stiffness is therefore left to the global iteration.

#include "context/context.h"

namespace hawser::stepper {

/// Arrays for the contacts of this step. @throws std::bad_alloc.
void reserve_wire_newton(const Model& model, Newton& newton);

/// Settle each line of which an element has switched since the matrix was factored, or a contact is
/// farther from its law than settled lines are. Call after linearise(), whose laws it replaces.
void settle_wire_contacts(Model& model, Work& work) noexcept;

}  // namespace hawser::stepper
