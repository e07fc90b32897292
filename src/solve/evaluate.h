// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file evaluate.h
/// Violations and Jacobians of rows at the current poses.

#include "context/context.h"

namespace hawser::solve {

/// Evaluate the interactions of one row block: violations and Jacobian.
void evaluate_block(const context::Model& model, const assembly::View& v, int strip) noexcept;

/// Evaluate every interaction at the current poses (g, Jacobian), as stage 5 does.
void evaluate_rows(context::Model& model, runtime::Pool& pool) noexcept;

/// Call evaluate_rows(), and then restore the active flags of ranges, which it overwrites.
void evaluate_keeping_ranges(context::Model& model, context::Before& before,
                             runtime::Pool& pool) noexcept;

}  // namespace hawser::solve
