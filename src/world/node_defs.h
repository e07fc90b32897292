// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_defs.h
/// Definitions of what comes with a node on an element of a wire.

#include <hawser/def.h>
#include <hawser/interactions.h>

#include "edit/nodes.h"
#include "model/interactions.h"

#include <cstdint>

namespace hawser {
class World;
}

namespace hawser::world {

/// A lump as those at the ends of its element are.
[[nodiscard]] BodyDef node_body(const World& w, const InteractionDef& element,
                                const stepper::NodeDef& node);

/// The element on the other side of the node.
/// @param element  The one that is there, which goes on from the node where `first` is true and
/// ends at it otherwise. @param share  Of it, before the node. @param mass  Of the new element
/// [kg], where a drum pays out the old one. @param beside  Element of the wire beyond, −1: none.
[[nodiscard]] InteractionDef other_element(const model::Interactions& in, std::int32_t element,
                                           BodyId node, double share, bool first, double mass,
                                           std::int32_t beside);

/// The bend of bending stiffness EI [N m²] at a node on an element, which the caller puts into its
/// middle, with the points where the ends are held.
[[nodiscard]] InteractionDef node_bend(const model::Interactions& in, std::int32_t element,
                                       double EI);

}  // namespace hawser::world
