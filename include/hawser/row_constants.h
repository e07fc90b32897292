// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file row_constants.h
/// Constants of a row from its compliance, its damping time and the step.
///
/// The force of a row is f = λ/h with ε f = −(ḡ + τ r). The violation ḡ = ¼(g₊ + 2g + g₋) is
/// averaged about the start of the step, with g₊ = g + h G v₊ and g₋ = g − h G v. The speed at the
/// damper is r = θ G v₊ + (1 − θ) G v. Multiplication by 4Υ/h results in
/// ```
///     G v₊ + Σ λ = −(4/h) Υ g + Υ (1 − 4τ(1 − θ)/h) G v,     Υ = 1/(1 + 4τθ/h),  Σ = 4εΥ/h²
/// ```
/// With θ = 1 this is SPOOK (Lacoursière, "Ghosts and machines", Umeå, 2007); docs/theory/step.md.
/// A velocity row, G v₊ + γ f = speed, has Σ = γ/h. The minimum of Σ of a rigid row, and the
/// stability term of a cut row, are added in src/assembly/system.cpp. The verifier computes its own
/// values (src/verify).

namespace hawser {

/// Return Υ, from 0 to 1, dimensionless.
/// @param damping_time  τ [s].
/// @param step  h [s].
/// @param late  θ, from ½ to 1; the scheme's own damping uses 1.
[[nodiscard]] constexpr double row_upsilon(double damping_time, double step,
                                           double late = 1.0) noexcept {
    return 1.0 / (1.0 + 4.0 * damping_time * late / step);
}

/// Return Σ of a row with a violation [1/kg; about an axis 1/(kg m²)]. With compliance 1 it is the
/// factor from ε to Σ.
/// @param compliance  ε [m/N or rad/(N m)].
/// @param upsilon  Υ; 1: undamped.
/// @param step  h [s].
[[nodiscard]] constexpr double row_sigma(double compliance, double upsilon, double step) noexcept {
    return 4.0 * compliance * upsilon / (step * step);
}

/// Return Σ of a velocity row [1/kg; about an axis 1/(kg m²)].
/// @param compliance  γ [m/s/N or rad/s/(N m)].
/// @param step  h [s].
[[nodiscard]] constexpr double velocity_row_sigma(double compliance, double step) noexcept {
    return compliance / step;
}

}  // namespace hawser
