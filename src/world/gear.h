// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gear.h
/// What holds ends of wires together (hawser/wire.h).

#include <hawser/id.h>
#include <hawser/structure.h>
#include <hawser/wire.h>

#include <cstddef>

namespace hawser::world {

using GearInUse = GearPiece;  ///< It may have gone or parted since.

/// A lump that one element holds.
struct FreeEnd {
    BodyId lump;
    InteractionId element;
    std::size_t slot = 0;  ///< Of the element.
};

/// What can be told without the world. @throws DefError
void check(const JoinDef& def);

}  // namespace hawser::world
