// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire.h
/// Wires as things of a world: lumps joined by elements, made, asked and parted as one.
///
/// A place along a wire is a *material coordinate* s [m]: the unstretched length from its first
/// end, so that it stays with the material however the wire stretches. Where a drum pays out
/// (WinchStretch) the first element grows, and all behind it move on by as much.
/// ```
///     from                                                to
///      o──── element 0 ────o──── element 1 ────o── … ────o
///      s = 0            node 1               node 2      s = length(wire)
/// ```
/// A wire owns what add_wire() makes: World::remove_wire() takes it away. What of it is removed by
/// itself, or with a body that holds it, leaves a gap. Source of the elements: M. Servin,
/// C. Lacoursière, F. Nordfelth, K. Bodin, "Hybrid, multiresolution wires with massless frictional
/// contacts", IEEE TVCG 17 (2011).
///
/// *Nodes come and go* between steps, also on elements of no wire, where elements have a mass of
/// their own (consistent_mass, StretchDef::mass) and a compliance by their length:
/// - World::insert_node() puts a lump on an element at a share of it, 0 to 1 from its first body,
///   and returns it. The element ends there from now on, a new one goes on. Mass, momentum, angular
///   momentum and energy stay to rounding, under gravity but for the sag that balances its weight,
///   and tensions go on. Of an element that a drum pays out `mass` [kg] is to be told, of which no
///   lump has any: its winch loads both ends with half (WinchDef::element). Where a
///   winch does so only it may. It stays at the drum, the new element takes what lies beyond the
///   node, and lumps have half of that. Such a node goes as others do, whatever it takes along; the
///   drum's winch takes over the new element's mass.
/// - World::remove_node() takes away a lump that two elements hold and nothing else but bends; the
///   first goes on to the next node. The same stay, energy at most is lost. It returns false and
///   has done nothing where the elements there are at an angle above `bend` [rad], or the lump
///   moves so against its neighbours that energy would grow or be lost: that is to be tried again
///   later. `bend` π: at any angle and with any loss; false then only where energy would grow.
/// World::set_mass() makes a lump more or less of the same material: its drag and its applied force
/// go with its mass. All throw DefError where they cannot be, and std::bad_alloc.
/// docs/methods.md, 12.
///
/// *Wires are cut, joined, held and let go* between steps (docs/wires.md). What throws has changed
/// nothing; a change listener hears of each, so that recordings repeat them:
/// - World::cut() makes two wires of one at the material coordinate s [m], above 0 and below its
///   length: the node there becomes two, with the same place and velocity, each with what it holds
///   of the elements on its side. Within an element that may have nodes one is put there first;
///   else the nearest node between elements parts. The bend there goes, its energy counts as
///   driven. The second piece is another wire, "name/2", "name/3", …; it is returned. Of an
///   element, `share` 0 to 1 of it from its first body, of 1 excluded; the id that is returned is
///   invalid where the element is of no wire. Event `cut`: the element before it, the tension [N].
/// - World::join() holds two free ends together by gear, or makes one wire of two by a splice
///   (Gear), also by the lumps there, or a lump and a body with a point. World::attach() holds a
///   free end to a point of a body's frame [m], where it is, with gear or rigidly. Ends are 0, the
///   first one, and 1. Event `join`: what holds, or the element before a splice; the distance of
///   the ends [m].
/// - World::detach() lets an end go, whatever holds it: gear or a body. An end that was held by a
///   body without a lump of its own gets one, with the half element that no body carried. Off a
///   drum (WinchStretch) the wire goes on as a Stretch of the same length; what lay on the drum
///   parts. Event `detach`: the element at the end, its tension [N].
/// - World::release() opens a pelican hook, with an event `release`: the hook, its tension [N].
///
/// An end is free where a lump is that one element holds and nothing else but bends.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/shapes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser {

/// What elements of a wire have besides their law, for those that come later.
struct WireTrim {
    double EI = 0.0;                    ///< Bending stiffness [N m²]; 0: none.
    std::optional<ShapeDef> segment{};  ///< Capsule between lumps; its bodies do not matter.
    bool to_ends = false;               ///< See WireDef::end_capsules.
};

/// A piece of a wire of one line type, in equal elements.
struct WireSection {
    int elements = 1;                 ///< Of all sections together 1 to 100,000.
    double length = kDefault;         ///< Unstretched [m]. Required.
    double EA = kDefault;             ///< Axial stiffness [N]. Required.
    double mass_per_length = 0.0;     ///< [kg/m]. Required: lumps have mass.
    double EI = 0.0;                  ///< Bending stiffness [N m²]; 0: none.
    double axial_damping = kDefault;  ///< As WireDef has it.
    double breaking_load = kDefault;  ///< [N]; kDefault: it does not part.
    double drag = 0.0;                ///< Of lumps along all axes [N s/m²], by length.
};

