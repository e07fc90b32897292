// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wraps.h
/// Wrap angle of a line at a turning point, and the resulting friction.
///
/// ```
///         u₁ ──►( )           δ = ∠(u₁, u₂), about the axis of the wheel if there is one, in the
///                  \\          direction in which the line passes; the whole turns of the
///                   ▼ u₂       definition are added.
/// ```
/// The exponents μδ − ln η of consecutive points add up. If a line leaves a bollard at another
/// angle, its friction therefore follows this angle: the factor of its loads is tanh((μδ − ln η)/2)
/// (capstans.h). It is computed from the poses at the start of the step. Within a step the bound is
/// therefore linear in the tensions.
///
/// Whole turns that the parts make on their wheel during the run are counted (kinds/routes.h).
/// Limit: at an eye the angle is at most half a turn.

#include "context/context.h"

namespace hawser::solve {

/// Return the angle of the line at the turning point of a friction with kFollowsAngle [rad].
[[nodiscard]] double wrap_angle(const context::Model& model, std::int32_t friction) noexcept;

/// Store the angles at which spans touch their wheels, and count whole turns after bodies have
/// moved.
void note_wheels(const context::Model& model, context::Work& work) noexcept;
void follow_wheels(context::Model& model, const context::Work& work) noexcept;

/// Update the factors of all friction with kFollowsAngle at the current poses. Call before bounds
/// are evaluated.
void follow_wraps(context::Model& model) noexcept;

}  // namespace hawser::solve
