// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_search.h
/// How far a Newton iteration goes towards the solution of its laws.

#include "context/context.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace hawser::stepper {

/// How far to go from an iterate, and what its merit is there.
struct Way {
    double share = 1.0, merit = 0.0;
};

/// Iterates may go round between two sets of laws, from neither of which the merit falls on the way
/// to the other. Told by a merit that is that of two iterations ago; left by going another share of
/// the way, a different one each time.
class Cycle {
  public:
    /// @param merit  Of the last iterate. @return the share to go, 0: as searched for.
    double leave(double merit) noexcept {
        constexpr double kSame = 1e-3;
        constexpr double kShares[] = {0.125, 0.75, 0.3, 0.05};
        // Less than: where contacts are solved and rows alone still switch, all is as searched for.
        const bool round = std::abs(merit - before_last_) < kSame * merit;
        before_last_ = std::exchange(last_, merit);
        return round ? kShares[left_++ % std::size(kShares)] : 0.0;
    }

  private:
    double last_ = -1.0, before_last_ = -1.0;
    std::size_t left_ = 0;
};

/// Go a given share of the way from the iterate kept.
Way go(Model& model, const Newton& newton, double share) noexcept;

/// Choose how far to go from the iterate kept, whose merit was `before`. @param given  If above 0.
Way search(Model& model, const Newton& newton, double before, double given) noexcept;

}  // namespace hawser::stepper
