// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file step.h
/// One step of the world: eight stages, in order.
///
/// The scheme is SPOOK (Lacoursière, "Ghosts and machines: regularized variational methods for
/// interactive simulations of multibodies with dry frictional contacts", 2007): positions live
/// at t, velocities at t − h/2; the matrix and right-hand side are in assembly/view.h.

#include "stepper/context.h"

namespace hawser::stepper {

/// Analyse when the topology changed and reserve all memory. @throws std::bad_alloc.
void prepare(StepContext& ctx);

/// Take v₀ from time 0 to −h/2, which makes the scheme second order: v₋ = v₀ − (h/2) a, with
/// the acceleration a at time 0 from a trial step (stagger.cpp). Also gives the first λ for
/// geometric stiffness.
Status stagger(StepContext& ctx) noexcept;

/// Stages factor and nonsmooth for rows already assembled, repeated while the set of
/// active rows changes; then rigid joints at the step's end (completion.h).
Status solve_assembled(StepContext& ctx) noexcept;
/// solve_assembled() without rigid joints at the step's end: the equations linearised about its
/// start.
Status solve_linear(StepContext& ctx) noexcept;

/// Keep, and put back, what a solve overwrites of the state: λ and which rows are active. λ is
/// kept bit by bit: h × the stored force would differ in its last place.
void remember(StepContext& ctx) noexcept;
void recall(StepContext& ctx) noexcept;

/// Advance by h. The state changes only when the result is ok.
Status step(StepContext& ctx) noexcept;

/// Evaluate every interaction at the current poses (g, Jacobian), as stage 5 does.
void evaluate_rows(StepContext& ctx) noexcept;
/// evaluate_rows(), which decides afresh which ranges are active, with those kept that were.
void evaluate_keeping_ranges(StepContext& ctx) noexcept;

/// ½ vᵀ M v [J], M without damping and geometric stiffness. @param velocity  Packed.
[[nodiscard]] double kinetic_energy(const model::Bodies& bodies, const double* velocity) noexcept;
/// Kinetic energy of one body that moves [J].
[[nodiscard]] double kinetic_energy_of(const model::Bodies& bodies, std::int32_t body,
                                       const double* velocity) noexcept;

/// Energy at the half-step position, see hawser::Energy.
[[nodiscard]] Energy energy(StepContext& ctx) noexcept;

/// Hash of the state: see World::state_hash.
[[nodiscard]] std::uint64_t state_hash(const StepContext& ctx) noexcept;

}  // namespace hawser::stepper
