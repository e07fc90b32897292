// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Numbers that drums, gypsies and what orders them have in common.

#include "base/number.h"

#include <numbers>

namespace hawser::wire {

inline constexpr double kTurn = 2.0 * std::numbers::pi;  ///< [rad]
inline constexpr double kUnbounded = 1e30;               ///< A torque that nothing overcomes [N m].
inline constexpr double kNear = 1e-9;    ///< Of a force at its bound, which rounding has moved.
inline constexpr double kStands = 1e-4;  ///< A drum whose wire is slower than this stands [m/s].

}  // namespace hawser::wire
