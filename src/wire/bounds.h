// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Constants shared by drums, gypsies and their controls.

#include "base/number.h"

#include <numbers>

namespace hawser::wire {

inline constexpr double kTurn = 2.0 * std::numbers::pi;  ///< [rad]
inline constexpr double kUnbounded = 1e30;               ///< Torque of a clamped row [N m].
/// Relative distance below a bound at which a force counts as at it, for rounding.
inline constexpr double kAtBoundTolerance = 1e-9;
inline constexpr double kMaxStandingSpeed =
    1e-4;  ///< Wire speed below which a drum counts as at rest [m/s].

}  // namespace hawser::wire
