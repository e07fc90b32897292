// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide.h
/// Turning points of a wire of nodes: a stern roller, a bollard, a pin, a fairlead, an eye.
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", .from = ship, .to = barge, …});
/// world.add(hawser::GuideDef{.name = "roller", .wire = tow, .body = ship, .point = {-40, 0, 2},
///                            .axis = {0, 1, 0}, .radius = 1.0, .friction = 0.2});
/// ```
/// The element of the wire that passes the point is divided into two of kind end_span, on both
/// sides of a massless contact node:
/// ```
///     lump a ──────── in ────────►( )            what runs through is the coordinate of the
///                                  \             guide's slide [m]: out of `in`, into `out`
///                                  out
///                                    ▼ lump b
/// ```
/// Friction is that of hawser/route.h: Euler's ratio of the tensions with its bound in the matrix.
/// Below the bound there is no creep. The line turns by its current angle in each step.
///
/// *Nodes run through.* If the straight part before the guide gets shorter than a quarter of
/// `element_length`, its node is removed. The element gets the node's material. If the part behind
/// is longer than 1.5 `element_length`, a node is inserted (wire.h). Material, momentum and energy
/// are preserved as at a winch. The material between the guide and the first node on each side acts
/// as a load. The node gets half of its mass, weight and drag. The body of the guide gets the other
/// half of the weight, and the slide the part of that along the wire.
///
/// WorldWires::engage() divides the element. The element `before` gets its name, nodes at its ends
/// lose their halves of its mass, and its capsule is removed. It throws DefError if the element is
/// wound up, removed or broken, or if the parts do not fit it. WorldWires::ends() returns the
/// points where an element leaves the bodies that hold it.
///
/// WorldWires::move_along() moves the place of two such parts along the axis of its wheel by
/// `along` [m]. A length `fed` [m] passes from the rest length of the part behind to that of the
/// part before: the wire slides sideways (post.h). A decrease of the energy of parts and bends
/// counts as friction (Energy). It returns false without changes if the energy would grow. It
/// throws DefError for an eye, and if a part is too short.
///
/// A guide is a System (system.h). Signals, as "name.signal":
/// - `angle` [rad], `slide` [m], `speed` [m/s];
/// - `before`, `behind`: tensions at the guide [N];
/// - `wire_before`, `wire_behind`: wire between the guide and the next node [m].
///
/// *Stops.* Parts that cannot run through (the last node of a wire, gear, another line type) come
/// up to the guide and stop there. The slide is held until it is pulled back.
///
/// *Open guides.* A guide with `closed = false` has no upper roller: it can push but not pull. Let
/// T be the tension, α the angle of the wire on the wheel, and w the weight of the half elements
/// there towards the wheel. If T α + w < 0 the wire leaves, and the two parts become one element
/// again (EventKind::lift_off). It engages again when it returns to the wheel from outside near the
/// same point of the axis (EventKind::lay_on). Without the wire, the guide does not act.
///
/// Limits:
/// - A wire stays on a closed guide for any direction of pull, and keeps its position along the
///   axis.
/// - A wire off an open guide has no contact with its body.
/// - Elements need their own mass (WireDef::consistent_mass), or no node runs through.
/// - Between a guide and a drum there are at least two elements of wire. Between two guides there
///   is a node and at least 0.2 m; below 1.9 elements, the elements between are half of the length
///   there.
/// - A wire that breaks at a guide stays an element at it.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/route.h>

#include <string>

namespace hawser {

class World;

struct GuideDef {
    std::string name{};  ///< Unique among systems. Parts: name/slide, name/behind, name/friction.
    WireId wire{};       ///< Required.
    InteractionId element{};    ///< Element that passes it; invalid: the nearest one.
    BodyId body{};              ///< Body that carries it. Required; not a node if it has a radius.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Axis of the wheel, in the frame of the body.
    /// Radius to the middle of the wire [m], 0: an eye. Seen from the first end, the wire turns
    /// about +axis if it is positive, about −axis if it is negative.
    double radius = 0.0;
    double friction = 0.0;    ///< μ of the wire on it.
    double efficiency = 1.0;  ///< η of a sheave or roller: lesser tension over greater; (0, 1].
    /// Inertia of a roller that turns with the wire [kg m²]; needs a radius.
    double inertia = 0.0;
    int turns = 0;  ///< Additional whole turns round the wheel, 0 to 100.
    /// Length of inserted elements [m]; kDefault: that of the element; 0: no node runs through.
    double element_length = kDefault;
    /// Mass per length of the wire [kg/m]; kDefault: that of the element.
    double mass_per_length = kDefault;
    /// True if an upper roller, or the ring of an eye, keeps the wire on it. False needs a radius.
    bool closed = true;
    /// Existing slide of the elements before and behind it. Invalid: the slide is added and the
    /// element divided.
    BodyId slide{};
};

/// Objects of a guide.
struct Guide {
    BodyId slide{};
    InteractionId before{}, behind{};  ///< Elements of the wire.
    InteractionId friction{};          ///< Friction, also the stop.
    double angle = 0.0;                ///< Wrap angle of the wire at the start [rad].
};

/// Add a guide, all or nothing; called by World::add().
/// @throws DefError if a value is missing or out of range or the name is in use. Also if the
/// element is at a drum or another guide, or within two elements of a drum. Also if the wire passes
/// with an element of another guide, or does not go round.
Guide define(World& world, const GuideDef& def);

/// Definitions of a guide on an element, for callers without a World.
struct GuidePlan {
    BodyDef slide;
    InteractionDef before, behind;
    InteractionDef friction;  ///< Its loads are `before` and `behind`.
    double material[2];       ///< Rest length of each part [m].
    double angle;             ///< Wrap angle [rad].
};
/// Directions of a drawn wire beside the element that passes a guide: unit vectors from the first
/// end to the last. At an end of the wire, that of the element.
struct DrawnWire {
    Vec3 before{0.0, 0.0, 0.0}, behind{0.0, 0.0, 0.0};
};

/// Plan a guide on an element.
/// @param element  With all its parameters.
/// @param tension  Tension of the element [N].
/// @param drawn  Wire to compare with the side of `radius`; null: no comparison.
/// @throws DefError, also if the wire is drawn on the other side of the wheel, or passes more than
///        half an element beside it.
[[nodiscard]] GuidePlan plan_guide(const GuideDef& def, const InteractionDef& element,
                                   double tension, const RouteBodies& bodies,
                                   const DrawnWire* drawn = nullptr);

}  // namespace hawser
