// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file asleep.h
/// State which bodies sleep and wake those that are disturbed. The rules of sleep are in sleep.h.

#include "context/context.h"

namespace hawser::context {

/// Upper limit of the number of steps for which a body counts as at rest.
inline constexpr std::int32_t kMaxQuiet = 1'000'000'000;

[[nodiscard]] inline bool moves(const model::Bodies& b, std::int32_t body) noexcept {
    return b.dof(body) > 0;
}

/// Allocate the arrays of sleep; part of prepare(). @throws std::bad_alloc.
void reserve_sleep(const Model& model, Sleep& sleep);

/// Wake all bodies, without a new analysis. Part of prepare().
void wake_all(Model& model, StepStats& stats) noexcept;

/// Validate flags after a restore; any values are accepted. A body that cannot move is awake. Sets
/// StepStats::asleep.
void check_asleep(Model& model, StepStats& stats) noexcept;

/// Wake the island of a moving body that is changed from outside the step.
void wake_island(Model& model, std::int32_t body) noexcept;

/// Wake all bodies. Call after a body was moved or removed, because the contacts then do not show
/// which bodies had rested on it.
void wake_islands_of(Model& model) noexcept;

}  // namespace hawser::context
