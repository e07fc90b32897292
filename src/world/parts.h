// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// Completion of interactions before they are added.

#include <hawser/interactions.h>

#include "context/context.h"

namespace hawser::world {

/// Set the defaults of a definition, including those that depend on the present poses, and check
/// its parameters. Its bodies must have been checked.
/// @throws DefError.
void fill_in(InteractionDef& def, const context::StepContext& ctx);

}  // namespace hawser::world
