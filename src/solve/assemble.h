// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file assemble.h
/// Rows and body terms of the analysed system: violations and Jacobians, terms of completed joints
/// and rejected wires, and the right-hand side of the first solve. Blocks of the matrix are written
/// later, each piece just before it is factored (factor.h).

#include "context/context.h"

namespace hawser::solve {

/// Assemble the system, including ghost bodies, whose poses must have been set.
void assemble_system(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
