// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file slack.h
/// Correction of c of a tension-only row that was slack.

namespace hawser::HAWSER_ISA {

/// Return the term to add to c of a tension-only row. The force of a step belongs to the mean of
/// the half-step positions x̄₋ = g − (h/2) ġ and x̄₊. If a line was slack, x̄₋ < 0, the mean would
/// absorb x̄₋²/2ε less energy than is then stored. Each tightening would thus create energy.
/// Therefore a slack x̄₋ is replaced by 0, which absorbs slightly too much energy: ġ is then 2g/h,
/// also for a damper. @param recalled  Υ × recall of the row.
inline double when_slack(double g, double speed, double recalled, double h) noexcept {
    const double before = g - 0.5 * h * speed;
    return before < 0.0 ? 2.0 * recalled / h * before : 0.0;
}

}  // namespace hawser::HAWSER_ISA
