// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file design_draught.h
/// Draughts at which drag and wind areas of hulls hold.

#include <hawser/sea.h>
#include <hawser/world.h>

namespace hawser::marine {

/// Set the design draughts that a definition does not specify.
/// @param level  Height of still water [m].
void set_design_draughts(const World& world, SeaDef& def, double level);

}  // namespace hawser::marine
