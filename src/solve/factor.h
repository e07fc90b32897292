// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factor.h
/// Stage factor: the matrix is written piece by piece, each just before it is factored, together
/// with the right-hand side. If contacts changed and bounded rows switched in a small part of the
/// matrix only, that part is factored again (factor/partial.h). Sliding contacts need L D U
/// (factor/unsymmetric.h).

#include "context/context.h"

#include <cstddef>

namespace hawser::solve {

/// Write the blocks, factor, and solve for the right-hand side in the solver's vector, in place.
/// @param whole  True: factor the whole matrix. Required if data other than contacts and active
///         rows have changed.
[[nodiscard]] Status factor(context::StepContext& ctx, bool whole) noexcept;

/// Return the capacity that SolveWork::columns needs.
[[nodiscard]] std::size_t max_columns(const context::Model& model) noexcept;

}  // namespace hawser::solve
