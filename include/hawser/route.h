// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file route.h
/// A line without mass that runs over bollards, pins, eyes and sheaves: hoists, tackles, brakes of
/// a rope round a post.
///
/// ```cpp
/// const hawser::Route hoist = world.add(hawser::RouteDef{
///     .name = "hoist", .EA = 5e7,
///     .first = {.body = drum_deck, .point = {0, 0, 1}, .drum = drum, .radius = 0.4},
///     .places = {{.body = boom, .point = {30, 0, 0}, .efficiency = 0.98},
///                {.body = block, .point = {0, 0, 0.5}, .efficiency = 0.98}},
///     .last = {.body = boom, .point = {30.5, 0, 0}}});
/// ```
/// The line is one piece: what leaves the part before a place enters the part behind it. Its parts
/// are interactions of kind span, end_span and body_span, its friction scalar_friction, its
/// *slides* scalar bodies next to no mass, whose coordinate tells how much has run through [m]
/// (src/model/kinds/routes.h); outputs and events know them by their names, "hoist/part2",
/// "hoist/friction1", "hoist/slide1".
///
/// Friction. Turning by an angle δ at a place, the tensions before and behind differ by a factor of
/// e^{μδ} at most, exactly (solve/capstans.h); a sheave of efficiency η by 1/η. Below that nothing
/// creeps.
///
/// The end of a line stops at the place that it comes to (stop_ends()).
///
/// Limits: friction is that of the angle at the start; the stiffness of a part stays EA over its
/// length at the start; tension alone, no weight, no bending. Places on one body that follow each
/// other keep the length between them.
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

/// Where a line ends: at a point of a body, or on a drum behind it.
struct RouteEnd {
    BodyId body{};              ///< Required; a lump, or any that has a place in space.
    Vec3 point{0.0, 0.0, 0.0};  ///< In its frame [m]; of a lump 0.
    BodyId drum{};              ///< A scalar body that the line is wound on. None: it is made fast.
    double radius = 0.0;        ///< Line that the drum pays out per unit of its coordinate [m].
};

/// What a line runs over.
struct RoutePlace {
    BodyId body{};              ///< Required; not a lump where `radius` is not 0.
    Vec3 point{0.0, 0.0, 0.0};  ///< Eye, or centre of the wheel, in the frame of the body [m].
    Vec3 axis{0.0, 1.0, 0.0};   ///< Of the wheel, in the frame of the body.
    /// Of the wheel [m], 0: an eye. The line turns about +axis where it is above 0, as seen along
    /// the route, about −axis where it is below.
    double radius = 0.0;
    double friction = 0.0;    ///< μ of the line on what it runs over.
    double efficiency = 1.0;  ///< η of a sheave: lesser tension over greater; (0, 1].
    double inertia = 0.0;     ///< Of the sheave [kg m²]; needs a radius.
    int turns = 0;            ///< Whole turns more round the wheel, 0 to 100.
    /// Angle by which the line turns here, with whole turns [rad]. kDefault: as it lies.
    double angle = kDefault;
};

struct RouteDef {
    std::string name{};    ///< Unique in the world, or empty.
    double EA = kDefault;  ///< Axial stiffness [N]. Required.
    RouteEnd first{};
    std::vector<RoutePlace> places{};  ///< In order, 1 to 256.
    RouteEnd last{};
    /// Length without tension [m]. kDefault: as it lies with `tension`.
    double length = kDefault;
    double tension = 0.0;            ///< At the start, where no length is given [N].
    double breaking_load = 1e30;     ///< Each part breaks above this tension [N].
    double damping_time = kDefault;  ///< Of all parts [s].
};

struct Route {
    std::vector<BodyId> slides;            ///< One a place.
    std::vector<InteractionId> parts;      ///< One more than places; tension is −force()[0].
    std::vector<InteractionId> frictions;  ///< One a place; invalid where there is none.
    std::vector<double> angles;            ///< By which the line turns at each place [rad].
};

/// What World::add() of a route calls. All or nothing. @throws DefError.
Route define(World& world, const RouteDef& def);

/// A body as a route meets it.
struct RouteBody {
    Vec3 position{0.0, 0.0, 0.0};  ///< Of its centre of mass, world frame [m].
    Quat orientation = Quat::Identity();
    BodyKind kind = BodyKind::fixed;
    double mass = 0.0;  ///< [kg]
};
/// How to find it. @throws DefError where there is none.
using RouteBodies = std::function<RouteBody(BodyId)>;

/// Stop the ends of lines at the places that they run through. A part whose end is made fast to a
/// body (kind end_span) holds its slide when less than 1 % of its length is left and more would run
/// through; the event `hauled_in` of the slide is reported. Running back is free. World::add() of a
/// route does it by itself. @param name  Of the System that does it; unique. @throws DefError.
void stop_ends(World& world, const std::string& name, std::vector<InteractionId> parts);

/// What a route is made of, for those that have no World yet.
struct RoutePlan {
    struct Friction {
        std::size_t place;  ///< Its loads are the parts `place` and `place` + 1.
        InteractionDef def;
    };
    std::vector<InteractionDef> parts;
    std::vector<Friction> frictions;
    std::vector<double> angles;  ///< As Route::angles.
};
/// The slides, one a place. @throws DefError on anything wrong with the definition.
[[nodiscard]] std::vector<BodyDef> route_slides(const RouteDef& def, const RouteBodies& bodies);
/// All that acts between them, once they are there. @throws DefError.
[[nodiscard]] RoutePlan plan_route(const RouteDef& def, const RouteBodies& bodies,
                                   std::span<const BodyId> slides);

}  // namespace hawser
