// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file structure.h
/// Structure of a world: the definitions of its bodies, interactions, shapes, inputs and wires, by
/// index.
///
/// A state (WorldState::save()) can only be restored in a world of equal structure. Edits during a
/// run change the structure: nodes inserted at a drum, wires cut. A new world from the same set-up
/// then differs. Structure and state together restore it:
/// ```cpp
/// const hawser::Structure made_of = world.state().structure();
/// const std::vector<std::byte> state = world.state().save();
/// // … in another world from the same set-up:
/// other.state().restore(made_of, state);        // continues with equal bits
/// ```
/// Systems are not included: `other` must have systems of equal set-up; their states are in
/// `state`. Worlds of equal WorldState::identity() have equal structure, and need none to be
/// restored.
///
/// Ids keep index and generation. Limits: outputs of `other` stay, and are NaN if their target was
/// removed. Outputs that were added during the run are missing.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>
#include <hawser/wire.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Definitions of the objects of one kind, by index.
template <class Def>
struct Placed {
    std::vector<Def> defs;  ///< Definition at each index; stored, but not used, if vacant.
    std::vector<std::int32_t> generations;  ///< Id::generation of each index.
    std::vector<std::int32_t> vacant;       ///< Indices without an object, ascending.
};

/// Parts of a wire.
struct WirePieces {
    std::string name{};                     ///< Name of the wire.
    std::vector<BodyId> nodes{};            ///< Nodes from end to end; one more than elements.
    std::vector<InteractionId> elements{};  ///< Elements from end to end.
    std::vector<BodyId> lumps{};            ///< Nodes that the wire owns; removed with it.
    std::vector<InteractionId> bends{};     ///< Bends that the wire owns; removed with it.
    std::vector<ShapeId> shapes{};          ///< Shapes that the wire owns; removed with it.
    bool owns = false;                      ///< True if WorldWires::add() created it.
    WireTrim trim{};                        ///< Properties of new elements.
};

/// Link or joint created by WorldWires::join() or WorldWires::attach().
struct GearPiece {
    InteractionId id{};        ///< Interaction of the link or joint.
    Gear kind = Gear::splice;  ///< Kind of gear.
};

/// Structure of a world, WorldStateView::structure().
struct Structure {
    Placed<BodyDef> bodies;
    Placed<InteractionDef> interactions;
    Placed<ShapeDef> shapes;
    Placed<InputDef> inputs;
    Placed<WirePieces> wires;
    std::vector<MaterialDef> materials;  ///< Materials after the default one.
    std::vector<MaterialPairDef> pairs;  ///< Pairs of materials, as added.
    std::vector<GearPiece> gear;         ///< Links and joints of wires.
    /// Compliances ε of all rows of existing interactions, in order [m/N, rad/(N m)], and radii of
    /// elements at drums [m]. These are the values at the time when each interaction was added,
    /// which analyses use; `interactions` has the present lengths and radii. Empty: from
    /// `interactions`.
    std::vector<double> compliances, radii;
    /// Coupling of each interaction by index; empty: none was set by WorldSplits::set_coupling().
    std::vector<Coupling> coupling;
};

}  // namespace hawser
