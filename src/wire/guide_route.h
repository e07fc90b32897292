// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_route.h
/// A guide as a route (hawser/route.h) of one place: the line between the ends of the element that
/// passes it.

#include <hawser/guide.h>

#include "wire/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace hawser::wire {

/// Return the line between the ends of the element, over the guide.
inline RouteDef route_over_guide(const GuideDef& def, const InteractionDef& element,
                                 double tension) {
    RouteDef out;
    out.EA = element.get("EA");
    out.first = {.body = element.body[0], .point = element.point[0]};
    out.last = {.body = element.body[1], .point = element.point[1]};
    out.places.push_back({.body = def.body,
                          .point = def.point,
                          .axis = def.axis,
                          .radius = def.radius,
                          .friction = def.friction,
                          .efficiency = def.efficiency,
                          .inertia = def.inertia,
                          .turns = def.turns});
    out.tension = std::max(0.0, tension);
    out.breaking_load = element.get("breaking_load");
    return out;
}

/// Return the largest angle by which the wire turns on the guide: half a turn more than defined
/// [rad].
inline double max_turning_angle(const GuideDef& def) {
    const double half = std::acos(-1.0);
    return half * (1.0 + 1e-9) + 2.0 * half * def.turns;
}

/// Return the message for a wire that would turn by more than max_turning_angle().
inline std::string turning_angle_error(const GuideDef& def, const InteractionDef& element,
                                       double tension, const RouteBodies& bodies, double angle) {
    GuideDef other = def;
    other.radius = -def.radius;
    bool lies = false;
    try {
        lies = plan_route(route_over_guide(other, element, tension), bodies, std::array{BodyId{0}})
                   .angles.front() <= max_turning_angle(def);
    } catch (const DefError&) {
        lies = false;
    }
    const std::string far =
        "the wire would turn by " + number(angle) + " rad, more than half a turn beyond `turns`";
    if (lies) return far + "; change the sign of `radius`";
    return far + ", and does not touch it with the other sign of `radius` either: the ends of '" +
           element.name +
           "', the element that passes it, are not on two sides of it; move the guide, or the "
           "nodes of the wire";
}

/// Return the message of a guide from that of its route: "route: places/0: radius: …" becomes
/// "radius: …".
inline std::string without_route(const std::string& text) {
    for (const char* lead : {"places/0: ", "route: "})
        if (const auto at = text.find(lead); at != std::string::npos)
            return text.substr(at + std::string(lead).size());
    return text;
}

}  // namespace hawser::wire
