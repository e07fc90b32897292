// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file slack.h
/// What a row that only pulls asks for when it was slack.

namespace hawser::HAWSER_ISA {

/// What to add to c of a row that only pulls. The force of a step is that of the mean of the
/// half-step positions x̄₋ = g − (h/2) ġ and x̄₊. Of a line that was slack, x̄₋ < 0, the mean would
/// ask the motion for less than what is stored then, by x̄₋²/2ε: each time that it comes taut,
/// energy out of nothing. So slack counts as x̄₋ = 0, which takes a little too much instead: ġ is
/// then 2g/h, to a damper too. @param recalled  Υ × recall of the row.
inline double when_slack(double g, double speed, double recalled, double h) noexcept {
    const double before = g - 0.5 * h * speed;
    return before < 0.0 ? 2.0 * recalled / h * before : 0.0;
}

}  // namespace hawser::HAWSER_ISA
