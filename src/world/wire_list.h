// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_list.h
/// What a world keeps of its wires: which bodies and interactions they are made of.

#include <hawser/structure.h>

#include "base/places.h"
#include "world/lookup.h"

#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

struct Wire : WirePieces {
    /// One of nothing yet, in the memory that there is.
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
    std::vector<Wire> wires;  ///< By place; without elements where one was removed.
    base::Places places;
    Names names;
    std::vector<WireId> ids;  ///< Of what there is, ascending.
    Wire coming;              ///< Memory of the next one.
    std::vector<Vec3> lumps;  ///< Memory for where its lumps are.
};

}  // namespace hawser::world
