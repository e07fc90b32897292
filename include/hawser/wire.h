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
///   lump has any: its winch loads both ends with half (WinchDef::element). It stays at the drum,
///   the new element takes what lies beyond the node, and lumps have half of that. Such a node goes
///   as others do, whatever it takes along; the drum's winch takes over the new element's mass.
/// - World::remove_node() takes away a lump that two elements hold and nothing else but bends; the
///   first goes on to the next node. The same stay, energy at most is lost. It returns false and
///   has done nothing where the elements there are at an angle above `bend` [rad], or the lump
///   moves so against its neighbours that energy would grow or be lost: that is to be tried again
///   later. `bend` π: at any angle and with any loss; false then only where energy would grow.
/// World::set_mass() makes a lump more or less of the same material: its drag and its applied force
/// go with its mass. All throw DefError where they cannot be, and std::bad_alloc.
/// docs/methods.md, 12.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/shapes.h>

#include <optional>
#include <string>
#include <vector>

namespace hawser {

/// What elements of a wire have besides their law, for those that come later.
struct WireTrim {
    double EI = 0.0;                    ///< Bending stiffness [N m²]; 0: none.
    std::optional<ShapeDef> segment{};  ///< Capsule between lumps; its bodies do not matter.
};

/// A wire of equal elements. A definition: World::add_wire copies it whole.
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
};

}  // namespace hawser
