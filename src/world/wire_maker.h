// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_maker.h
/// Nodes, elements, bends and capsules from the definition of a wire.

#include <hawser/world.h>

#include "world/wire_list.h"

#include <vector>

namespace hawser::world {

/// Check a definition as far as possible without the world.
/// @throws DefError
void check(const WireDef& def);

/// Add the parts of a wire to a world and record them in `out` one by one. If this throws, the
/// caller removes them.
/// @param nodes  Buffer for the positions of its nodes.
/// @throws DefError, std::bad_alloc.
void make_wire(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps);

}  // namespace hawser::world
