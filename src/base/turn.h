// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file turn.h
/// Rotation of a body over a time t at the constant angular velocity ω.
///
/// With a = t ω/2 and y = |a|² the rotation has the quaternion (s, a)/|·|, where
/// ```
///   s(y) = |a| cot |a| = 1 − y b(y),     b(y) = 1/3 + y/45 + 2y²/945 + …
/// ```
/// The angle is then t|ω|, exact for any steady rotation. The Cayley map has s = 1 and turns by
/// 2 atan(t|ω|/2), too slow by (t|ω|)²/12.
///
/// From t|ω| = 2 rad on, s = s₁ + s₁'(1 − 1/y), with the value s₁ and the slope s₁' at y = 1. Value
/// and slope are continuous and s > 0, so the angle stays below π. Without this bound, s would be
/// negative beyond half a turn, and infinite at a whole turn.
///
/// Angular momentum is exact for any s(y). The rotation turns μ₋ into μ₊ (body frame, m = Iω):
/// ```
///   μ±(ω) = m ± (t/2) ω×m + (t²/4) b ω×(ω×m)
/// ```
/// With s = |a| cot |a| these are the momenta of the discrete Lagrangian ½ ω·Iω with the
/// exponential map (Bou-Rabee, Marsden, "Hamilton-Pontryagin integrators on Lie groups", 2009).

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// Return the function b(y) of the formula at the top of this file, for y = a² ≥ 0. T is double, or
/// a vector with one lane per body.
template <class T>
inline T turn_bend(const T& y) {
    constexpr double kValue = 0.642092615934330703, kSlope = -0.385095155751530605;  // s₁, s₁'
    const T unit = one(y);
    const T inside = select_greater(y, unit, unit, y);
    // Continued fraction of |a| cot |a| of depth 8: error below 2e-16.
    const T over = ((-44.0 * inside + 12870.0) * inside + -810810.0) * inside + 11486475.0;
    const T under =
        (((inside + -990.0) * inside + 135135.0) * inside + -4729725.0) * inside + 34459425.0;
    const T inverse = 1.0 / select_greater(y, unit, y, unit);
    const T beyond = (kSlope * inverse + (1.0 - kValue - kSlope)) * inverse;
    return select_greater(y, unit, beyond, T(over * (1.0 / under)));
}

/// Return μ₊(ω) − Iω for half = t/2, or μ₋(ω) − Iω for half = −t/2; body frame [N m s].
template <class T, class Inertia>
inline V3T<T> turn_momentum(const Inertia& inertia, const V3T<T>& w, const T& half) {
    const V3T<T> across = cross(w, inertia * w);
    const T square = half * half;
    return half * across + (square * turn_bend(T(square * dot(w, w)))) * cross(w, across);
}

}  // namespace hawser::HAWSER_ISA
