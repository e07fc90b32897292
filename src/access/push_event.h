// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file push_event.h
/// Events of a step: for those who read them, and counted.

#include "context/context.h"

namespace hawser::stepper {

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept;

}  // namespace hawser::stepper
