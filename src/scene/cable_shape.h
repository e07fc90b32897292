// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_shape.h
/// Where the nodes of a cable start: its key "shape".

#include "scene/cable_parts.h"

#include <optional>

namespace hawser::scene {

/// The interior nodes, where "shape" lists them; else nullptr.
[[nodiscard]] const Json* listed_points(const Json& cable);

/// Still water at the start.
struct StillSea {
    double level = 0.0;       ///< z of its surface [m].
    double density = 1025.0;  ///< [kg/m³].
};
/// That of the key "sea"; none: there is no sea.
[[nodiscard]] std::optional<StillSea> still_sea(const Document& document);
/// True if the sea acts on the cable: it is made of lumps, and its line types have "cd_normal".
[[nodiscard]] bool in_water(const CableLayout& c) noexcept;

/// Set `length` and `nodes`, and where a free end is that hangs. Shapes at rest have their weight
/// in still water where a sea acts on them. @throws SceneError.
void place_nodes(CableLayout& c, const Description& out, const Scope& scope, const Json& cable,
                 const std::optional<StillSea>& sea, const Place& place);

}  // namespace hawser::scene
