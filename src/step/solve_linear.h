// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solve_linear.h
/// The equations of a step as they were linearised about its start, by the method of the world.

#include "context/context.h"

namespace hawser::stepper {

/// solve_assembled() without rigid joints at the step's end: the equations linearised about its
/// start.
Status solve_linear(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
