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
    std::vector<BodyId> bodies;               ///< Removed bodies.
    std::vector<InteractionId> interactions;  ///< Removed interactions.
    std::vector<ShapeId> shapes;              ///< Removed shapes.
    std::vector<InputId> inputs;              ///< Removed inputs.
};

}  // namespace hawser
