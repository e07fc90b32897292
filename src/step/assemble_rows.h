// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file assemble_rows.h
/// Stage assemble: a system with its splits.

#include "context/context.h"

namespace hawser::step {

/// Run stage 5: violation and Jacobian of rows, body terms, right-hand sides. Blocks of the matrix
/// are written in stage 6, each piece just before it is factorised.
void assemble_rows(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
