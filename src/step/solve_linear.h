// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solve_linear.h
/// Solution of the equations of a step linearised about its start, by the method of the world.

#include "context/context.h"

namespace hawser::step {

/// Run solve_assembled() without completion: the equations are linearised about the start of the
/// step.
Status solve_linear(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
