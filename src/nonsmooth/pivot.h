// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pivot.h
/// Which rows of a problem with box friction (box.h) change their bounds between two solutions.
///
/// All infeasible rows change at once (block principal pivoting; J. Júdice, F. Pires, "A block
/// principal pivoting algorithm for large-scale strictly monotone linear complementarity problems",
/// 1994); when their number has not fallen in kPivotTrials rounds only the last of them does (K.
/// Murty, "Note on a Bard-type scheme for solving the complementarity problem", 1974), which ends
/// with certainty where the matrix is a P-matrix, until it has.

#include "nonsmooth/box.h"

#include <limits>
#include <span>

namespace hawser::nonsmooth {

inline constexpr int kPivotTrials = 10;  ///< Rounds without progress before rows change singly.

/// What the choice remembers between rounds. A best of 0 with no trials: always one row only.
struct PivotProgress {
    int best = std::numeric_limits<int>::max();  ///< Fewest infeasible rows so far.
    int trials = kPivotTrials;                   ///< Left.
};

/// Change bounds after a round. @param cones  With u, λ of the solution at the bounds as they are.
/// @param rows    Three bounds a contact. @param limit  One a contact [N s].
/// @param floor   See box_pivots(). @return infeasible rows; 0: solved, nothing changed.
[[nodiscard]] int pivot(std::span<const Cone> cones, std::span<Bound> rows,
                        std::span<const double> limit, double floor,
                        PivotProgress& progress) noexcept;

}  // namespace hawser::nonsmooth
