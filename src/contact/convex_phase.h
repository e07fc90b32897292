// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file convex_phase.h
/// Newton iterations on a convex function, for steps in which a whole line begins to slide.
///
/// If many contacts and elements switch at once, the exact iteration need not converge, because it
/// does not descend on its merit. Fix the radius R of each friction disk at that of the iterate.
/// Then compliant contacts and rows are the minimum over v:
/// ```
///   E(v) = ½ (v − v₀)ᵀ M̃ (v − v₀) + Σ φ*(u),        convex, once differentiable,  −∂φ*/∂u = P(u)
///   contacts:  P_n = max(0, (b_n − u_n)/Σ_n),   P_t = (b_t − u_t)/Σ_t, shortened to R
///   rows:      P = clamp((c − G v)/Σ, low, high)
/// ```
/// Its Newton iterations have the laws of cone.h with lagged coupling and ρ = 1/(Σ + θW), θ = 0.
/// This gives a symmetric matrix without wrong pivots. A small θ (kShare) leaves a part of the last
/// impulse in y, as all laws of cone.h do. The direction is then not exactly Newton's. It is damped
/// at contacts that switch and needs fewer iterations: 25 factorisations instead of 53 in the worst
/// step of anchor_contact in a seaway with the phase 1.9.
///
/// *Line search.* Momentum and joints hold with the linear laws' impulses λ(t) along a whole step
/// δ. So the slope of E needs a sweep over contacts and rows and no matrix:
/// ```
///   ψ(t) = dE/dt = Σ (λ(t) − P(u(t)))·δu + Σ_rows (λ(t) − P(t)) δ(G v)
/// ```
/// ψ does not decrease for θ = 0. Its zero in (0, 1] is found by regula falsi (Illinois) to 5 % of
/// |ψ(0)|.
///
/// The radius is a fixed point of a few iterations, since the normal load of sliding contacts
/// hardly depends on their friction. If it does (jamming), this phase may not terminate. The phase
/// ends when the natural map is small and no row requests to switch. The exact iteration follows.

#include "context/context.h"

#include <cmath>

namespace hawser::contact {

/// Return a contact with the linear law of the convex phase.
[[nodiscard]] nonsmooth::Cone convex_cone(const nonsmooth::Cone& cone) noexcept;

/// Return the part of a contact in ψ, at a fraction t of the way from u and λ in `from` to those of
/// the cone [J].
[[nodiscard]] double contact_slope(const nonsmooth::Cone& cone, const double from[6],
                                   double t) noexcept;

/// Return ψ at a fraction t of the way from the stored iterate [J].
[[nodiscard]] double convex_slope(const context::Model& model, const context::Newton& newton,
                                  double t) noexcept;

/// Return the fraction of the way in (0, 1] at which a non-decreasing slope ψ(t) vanishes.
template <class Slope>
[[nodiscard]] double zero_slope_fraction(Slope&& slope) noexcept {
    constexpr int kMaxSweeps = 30;
    constexpr double kSmall = 0.05;
    double low = 0.0, high = 1.0, at_low = slope(low), at_high = slope(high);
    if (!(at_high > 0.0 && at_low < 0.0)) return 1.0;
    const double small = kSmall * std::fabs(at_low);
    double t = 1.0;
    int side = 0;  // end that was moved last: −1 low, 1 high
    for (int k = 0; k < kMaxSweeps; ++k) {
        t = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(t > low && t < high)) t = 0.5 * (low + high);
        const double now = slope(t);
        if (std::fabs(now) <= small) break;
        if (now > 0.0) {
            high = t;
            at_high = now;
            if (side == 1) at_low *= 0.5;
            side = 1;
        } else {
            low = t;
            at_low = now;
            if (side == -1) at_high *= 0.5;
            side = -1;
        }
    }
    return t;
}

}  // namespace hawser::contact
