// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analyse.h
/// Stage analyse: the system for what there is, with splits. Where bodies touch that did not
/// before, only links of contacts change, unless other cuts come into force by that.

#include "context/context.h"

namespace hawser::stepper {

/// Stage analyse: the system for the interactions and links there are.
/// @param state  Of the analysis of a saved world, to go on from. @throws std::bad_alloc.
void analyse(StepContext& ctx, const factor::AnalysisState* state = nullptr);
/// Stage analyse where only links of contacts changed. @throws std::bad_alloc; prepare() then.
void relink(StepContext& ctx);

/// Have these interfaces in force, see Degradation::cuts, and analyse if that changes a cut.
[[nodiscard]] Status ask_for_cuts(StepContext& ctx, std::uint64_t interfaces) noexcept;

}  // namespace hawser::stepper
