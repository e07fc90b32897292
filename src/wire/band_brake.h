// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file band_brake.h
/// What a band brake holds, each way.
///
/// ```
///        ____            The band lies round the drum by the angle β. Along it the tension of the
///      /      \          band grows by e^(μ β) in the sense in which the drum drags it (Euler,
///     |   o    |         Eytelwein), so that the torque about the axis is
///      \ _____/              (T_tight − T_slack) R
///   fixed |   | actuator
/// ```
/// The actuator pulls with T. Where the drum drags the band away from the actuator that end is the
/// slack one, and the torque T R (e^(μβ) − 1); the other way it is the tight one, and the torque
/// T R (1 − e^(−μβ)). Their ratio is e^(μβ). A winch's band is set to hold more as wire runs out.

#include "wire/bounds.h"

#include <cmath>

namespace hawser::wire {

/// Torque against wire that runs in, over that against wire that runs out. @param friction  μ [1].
/// @param angle  β [rad].
[[nodiscard]] inline double band_ratio(double friction, double angle) noexcept {
    return std::exp(-friction * angle);
}

/// What is left of a tension behind wraps on a drum: T e^(−2π μ wraps).
[[nodiscard]] inline double behind_wraps(double tension, double friction, double wraps) noexcept {
    return tension * std::exp(-kTurn * friction * std::fmax(wraps, 0.0));
}

}  // namespace hawser::wire
