// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gear.h
/// What holds ends of wires together (hawser/wire.h).

#include <hawser/id.h>
#include <hawser/wire.h>

#include <cstddef>

namespace hawser::world {

/// A link or joint that join() or attach() has made; it may have gone or parted since.
struct GearInUse {
    InteractionId id;
    Gear kind = Gear::splice;
};

/// A lump that one element holds.
struct FreeEnd {
    BodyId lump;
    InteractionId element;
    std::size_t slot = 0;  ///< Of the element.
};

/// What can be told without the world. @throws DefError
void check(const JoinDef& def);

}  // namespace hawser::world
