// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire.h
/// Wires of a world: nodes (lumped masses) joined by elastic elements. This header has their
/// definitions; world_wires.h has the functions.
///
/// A position along a wire is a *material coordinate* s [m], the unstretched length from its first
/// end. It follows the material when the wire stretches. If a drum pays out at the first end
/// (WinchStretch), the first element grows and s of all later nodes increases by the same length.
/// ```
///     from                                                to
///      o──── element 0 ────o──── element 1 ────o── … ────o
///      s = 0            node 1               node 2      s = length(wire)
/// ```
/// An element of rest length l₀ and length l > l₀ has the tension T = EA (l − l₀)/l₀ plus its
/// damping, and 0 if it is slack. Bends at the nodes have the stiffness EI. A wire owns the parts
/// that WorldWires::add() creates; WorldWires::remove() removes them. If a part is removed
/// separately, or with a body that holds it, the wire has a gap. Source of the elements: M. Servin,
/// C. Lacoursière, F. Nordfelth, K. Bodin, "Hybrid, multiresolution wires with massless frictional
/// contacts", IEEE TVCG 17 (2011).
///
/// *Nodes*. Nodes are inserted and removed between steps, also at elements outside wires. The
/// elements need their own mass (consistent_mass, StretchDef::mass) and a compliance that follows
/// from their length. Derivation: docs/theory/wire_nodes.md.
///
/// WorldWires::insert_node() inserts a node on an element. The element then ends at the node, and a
/// new element continues from it. Mass, momentum, angular momentum, energy and tensions are
/// conserved to rounding. An exception is the sag under gravity, which balances the weight of the
/// new node.
///
/// An element at a drum needs the parameter `mass` [kg], because no node carries its mass. The
/// winch applies half of it to each end (WinchDef::element). If a winch feeds the element, only the
/// winch may insert nodes there. The element stays at the drum, the new element has the length
/// beyond the node, and nodes carry half of its mass. When such a node is removed, the winch takes
/// over the mass of the removed element.
///
/// WorldWires::remove_node() removes a node that only two elements and bends hold; the first
/// element then extends to the next node. Mass, momentum and angular momentum are conserved; energy
/// is conserved or decreases. The call returns false without a change in three cases:
/// - the angle between the elements exceeds `bend` [rad];
/// - energy would increase;
/// - the node moves relative to its neighbours, so that energy would be lost.
///
/// Repeat the call later in these cases. With `bend` π only an increase of energy is rejected.
///
/// *Ends*. Wires are cut, joined, attached and detached between steps (world_wires.h,
/// docs/wire_edits.md). An end is given by its number, 0 (first) or 1 (last), or by its node. An
/// end is *free* if it is a node that only one element and bends hold.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/shapes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser {

/// Properties of the elements that edits and winches insert in a wire.
struct WireTrim {
    double EI = 0.0;                    ///< Bending stiffness [N m²]; 0: none.
    std::optional<ShapeDef> segment{};  ///< Capsule between nodes; its bodies are not used.
    bool to_ends = false;               ///< WireDef::end_capsules of the wire.
};

/// Section of a wire with one line type and equal elements.
struct WireSection {
    int elements = 1;              ///< Number of elements; 1 to 100,000 in all sections together.
    double length = kDefault;      ///< Unstretched length [m]. Required.
    double EA = kDefault;          ///< Axial stiffness [N]. Required.
    double mass_per_length = 0.0;  ///< Mass per length [kg/m]. Required.
    double EI = 0.0;               ///< Bending stiffness [N m²]; 0: none.
    double axial_damping = kDefault;  ///< Fraction of critical damping, as WireDef::axial_damping.
    double breaking_load = kDefault;  ///< Breaking load [N]; default: unbreakable.
    double drag = 0.0;                ///< Drag of nodes along all axes per length [N s/m²].
};

