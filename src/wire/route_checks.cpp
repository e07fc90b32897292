// SPDX-License-Identifier: Apache-2.0
#include "wire/route_checks.h"

#include "wire/bounds.h"

#include <cmath>
#include <string>

namespace hawser::wire {
namespace {

constexpr int kMaxPlaces = 256, kMaxTurns = 100;

void check_position(const RouteBodies& bodies, const RouteDef& def, std::size_t i) {
    const RoutePlace& p = def.places[i];
    const std::string where = "places/" + std::to_string(i) + ": ";
    const BodyKind kind = bodies(p.body).kind;
    if (kind == BodyKind::scalar)
        throw_def_error(def, where + "a scalar body has no position in space");
    if (kind == BodyKind::lump && (p.radius != 0.0 || !p.point.isZero(0.0)))
        throw_def_error(def, where + "a point mass has neither a wheel nor points");
    if (!(std::abs(p.radius) <= 1e3)) throw_def_error(def, where + "radius: give -1000 to 1000 m");
    if (!(p.efficiency > 0.0 && p.efficiency <= 1.0))
        throw_def_error(def, where + "efficiency = " + number(p.efficiency) + "; give (0, 1]");
    if (!(p.friction >= 0.0 && p.friction <= 10.0))
        throw_def_error(def, where + "friction = " + number(p.friction) + "; give 0 to 10");
    if (!(p.inertia >= 0.0 && p.inertia <= 1e12))
        throw_def_error(def, where + "inertia = " + number(p.inertia) + " kg m^2; give 0 to 1e12");
    if (p.inertia > 0.0 && p.radius == 0.0)
        throw_def_error(def, where + "inertia: only a wheel with a radius has one");
    if (p.turns < 0 || p.turns > kMaxTurns) throw_def_error(def, where + "turns: give 0 to 100");
    if (p.turns > 0 && p.radius == 0.0)
        throw_def_error(def, where + "turns: an eye has none; give a radius");
    if (p.radius != 0.0 && !(p.axis.norm() > 1e-9 && p.axis.allFinite()))
        throw_def_error(def, where + "axis: give a direction");
    if (!p.point.allFinite()) throw_def_error(def, where + "point: give numbers");
    if (!std::isnan(p.angle) && !(p.angle >= 0.0 && p.angle <= 1e3))
        throw_def_error(def, where + "angle = " + number(p.angle) + " rad; give 0 to 1000");
}

}  // namespace

void throw_def_error(const RouteDef& def, const std::string& why) {
    throw DefError("route" + (def.name.empty() ? std::string() : " '" + def.name + "'") + ": " +
                   why);
}

void check(const RouteBodies& bodies, const RouteDef& def) {
    if (!(def.EA > 0.0 && def.EA <= 1e15)) throw_def_error(def, "EA: give its axial stiffness [N]");
    if (def.places.empty() || def.places.size() > kMaxPlaces)
        throw_def_error(def, "places: give 1 to 256 turning points");
    for (const RouteEnd* e : {&def.first, &def.last}) {
        const std::string where = e == &def.first ? "first: " : "last: ";
        const RouteBody body = bodies(e->body);
        if (body.kind == BodyKind::scalar)
            throw_def_error(def,
                            where + "a scalar body has no position in space; name it as the drum");
        if (body.kind == BodyKind::lump && !e->point.isZero(0.0))
            throw_def_error(def, where + "a lump is a point; leave the point on it at 0");
        if (e->drum.valid() && bodies(e->drum).kind != BodyKind::scalar)
            throw_def_error(def, where + "its drum must be a scalar body");
        if (e->drum.valid() && !(std::abs(e->radius) > 0.0 && std::abs(e->radius) <= 1e3))
            throw_def_error(
                def, where + "radius: give the length that its drum pays out per radian [m]");
    }
    for (std::size_t i = 0; i < def.places.size(); ++i) check_position(bodies, def, i);
    if (!std::isnan(def.length) && !(def.length > 0.0))
        throw_def_error(def, "length: give more than 0 m");
    if (!(def.tension >= 0.0) || !std::isfinite(def.tension))
        throw_def_error(def, "tension: give 0 N or more");
}

}  // namespace hawser::wire
