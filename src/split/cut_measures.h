// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cut_measures.h
/// What cuts left open in a step, and the one multiplier that readers see: the mean of the sides.

#include "context/context.h"

namespace hawser::stepper {

/// After the solve, before bodies move: multipliers for readers, and what the cuts left open.
void finish_cuts(StepContext& ctx) noexcept;

/// Multipliers of copies become those of what they stand for.
void follow_cuts(StepContext& ctx) noexcept;

/// A line parted; if it is cut, with all copies.
void part_all(StepContext& ctx, std::int32_t id) noexcept;

}  // namespace hawser::stepper
