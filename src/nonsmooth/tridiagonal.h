// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tridiagonal.h
/// Tridiagonal linear complementarity problems: elements of a wire that only pull.
///
/// Find z with
/// ```
///   z ≥ 0   ⊥   w = w₀ + M (z − z₀) ≥ 0       M tridiagonal, symmetric, positive definite
/// ```
/// *Method.* Use Newton's method on min(z, w) = 0. With a set A of active rows, solve w_A = 0 with
/// z = 0 in all other rows, by one Gaussian elimination along the chain. Then a row of A leaves if
/// z ≤ 0, and another row enters if w < 0. All rows switch at once. A sweep costs O(n). The matrix
/// of a straight wire has no positive entry next to its diagonal (an M-matrix). The sets then grow
/// or shrink monotonically, and the method ends after at most n sweeps. For other positive definite
/// M it may cycle: after 2n sweeps only the first inconsistent row switches (K. G. Murty's least
/// index rule, which ends for every P-matrix).

#include <cstddef>
#include <cstdint>

namespace hawser::nonsmooth {

/// A row of the problem. `active` is the first guess, and the result.
struct ChainRow {
    double diagonal;        ///< M_ii > 0.
    double next;            ///< M_i,i+1; of the last row unused.
    double residual;        ///< w₀.
    double start;           ///< z₀.
    bool active;            ///< w = 0 is solved for; else z = 0.
    bool fixed;             ///< z = 0 always.
    double z;               ///< Result.
    double pivot, reduced;  ///< Scratch of the elimination.
};

/// Solve a chain of n rows. @return false if it did not end within 4n + 8 sweeps.
[[nodiscard]] bool solve_chain(std::size_t n, ChainRow* rows) noexcept;

}  // namespace hawser::nonsmooth
