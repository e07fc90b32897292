// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file band_brake.h
/// Holding torque of a band brake in both senses.
///
/// ```
///        ____            The band lies round the drum by the angle β. Along it the tension of the
///      /      \          band grows by e^(μ β) in the sense in which the drum drags it (Euler,
///     |   o    |         Eytelwein), so that the torque about the axis is
///      \ _____/              (T_tight − T_slack) R
///   fixed |   | actuator
/// ```
/// The actuator pulls with T. If the drum drags the band away from the actuator, that end is slack
/// and the torque is T R (e^(μβ) − 1). In the other sense that end is tight and the torque is T R
/// (1 − e^(−μβ)). Their ratio is e^(μβ). The band of a winch is mounted so that it holds more
/// against wire that runs out.

#include "wire/bounds.h"

#include <cmath>

namespace hawser::wire {

/// Return the holding torque against wire that runs in, divided by that against wire that runs out.
/// @param friction  μ [1].
/// @param angle  β [rad].
[[nodiscard]] inline double band_ratio(double friction, double angle) noexcept {
    return std::exp(-friction * angle);
}

/// Return the tension behind a number of wraps on a drum: T e^(−2π μ wraps).
[[nodiscard]] inline double tension_behind_wraps(double tension, double friction,
                                                 double wraps) noexcept {
    return tension * std::exp(-kTurn * friction * std::fmax(wraps, 0.0));
}

}  // namespace hawser::wire