/// Wire of equal elements, or of sections. WorldWires::add() copies the definition.
struct WireDef {
    std::string name{};  ///< Unique name among wires. Nodes: name/1, …; elements: name/s0, ….
    BodyId from{};       ///< Body that holds the first end. Required.
    Vec3 from_point{0.0, 0.0, 0.0};  ///< Position of the first end in the frame of `from`, from its
                                     ///< centre of mass [m].
    BodyId to{};                     ///< Body that holds the last end; invalid: the end is free.
    Vec3 to_point{0.0, 0.0, 0.0};    ///< Position of the last end in the frame of `to` [m].
    int elements = 10;               ///< Number of elements, 1 to 100,000; 1 requires `to`.
    double length = kDefault;        ///< Unstretched length [m]; default: length of the path.
    double EA = kDefault;            ///< Axial stiffness [N]. Required.
    double mass_per_length = 0.0;    ///< Mass per length [kg/m]. Required.
    double EI = 0.0;                 ///< Bending stiffness [N m²]; 0: none.
    /// Fraction of critical damping of the highest axial mode [1]; default: a damping time of two
    /// steps.
    double axial_damping = kDefault;
    double breaking_load = kDefault;  ///< Breaking load [N]; default: unbreakable.
    double drag = 0.0;                ///< Drag of nodes along all axes per length [N s/m²].
    /// Positions of the nodes 1, 2, …, world frame [m]. Empty: evenly spaced between the ends, or
    /// below the first end if the last is free.
    std::vector<Vec3> path{};
    Vec3 velocity{0.0, 0.0, 0.0};  ///< Velocity of the nodes, world frame [m/s].
    double radius = 0.0;           ///< Radius of the capsules between nodes [m]; 0: no contacts.
    MaterialId material{};         ///< Material of the capsules.
    std::uint32_t group = 1, touches = ~0U;  ///< Collision groups and their mask, as in ShapeDef.
    /// True: consistent mass matrix of finite elements, so that angular momentum and energy of a
    /// rotating wire are independent of the number of elements. False: lumped masses.
    bool consistent_mass = false;
    /// Sections of several line types, from the first end. `elements`, `length`, `EA`,
    /// `mass_per_length`, `EI`, `axial_damping`, `breaking_load` and `drag` above are then not
    /// used. The node between two sections has half of the mass of each. The bend there has both
    /// flexibilities in series, and is omitted if one EI is 0 (docs/wires.md, "Several line
    /// types").
    std::vector<WireSection> sections{};
    /// True: elements between a node and a body also have capsules (ShapeDef::body_b), up to the
    /// holding point. Inserted and removed elements follow this setting. False: elements at bodies
    /// have no contacts. True requires a radius.
    bool end_capsules = false;
};

/// Kind of connection of two ends. Wires have no torsion, so that a swivel has the effect of a
/// shackle.
enum class Gear : std::uint8_t {
    splice,        ///< Two wires become one; an end on a body gets a rigid joint.
    shackle,       ///< Link that turns freely at both ends.
    swivel,        ///< Link that also turns about its own axis.
    triplate,      ///< Rigid plate with three holes; two shackles hold the ends, the third hole is
                   ///< free.
    pelican_hook,  ///< Link that WorldWires::release() opens under load.
};

/// Definition of gear for WorldWires::join() and attach(). The gear gets the velocity of the ends;
/// its kinetic energy counts as edited (Energy).
struct JoinDef {
    std::string name{};  ///< Name of the link or joint, unique among interactions; of a plate, with
                         ///< links name/0 and name/1. "": the wire's name and "/gear", "/gear2".
    Gear gear = Gear::splice;  ///< Kind of connection.
    /// Mass of the link or plate [kg]. Each node that a link holds gets half of it; a plate
    /// requires > 0.
    double mass = 0.0;
    /// Rest length of a link [m]. If the ends are farther apart, their distance is the rest length;
    /// if they are closer, the link starts slack.
    double length = 0.3;
    double EA = kDefault;  ///< Axial stiffness of a link [N]; default: that of the first wire's
                           ///< element.
    double breaking_load = kDefault;  ///< Breaking load of a link [N]; default: unbreakable.
    double radius = 0.3;              ///< Radius of the circle through a plate's holes [m].
    /// Largest distance of the ends in excess of the gear's length [m].
    double reach = 0.1;
};

/// Result of WorldWires::join() and WorldWires::attach().
struct Joint {
    WireId wire{};            ///< First wire; after a splice, the united wire.
    InteractionId held[2]{};  ///< Link or joint; with a plate, one link for each end. Invalid after
                              ///< a splice.
    BodyId plate{};           ///< Body of a triplate; else invalid.
};

/// Return the position of hole k, 0 to 2, in the frame of a triplate [m]. The plate is a disc in
/// the x-y plane with the radius of its circle of holes.
[[nodiscard]] Vec3 triplate_hole(const JoinDef& def, int k) noexcept;

}  // namespace hawser
