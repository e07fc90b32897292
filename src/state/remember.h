// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file remember.h
/// Save the part of the state that a solve overwrites, for a repeated solve or a failed step.

#include "context/context.h"

namespace hawser::state {

/// Save or restore the part of the state that a solve overwrites: λ and the active flags of rows.
/// The multipliers λ are saved bit by bit, because h times the stored force would differ in its
/// last bit.
void save_solved_state(context::StepContext& ctx) noexcept;

void restore_solved_state(context::StepContext& ctx) noexcept;

}  // namespace hawser::state
