// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide.h
/// Guides: turning points that a wire of nodes runs over for the whole run. A guide is a stern
/// roller, a bollard, a pin, a fairlead or an eye. For bollards that wires engage and leave:
/// post.h.
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", .from = ship, .to = barge, …});
/// world.add(hawser::GuideDef{.name = "roller", .wire = tow, .body = ship, .point = {-40, 0, 2},
///                            .axis = {0, 1, 0}, .radius = 1.0, .friction = 0.2});
/// ```
/// *Division*. WorldWires::engage() divides the element of the wire that passes the point into two
/// of kind end_span, `before` and `behind`, on both sides of a massless contact node:
/// ```
///     node a ────── before ──────►( )            q, coordinate of the guide's slide [m]: length
///                                  \             that has run from `before` to `behind`
///                                 behind         l_before = l₁ − q,   l_behind = l₂ + q
///                                    ▼ node b
/// ```
/// The element `before` gets the name of the divided element. The nodes at its ends lose their
/// halves of its mass, and its capsule is removed. WorldWires::ends() returns the points where an
/// element leaves the bodies that hold it.
///
/// *Friction* is that of route.h: the tensions differ by at most e^{μδ}, without creep below this
/// bound. The wrap angle δ follows the wire in each step.
///
/// *Nodes run through.* If the straight part before the guide gets shorter than a quarter of
/// `element_length`, its node is removed, and the element gets the node's material. If the part
/// behind is longer than 1.5 `element_length`, a node is inserted (wire.h). Material, momentum and
/// energy are conserved as at a winch. The material between the guide and the first node on each
/// side acts as a load. The node gets half of its mass, weight and drag. The body of the guide gets
/// the other half of the weight, and the slide gets the component of this half along the wire.
///
/// *Sideways motion* (post.h). WorldWires::move_along() moves the contact point of the two parts by
/// `along` [m] along the axis of the wheel, and passes the rest length `fed` [m] from the part
/// behind to the part before. A decrease of the energy of parts and bends counts as friction
/// (Energy).
///
/// A guide is a System (system.h). Signals, as "name.signal":
/// - `angle` [rad], `slide` [m], `speed` [m/s];
/// - `before`, `behind`: tensions at the guide [N];
/// - `wire_before`, `wire_behind`: wire between the guide and the next node [m].
///
/// *Stops.* The last node of a wire, gear and another line type cannot run through. They come up to
/// the guide, and the slide stops until the wire is pulled back.
///
/// *Open guides.* A guide with `closed = false` has no upper roller: it pushes the wire but does
/// not pull it. Let T be the tension, α the angle of the wire on the wheel, and w the component of
/// the weight of both half elements towards the wheel. If T α + w < 0, the wire leaves the guide,
/// and the two parts become one element again (EventKind::lift_off). It engages again when it
/// returns to the wheel from outside near the same point of the axis (EventKind::lay_on). Without
/// the wire, the guide has no effect.
///
/// Limits:
/// - A wire stays on a closed guide for any direction of pull, and keeps its position along the
///   axis.
/// - A wire that has left an open guide has no contact with the body of the guide.
/// - Elements need their own mass (WireDef::consistent_mass); otherwise no node runs through.
/// - Between a guide and a drum there must be at least two elements of wire, between two guides a
///   node and at least 0.2 m of wire. If two guides are closer than 1.9 elements, the elements
///   between them have half of the length between the guides.
/// - If a wire breaks in one of its parts at a guide, the guide keeps the other part.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/route.h>

#include <string>

namespace hawser {

class World;

/// Definition of a guide. World::add() copies it.
struct GuideDef {
    /// Unique name among systems. Parts: name/slide, name/behind, name/friction.
    std::string name{};
    WireId wire{};            ///< Wire of nodes that runs over the guide. Required.
    InteractionId element{};  ///< Element that passes the guide; invalid: the nearest one.
    BodyId body{};            ///< Body that carries the guide; not a lumped mass if `radius` is not
                              ///< 0. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Direction of the wheel's axis, in the frame of the body.
    /// Radius to the middle of the wire [m]; 0: an eye. > 0: from the first end of the wire to the
    /// last, it turns about +axis (right hand); < 0: about −axis.
    double radius = 0.0;
    double friction = 0.0;    ///< Friction coefficient μ of the wire on the guide [1].
    double efficiency = 1.0;  ///< Efficiency η of a sheave or roller [1], (0, 1]: smaller over
                              ///< larger tension.
    double inertia = 0.0;     ///< Inertia of a roller that turns with the wire [kg m²]; requires a
                              ///< radius.
    int turns = 0;            ///< Additional whole turns round the wheel, 0 to 100.
    /// Length of inserted elements [m]; default: length of the element. 0: no node runs through.
    double element_length = kDefault;
    /// Mass per length of the wire [kg/m]; default: mass per length of the element.
    double mass_per_length = kDefault;
    /// True: an upper roller, or the ring of an eye, keeps the wire on the guide. False: the wire
    /// may leave the wheel; requires a radius.
    bool closed = true;
    /// Slide of an element that is already divided at this guide. Invalid: the element is divided
    /// and the slide is added.
    BodyId slide{};
};

/// Objects of a guide.
struct Guide {
    BodyId slide{};                    ///< Scalar body with the length that has run through.
    InteractionId before{}, behind{};  ///< Parts of the wire on both sides of the guide.
    InteractionId friction{};          ///< Friction of the slide; it also stops the slide.
    double angle = 0.0;                ///< Wrap angle of the wire at the start [rad].
};

/// Add a guide, all of it or nothing; World::add() calls it.
/// @throws DefError if a required field is missing, a value is out of range or the name is in use
/// @throws DefError if the element is at a drum or another guide, or within two elements of a drum
/// @throws DefError if the wire passes another guide with the same element, or does not go round
/// the wheel
Guide define(World& world, const GuideDef& def);

/// Definitions of the parts of a guide, for callers without a World.
struct GuidePlan {
    BodyDef slide;                  ///< Slide.
    InteractionDef before, behind;  ///< Parts of the divided element.
    InteractionDef friction;        ///< Friction. Its loads are `before` and `behind`.
    double material[2];             ///< Rest lengths of `before` and `behind` [m].
    double angle;                   ///< Wrap angle [rad].
};
/// Directions of the elements before and behind the element that passes a guide: unit vectors from
/// the first end of the wire to the last, world frame. At an end of the wire: direction of the
/// element itself. They show on which side of the wheel the scene has drawn the wire.
struct DrawnWire {
    Vec3 before{0.0, 0.0, 0.0}, behind{0.0, 0.0, 0.0};
};

/// Compute the parts of a guide on an element.
/// @param element  Definition of the element, with all parameters.
/// @param tension  Tension of the element [N].
/// @param bodies  Function that returns the state of a body.
/// @param drawn  Neighbouring elements, to check the side of the wheel; null: no check.
/// @throws DefError if a value is invalid
/// @throws DefError with `drawn`, if the wire is on the other side of the wheel than `radius`
/// states, or passes the wheel at more than half an element
[[nodiscard]] GuidePlan plan_guide(const GuideDef& def, const InteractionDef& element,
                                   double tension, const RouteBodies& bodies,
                                   const DrawnWire* drawn = nullptr);

}  // namespace hawser
