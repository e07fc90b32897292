// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impact.h
/// Impacts with restitution: a stage of velocities before the regular one.
///
/// The stage applies if a contact with restitution e > 0 would close within the step, faster than
/// by gravity alone. Velocities then change first, with the same matrix but without forces and
/// at constant time (C. Lacoursière, thesis, 2007).
/// ```
///   M̃ (v⁺ − v) = Gᵀλ + Jᵀλ_c,   G v⁺ + Σλ = G v,   0 ≤ λ_n ⊥ u_n⁺ + e u_n⁻ + Σλ_n ≥ 0
/// ```
/// Friction acts as usual, resting contacts have e = 0, and the velocities of rows of lines and
/// motors do not change. The regular stage then starts from v⁺. Newton's law with friction can
/// create energy (T. R. Kane, 1984). If ½ vᵀM v grows, or the stage is not certified, it is
/// repeated with e = 0, and then skipped.
///
/// Limits: a body bounces up to h |u_n| above the surface, at the start of the step in which it
/// would touch. Contacts that close within one step act simultaneously.

#include "context/context.h"

namespace hawser::step {

/// Find impacts among the contacts of the step and change v by their impulses. If impacts were
/// found, the caller must start the contacts again. @param found  Output: true if there were
/// impacts.
[[nodiscard]] Status impact(context::StepContext& ctx, bool& found) noexcept;

}  // namespace hawser::step
