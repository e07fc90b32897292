// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impact.h
/// Impacts with restitution: a stage of velocities before the regular one.
///
/// Where a contact with restitution e > 0 would close within the step, faster than gravity accounts
/// for, velocities jump first: the same matrix, no forces, no time (C. Lacoursière, thesis, 2007)
/// ```
///   M̃ (v⁺ − v) = Gᵀλ + Jᵀλ_c,   G v⁺ + Σλ = G v,   0 ≤ λ_n ⊥ u_n⁺ + e u_n⁻ + Σλ_n ≥ 0
/// ```
/// with friction as ever, resting contacts at e = 0, and rows of lines and motors as they move.
/// The regular stage then starts from v⁺. Newton's law with friction can create energy
/// (T. R. Kane, 1984): should ½ vᵀM v grow, or the stage end uncertified, it is done again with e =
/// 0, then left out.
///
/// Limits: a body bounces where it is at the start of the step in which it would touch, up to
/// h |u_n| above the surface; contacts that meet within one step meet at once.

#include "context/context.h"

namespace hawser::stepper {

/// Find impacts among the contacts of the step and change v by them. Contacts must be started
/// again where any were. @param found  Whether there were any.
[[nodiscard]] Status impact(StepContext& ctx, bool& found) noexcept;

}  // namespace hawser::stepper
