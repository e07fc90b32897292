// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide.h
/// What a wire of lumps runs over: a stern roller, a post, a pin, a fairlead, an eye.
///
/// ```cpp
/// const hawser::WireId tow = world.add_wire({.name = "tow", .from = ship, .to = barge, …});
/// world.add(hawser::GuideDef{.name = "roller", .wire = tow, .body = ship, .point = {-40, 0, 2},
///                            .axis = {0, 1, 0}, .radius = 1.0, .friction = 0.2});
/// ```
/// The wire's element that passes the point becomes two, of kind end_span, on both sides of a
/// contact node without mass:
/// ```
///     lump a ──────── in ────────►( )            what runs through is the coordinate of the
///                                  \             guide's slide [m]: out of `in`, into `out`
///                                  out
///                                    ▼ lump b
/// ```
/// Friction is that of hawser/route.h, Euler's ratio of the tensions with its bound in the matrix:
/// below it nothing creeps. The line turns by the angle that it has in each step.
///
/// *Nodes run through.* Where the straight part before the guide gets shorter than a quarter of
/// `element`, its lump goes and its material is the element's; where the one behind has half more
/// than `element`, a lump comes (wire.h). Material, momentum and energy are kept as they are where
/// a winch takes in and pays out. What lies between the guide and the first lump on each side loads
/// the lump with half of its mass, weight and drag, the body of the guide with the other half of
/// the weight, and the slide with what of that pulls along the wire.
///
/// World::lay_over() is what divides the element: `before` gets its name, lumps at its ends lose
/// their halves of its mass, its capsule goes; DefError where it is wound up, gone or parted, or
/// the parts do not fit it. World::ends() tells where a piece of a line leaves what holds it.
///
/// World::move_along() moves the place of two such parts along the axis of its wheel by `along`
/// [m], with `fed` [m] of the rest length of the part behind going to that before: the wire slides
/// sideways (post.h). What parts and bends hold less counts as friction (Energy). @return false:
/// they would hold more, and nothing has changed. DefError on an eye, and where a part has no so
/// much length.
///
/// A guide is a System (system.h). Signals, as "name.signal": `angle` [rad], `before` and `behind`
/// [N], the tensions at the guide, `slide` [m], `speed` [m/s], `wire_before`, `wire_behind` [m],
/// the wire between the guide and the next lump.
///
/// *Stops.* What cannot run through (the last lump of a wire, gear, another line type) comes up to
/// the guide and stops there: the slide is held against running on until it is pulled back.
///
/// *Open guides.* A guide with `closed = false` has no upper roller: it pushes, and cannot pull.
/// Let T be the tension, α the angle of the wire on the wheel, w the weight of the half elements
/// there that points to the wheel. The wire leaves where T α + w < 0, and the two parts become one
/// element again (EventKind::lift_off). It is laid on again (EventKind::lay_on) where it comes back
/// to the wheel from outside, beside the same point of the axis. While it is off, the guide does
/// not act.
///
/// Limits: the wire stays on a closed guide whatever way it pulls, and keeps its place along the
/// axis. A wire that is off an open guide has no contact with its body.
/// Elements must have a mass of their own (WireDef::consistent_mass), or none runs through. A guide
/// and a drum have at least two elements of wire between them, two guides a lump and 0.2 m: nearer
/// than 1.9 elements, those between are half of what lies there. A wire that parts at a guide stays
/// an element at it.

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
    InteractionId element{};    ///< That passes it; invalid: the one that is nearest.
    BodyId body{};              ///< On which it is. Required; no lump where it has a radius.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Of the wheel, in the frame of the body.
    /// To the middle of the wire [m], 0: an eye. The wire turns about +axis where it is above 0, as
    /// seen from its first end, about −axis where it is below.
    double radius = 0.0;
    double friction = 0.0;    ///< μ of the wire on it.
    double efficiency = 1.0;  ///< η of a sheave or roller: lesser tension over greater; (0, 1].
    double inertia = 0.0;     ///< Of a roller that turns with the wire [kg m²]; needs a radius.
    int turns = 0;            ///< Whole turns more round the wheel, 0 to 100.
    /// Of what comes behind it [m]; kDefault: that of the element; 0: no node runs through.
    double element_length = kDefault;
    /// Of the wire [kg/m]; kDefault: that of the element.
    double mass_per_length = kDefault;
    /// Whether an upper roller, or the ring of an eye, keeps the wire on it. False needs a radius.
    bool closed = true;
    /// The scalar body that the elements before and behind it have as their slide already. Invalid:
    /// it is made, and the element divided.
    BodyId slide{};
};

/// What a guide is made of.
struct Guide {
    BodyId slide{};
    InteractionId before{}, behind{};  ///< Elements of the wire.
    InteractionId friction{};          ///< Also what stops there.
    double angle = 0.0;                ///< By which the wire turns there at the start [rad].
};

/// What World::add() of it calls. All or nothing. @throws DefError on what is missing or out of
/// range, a name that is taken, an element at a drum or another guide or within two elements of
/// a drum, a wire that passes with an element that another guide has, a wire that does not go
/// round.
Guide define(World& world, const GuideDef& def);

/// What a guide makes of an element, for those that have no World yet.
struct GuidePlan {
    BodyDef slide;
    InteractionDef before, behind;
    InteractionDef friction;  ///< Its loads are `before` and `behind`.
    double material[2];       ///< Of each part, without tension [m].
    double angle;             ///< [rad]
};
/// Directions of a wire beside the element that passes a guide, as drawn: unit vectors from the
/// first end to the last. Where the wire ends, that of the element.
struct DrawnWire {
    Vec3 before{0.0, 0.0, 0.0}, behind{0.0, 0.0, 0.0};
};

/// @param element  With all its parameters. @param tension  Of the element [N]. @param drawn  Wire
/// to be compared with the side of `radius`; null: it is not compared.
/// @throws DefError, also if the wire is drawn on the other side of the wheel, or passes more than
/// half an element beside it.
[[nodiscard]] GuidePlan plan_guide(const GuideDef& def, const InteractionDef& element,
                                   double tension, const RouteBodies& bodies,
                                   const DrawnWire* drawn = nullptr);

}  // namespace hawser
