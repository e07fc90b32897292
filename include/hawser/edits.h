// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// What a removal takes away.

#include <hawser/id.h>

#include <vector>

namespace hawser {

/// Everything that went in one call of World::remove_…, what was asked for included; ascending by
/// places. All of these ids are refused from then on.
struct Removed {
    std::vector<BodyId> bodies;
    std::vector<InteractionId> interactions;
    std::vector<ShapeId> shapes;
    std::vector<InputId> inputs;
};

}  // namespace hawser
