// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_maker.h
/// From the definition of a wire to its lumps, elements, bends and segments.

#include <hawser/world.h>

#include "world/wire_list.h"

#include <vector>

namespace hawser::world {

/// What can be told without the world. @throws DefError
void check(const WireDef& def);

/// Adds the pieces of a wire to a world, and notes them in `out` one by one: where this throws,
/// they are for the caller to take away. @param lumps  Memory for where its lumps are.
/// @throws DefError, std::bad_alloc.
void make_wire(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps);

}  // namespace hawser::world
