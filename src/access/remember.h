// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file remember.h
/// What a solve overwrites of the state, kept for a solve that is done again and a step that fails.

#include "context/context.h"

namespace hawser::stepper {

/// Keep, and put back, what a solve overwrites of the state: λ and which rows are active. λ is
/// kept bit by bit: h × the stored force would differ in its last place.
void remember(StepContext& ctx) noexcept;

void recall(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
