// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file self_stress.h
/// The filter of completion.h: removes impulses of joints in closed loops that act against each
/// other without moving any body.

#include "context/context.h"

namespace hawser::solve {

/// Remove impulses of redundant joints that act against each other and move no body. Call after the
/// end-of-step constraint iteration.
void take_self_stress(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
