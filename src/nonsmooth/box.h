// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file box.h
/// Box friction: a contact whose three rows have separate bounds.
/// ```
///   0 ≤ λ_n ⊥ r_n ≥ 0        |λ_ti| ≤ limit:   r_ti = 0 inside, r_ti ≤ 0 at +limit, ≥ 0 at −limit
/// ```
/// with r = u + Σλ − b as in cone.h. The limit is constant while rows are pivoted: μ times the
/// normal impulse of an earlier pass ("scaled box"). The linear complementarity problem then has a
/// positive definite symmetric matrix, hence one solution. Limit of the model: friction along a
/// diagonal of the axes may be √2 times too strong, which later passes do not correct.

#include "nonsmooth/cone.h"

namespace hawser::nonsmooth {

enum class Bound : std::uint8_t { free, low, high };

/// Return the law λ = p − S u with every row free (r = 0) or at its bound; S is diagonal.
[[nodiscard]] Law box_law(const Cone& cone, const Bound rows[3], double limit) noexcept;

/// Find the rows that violate their state, and the bound that each should be at instead. A free row
/// is tested by the sign of λ, a row at a bound by the sign of r. @param floor  Impulses below 1e-9
/// of it count as rounding [N s]. @return number of rows to change.
[[nodiscard]] int box_pivots(const Cone& cone, const Bound rows[3], double limit, double floor,
                             Bound wanted[3]) noexcept;

/// Return the state of the contact for the rest of the step: open, sliding or sticking.
[[nodiscard]] Touch contact_state(const Bound rows[3], double limit) noexcept;

}  // namespace hawser::nonsmooth
