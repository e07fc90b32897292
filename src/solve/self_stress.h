// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file self_stress.h
/// The filter of completion.h: what joints in closed loops push against each other without moving
/// anything is taken out of their impulses.

#include "context/context.h"

namespace hawser::stepper {

/// After rounds have ended.
void take_self_stress(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
