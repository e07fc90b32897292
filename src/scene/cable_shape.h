// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_shape.h
/// Where the nodes of a cable start: its key "shape".

#include "scene/cable_parts.h"

namespace hawser::scene {

/// The interior nodes, where "shape" lists them; else nullptr.
[[nodiscard]] const Json* listed_points(const Json& cable);

/// Set `length` and `nodes`, and where a free end is that hangs. @throws SceneError.
void place_nodes(CableLayout& c, const Description& out, const Scope& scope, const Json& cable,
                 const Place& place);

}  // namespace hawser::scene
