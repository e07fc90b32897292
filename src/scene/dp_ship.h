// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_ship.h
/// The key `dp_capability` of vessels: data of a ship for DNV-ST-0111 (hawser/dp_capability.h).

#include <hawser/dp_capability.h>

#include "scene/description.h"

namespace hawser::scene {

/// Read an object whose form has been checked. @throws SceneError at `location`.
[[nodiscard]] DpShip read_dp_ship(const Json& json, const SourceLocation& location);

}  // namespace hawser::scene
