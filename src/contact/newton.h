// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton.h
/// The semismooth Newton method that finds which contacts are open, stick or slide.
///
/// Each iteration linearises every contact about the iterate (nonsmooth/cone.h) and solves all
/// joints, elements and contacts at once. Where the impulses of the linear system and the law
/// λ = P(y) agree, the step is solved. The first iterate is the velocity of the last step with
/// its impulses.
///
/// **Along a step** velocities and impulses move together, so that the momentum balance and the
/// joints hold at every point of it; how far to go is decided by the law's residual there, at the
/// cost of a sweep over contacts.
///
/// **Matrix.** The first two iterations factor with JᵀS J in the matrix, in part where little of it
/// changed by contacts and by rows that switched (factor/partial.h), with L D U where contacts
/// slide (factor/unsymmetric.h). In the second one, contacts whose law hardly changed keep it
/// (adopt_far_laws() in iterate.h). Later ones change few contacts, or all by little: they use the
/// factorisation at hand and find by GMRES the impulses w that make up for the difference, a
/// handful of substitutions. When those do not suffice, the matrix is factored again.
///
/// **Guesses.** Between iterations the elements of each wire that only pull are settled along it
/// (solve/wire_bounds.h), then each line that is unsettled with its contacts (wire_newton.h). Both
/// only choose the laws and statuses of the next iteration.
///
/// **Ten iterations** that did not end are followed by the convex phase (convex_phase.h): fixed
/// radii of the friction disks and an exact line search, until the solution is near.
///
/// **Completion.** What completed joints ask for changes with the velocity (step/completion.h).
/// Where a step takes a second iteration, that one is asked for what holds about the first, so that
/// rounds need not follow.
///
/// **When iterations end** before that (WorldDef::budget, budget_work, contact_iterations), the
/// contacts are linearised once more about the iterate of the least merit with lagged coupling,
/// which is symmetric and never singular; the impulses of that solve are projected onto their
/// cones, and the refinement balances momentum with each contact's law through the projected
/// impulse. Where even the best iterate is poor, the end of the last step takes its place. Limits
/// of cost are looked at where no tension-only line or range has just switched.
///
/// **First step.** Contacts have no impulses. A path of iterations that are shortened or do not
/// descend depends on rounding: it is replaced by a start from soft tangents, as below.
///
/// **Repeated steps** (step/guard.h) start from the contacts of the rejected solution.
///
/// **Safety.** When the iterations do not end, the step is done again with tangents 1024 and 32
/// times as soft first, roughly; each solution is the start of the next. A sliding contact's S is
/// unsymmetric and its matrix may be singular where friction is so strong that it jams (Painlevé):
/// what then still does not end is done again with lagged coupling, symmetric and positive, for all
/// contacts. The certificate says what is left.

#include "context/context.h"

namespace hawser::stepper {

/// Scratch for the contacts of this step. @throws std::bad_alloc.
void reserve_newton(const Model& model, Newton& newton);

/// Linearise about the last step's solution.
void begin_newton(Model& model, Work& work, runtime::Pool& pool) noexcept;

/// Keep the contacts of a solved step that will be solved again (step/guard.h).
/// @return false if the step is not solved: begin_newton_again() must not be called.
[[nodiscard]] bool keep_solution(Model& model, Work& work) noexcept;
/// Linearise about the contacts kept instead of those of the last step. Call after
/// start_contacts().
void begin_newton_again(StepContext& ctx) noexcept;

/// Stages 6 and 7; the right-hand side is that of assemble_rows().
/// @param settled_later  settle_newton() is to come, and rounds of completion before it: a solution
///     that iterations have found is left to them as it is, neither refined nor measured.
[[nodiscard]] Status solve_newton(StepContext& ctx, bool settled_later = false) noexcept;
/// Measure v₊ and λ after rounds of completion, refine them where their residual is above
/// solution_tolerance, or where no round has refined them; and iterate again where contacts no
/// longer obey their law.
[[nodiscard]] Status settle_newton(StepContext& ctx) noexcept;
/// Whether rows at their bounds, or lines, ask to switch in the solution at hand, as after rounds
/// of completion that moved them across. Not in a step that is not solved, or was cut.
[[nodiscard]] bool rows_ask(StepContext& ctx) noexcept;
/// Switch the rows that ask for it and iterate again, with contacts, until no row asks. After eight
/// repetitions count the rows that still ask in StepStats::flips_left.
[[nodiscard]] Status settle_rows(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
