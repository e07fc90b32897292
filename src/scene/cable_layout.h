// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_layout.h
/// Read a cable of the scene: look up its line type, find its ends and compute the positions of its
/// nodes.

#include "scene/cable_parts.h"

namespace hawser::scene {

/// Read a cable and compute its layout. @throws SceneError.
[[nodiscard]] CableLayout lay_out_cable(Description& out, const Scope& scope, const Scope& to_scope,
                                        const Json& cable, const Document& document,
                                        const SourceLocation& location);

}  // namespace hawser::scene