/// A wire of equal elements, or of sections. A definition: World::add_wire copies it whole.
struct WireDef {
    std::string name{};  ///< Unique among wires. Nodes are called name/1, …, elements name/s0, ….
    BodyId from{};       ///< Body that holds the first end. Required.
    Vec3 from_point{0.0, 0.0, 0.0};  ///< There, in the body's frame, from its centre of mass [m].
    BodyId to{};                     ///< Body that holds the last end; invalid: it is free.
    Vec3 to_point{0.0, 0.0, 0.0};    ///< There, in the body's frame [m].
    int elements = 10;               ///< 1 to 100,000; 1 needs a last body.
    double length = kDefault;        ///< Unstretched [m]; kDefault: that of the path.
    double EA = kDefault;            ///< Axial stiffness [N]. Required.
    double mass_per_length = 0.0;    ///< [kg/m]. Required: lumps have mass.
    double EI = 0.0;                 ///< Bending stiffness [N m²]; 0: none.
    /// Fraction of critical damping of the highest axial mode; kDefault: two steps' worth.
    double axial_damping = kDefault;
    double breaking_load = kDefault;  ///< [N]; kDefault: it does not part.
    double drag = 0.0;                ///< Of lumps along all axes [N s/m²], by length.
    /// Where nodes 1, 2, … are, world frame [m]: one for each lump. Empty: evenly between the ends,
    /// and below the first one where the last is free.
    std::vector<Vec3> path{};
    Vec3 velocity{0.0, 0.0, 0.0};  ///< Of lumps, world frame [m/s].
    double radius = 0.0;           ///< Of capsules between lumps [m]; 0: it touches nothing.
    MaterialId material{};         ///< Of these.
    std::uint32_t group = 1, touches = ~0U;  ///< As ShapeDef has them.
    /// True: an element between two lumps moves as a straight piece (the consistent mass matrix of
    /// finite elements), so that a turning wire has the angular momentum and energy of its
    /// material, however few elements it has. False: lumps move by themselves.
    bool consistent_mass = false;
    /// Pieces of several line types, from the first end on. With them `elements`, `length`, `EA`,
    /// `mass_per_length`, `EI`, `axial_damping`, `breaking_load` and `drag` above are left as they
    /// are. The node between two has half of each; a bend there has their flexibilities in a row,
    /// and none where one of them has no EI (docs/wires.md, "Several line types").
    std::vector<WireSection> sections{};
    /// True: elements between a lump and a body have capsules, too (ShapeDef::body_b), up to the
    /// point, drum, guide or post that holds the wire, as elements come and go there. False: what
    /// ends on a body has none there, and others pass through it. Needs a radius.
    bool end_capsules = false;
};

/// What holds two ends together. Wires of lumps have no torsion: a swivel, which lets one end twist
/// against the other, acts as a shackle.
enum class Gear : std::uint8_t {
    splice,        ///< The two become one wire; of an end and a body: a rigid joint.
    shackle,       ///< A link, free to turn at both ends.
    swivel,        ///< A link about which nothing twists.
    triplate,      ///< A rigid plate with three holes, held by two shackles; the third is free.
    pelican_hook,  ///< A link that World::release() opens under load.
};

/// Gear that comes with the wires' ends, at their velocity; what that makes of energy is driven.
struct JoinDef {
    std::string
        name{};  ///< Of the link or joint, unique among interactions; of the plate, whose
                 ///< links are name/0 and name/1. "": the wire's name and "/gear", "/gear2".
    Gear gear = Gear::splice;
    /// [kg]; of a link half at each lump that it holds, of a plate that of the plate and above 0.
    double mass = 0.0;
    /// Of a link [m]. It may be slack; ends farther apart make it as long as they are.
    double length = 0.3;
    double EA = kDefault;             ///< Of a link [N]; kDefault: of the first wire's element.
    double breaking_load = kDefault;  ///< Of a link [N]; kDefault: it does not part.
    double radius = 0.3;              ///< Of the circle of a plate's holes [m].
    /// How much farther apart ends may be than the gear is long [m].
    double reach = 0.1;
};

/// What World::join() and World::attach() have made.
struct Joint {
    WireId wire{};            ///< The first wire, of a splice the whole one.
    InteractionId held[2]{};  ///< Link or joint; of a plate that of each end. A splice has none.
    BodyId plate{};           ///< Of a triplate.
};

/// Hole k, 0 to 2, of a triplate in the frame of its plate [m]. Plates are discs of the radius of
/// their holes' circle in the x-y plane.
[[nodiscard]] Vec3 triplate_hole(const JoinDef& def, int k) noexcept;

}  // namespace hawser
