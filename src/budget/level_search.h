// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file level_search.h
/// What each level of cuts would cost: its system is analysed beside that of the world
/// (cut_levels.h).

#include "context/context.h"
#include "context/cut_levels.h"

namespace hawser::stepper {

/// Levels of the present state, with their matrices analysed beside the world, which stays as it
/// is. Within a step, which goes back where this throws. @throws std::bad_alloc, LimitError.
[[nodiscard]] std::vector<CutLevels::Level> find_cut_levels(StepContext& ctx);

}  // namespace hawser::stepper
