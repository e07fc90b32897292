// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file route.h
/// Routes: massless lines over fixed turning points, for hoists, tackles and rope brakes. Turning
/// points are bollards, pins, eyes and sheaves on bodies.
///
/// ```cpp
/// const hawser::Route hoist = world.add(hawser::RouteDef{
///     .name = "hoist", .EA = 5e7,
///     .first = {.body = drum_deck, .point = {0, 0, 1}, .drum = drum, .radius = 0.4},
///     .places = {{.body = boom, .point = {30, 0, 0}, .efficiency = 0.98},
///                {.body = block, .point = {0, 0, 0.5}, .efficiency = 0.98}},
///     .last = {.body = boom, .point = {30.5, 0, 0}}});
/// ```
/// ```
///     first ──── part 1 ────( )                   ( ) a contact point: eye, bollard or sheave
///                              \ part 2           its slide has the coordinate q [m], the length
///                               ( )──── last      that has run from the part before to the part
///                                     part 3      behind
/// ```
/// Line that leaves the part before a contact point enters the part behind it, so that the total
/// unstretched length is constant. Parts are interactions of the kinds span, end_span and
/// body_span; friction is scalar_friction. The *slides* are scalar bodies of negligible mass, whose
/// coordinate is the length that has run through [m] (src/model/kinds/routes.h). Outputs and events
/// use the names "hoist/part2", "hoist/friction1", "hoist/slide1".
///
/// *Friction*. If the line turns by an angle δ, the tensions T₁ and T₂ before and behind obey the
/// capstan equation e^{−μδ} ≤ T₁/T₂ ≤ e^{μδ}, exactly (solve/capstans.h). At a sheave of efficiency
/// η the factor is 1/η instead. Below the bound there is no creep. The angle is that of each step;
/// if RoutePlace::angle is given, it is constant.
///
/// *End stops*. The end of a line stops at the contact point that it reaches (stop_ends()).
///
/// Limits: the stiffness of a part remains EA over its initial length. Parts carry tension only,
/// without weight or bending. The length between consecutive contact points on one body is
/// constant.
///
/// Source: Servin, Lacoursière, Nordfelth, Bodin, "Hybrid, multiresolution wires with massless
/// frictional contacts" (2011).

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hawser {

class World;

/// End of a line: fixed at a point of a body, or wound on a drum behind this point.
struct RouteEnd {
    BodyId body{};              ///< Body of the end; not a scalar body. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< End in the body's frame [m]; 0 for a lumped mass.
    BodyId drum{};        ///< Scalar body on which the line is wound; invalid: the end is fixed.
    double radius = 0.0;  ///< Length paid out per unit of the drum's coordinate [m].
};

/// Contact point of a line: an eye, bollard or sheave.
struct RoutePlace {
    BodyId body{};              ///< Body; not a lumped mass if `radius` is not 0. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Direction of the wheel's axis, in the frame of the body.
    /// Radius of the wheel [m]; 0: an eye. > 0: along the route, the line turns about +axis (right
    /// hand); < 0: about −axis.
    double radius = 0.0;
    double friction = 0.0;    ///< Friction coefficient μ of the line [1].
    double efficiency = 1.0;  ///< Efficiency η of a sheave [1], (0, 1]: smaller over larger
                              ///< tension.
    double inertia = 0.0;     ///< Inertia of the sheave [kg m²]; requires a radius.
    int turns = 0;            ///< Additional whole turns round the wheel, 0 to 100.
    /// Constant wrap angle of the line in the friction, whole turns included [rad]; default:
    /// follows the poses.
    double angle = kDefault;
};

/// Definition of a route. World::add() copies it.
struct RouteDef {
    std::string name{};                ///< Unique name in the world, or empty.
    double EA = kDefault;              ///< Axial stiffness [N]. Required.
    RouteEnd first{};                  ///< First end.
    std::vector<RoutePlace> places{};  ///< Contact points in order, 1 to 256.
    RouteEnd last{};                   ///< Last end.
    /// Unstretched length of the whole line [m]; default: the length that has the tension `tension`
    /// at the present poses.
    double length = kDefault;
    double tension = 0.0;            ///< Tension at the start, if `length` is the default [N].
    double breaking_load = 1e30;     ///< Tension above which a part breaks [N].
    double damping_time = kDefault;  ///< Damping time of all parts [s].
};

/// Objects of a route.
struct Route {
    std::vector<BodyId> slides;            ///< Slide of each contact point.
    std::vector<InteractionId> parts;      ///< Parts from first to last, one more than contact
                                           ///< points; tension = −World::force()[0].
    std::vector<InteractionId> frictions;  ///< Friction of each contact point; invalid: none.
    std::vector<double> angles;            ///< Wrap angle at each contact point [rad].
};

/// Add a route, all of it or nothing; World::add() calls it.
/// @throws DefError if a required field is missing, a value is out of range or a name is in use.
Route define(World& world, const RouteDef& def);

/// State of a body that a route reads.
struct RouteBody {
    Vec3 position{0.0, 0.0, 0.0};         ///< Centre of mass, world frame [m].
    Quat orientation = Quat::Identity();  ///< Rotation from body to world frame.
    BodyKind kind = BodyKind::fixed;      ///< Kind of the body.
    double mass = 0.0;                    ///< Mass [kg].
};
/// Function that returns the state of a body, and throws DefError if the body does not exist.
using RouteBodies = std::function<RouteBody(BodyId)>;

/// Add end stops to the parts of lines, as a System. A part with a fixed end (kind end_span) stops
/// its slide when less than a hundredth of its length is left and more would run through. The event
/// is `hauled_in` of the slide; running back is free. World::add() of a route calls this function.
/// @param name  Unique name of the system.
/// @param parts  Existing interactions of the kind end_span.
/// @throws DefError if the name is in use, or if a part is no end_span.
void stop_ends(World& world, const std::string& name, std::vector<InteractionId> parts);

/// Definitions of the parts of a route, for callers that have no World yet.
struct RoutePlan {
    /// Friction at a contact point.
    struct Friction {
        std::size_t place;  ///< Index of the contact point. The loads of the friction are the parts
                            ///< with the indices `place` and `place` + 1.
        InteractionDef def;  ///< Definition. Its loads have factors, but no interactions yet.
    };
    std::vector<InteractionDef> parts;  ///< Parts from first to last.
    std::vector<Friction> frictions;    ///< Friction of those contact points that have any.
    std::vector<double> angles;         ///< Wrap angle at each contact point [rad].
};
/// Return the definitions of the slides, one for each contact point.
/// @throws DefError if the definition is invalid.
[[nodiscard]] std::vector<BodyDef> route_slides(const RouteDef& def, const RouteBodies& bodies);
/// Return the definitions of the interactions of a route.
/// @param slides  Ids of the added slides, in the order of route_slides().
/// @throws DefError if the definition is invalid.
[[nodiscard]] RoutePlan plan_route(const RouteDef& def, const RouteBodies& bodies,
                                   std::span<const BodyId> slides);

}  // namespace hawser
