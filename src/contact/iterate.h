// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file iterate.h
/// What methods that solve the step several times share: laws into the matrix, and the way from
/// one iterate to the next.

#include "context/context.h"

namespace hawser::stepper {

/// Newton::laws go into the contacts and into the matrix: blocks that change.
/// @param first  All of them.
void adopt_laws(StepContext& ctx, bool first) noexcept;

/// Keep v₊, λ, and u, λ of the contacts, to come back to.
void keep_iterate(StepContext& ctx) noexcept;

/// Go back to a share t of the way from the iterate kept. The laws' p follow, so that λ = p − S u.
void shorten(StepContext& ctx, double t) noexcept;

/// Σ (W + Σ) ‖λ − P‖² over contacts, a share t of the way: an energy [J].
[[nodiscard]] double contacts_merit(const StepContext& ctx, double t) noexcept;

/// Largest relative residual of Coulomb's law over contacts, see nonsmooth::natural_map().
[[nodiscard]] double worst(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
