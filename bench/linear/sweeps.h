// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sweeps.h
/// Products with the blocks that every solver needs around its own solve: the residual of the
/// saddle system, the condensed right-hand side, the multipliers. Vectors have 8 more numbers at
/// the end than the system has scalars.

#include "linear/form.h"

#include <vector>

namespace hawser::bench {

/// r = b − K x.
void residual(const BlockSystem& system, const std::vector<double>& b, const std::vector<double>& x,
              std::vector<double>& r, base::Executor& executor);

/// Right-hand side of a form: that of the kept nodes plus Gᵀ Σ⁻¹ r of the eliminated.
/// @param scratch  As long as r; overwritten.
void fold(const BlockSystem& system, const BlockForm& form, const std::vector<double>& inverse,
          const std::vector<double>& r, std::vector<double>& scratch, std::vector<double>& folded,
          base::Executor& executor);

/// Solution of the system from that of a form: λ = Σ⁻¹ (G v − r).
void unfold(const BlockSystem& system, const BlockForm& form, const std::vector<double>& inverse,
            const std::vector<double>& r, const std::vector<double>& solved, std::vector<double>& x,
            base::Executor& executor);

}  // namespace hawser::bench
