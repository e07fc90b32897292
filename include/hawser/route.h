// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file route.h
/// Massless line over bollards, pins, eyes and sheaves, for hoists, tackles and rope brakes.
///
/// ```cpp
/// const hawser::Route hoist = world.add(hawser::RouteDef{
///     .name = "hoist", .EA = 5e7,
///     .first = {.body = drum_deck, .point = {0, 0, 1}, .drum = drum, .radius = 0.4},
///     .places = {{.body = boom, .point = {30, 0, 0}, .efficiency = 0.98},
///                {.body = block, .point = {0, 0, 0.5}, .efficiency = 0.98}},
///     .last = {.body = boom, .point = {30.5, 0, 0}}});
/// ```
/// Line that leaves the part before a contact point enters the part behind it, so that the total
/// length is kept. Parts are interactions of the kinds span, end_span and body_span; friction is
/// scalar_friction. The *slides* are scalar bodies of negligible mass, whose coordinate is the
/// length that has run through [m] (src/model/kinds/routes.h). Outputs and events use the names
/// "hoist/part2", "hoist/friction1", "hoist/slide1".
///
/// *Friction*. If the line turns by an angle δ, the tensions before and behind differ by a factor
/// of at most e^{μδ}, exactly (solve/capstans.h). At a sheave of efficiency η the factor is 1/η.
/// Below the bound there is no creep.
///
/// The end of a line stops at the contact point that it reaches (stop_ends()).
///
/// Limits: friction uses the angle at the start. The stiffness of a part remains EA over its
/// initial length. Parts carry tension only, without weight or bending. Consecutive contact points
/// on one body keep the length between them.
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

/// End of a line: at a point of a body, or on a drum behind it.
struct RouteEnd {
    BodyId body{};              ///< Body with a position in space; not a scalar body. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< End in the body's frame [m]; 0 for a lumped mass.
    BodyId drum{};        ///< Scalar body on which the line is wound; invalid: the end is fixed.
    double radius = 0.0;  ///< Line paid out per unit of the drum's coordinate [m].
};

/// Contact point of a line: an eye, bollard or sheave.
struct RoutePlace {
    BodyId body{};              ///< Body; not a lumped mass if `radius` is not 0. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Axis of the wheel, in the frame of the body.
    /// Radius of the wheel [m]; 0: an eye. Along the route, the line turns about +axis if > 0,
    /// about −axis if < 0.
    double radius = 0.0;
    double friction = 0.0;    ///< Friction coefficient μ of the line [1].
    double efficiency = 1.0;  ///< Efficiency η of a sheave [1], (0, 1]: smaller over larger
                              ///< tension.
    double inertia = 0.0;     ///< Inertia of the sheave [kg m²]; requires a radius.
    int turns = 0;            ///< Additional whole turns round the wheel, 0 to 100.
    /// Angle of the line here, whole turns included [rad]; default: from the present poses.
    double angle = kDefault;
};

/// Definition of a route. World::add() copies it.
struct RouteDef {
    std::string name{};                ///< Unique name in the world, or empty.
    double EA = kDefault;              ///< Axial stiffness [N]. Required.
    RouteEnd first{};                  ///< First end.
    std::vector<RoutePlace> places{};  ///< Contact points in order, 1 to 256.
    RouteEnd last{};                   ///< Last end.
    /// Unstretched length [m]; default: that with `tension` at the present poses.
    double length = kDefault;
    double tension = 0.0;            ///< Tension at the start if no length is given [N].
    double breaking_load = 1e30;     ///< Tension above which a part breaks [N].
    double damping_time = kDefault;  ///< Damping time of all parts [s].
};

/// Parts of a route.
struct Route {
    std::vector<BodyId> slides;            ///< One for each contact point.
    std::vector<InteractionId> parts;      ///< One more than contact points; the tension is
                                           ///< −force()[0].
    std::vector<InteractionId> frictions;  ///< One for each contact point; invalid if it has no
                                           ///< friction.
    std::vector<double> angles;            ///< Angle of the line at each contact point [rad].
};

/// Add a route, all of it or nothing; World::add() calls it.
/// @throws DefError.
Route define(World& world, const RouteDef& def);

/// State of a body, as a route requires it.
struct RouteBody {
    Vec3 position{0.0, 0.0, 0.0};  ///< Centre of mass, world frame [m].
    Quat orientation = Quat::Identity();
    BodyKind kind = BodyKind::fixed;
    double mass = 0.0;  ///< Mass [kg].
};
/// Function that returns the state of a body. It throws DefError if the body does not exist.
using RouteBodies = std::function<RouteBody(BodyId)>;

/// Add end stops to lines. A part with a fixed end (kind end_span) clamps its slide if less than 1
/// % of its length is left and more would run through. The event is `hauled_in` of the slide.
/// Running back is free. World::add() of a route calls it.
/// @param name  Unique name of the System for the end stops.
/// @throws DefError.
void stop_ends(World& world, const std::string& name, std::vector<InteractionId> parts);

/// Parts of a route, for callers that have no World yet.
struct RoutePlan {
    /// Friction at a contact point.
    struct Friction {
        std::size_t place;  ///< Index of the contact point; its loads are the parts `place` and
                            ///< `place` + 1.
        InteractionDef def;
    };
    std::vector<InteractionDef> parts;
    std::vector<Friction> frictions;
    std::vector<double> angles;  ///< As Route::angles.
};
/// Return the slides, one for each contact point.
/// @throws DefError if the definition is invalid.
[[nodiscard]] std::vector<BodyDef> route_slides(const RouteDef& def, const RouteBodies& bodies);
/// Return the interactions of a route, once its slides exist.
/// @throws DefError.
[[nodiscard]] RoutePlan plan_route(const RouteDef& def, const RouteBodies& bodies,
                                   std::span<const BodyId> slides);

}  // namespace hawser
