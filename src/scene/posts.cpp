// SPDX-License-Identifier: Apache-2.0
/// Posts: a cylinder on a body, and what takes cables that touch it (hawser/post.h).
#include <hawser/post.h>

#include "scene/description.h"

#include <string>
#include <utility>

namespace hawser::scene {
namespace {

PostDef read_post(const Scope& scope, const Json& json) {
    PostDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.friction = number_or(json, "friction", def.friction);
    def.efficiency = number_or(json, "efficiency", def.efficiency);
    def.inertia = number_or(json, "inertia", def.inertia);
    if (const auto wires = json.find("wires"); wires != json.end()) def.wires = wires->get<int>();
    def.element_length = number_or(json, "element", def.element_length);
    return def;
}

ShapeDef shape_of(Description& out, const Scope& scope, const Json& json, const Place& place) {
    ShapeDef def;
    def.kind = ShapeKind::cylinder;
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), place / "on");
    const Vec3 from = vector_of(json["from"]), to = vector_of(json["to"]);
    const double length = (to - from).norm();
    if (!(length > 0.0)) refuse(place / "to", "its axis has no length: \"from\" is there, too");
    def.position = 0.5 * (from + to);
    def.orientation = turn_between(Vec3::UnitZ(), (to - from) / length);
    def.radius = json["radius"].get<double>();
    def.half_length = 0.5 * length;
    def.margin = number_or(json, "margin", 1.0);
    read_surface(def, out, json, place);
    return def;
}

}  // namespace

void expand_posts(Description& out, const Scope& scope) {
    const auto list = scope.content->find("posts");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const Place place = scope.place / "posts" / i;
        (void)attempt(out.mistakes, [&] {
            PostDef def = read_post(scope, json);
            for (const PostItem& other : out.posts)
                if (other.def.name == def.name)
                    refuse(place / "name", "the post " + in_quotes(def.name) + " exists already");
            ShapeDef shape = shape_of(out, scope, json, place);
            shape.name = def.name;
            const int at = out.keep(place);
            out.add_shape(std::move(shape), at);
            out.posts.push_back({std::move(def), at});
        });
    }
}

}  // namespace hawser::scene
