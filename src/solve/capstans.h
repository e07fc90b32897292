// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file capstans.h
/// Friction of lines over bollards, pins and sheaves, with its bound in the matrix.
///
/// At a turning point a line turns by an angle δ. T₁ and T₂ are its tensions before and behind the
/// point. The multipliers of its spans are λ₁, λ₂ = −h T₁, −h T₂ (model/kinds/routes.h). q̇ is the
/// speed of the line through the point, and F the friction on it:
/// ```
///     m q̇₊ − m q̇ = h (T₂ − T₁) + h F,   |F| ≤ F₀ + k (T₁ + T₂),   k = tanh(μδ/2)
/// ```
/// While it slides in one direction, with σ the sign of F and negligible m, T₁ (1 − σk) = T₂ (1 +
/// σk), or T₁/T₂ = e^{σμδ}. This is Euler's and Eytelwein's ratio, for any division of a circle
/// into points.
///
/// *In the matrix.* If the bound follows its loads one iteration late (bounds.h), the iteration
/// reduces the error by the factor k only, which is almost 1 for many points in a row. Here F is
/// therefore a function of λ₁, λ₂. The slide's equation gets an additional −σ k of each, without a
/// counterpart in the equations of the spans,
/// ```
///            q̇      −λ₁      −λ₂
///     q̇  [   m     1 − σk  −1 − σk ]
///     λ₁ [   1      −Σ₁            ]       k < 1: the signs do not change.
///     λ₂ [  −1               −Σ₂   ]
/// ```
/// so that fronts above it are factored as L D U (factor/unsymmetric.h). Slides have few
/// neighbours, so the order eliminates them before the multipliers. The Schur complement of a run
/// of points is then tridiagonal in the tensions. It has a positive diagonal, negative entries next
/// to it, and columns that sum to W + Σ. It is therefore an M-matrix, and sliding changes the sign
/// of no pivot. If a run pulls two bodies together over each other, a pivot may change sign. The
/// pivot is used unchanged, and the residual shows the lost accuracy.
///
/// *Status.* The active set of bounds.h decides which points slide. A point begins to slide if it
/// would need a friction above its bound. It sticks again if it slides in the wrong direction. In a
/// run, a point that begins to slide loads the next one; runs.h finds the statuses of all points.

#include "context/context.h"

namespace hawser::solve {

/// Fraction of the bound below which impulses on a slide are rounding. With slides of a millionth
/// of the pulled mass, these are speeds of 1e-11 m/s.
inline constexpr double kCapstanNoise = 1e-14;
/// Fraction of the largest impulse of a run. Speeds of its slides are differences of its impulses
/// over almost no mass, and their rounding passes from point to point. Below this fraction a slide
/// in the wrong direction is rounding, even if its own tensions are small.
inline constexpr double kCapstanRounding = 1e-15;
/// Relative excess over the bound before a sticking point begins to slide. Points behind those
/// that have slid are all at their bounds.
inline constexpr double kCapstanAtBound = 1e-10;

/// Set the sliding direction of each turning point at the start of a step, from the impulses that
/// hold_bounds() has set.
void begin_capstans(context::Model& model) noexcept;

/// Set the friction impulses of sliding turning points for a solution that starts from λ = 0, that
/// is, without the tensions on which they depend.
void release_capstans(context::Model& model, const context::Newton& newton) noexcept;

/// Set the friction impulses of sliding turning points from the current tensions. Call after each
/// change of λ, before momentum is balanced.
void follow_capstans(context::Model& model, const context::Newton& newton,
                     const assembly::View& v) noexcept;

/// Write the terms that couple sliding friction to its tensions into the matrix, for the current
/// statuses.
/// @return true if there are any.
[[nodiscard]] bool couple_capstans(context::Model& model) noexcept;

/// Return true if the bound of this friction is in the matrix.
[[nodiscard]] bool is_capstan(const context::Model& model, std::int32_t friction) noexcept;

}  // namespace hawser::solve
