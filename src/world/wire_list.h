// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_list.h
/// Wires of a world: their bodies and interactions.

#include <hawser/structure.h>

#include "base/places.h"
#include "world/lookup.h"

#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

struct Wire : WirePieces {
    /// Clear the wire and keep its memory. @param of  New name. @param made  True if a definition
    /// of a wire made it.
    void begin(std::string_view of, bool made) {
        name = of;
        owns = made;
        trim = {};
        nodes.clear();
        elements.clear();
        lumps.clear();
        bends.clear();
        shapes.clear();
    }
};

struct WireList {
    std::vector<Wire> wires;  ///< By index; without elements at vacant indices.
    base::Slots slots;
    Names names;
    std::vector<WireId> ids;  ///< Ids of existing wires, ascending.
    Wire coming;              ///< Buffer of the next wire.
    std::vector<Vec3> lumps;  ///< Buffer for the positions of its nodes.
};

}  // namespace hawser::world
