// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file post.h
/// Bollards (PostDef): pins, bollards, rails and deck edges that wires of nodes engage and
/// disengage during the run. A guide (guide.h), in contrast, carries one wire from the start.
///
/// ```cpp
/// const hawser::ShapeId pin = world.add_shape({.kind = hawser::ShapeKind::cylinder, .body = ship,
///     .position = {-40, 2, 3}, .radius = 0.075, .half_length = 0.6, .margin = 1.0});
/// world.add(hawser::PostDef{.name = "pin", .shape = pin, .friction = 0.15});
/// ```
/// *Detection* is by contacts between the capsules of wires and the bollard's shape. Collision
/// detection sweeps both along their velocities. A fast wire is therefore stopped at the surface in
/// the step that would pass it. Motion that starts within a step is stopped within the shape's
/// `margin`.
///
/// *Engagement*. In a later step the touching element is divided at a massless contact node
/// (WorldWires::engage()), without a change of position or tension. The contact node lies at the
/// bollard's radius plus half the wire's diameter from the axis; the initial wrap angle is close
/// to 0.
/// ```
///      a ──────────────── b          a ─────.     .───── b
///            ( )             ──►           ( `─○─' )              ○ the contact node
/// ```
/// The engaged wire then runs as over a guide: the tensions differ by at most e^{μφ} at the wrap
/// angle φ of each step, without creep below this bound, and nodes run through. A node on the
/// bollard itself is removed first, if possible (WorldWires::remove_node()).
///
/// *Release*. Let T be the tension, φ the wrap angle, w the weight of the two half elements at the
/// bollard (as a vector) and n the outward normal. The wire is released if
/// ```
///     T (φ + 0.002 rad) − w·n < 0
/// ```
/// The constant prevents repeated engagement of a straight wire. The wire is also released if the
/// straight line between its nodes passes an end of the shape by more than the shape's radius. The
/// parts become one element again (WorldWires::disengage()): with their tension, or past an end
/// with their rest length. An element longer than 1.5 `element_length` gets a node.
///
/// *Slip along the axis* (`slides`). On the unrolled surface the wire arrives at the angle β₁ to
/// the axis and leaves at β₂. Coulomb's law across the wire is
/// ```
///     |ln tan(β₂/2) − ln tan(β₁/2)| ≤ μ φ
/// ```
/// While it is met, the axial position stays constant to the bit. Beyond it, the wire moves until
/// both sides are equal (WorldWires::move_along()). Without friction β₁ = β₂, which is the shortest
/// path. At an end of the shape the wire is released. Without `slides` a wire keeps its axial
/// position.
///
/// A bollard is a System (system.h). Outputs, as "name.signal":
/// - `held`: number of engaged wires; `taken`, `let_go`: engagements and releases since the start;
/// - of the first wire: `angle`, wrap angle [rad]; `before`, `behind`, tensions [N]; `slide`,
/// length
///   that has run through [m];
/// - with `slides`: `along`, position of the first wire from the middle of the shape along its z
/// axis
///   [m]; `slid`, total axial slip of all wires [m].
///
/// Limits:
/// 1. A wire engages a bollard at one point only; its other parts pass through while it is engaged.
/// 2. Friction along a wire and across it have separate bounds.
/// 3. Between two bollards a node is inserted midway, so that an element with a capsule can touch
/// the
///    second one. Bollards closer than 0.2 m along the wire are not distinguished.
/// 4. A wire needs capsules (WireDef::radius), nodes on both sides, and elements with mass
///    (WireDef::consistent_mass).
/// 5. The round end of a capsule counts as part of its side.
/// 6. The elastic deformation of the contact's tangential spring is lost on engagement.
///
/// Details: docs/theory/posts.md.

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <string>

namespace hawser {

class World;

/// Definition of a bollard. World::add() copies it.
struct PostDef {
    std::string name{};  ///< Unique name among systems. Parts: name/K/slide, …, K from 1 on.
    ShapeId shape{};     ///< Cylinder or capsule of one body that is not a lumped mass. Required.
    double friction = 0.0;    ///< Friction coefficient μ of the wires [1].
    double efficiency = 1.0;  ///< Efficiency η of a roller [1], (0, 1]: smaller over larger
                              ///< tension.
    double inertia = 0.0;     ///< Inertia of a roller that turns with the wire [kg m²].
    int wires = 2;            ///< Largest number of engaged wires, 1 to 16; further wires have
                              ///< contacts only.
    double element_length = kDefault;  ///< Length of inserted elements [m], as
                                       ///< GuideDef::element_length.
    bool slides = false;               ///< True: engaged wires slip along the axis.
};

/// Add a bollard; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range, or if the name is
/// already used.
void define(World& world, const PostDef& def);

}  // namespace hawser
