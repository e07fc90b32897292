// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stages.h
/// The stages that step() calls. `graph` (regroup.h) runs in the steps in which groups that follow
/// the state are looked at again; `analyse` in those in which the system changed, and in
/// prepare(); `collide` where there are shapes.

#include "stepper/context.h"

namespace hawser::stepper {

[[nodiscard]] assembly::View view(StepContext& ctx) noexcept;

/// Stage analyse: the system for the interactions and links there are.
/// @param state  Of the analysis of a saved world, to go on from. @throws std::bad_alloc.
void analyse(StepContext& ctx, const factor::AnalysisState* state = nullptr);
/// Stage analyse where only links of contacts changed. @throws std::bad_alloc; prepare() then.
void relink(StepContext& ctx);

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept;

/// Stage 1. Systems act: loads, inputs. Without systems it does nothing.
[[nodiscard]] Status prestep(StepContext& ctx) noexcept;
/// After a good step: what they did stays.
void accept_systems(StepContext& ctx) noexcept;
/// After a step that failed, wherever it did: what they did is taken back.
void take_back_systems(StepContext& ctx) noexcept;
/// ½ vᵀA v of the added mass that systems load bodies with in this step [J].
[[nodiscard]] double added_energy(StepContext& ctx, const double* v) noexcept;
/// Stage 5. Rows: violation, Jacobian; body terms; right-hand sides. Blocks of the matrix are
/// written in stage 6, each piece just before it is factored.
void assemble_rows(StepContext& ctx) noexcept;
/// Stage 6. Write the blocks of the matrix, factor, solve, refine: v₊ and λ.
[[nodiscard]] Status factor_and_solve(StepContext& ctx) noexcept;
/// Write the blocks, factor, and solve for the right-hand side in the solver's vector, in place.
/// `whole`: rows changed besides contacts, so that the matrix is factored whole.
[[nodiscard]] Status factor(StepContext& ctx, bool whole) noexcept;
/// Write the blocks, factor and solve once, without refinement: one iteration of a Newton method.
/// `first`: from v₊ = 0, else from v₊ and λ as they are.
[[nodiscard]] Status newton_solve(StepContext& ctx, bool first, bool whole) noexcept;
/// One more iteration from v₊ and λ as they are, with the factorisation at hand.
void continue_with_factor(StepContext& ctx) noexcept;
/// Refine what newton_solve() found, and measure it.
[[nodiscard]] Status refine(StepContext& ctx) noexcept;
/// refine() where the residual is above solution_tolerance. `measured`: the residual is in the
/// statistics, else it is measured first.
[[nodiscard]] Status settle_rounds(StepContext& ctx, bool measured) noexcept;
/// Measure v₊, λ and row residuals as they stand, found without the matrix.
[[nodiscard]] Status measure(StepContext& ctx) noexcept;
/// G v₊ of a one-row interaction.
[[nodiscard]] double row_speed(const assembly::View& v, std::int32_t id) noexcept;
/// Stage 8. Poses, velocities, forces, line breaks, energy bookkeeping, time.
void integrate(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
