// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pivot.h
/// Choice of the rows of a problem with box friction (box.h) that change their bounds between two
/// solutions.
///
/// All infeasible rows change at once by block principal pivoting. Source: J. Júdice, F. Pires, "A
/// block principal pivoting algorithm for large-scale strictly monotone linear complementarity
/// problems", 1994. If their number has not decreased in kPivotTrials iterations, only the last one
/// changes until it decreases. Source: K. Murty, "Note on a Bard-type scheme for solving the
/// complementarity problem", 1974. For P-matrices this terminates.

#include "nonsmooth/box.h"

#include <limits>
#include <span>

namespace hawser::nonsmooth {

inline constexpr int kPivotTrials = 10;  ///< Iterations without progress before rows change singly.

/// State of the choice between iterations. A best of 0 with no trials: always one row only.
struct PivotProgress {
    int best = std::numeric_limits<int>::max();  ///< Smallest number of infeasible rows up to now.
    int trials = kPivotTrials;                   ///< Number of trials left.
};

/// Change bounds after an iteration. @param cones  Contacts with u, λ of the solution at the
/// present bounds. @param rows    Three bounds per contact. @param limit  One limit per contact [N
/// s]. @param floor   See box_pivots(). @return number of infeasible rows; 0: solved, nothing
/// changed.
[[nodiscard]] int pivot(std::span<const Cone> cones, std::span<Bound> rows,
                        std::span<const double> limit, double floor,
                        PivotProgress& progress) noexcept;

}  // namespace hawser::nonsmooth
