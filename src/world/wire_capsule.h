// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_capsule.h
/// Capsules along the elements of a wire.

#include <hawser/wire.h>
#include <hawser/world.h>

#include <array>
#include <optional>

namespace hawser::world {

/// Return the capsule of an element between two bodies, attached at these points of their frames
/// [m]. An element between two nodes has one. An element between a node and a body has one if the
/// wire has capsules to its ends. No capsule if the wire touches nothing.
[[nodiscard]] std::optional<ShapeDef> element_capsule(const World& world, const WireTrim& trim,
                                                      const std::array<BodyId, 2>& body,
                                                      const std::array<Vec3, 2>& point);
/// Return the capsule of a defined element.
[[nodiscard]] inline std::optional<ShapeDef> element_capsule(const World& world,
                                                             const WireTrim& trim,
                                                             const InteractionDef& element) {
    return element_capsule(world, trim, {element.body[0], element.body[1]},
                           {element.point[0], element.point[1]});
}

}  // namespace hawser::world
