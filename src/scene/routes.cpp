// SPDX-License-Identifier: Apache-2.0
/// Lines over posts and sheaves. Their parts become bodies and interactions of the scene, which
/// inputs and outputs find by name.
#include "scene/description.h"

#include <hawser/route.h>

#include <string>
#include <vector>

namespace hawser::scene {
namespace {

RouteEnd read_end(Description& out, const Scope& scope, const Json& json,
                  const SourceLocation& location) {
    RouteEnd end;
    end.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    end.point = vector_or(json, "point", end.point);
    if (const auto drum = json.find("drum"); drum != json.end())
        end.drum = resolve_body(out, scope, drum->get<std::string>(), location / "drum");
    end.radius = number_or(json, "radius", end.radius);
    return end;
}

RoutePlace read_contact_point(Description& out, const Scope& scope, const Json& json,
                              const SourceLocation& location) {
    RoutePlace p;
    p.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    p.point = vector_or(json, "point", p.point);
    p.axis = vector_or(json, "axis", p.axis);
    p.radius = number_or(json, "radius", p.radius);
    p.friction = number_or(json, "friction", p.friction);
    p.efficiency = number_or(json, "efficiency", p.efficiency);
    p.inertia = number_or(json, "inertia", p.inertia);
    p.angle = number_or(json, "angle", p.angle);
    if (const auto turns = json.find("turns"); turns != json.end()) p.turns = turns->get<int>();
    return p;
}

void read_route(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location) {
    RouteDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.EA = json["EA"].get<double>();
    def.first = read_end(out, scope, json["first"], location / "first");
    def.last = read_end(out, scope, json["last"], location / "last");
    const Json& places = json["places"];
    for (std::size_t i = 0; i < places.size(); ++i)
        def.places.push_back(read_contact_point(out, scope, places[i], location / "places" / i));
    def.length = number_or(json, "length", def.length);
    def.tension = number_or(json, "tension", def.tension);
    def.breaking_load = number_or(json, "breaking_load", def.breaking_load);
    def.damping_time = number_or(json, "damping_time", def.damping_time);

    const RouteBodies bodies = [&out](BodyId id) {
        const BodyDef& b = out.body(id);
        return RouteBody{b.position, b.orientation.normalized(), b.kind, b.mass};
    };
    const int at = out.store_location(location);
    try {
        std::vector<BodyId> slides;
        // Plan all parts before any is added.
        const std::vector<BodyDef> made = route_slides(def, bodies);
        RoutePlan plan = plan_route(def, bodies, std::vector<BodyId>(made.size(), BodyId{0}));
        for (const BodyDef& slide : made) slides.push_back(out.add_body(slide, at));
        plan = plan_route(def, bodies, slides);
        std::vector<InteractionId> parts;
        for (InteractionDef& part : plan.parts)
            parts.push_back(out.add_interaction(std::move(part), at));
        for (RoutePlan::Friction& f : plan.frictions) {
            for (std::size_t k = 0; k < 2; ++k) f.def.load[k].interaction = parts[f.place + k];
            out.add_interaction(std::move(f.def), at);
        }
    } catch (const DefError& error) {
        throw_error(location, library_words(error));
    }
}

}  // namespace

void expand_routes(Description& out, const Scope& scope) {
    const auto list = scope.content->find("routes");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / "routes" / i;
        (void)attempt(out.mistakes, [&] { read_route(out, scope, json, location); });
    }
}

}  // namespace hawser::scene
