// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// Interactions on their way into a world.

#include <hawser/interactions.h>

#include "context/context.h"

namespace hawser::world {

/// Defaults filled in, those from the present poses as well, of a definition whose bodies have been
/// checked; then its parameters are checked. @throws DefError.
void fill_in(InteractionDef& def, const stepper::StepContext& ctx);

}  // namespace hawser::world
