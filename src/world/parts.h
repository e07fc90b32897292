// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// Completion of interactions before they are added.

#include <hawser/interactions.h>

#include "context/context.h"

namespace hawser::world {

/// Fill in defaults, also those from the present poses, of a definition with checked bodies. Then
/// check its parameters.
/// @throws DefError.
void fill_in(InteractionDef& def, const context::StepContext& ctx);

}  // namespace hawser::world
