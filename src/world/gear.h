// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gear.h
/// Gear that holds ends of wires together (hawser/wire.h).

#include <hawser/id.h>
#include <hawser/structure.h>
#include <hawser/wire.h>

#include <cstddef>

namespace hawser::world {

using GearInUse = GearPiece;  ///< The gear may have been removed or broken since.

/// A node that one element holds.
struct FreeEnd {
    BodyId lump;
    InteractionId element;
    std::size_t slot = 0;  ///< Slot of the element.
};

/// Check the definition of a joint of wires as far as possible without the world. @throws DefError
void check(const JoinDef& def);

}  // namespace hawser::world
