// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file damping.h
/// Divide damping between velocities after the step (θ) and before the step (1 − θ).
///
/// For a damper alone, ẇ = −c W w with mobility W, the step with
/// ```
///     θ(z) = 1/(1 − e⁻ᶻ) − 1/z,   z = h c W + h² k W/4
/// ```
/// and k = 0 is exact: w₊ = e⁻ᶻ w. If the step resolves the damper, θ = ½ + O(h) and the order is
/// two. If not, θ → 1 and (1 − θ) z → 1, so no oscillation remains: the step is L-stable.
///
/// The spring parallel to a damper counts in z, because the trapezoidal rule would not bring a fast
/// spring to rest. Source of exponential fitting: Liniger, Willoughby, "Efficient integration
/// methods for stiff systems of ordinary differential equations", 1970. θ ≥ ½ keeps any number of
/// such dampers on one body stable; docs/theory/step.md.

#include <cmath>

namespace hawser::model {

/// Return θ, the weight of the velocity after the step in the force of a damper. It increases from
/// ½ to 1 with z ≥ 0, the damping per step (see the head of this file).
[[nodiscard]] inline double late_fraction(double z) noexcept {
    if (!(z > 0.0)) return 0.5;
    if (z < 1e-2) return 0.5 + z / 12.0 - z * z * z / 720.0;  // the next term is below 1e-14
    return -1.0 / std::expm1(-z) - 1.0 / z;
}

}  // namespace hawser::model
