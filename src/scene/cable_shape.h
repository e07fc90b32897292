// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_shape.h
/// Compute the initial positions of a cable's nodes: its key "shape".

#include "scene/cable_parts.h"

#include <optional>

namespace hawser::scene {

/// Return the interior nodes if "shape" lists them, else nullptr.
[[nodiscard]] const Json* listed_points(const Json& cable);

/// Still water at the start.
struct StillSea {
    double level = 0.0;       ///< Height z of its surface [m].
    double density = 1025.0;  ///< Density [kg/m³].
};
/// Return the still water of the key "sea"; null: there is no sea.
[[nodiscard]] std::optional<StillSea> still_sea(const Document& document);
/// True if the sea acts on the cable: it consists of nodes, and its line types have "cd_normal".
[[nodiscard]] bool in_water(const CableLayout& c) noexcept;

/// Set `length` and `nodes`, and the position of a free end of a hanging cable. Shapes at rest have
/// their weight in still water if a sea acts on them. @throws SceneError.
void place_nodes(CableLayout& c, const Description& out, const Scope& scope, const Json& cable,
                 const std::optional<StillSea>& sea, const SourceLocation& location);

}  // namespace hawser::scene
