// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_layout.h
/// A cable of the scene with its line type looked up, its ends found and its nodes placed.

#include "scene/cable_parts.h"

namespace hawser::scene {

/// @throws SceneError.
[[nodiscard]] CableLayout lay_out_cable(Description& out, const Scope& scope, const Scope& to_scope,
                                        const Json& cable, const Document& document,
                                        const Place& place);

}  // namespace hawser::scene
