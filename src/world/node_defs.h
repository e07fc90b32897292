// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_defs.h
/// Definitions of the objects added with a node on an element of a wire.

#include <hawser/def.h>
#include <hawser/interactions.h>

#include "edit/nodes.h"
#include "model/interactions.h"

#include <cstdint>

namespace hawser {
class World;
}

namespace hawser::world {

/// Return a node with the properties of the nodes at the ends of its element.
[[nodiscard]] BodyDef node_body(const World& w, const InteractionDef& element,
                                const edit::NodeDef& node);

/// Return the definition of the new element on the other side of an inserted node.
/// @param element  The existing element. It begins at the node if `first` is true and ends there
/// otherwise.
/// @param share  Fraction of it before the node.
/// @param mass  Mass of the new element [kg] if a drum pays out the old one.
/// @param beside  Next element of the wire, −1: none.
[[nodiscard]] InteractionDef other_element(const model::Interactions& in, std::int32_t element,
                                           BodyId node, double share, bool first, double mass,
                                           std::int32_t beside);

/// Return a bend interaction of stiffness EI [N m²] for a node that is inserted in an element, with
/// the attachment points of its outer bodies. The caller sets its middle body.
[[nodiscard]] InteractionDef node_bend(const model::Interactions& in, std::int32_t element,
                                       double EI);

}  // namespace hawser::world
