// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_search.h
/// Step length of a Newton iteration towards the solution of its laws.

#include "context/context.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace hawser::contact {

/// Fraction of the way from an iterate, and the merit there.
struct LineStep {
    double fraction = 1.0, merit = 0.0;
};

/// Detects iterates that alternate between two sets of laws, between which the merit does not
/// decrease. The sign is a merit equal to that of two iterations ago. Another fraction of the way
/// leaves the cycle, a different one each time.
class Cycle {
  public:
    /// Return the fraction to move, 0: as found by the line search.
    /// @param merit  Merit of the last iterate.
    double next_fraction(double merit) noexcept {
        constexpr double kSame = 1e-3;
        constexpr double kShares[] = {0.125, 0.75, 0.3, 0.05};
        // Less than: if contacts are solved and only rows still switch, the line search decides.
        const bool round = std::abs(merit - before_last_) < kSame * merit;
        before_last_ = std::exchange(last_, merit);
        return round ? kShares[fractions_used_++ % std::size(kShares)] : 0.0;
    }

  private:
    double last_ = -1.0, before_last_ = -1.0;
    std::size_t fractions_used_ = 0;
};

/// Move a given fraction of the way from the stored iterate.
LineStep move_fraction(context::Model& model, const context::Newton& newton,
                       double fraction) noexcept;

/// Choose the fraction of the way from the stored iterate, whose merit was `before`.
/// @param given  The fraction, if positive.
LineStep search_line(context::Model& model, const context::Newton& newton, double before,
                     double given) noexcept;

}  // namespace hawser::contact
