// SPDX-License-Identifier: Apache-2.0
/// Read posts: cylinders on bodies, which touching cables engage (hawser/post.h).
#include <hawser/post.h>

#include "scene/description.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
    if (const auto slides = json.find("slides"); slides != json.end())
        def.slides = slides->get<bool>();
    return def;
}

/// Return the axis of a cylinder along an edge of the body's box. It lies within the box, so that
/// the cylinder touches both faces of the edge over its whole length.
EdgeAxis edge_axis(const BodyDef& body, const Json& json, const SourceLocation& location) {
    const Vec3 toward = vector_of(json["edge"]), half = body.half_size;
    int along = -1;
    bool is_edge = true;
    for (int k = 0; k < 3; ++k) {
        is_edge = is_edge && (toward[k] == 0.0 ? along < 0 : std::abs(toward[k]) == 1.0);
        if (toward[k] == 0.0) along = k;
    }
    if (!is_edge || along < 0)
        throw_error(location / "edge",
                    "give 1, -1 and one 0: [1, 0, 1] is the edge of the faces +x and +z, along y");
    if (!(half.minCoeff() > 0.0))
        throw_error(location / "edge", "its body has no box; give that \"box\" or \"half_size\"");
    const double radius = json["radius"].get<double>();
    Vec3 centre = Vec3::Zero(), end = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (k == along) continue;
        if (radius > half[k])
            throw_error(location / "radius", "the box of its body is thinner than the cylinder");
        centre[k] = toward[k] * (half[k] - radius);
    }
    end[along] = half[along];
    return {centre - end, centre + end};
}

/// Return the axis, or all axes that "edge_of" names.
std::vector<EdgeAxis> edge_axes(const Description& out, BodyId body, const Json& json,
                                const SourceLocation& location) {
    for (const char* edge : {"edge", "edge_of"})
        for (const char* other : {"from", "to", "edge_of"})
            if (json.contains(edge) && json.contains(other) && std::string_view(edge) != other)
                throw_error(location / other, "the axis is that of \"" + std::string(edge) +
                                                  "\"; leave out one of the two");
    if (json.contains("edge")) return {edge_axis(out.body(body), json, location)};
    if (json.contains("edge_of"))
        return axes_of_edges(out, body, json["edge_of"], json["radius"].get<double>(),
                             location / "edge_of");
    for (const char* end : {"from", "to"})
        if (!json.contains(end))
            throw_error(location,
                        std::string("a post needs \"") + end +
                            "\", or \"edge\" of its body's box, or \"edge_of\" of a shape");
    const EdgeAxis axis{vector_of(json["from"]), vector_of(json["to"])};
    if (!((axis.to - axis.from).norm() > 0.0))
        throw_error(location / "to", "its axis has no length: \"from\" is there, too");
    return {axis};
}

ShapeDef post_shape_def(Description& out, BodyId body, const EdgeAxis& axis, const Json& json,
                        const SourceLocation& location) {
    ShapeDef def;
    def.kind = ShapeKind::cylinder;
    def.body = body;
    const double length = (axis.to - axis.from).norm();
    def.position = 0.5 * (axis.from + axis.to);
    def.orientation = turn_between(Vec3::UnitZ(), (axis.to - axis.from) / length);
    def.radius = json["radius"].get<double>();
    def.half_length = 0.5 * length;
    def.margin = number_or(json, "margin", 1.0);
    read_surface(def, out, json, location);
    return def;
}

void expand_post(Description& out, const Scope& scope, const Json& json,
                 const SourceLocation& location) {
    const PostDef def = read_post(scope, json);
    const BodyId body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    const std::vector<EdgeAxis> axes = edge_axes(out, body, json, location);
    // If there are several edges, each is a post with its own number.
    const auto of = json.find("edge_of");
    const bool several = of != json.end() && of->contains("sharper_than");
    for (std::size_t k = 0; k < axes.size(); ++k) {
        PostItem item{def, out.store_location(location)};
        if (several) item.def.name += "/" + std::to_string(k + 1);
        for (const PostItem& other : out.posts)
            if (other.def.name == item.def.name)
                throw_error(location / "name",
                            "the post " + in_quotes(item.def.name) + " exists already");
        ShapeDef shape = post_shape_def(out, body, axes[k], json, location);
        shape.name = item.def.name;
        out.add_shape(std::move(shape), item.location);
        out.posts.push_back(std::move(item));
    }
}

}  // namespace

void expand_posts(Description& out, const Scope& scope) {
    const auto list = scope.content->find("posts");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / "posts" / i;
        (void)attempt(out.mistakes, [&] { expand_post(out, scope, json, location); });
    }
}

}  // namespace hawser::scene
