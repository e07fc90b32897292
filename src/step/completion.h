// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file completion.h
/// End-of-step constraint iteration of joints, and of spins, which preserve their angular momentum.
///
/// One linear solution leaves a rigid row open by the turning of its direction, h² v⊥²/L. Redundant
/// rows have different gaps; without compliance this is unbounded self-stress. Therefore the step
/// iterates with the present factorisation until
/// ```
///     g(x_k ⊕ h v₊) = 0                                     of completed rows
///     μ₊(ω₊) = μ₋(ω) + h t + (Gᵀλ)                          of turning bodies, body frame
///     μ±(ω) = Iω ± (h/2) ω×Iω + (h²/4) b ω×(ω×Iω)
/// ```
/// with G at x_k and b of base/turn.h. This is SHAKE with the exponential map of rotations
/// (Ryckaert, Ciccotti, Berendsen 1977; Bou-Rabee, Marsden 2009). It is variational, so that energy
/// does not drift and momentum is exact. Each iteration adds the error of the linear equations to
/// their right-hand sides, with u the present v₊,
/// ```
///     c = G u − g(x_k ⊕ h u)/h,      a += μ₋(ω) − μ₊(ω_u) + I ω_u,
/// ```
/// and costs a substitution. The first one uses u = 2v − v₋, so that motion without jerk needs no
/// other. Iterations end at a change of 1e-7 m/s or rad/s. If bodies turn by ω, the limit is max(1,
/// ω/5)³ of it, because the error of the step grows in the same way. If solution_tolerance is below
/// its default, the limit is reduced in proportion.
///
/// Compliant joints, with a row of ε > 0, obey the law of their rows with the violations at both
/// ends of the step. The values 1/Υ = 1 + 4(τθ + κ)/h and R = 1 − 4(τ(1 − θ) − κ)/h are those of
/// model/share_damping.cpp. Let d₊ = (g(x_k ⊕ h u) − g)/h, d₋ = (g − g(x_k ⊖ h v))/h. Then
/// ```
///     c = G u − d₊ − (4Υ/h) g + ΥR d₋
///     λ = −(h/ε)(g + (h/4 + κ)(d₊ − d₋) + τ(θ d₊ + (1 − θ) d₋)).
/// ```
/// Linearised once, such a row would resist the rotation of its direction: by h²v⊥²/8L over ε, and
/// its damper by the speed h v⊥²/L. The elastic energy of these rows is counted with the mean (g +
/// g₋)/2 (docs/theory/compliance.md).
///
/// Selection. Joints and rods (model::may_complete()) whose oscillation under their force f is
/// resolved: s = h² f max(r/I) ≤ 1.5. Beyond that the iterations may diverge. Such a joint is
/// linearised once a step with numerical damping (assembly/geo.h), also for 60 steps after.
///
/// A force that arises within a step is known after a first solution. The step is then solved again
/// in two cases:
/// - Completed joints oscillate far too fast. They are then linearised once.
/// - The force of other joints exceeds that of their stiffness by a factor of 1.5.
/// The force of a compliant joint is checked after the iterations, when it is known.
/// The stiffness is computed from the new forces. Otherwise a chain that tightens would create
/// energy.
///
/// Fallback. If the iterations diverge, or end with a gap of more than 0.1 mm, the step is solved
/// again with every joint linearised once.
///
/// Filter. Some impulses of joints in closed loops have no effect on bodies: Gᵀλ₀ = 0. Rounding and
/// the error of the last iteration, divided by Σ, accumulate in them. They are removed by λ ← (W +
/// Σ)⁻¹ W λ with W = G M⁻¹ Gᵀ, in one substitution: K [u; −λ] = [Gᵀλ; 0]. The filter applies only
/// if it changes the impulse of a joint by more than 1 %. In long chains between heavy bodies it
/// would otherwise remove 0.1 %.

#include <hawser/stats.h>

#include "assembly/view.h"
#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::step {

/// Iterate until the equations of rigid joints are satisfied at the end of the step; then filter
/// the impulses of redundant joints. v₊ and λ must solve the linear equations. No effect if no
/// joint is to be completed.
[[nodiscard]] Status complete(context::StepContext& ctx) noexcept;

/// Run stages factor and nonsmooth for assembled rows, repeated while the set of active rows
/// changes. Then complete the rigid joints at the end of the step (completion.h).
Status solve_assembled(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
