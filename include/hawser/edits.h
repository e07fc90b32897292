// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Result of a removal.

#include <hawser/id.h>

#include <vector>

namespace hawser {

/// Ids that one call of World::remove_…() removed, the requested one included, by ascending index.
/// They are rejected from then on.
struct Removed {
    std::vector<BodyId> bodies;
    std::vector<InteractionId> interactions;
    std::vector<ShapeId> shapes;
    std::vector<InputId> inputs;
};

}  // namespace hawser
