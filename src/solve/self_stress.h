// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file self_stress.h
/// The filter of completion.h: what joints in closed loops push against each other without moving
/// anything is taken out of their impulses.

#include "context/context.h"

namespace hawser::stepper {

/// Filter the impulses of joints. To be called when the rounds of completion have ended.
void take_self_stress(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
