// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nonsmooth.h
/// Declare the methods for contacts with friction, see WorldDef::nonsmooth. Each method has one
/// file.
///
/// All methods use the same rows: contacts are cones (nonsmooth/cone.h) whose linear laws λ = p − S
/// u enter the matrix. They also use the same stages newton_solve(), continue_with_factor() and
/// refine(). StepStats::natural_map is the residual of the exact law for every method, so that
/// methods can be compared.

#include "context/context.h"

namespace hawser::methods {

/// Set linear laws about the solution of the last step, by the method of the world.
void begin_contacts(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept;

/// Run stages 6 and 7 of a world with contacts, with the right-hand side of assemble_rows(). If an
/// end-of-step constraint iteration of joints follows, the solution is measured and refined after
/// it (newton.h).
[[nodiscard]] Status solve_contacts(context::StepContext& ctx) noexcept;

/// Run stages 6 and 7 by sweeps over all rows, with or without contacts.
[[nodiscard]] Status solve_pgs(context::StepContext& ctx) noexcept;

void begin_pivoting(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_pivoting(context::StepContext& ctx) noexcept;
void begin_split(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_split(context::StepContext& ctx) noexcept;
void begin_convex(context::Model& model, context::Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_convex(context::StepContext& ctx) noexcept;
void begin_pgs(context::Model& model) noexcept;

}  // namespace hawser::methods
