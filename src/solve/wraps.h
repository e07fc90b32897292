// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wraps.h
/// The angle by which a line turns at a place, and the friction that comes of it.
///
/// ```
///         u₁ ──►( )           δ = ∠(u₁, u₂), about the wheel's axis where there is one, in the
///                  \\          direction in which it is passed; with the whole turns that it was
///                   ▼ u₂       defined with.
/// ```
/// The exponents μδ − ln η of places that follow each other add up, so that the friction of a line
/// that leaves a post by another angle is that of this angle: the factor of its loads is
/// tanh((μδ − ln η)/2) (capstans.h). It is taken from the poses with which the step begins, so that
/// within a step the bound is linear in the tensions.
///
/// Whole turns are those that the parts have made on their wheel since (kinds/routes.h).
/// Limit: at an eye the angle is at most half a turn.

#include "context/context.h"

namespace hawser::stepper {

/// Angle at the place of friction that follows it (kFollowsAngle) [rad].
[[nodiscard]] double wrap_angle(const Model& model, std::int32_t friction) noexcept;

/// Remember how spans lie on their wheels, and count the whole turns that they have made when
/// bodies have moved.
void note_wheels(const Model& model, Work& work) noexcept;
void follow_wheels(Model& model, const Work& work) noexcept;

/// Factors of all such friction at the poses there are. Before bounds are asked for.
void follow_wraps(Model& model) noexcept;

}  // namespace hawser::stepper
