// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file assemble.h
/// Rows and body terms of the system that was analysed: violations and Jacobians, what completed
/// joints and refused wires ask for, and the right-hand side of the first solve. Blocks of the
/// matrix are written later, each piece just before it is factored (factor.h).

#include "context/context.h"

namespace hawser::stepper {

/// With images of bodies where they have been placed.
void assemble_system(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
