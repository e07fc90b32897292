// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factor.h
/// Stage factor: the matrix is written piece by piece, each just before it is factored, and the
/// right-hand side goes along. If only contacts changed, and bounded rows switched, and little of
/// the matrix with them, the part that they reach is factored again (factor/partial.h), with L D U
/// where contacts slide (factor/unsymmetric.h).

#include "context/context.h"

#include <cstddef>

namespace hawser::stepper {

/// Write the blocks, factor, and solve for the right-hand side in the solver's vector, in place.
/// `whole`: more changed than contacts and the rows that are active, so that the matrix is factored
/// whole.
[[nodiscard]] Status factor(StepContext& ctx, bool whole) noexcept;

/// Capacity that SolveWork::columns needs.
[[nodiscard]] std::size_t most_columns(const Model& model) noexcept;

}  // namespace hawser::stepper
