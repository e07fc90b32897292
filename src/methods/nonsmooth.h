// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nonsmooth.h
/// The methods for contacts with friction, see WorldDef::nonsmooth: one file each.
///
/// All share the rows: contacts as cones (nonsmooth/cone.h) whose linear laws λ = p − S u go into
/// the matrix, and the stages newton_solve(), continue_with_factor(), refine(). StepStats::
/// natural_map is the residual of the exact law whatever the method, so that they can be compared.

#include "context/context.h"

namespace hawser::stepper {

/// Linear laws about the last step's solution, by the method of the world.
void begin_contacts(Model& model, Work& work, runtime::Pool& pool) noexcept;

/// Stages 6 and 7 of a world in which something touches; the right-hand side is that of
/// assemble_rows(). Where joints are completed, completion settles what this leaves (newton.h).
[[nodiscard]] Status solve_contacts(StepContext& ctx) noexcept;

/// Stages 6 and 7 by sweeps over all rows, whether or not something touches.
[[nodiscard]] Status solve_pgs(StepContext& ctx) noexcept;

void begin_pivoting(Model& model, Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_pivoting(StepContext& ctx) noexcept;
void begin_split(Model& model, Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_split(StepContext& ctx) noexcept;
void begin_convex(Model& model, Newton& newton, runtime::Pool& pool) noexcept;
[[nodiscard]] Status solve_convex(StepContext& ctx) noexcept;
void begin_pgs(Model& model) noexcept;

}  // namespace hawser::stepper
