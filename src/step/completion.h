// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file completion.h
/// Rigid joints that hold at the end of a step, and spins that keep their angular momentum.
///
/// One linear solution leaves a rigid row behind by the turning of its direction, h² v⊥²/L, and by
/// different amounts on rows that say the same: over no compliance at all that is self-stress
/// without limit. So the step goes on, with the factorisation at hand, until
/// ```
///     g(x_k ⊕ h v₊) = 0                                     of completed rows
///     μ₊(ω₊) = μ₋(ω) + h t + (Gᵀλ)                          of turning bodies, body frame
///     μ±(ω) = Iω ± (h/2) ω×Iω
/// ```
/// G taken at x_k. This is SHAKE with the Cayley rotation (Ryckaert, Ciccotti, Berendsen 1977;
/// Bou-Rabee, Marsden 2009): variational, so that energy does not drift and momentum is exact.
/// Each round writes what the linear equations lack into their right-hand sides,
/// ```
///     c = G u − g(x_k ⊕ h u)/h,      a += μ₋(ω) − μ₊(ω_u) + I ω_u,       u = v₊ so far,
/// ```
/// and costs a substitution; the first one is about u = 2v − v₋, so that motion without jerk takes
/// none but the first. Rounds end at a change of 1e-7 m/s or rad/s, of bodies that turn by ω with
/// max(1, ω/5)³ of it as what the step itself leaves grows so, and later where solution_tolerance
/// is below its default, in proportion.
///
/// Springs with dampers that the step does not resolve are completed as well, about the same u:
/// with d₊ = (g(x_k ⊕ h u) − g)/h and d₋ = (g − g(x_k ⊖ h v))/h, Υ and R = 1 − 4τ(1 − θ)/h of
/// model/damping.h,
/// ```
///     c = G u − d₊ − (4Υ/h) g + ΥR d₋,      λ = −(h/ε)((g₋ + 2g + g₊)/4 + τ(θ d₊ + (1 − θ) d₋)).
/// ```
/// Linearised once, the damper would resist the speed h v⊥²/L with which its direction turns.
///
/// *What is completed.* Rigid joints and rods (model::may_complete()) whose swing under their force
/// f is resolved: s = h² f max(r/I) ≤ 1.5. Beyond that the rounds need not converge: such a joint,
/// and for 60 steps after, is linearised once a step with numerical damping (assembly/geo.h).
///
/// A force that comes within a step is seen once it is known: where a first solution has completed
/// joints swing far too fast, or others with one and a half times the force of their stiffness, the
/// step is solved again, with the former linearised once and the stiffness of the new forces. A
/// chain that comes taut would else make energy.
///
/// *Fallback.* Rounds that do not converge, or end with a gap of more than 0.1 mm, are given up:
/// the step is solved again with every joint linearised once.
///
/// *Filter.* Of joints in closed loops some impulses move nothing: Gᵀλ₀ = 0. What rounding and the
/// last round leave in them over Σ is taken out, λ ← (W + Σ)⁻¹ W λ with W = G M⁻¹ Gᵀ, by one
/// substitution: K [u; −λ] = [Gᵀλ; 0]. Only where that changes a joint's impulse by more than a
/// hundredth: elsewhere it would take a thousandth off long chains between heavy bodies.

#include <hawser/stats.h>

#include "assembly/view.h"
#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// Rounds until the equations hold at the step's end; then the filter. v₊ and λ solve the linear
/// ones. Changes nothing where nothing is to be completed.
[[nodiscard]] Status complete(StepContext& ctx) noexcept;

/// Stages factor and nonsmooth for rows already assembled, repeated while the set of
/// active rows changes; then rigid joints at the step's end (completion.h).
Status solve_assembled(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
