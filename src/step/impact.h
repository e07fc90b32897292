// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impact.h
/// Impacts with restitution: a stage of velocities before the regular one.
///
/// The stage applies if a contact with restitution e > 0 closes within the step, faster than by
/// gravity alone. A trial of the step without these contacts gives the time t of the impact
/// (impact_times.h) and the velocities at this time. They change with the same matrix but without
/// forces and at constant time (C. Lacoursière, thesis, 2007).
/// ```
///   M̃ (v⁺ − v) = Gᵀλ + Jᵀλ_c,   G v⁺ + Σλ = G v,   0 ≤ λ_n ⊥ u_n⁺ + e u_n⁻ + Σλ_n ≥ 0
/// ```
/// Friction acts as usual, resting contacts have e = 0, and the velocities of rows of lines and
/// motors do not change. With the change Δv, the regular stage starts from v + Δv and from the
/// poses x − t Δv, which are those of the motion after the impact, extended back. Newton's law with
/// friction can create energy (T. R. Kane, 1984). If ½ vᵀM v grows, or the stage is not certified,
/// it is repeated with e = 0, and then skipped.
///
/// Limits: contacts that close within one step, of bodies that joints or contacts connect, act
/// simultaneously. A second impact in the step has e = 0.

#include "context/context.h"

namespace hawser::step {

/// Find impacts among the contacts of the step and change v by their impulses. If impacts were
/// found, the caller must start the contacts again. @param found  Output: true if there were
/// impacts.
[[nodiscard]] Status impact(context::StepContext& ctx, bool& found) noexcept;

}  // namespace hawser::step
