// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file structure.h
/// What a world is made of, place by place: bodies, interactions, shapes, inputs, wires.
///
/// A state (World::save()) belongs to a world of the same pieces. Where pieces came and went while
/// it ran, nodes at a drum or wires that were cut, a world that was just set up is none. Structure
/// and state together are:
/// ```cpp
/// const hawser::Structure made_of = world.structure();   // pieces, with what masses they have now
/// const std::vector<std::byte> state = world.save();
/// …
/// other.restore(made_of, state);   // the same set-up: goes on in the same bits
/// ```
/// Systems are not part of it: `other` has its own, of the same set-up, whose states come with the
/// state. World::identity() tells whether a structure is needed: worlds of one identity are made
/// of the same pieces.
///
/// Ids keep index and generation. Limits: an output of `other` stays, also where what it reads has
/// gone (it then reads 0), and outputs that were added later are not there.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>
#include <hawser/wire.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Things of one sort by place.
template <class Def>
struct Placed {
    std::vector<Def> defs;                  ///< Of an empty place what keeps it as it was.
    std::vector<std::int32_t> generations;  ///< How many had each place before.
    std::vector<std::int32_t> vacant;       ///< Empty places, ascending.
};

/// Which bodies and interactions a wire is made of.
struct WirePieces {
    std::string name{};
    std::vector<BodyId> nodes{};            ///< One more than elements.
    std::vector<InteractionId> elements{};  ///< In order.
    std::vector<BodyId> lumps{};            ///< Its own: they go with it, as do …
    std::vector<InteractionId> bends{};     ///< … these …
    std::vector<ShapeId> shapes{};          ///< … and these.
    bool owns = false;                      ///< It was made by World::add_wire().
    WireTrim trim{};                        ///< Of elements to come.
};

/// A link or joint that World::join() or World::attach() has made.
struct GearPiece {
    InteractionId id{};
    Gear kind = Gear::splice;
};

struct Structure {
    Placed<BodyDef> bodies;
    Placed<InteractionDef> interactions;
    Placed<ShapeDef> shapes;
    Placed<InputDef> inputs;
    Placed<WirePieces> wires;
    std::vector<MaterialDef> materials;  ///< Behind the default one.
    std::vector<MaterialPairDef> pairs;
    std::vector<GearPiece> gear;
    /// What analyses take instead of what lengths and layers have made of it by now: compliances ε
    /// of all rows of interactions that are there, in order [m/N, rad/(N m)], and the radii of
    /// elements that drums pay out [m]. Empty: as the definitions say.
    std::vector<double> compliances, radii;
    std::vector<Coupling> coupling;  ///< Of each interaction, where any was set (World::cuts()).
};

}  // namespace hawser
