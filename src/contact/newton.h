// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton.h
/// The semismooth Newton method that finds which contacts are open, stick or slide.
///
/// Each iteration linearises every contact about the iterate (nonsmooth/cone.h) and solves all
/// joints, elements and contacts together. The step is solved if the impulses of the linear system
/// agree with the law λ = P(y). The first iterate is the velocity of the last step with its
/// impulses.
///
/// *Along a step.* Velocities and impulses change together, so that momentum balance and joints
/// hold at every point of it. The residual of the law there determines the length of the step, at
/// the cost of a sweep over contacts.
///
/// *Matrix.* The first two iterations factor with JᵀS J in the matrix. If contacts and switched
/// rows changed little of it, only a part is factored (factor/partial.h). Sliding contacts need L D
/// U (factor/unsymmetric.h). In the second iteration, contacts whose law hardly changed keep their
/// S. Later iterations change few contacts, or all by little. They use the current factorisation
/// and find by GMRES the impulses w that compensate the difference, with a few substitutions. If
/// these do not suffice, the matrix is factored again.
///
/// *Guesses.* Between iterations the elements of each wire that only pull are solved along the
/// wire (solve/wire_bounds.h). Then each unsettled line is solved with its contacts
/// (wire_newton.h). Both only choose the laws and statuses of the next iteration.
///
/// *Convex phase.* Ten iterations without a solution are followed by the convex phase
/// (convex_phase.h). It has fixed radii of the friction disks and an exact line search, until the
/// solution is near.
///
/// *Completion.* The equations of completed joints change with the velocity (step/completion.h).
/// If a step needs a second iteration, that iteration uses the equations about the first one, so
/// that no further constraint iteration is needed.
///
/// *Early end.* Iterations may end before the solution (WorldDef::budget, budget_work,
/// contact_iterations). The contacts are then linearised once more about the iterate of the least
/// merit with lagged coupling, which is symmetric and never singular. The impulses of that solve
/// are projected onto their cones. The refinement balances momentum with each contact's law through
/// the projected impulse. If even the best iterate is poor, the end of the last step replaces it.
/// Limits of cost are checked only if no tension-only line or range has just switched.
///
/// *First step.* Contacts have no impulses. If an iteration is shortened or does not descend, the
/// path depends on rounding. The step then starts again from soft tangents, see Safety.
///
/// *Repeated steps* (step/guard.h) start from the contacts of the rejected solution.
///
/// *Safety.* Iterations that do not end are repeated with tangents 1,024 and 32 times as soft
/// first. Each solution is the start of the next. The S of a sliding contact is unsymmetric. Its
/// matrix may be singular if strong friction jams (Painlevé). The last resort is lagged coupling of
/// all contacts, which is symmetric and positive. The certificate reports the remaining residual.

#include "context/context.h"

namespace hawser::contact {

/// Reserve scratch for the contacts of this step.
/// @throws std::bad_alloc.
void reserve_newton(const context::Model& model, context::Newton& newton);

/// Linearise about the last step's solution.
void begin_newton(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept;

/// Keep the contacts of a solved step that will be solved again (step/guard.h).
/// @return false if the step is not solved: restart_newton() must not be called.
[[nodiscard]] bool save_contact_solution(context::Model& model, context::Work& work) noexcept;
/// Linearise about the contacts kept instead of those of the last step. Call after
/// start_contacts().
void restart_newton(context::StepContext& ctx) noexcept;

/// Perform stages 6 and 7, with the right-hand side of assemble_rows().
/// @param settled_later  True if settle_newton() follows, after iterations of rigid joints. The
/// solution is then left as it is, neither refined nor measured.
[[nodiscard]] Status solve_newton(context::StepContext& ctx, bool settled_later = false) noexcept;
/// Measure v₊ and λ after end-of-step constraint iterations. Refine them if their residual is above
/// solution_tolerance or if no iteration has refined them. Iterate again if contacts no longer obey
/// their law.
[[nodiscard]] Status settle_newton(context::StepContext& ctx) noexcept;
/// Return true if rows at their bounds, or lines, request to switch in the current solution, for
/// example after end-of-step constraint iterations. False in a step that is not solved or was cut.
[[nodiscard]] bool rows_request_switch(context::StepContext& ctx) noexcept;
/// Switch the rows that request it and iterate again, with contacts, until no row does. After eight
/// repetitions StepStats::flips_left counts the rows that still request it.
[[nodiscard]] Status settle_rows(context::StepContext& ctx) noexcept;

}  // namespace hawser::contact
