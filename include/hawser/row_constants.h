// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file row_constants.h
/// Constants of a row that follow from its compliance, its damping time and the step.
///
/// The force of a row is f = λ/h with ε f = −(ḡ + τ r), where ḡ = ¼(g₊ + 2g + g₋) is the violation
/// averaged about the start of the step, g₊ = g + h G v₊, g₋ = g − h G v, and where
/// r = θ G v₊ + (1 − θ) G v is the speed that the damper sees. Multiplied by 4Υ/h that is
/// ```
///     G v₊ + Σ λ = −(4/h) Υ g + Υ (1 − 4τ(1 − θ)/h) G v,     Υ = 1/(1 + 4τθ/h),  Σ = 4εΥ/h²:
/// ```
/// SPOOK (Lacoursière, "Ghosts and machines", Umeå, 2007) where θ = 1; docs/methods.md, 2. A
/// velocity row, G v₊ + γ f = speed, has Σ = γ/h. These are the bare numbers: what keeps the Σ of
/// a rigid row above zero, and that of a cut row so large that the sides are stable, is added where
/// Σ is chosen (src/assembly/system.cpp). The verifier computes its own (src/verify).

namespace hawser {

/// Υ, from 0 to 1, without unit.
/// @param damping_time  τ [s]. @param step  h [s]. @param late  θ, from ½ to 1; the scheme's own
///                      damping has 1.
[[nodiscard]] constexpr double row_upsilon(double damping_time, double step,
                                           double late = 1.0) noexcept {
    return 1.0 / (1.0 + 4.0 * damping_time * late / step);
}

/// Σ [1/kg, or 1/(kg m²) of a row about an axis] of a row with a violation; of compliance 1 the
/// factor from ε to Σ.
/// @param compliance  ε [m/N or rad/(N m)]. @param upsilon  Υ; 1: not damped. @param step  h [s].
[[nodiscard]] constexpr double row_sigma(double compliance, double upsilon, double step) noexcept {
    return 4.0 * compliance * upsilon / (step * step);
}

/// Σ [1/kg, or 1/(kg m²)] of a velocity row.
/// @param compliance  γ [m/s/N or rad/s/(N m)]. @param step  h [s].
[[nodiscard]] constexpr double velocity_row_sigma(double compliance, double step) noexcept {
    return compliance / step;
}

}  // namespace hawser
