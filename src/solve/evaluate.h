// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file evaluate.h
/// Violations and Jacobians of rows at the poses at hand.

#include "context/context.h"

namespace hawser::stepper {

/// Evaluate the interactions of one strip of memory: violations and Jacobian.
void evaluate_strip(const Model& model, const assembly::View& v, int strip) noexcept;

/// Evaluate every interaction at the current poses (g, Jacobian), as stage 5 does.
void evaluate_rows(Model& model, runtime::Pool& pool) noexcept;

/// evaluate_rows(), which decides afresh which ranges are active, with those kept that were.
void evaluate_keeping_ranges(Model& model, Before& before, runtime::Pool& pool) noexcept;

}  // namespace hawser::stepper
