// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file iterate.h
/// Functions shared by the methods that solve the step several times: write the laws into the
/// matrix, move from one iterate to the next.

#include "context/context.h"

namespace hawser::contact {

/// Copy the linear contact laws of this iteration (Newton::laws) to the contacts, and update the
/// matrix blocks that change.
/// @param first  True: all blocks.
void adopt_laws(context::Model& model, const context::Newton& newton, runtime::Pool& pool,
                bool first) noexcept;

/// Adopt the new laws of contacts if they differ by much from the laws in the matrix. Other
/// contacts keep the slope S of the law in the matrix; their offset p is changed so that the
/// impulse at the iterate is that of the new law.
void adopt_changed_laws(context::Model& model, const context::Newton& newton,
                        runtime::Pool& pool) noexcept;

/// Store v₊, λ, and u, λ of the contacts, for a later return to this iterate.
void save_iterate(context::Model& model, context::Newton& newton) noexcept;

/// Set u and λ of the contacts to the values that save_iterate() stored.
void recall_contacts(context::Model& model, const context::Newton& newton) noexcept;

/// Set the iterate to the fraction t of the way from the stored iterate to the present one. The
/// offsets p of the laws are updated, so that λ = p − S u.
void return_to_fraction(context::Model& model, const context::Newton& newton, double t) noexcept;

/// Return Σ (W + Σ) ‖λ − P‖² over contacts, at a fraction t of the way from the stored iterate. The
/// value is an energy [J].
[[nodiscard]] double contacts_merit(const context::Model& model, const context::Newton& newton,
                                    double t) noexcept;

/// Return the largest relative residual of Coulomb's law over contacts, see
/// nonsmooth::natural_map().
[[nodiscard]] double largest_residual(const context::Model& model, context::SolveWork& solve,
                                      runtime::Pool& pool) noexcept;

}  // namespace hawser::contact
