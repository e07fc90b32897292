// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file asleep.h
/// Which bodies sleep and which are disturbed; what is made of it is told in sleep.h.

#include "context/context.h"

namespace hawser::stepper {

/// Most that bodies are counted to have been at rest for [steps].
inline constexpr std::int32_t kMostQuiet = 1'000'000'000;

[[nodiscard]] inline bool moves(const model::Bodies& b, std::int32_t body) noexcept {
    return b.dof(body) > 0;
}

/// Part of prepare(). @throws std::bad_alloc.
void reserve_sleep(const Model& model, Sleep& sleep);

/// Without analysing: part of prepare().
void wake_all(Model& model, StepStats& stats) noexcept;

/// Of flags that were restored, whatever they were: what cannot move is awake; StepStats::asleep.
void check_asleep(Model& model, StepStats& stats) noexcept;

/// A body that moves is changed from outside the step: its island wakes.
void disturb(Model& model, std::int32_t body) noexcept;

/// Something is no longer where it was, so that contacts do not tell what leant on it: all wake.
void disturb_all(Model& model) noexcept;

}  // namespace hawser::stepper
