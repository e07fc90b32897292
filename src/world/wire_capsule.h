// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_capsule.h
/// Capsules along the elements of a wire.

#include <hawser/wire.h>
#include <hawser/world.h>

#include <array>
#include <optional>

namespace hawser::world {

/// The capsule of an element between two bodies, which hold it at these points of their frames [m]:
/// of one between two lumps, and where the wire has capsules to its ends of one between a lump and
/// a body. None otherwise, or where the wire touches nothing.
[[nodiscard]] std::optional<ShapeDef> capsule_of(const World& world, const WireTrim& trim,
                                                 const std::array<BodyId, 2>& body,
                                                 const std::array<Vec3, 2>& point);
/// Of an element as it is defined.
[[nodiscard]] inline std::optional<ShapeDef> capsule_of(const World& world, const WireTrim& trim,
                                                        const InteractionDef& element) {
    return capsule_of(world, trim, {element.body[0], element.body[1]},
                      {element.point[0], element.point[1]});
}

}  // namespace hawser::world
