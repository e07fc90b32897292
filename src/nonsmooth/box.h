// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file box.h
/// Box friction: a contact whose three rows have bounds of their own.
/// ```
///   0 ≤ λ_n ⊥ r_n ≥ 0        |λ_ti| ≤ limit:   r_ti = 0 inside, r_ti ≤ 0 at +limit, ≥ 0 at −limit
/// ```
/// with r = u + Σλ − b as in cone.h. The limit is a number while rows are pivoted: μ times the
/// normal impulse of an earlier pass ("scaled box"). The linear complementarity problem then has a
/// positive definite symmetric matrix, hence one solution. Limit of the model: friction along a
/// diagonal of the axes may be √2 times too strong, which no later pass mends.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

enum class Bound : std::uint8_t { free, low, high };

/// λ = p − S u with every row free (r = 0) or at its bound; S is diagonal.
[[nodiscard]] Law box_law(const Cone& cone, const Bound rows[3], double limit) noexcept;

/// Which bound each row should be at instead, by the sign of λ where it is free and of r where it
/// is at a bound. @param floor  Impulses below a billionth of it are rounding [N s].
/// @return rows that are to change.
[[nodiscard]] int box_pivots(const Cone& cone, const Bound rows[3], double limit, double floor,
                             Bound wanted[3]) noexcept;

/// Open, sliding or sticking, as the rest of the step wants to know it.
[[nodiscard]] Touch touch_of(const Bound rows[3], double limit) noexcept;

}  // namespace hawser::nonsmooth
