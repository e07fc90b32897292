// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Result of a removal: the ids of all removed objects.

#include <hawser/id.h>

#include <vector>

namespace hawser {

/// Objects that one call of World::remove_…() has removed, including the requested one, by
/// ascending index. Their ids are rejected from then on.
struct Removed {
    std::vector<BodyId> bodies;               ///< Removed bodies.
    std::vector<InteractionId> interactions;  ///< Removed interactions.
    std::vector<ShapeId> shapes;              ///< Removed shapes.
    std::vector<InputId> inputs;              ///< Removed inputs.
};

}  // namespace hawser
