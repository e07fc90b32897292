// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file structure.h
/// Structure of a world by index: bodies, interactions, shapes, inputs, wires.
///
/// A state (WorldState::save()) requires a world of equal structure. If nodes at a drum were
/// inserted or wires were cut, a new world from the same set-up differs. Structure and state
/// together restore it:
/// ```cpp
/// const hawser::Structure made_of = world.state().structure();   // parts with their present
/// masses const std::vector<std::byte> state = world.state().save(); … other.restore(made_of,
/// state);   // equal set-up: continues with equal bits
/// ```
/// Systems are not included: `other` has its own of equal set-up, and the state contains their
/// states. WorldState::identity() shows whether a structure is needed: worlds of equal identity
/// have equal structure.
///
/// Ids keep index and generation. Limits: outputs of `other` stay, and are NaN if their target was
/// removed. Outputs that were added later are missing.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>
#include <hawser/wire.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Objects of one kind by index.
template <class Def>
struct Placed {
    std::vector<Def> defs;  ///< Definitions; at a free index, unused values that are kept
                            ///< unchanged.
    std::vector<std::int32_t> generations;  ///< Number of earlier objects at each index.
    std::vector<std::int32_t> vacant;       ///< Free indices, ascending.
};

/// Parts of a wire.
struct WirePieces {
    std::string name{};
    std::vector<BodyId> nodes{};            ///< Nodes in order; one more than elements.
    std::vector<InteractionId> elements{};  ///< Elements in order.
    std::vector<BodyId> lumps{};            ///< Nodes that the wire owns; removed with it.
    std::vector<InteractionId> bends{};     ///< Bends that the wire owns; removed with it.
    std::vector<ShapeId> shapes{};          ///< Shapes that the wire owns; removed with it.
    bool owns = false;                      ///< True if WorldWires::add() created it.
    WireTrim trim{};                        ///< Properties of new elements.
};

/// Link or joint created by WorldWires::join() or WorldWires::attach().
struct GearPiece {
    InteractionId id{};
    Gear kind = Gear::splice;
};

/// Structure of a world.
struct Structure {
    Placed<BodyDef> bodies;
    Placed<InteractionDef> interactions;
    Placed<ShapeDef> shapes;
    Placed<InputDef> inputs;
    Placed<WirePieces> wires;
    std::vector<MaterialDef> materials;  ///< Materials after the default one.
    std::vector<MaterialPairDef> pairs;
    std::vector<GearPiece> gear;
    /// Values of the last analyses, if lengths and layers have changed since. Compliances ε of all
    /// rows of existing interactions, in order [m/N, rad/(N m)], and radii of elements at drums
    /// [m]. Empty: from the definitions.
    std::vector<double> compliances, radii;
    std::vector<Coupling> coupling;  ///< Coupling of each interaction, if any was set
                                     ///< (WorldSplits::cuts()).
};

}  // namespace hawser
