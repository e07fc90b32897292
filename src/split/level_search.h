// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file level_search.h
/// Compute the cost of each level of cuts (cut_levels.h). The system of a level is analysed next to
/// that of the world.

#include "budget/cut_levels.h"
#include "context/context.h"

namespace hawser::split {

/// Return the levels of the present state. Their matrices are analysed in a separate system, so
/// that the world does not change. Call within a step, which is undone if this throws. @throws
/// std::bad_alloc, LimitError.
[[nodiscard]] std::vector<budget::CutLevels::Level> find_cut_levels(context::StepContext& ctx);

}  // namespace hawser::split
