// SPDX-License-Identifier: Apache-2.0
/// Posts in the edges of a body's shapes (hawser/edges.h).
#include <hawser/edges.h>

#include "scene/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::scene {
namespace {

constexpr std::size_t kMaxEdges = 64;  ///< Largest number of edges of one post.
constexpr double kMaxEdgeDistance =
    0.1;  ///< Largest distance of an edge from two points, relative to their distance.
constexpr double kAnyTurn = 1e-3;  ///< Least angle of an edge that two points define [rad].

bool has_edges(const ShapeDef& shape) {
    return shape.kind == ShapeKind::box || shape.kind == ShapeKind::hull ||
           shape.kind == ShapeKind::mesh;
}

/// Return the shape that the key "shape" names; without this key, the only shape with edges.
const ShapeDef& shape_with_edges(const Description& out, BodyId body, const Json& json,
                                 const SourceLocation& location) {
    const std::string on = out.body(body).name, lead = on + "/";
    const std::string shape_name = text_or(json, "shape", "");
    std::vector<const ShapeDef*> candidates;
    std::vector<std::string> known;
    for (const ShapeDef& shape : out.shapes) {
        if (shape.body != body) continue;
        if (!shape_name.empty() && shape.name == lead + shape_name) {
            if (!has_edges(shape))
                throw_error(location / "shape", "a " + std::string(to_string(shape.kind)) +
                                                    " has no edges; name a box, hull or mesh");
            return shape;
        }
        if (!has_edges(shape)) continue;
        candidates.push_back(&shape);
        if (shape.name.starts_with(lead)) known.push_back(shape.name.substr(lead.size()));
    }
    if (!shape_name.empty())
        throw_error(location / "shape", in_quotes(on) + " has no shape " + in_quotes(shape_name) +
                                            " with edges" + suggestion(shape_name, known));
    if (candidates.empty())
        throw_error(location, in_quotes(on) +
                                  " has no shape with edges; give its \"shapes\" a box, hull "
                                  "or mesh");
    if (candidates.size() > 1)
        throw_error(location, in_quotes(on) +
                                  " has several shapes with edges; give the \"shape\" by name" +
                                  suggestion("", known));
    return *candidates.front();
}

std::string words(const Vec3& v) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x(), v.y(), v.z());
}

/// Return the edge with the smallest distance to two points.
ShapeEdge edge_near(const std::vector<ShapeEdge>& edges, const Vec3& a, const Vec3& b,
                    const SourceLocation& location) {
    if (!((b - a).norm() > 0.0)) throw_error(location, "give two different points");
    if (edges.empty()) throw_error(location, "the shape has no convex edge");
    const auto best =
        std::min_element(edges.begin(), edges.end(), [&](const auto& x, const auto& y) {
            return distance_to_edge(x, a, b) < distance_to_edge(y, a, b);
        });
    const double far = distance_to_edge(*best, a, b);
    if (far > kMaxEdgeDistance * (b - a).norm())
        throw_error(location, fmt::format("no convex edge is within a tenth of their distance; the "
                                          "nearest, {:.3g} m away, goes from {} to {}",
                                          far, words(best->from), words(best->to)));
    return *best;
}

}  // namespace

std::vector<EdgeAxis> axes_of_edges(const Description& out, BodyId body, const Json& json,
                                    double radius, const SourceLocation& location) {
    if (json.contains("near") == json.contains("sharper_than"))
        throw_error(location,
                    "give either two points \"near\" the edge, or \"sharper_than\" for all");
    const ShapeDef& shape = shape_with_edges(out, body, json, location);
    const double least = number_or(json, "sharper_than", kAnyTurn);
    std::vector<ShapeEdge> edges;
    try {
        edges = convex_edges(shape, least);
    } catch (const DefError& error) {
        throw_error(location, error.what());
    }
    if (json.contains("near")) {
        const Json& near = json["near"];
        edges = {edge_near(edges, vector_of(near[0]), vector_of(near[1]), location / "near")};
    } else if (edges.empty() || edges.size() > kMaxEdges) {
        throw_error(location / "sharper_than",
                    edges.empty()
                        ? "no convex edge of the shape is so sharp"
                        : fmt::format("{} edges are so sharp, of at most {}; give a larger "
                                      "angle, or points \"near\" one",
                                      edges.size(), kMaxEdges));
    }
    std::vector<EdgeAxis> axes;
    for (const ShapeEdge& edge : edges) {
        if (radius > edge.most_radius * (1.0 + 1e-9))
            throw_error(location,
                        fmt::format("the shape is thinner than the cylinder at its edge from {} "
                                    "to {}: its radius there is at most {:.4g} m",
                                    words(edge.from), words(edge.to), edge.most_radius));
        axes.push_back(axis_in_edge(edge, radius));
    }
    return axes;
}

}  // namespace hawser::scene
