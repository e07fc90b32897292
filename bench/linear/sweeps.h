// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sweeps.h
/// Products with the blocks that every solver needs around its own solution. Vectors of the system
/// have 8 more numbers at the end than it has scalars.
///
/// In condensed form each eliminated row e has λ = Σ⁻¹ (G v − b) and residual r = b − G v + Σ λ,
/// from one product G v. The right-hand side of the next solution for a body is
/// b − A v − Gᵀ λ + Gᵀ Σ⁻¹ r = b − A v + Gᵀ s with s = Σ⁻¹ r − λ.
/// Thus one sweep over the rows and one over the bodies are sufficient.

#include "linear/form.h"

#include <vector>

namespace hawser::bench {

struct SweepVectors {
    std::vector<double> x;       ///< Solution.
    std::vector<double> r;       ///< b − K x at eliminated rows; in saddle form everywhere.
    std::vector<double> s;       ///< Scratch memory of eliminated rows.
    std::vector<double> folded;  ///< Right-hand side and solution of the form.
    void resize(const BlockSystem& system);
};

/// Set folded to the right-hand side of the form: b of the kept nodes plus Gᵀ Σ⁻¹ b of the
/// eliminated.
void fold_right_side(const BlockSystem& system, const BlockForm& form,
                     const std::vector<double>& inverse, SweepVectors& vectors,
                     base::Executor& executor);

/// Compute x from the form's solution in folded, and then its folded saddle residual.
void unfold_solution(const BlockSystem& system, const BlockForm& form,
                     const std::vector<double>& inverse, SweepVectors& vectors,
                     base::Executor& executor);
void fold_residual(const BlockSystem& system, const BlockForm& form, SweepVectors& vectors,
                   base::Executor& executor);

/// Add to x the correction whose kept part is in folded.
void add_correction(const BlockSystem& system, const BlockForm& form,
                    const std::vector<double>& inverse, SweepVectors& vectors,
                    base::Executor& executor);

}  // namespace hawser::bench
