// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file push_event.h
/// Store an event of a step for readers and count it.

#include "context/context.h"

namespace hawser::context {

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept;

}  // namespace hawser::context
