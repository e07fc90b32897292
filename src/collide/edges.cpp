// SPDX-License-Identifier: Apache-2.0
/// Convex edges of boxes, hulls and meshes (hawser/edges.h).
#include <hawser/def.h>
#include <hawser/edges.h>

#include "collide/narrow/shape_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace hawser {
namespace {

using collide::HullFace;
using collide::ShapeData;

/// Tolerance of equal directions.
constexpr double kSameDirection = 1e-6;

Vec3 vector_of(const generic::V3& v) { return {v.x, v.y, v.z}; }

/// A part of an edge, by its vertices, in the frame of the shape.
struct Piece {
    int vertex[2];
    Vec3 normal[2];  ///< Normals of its faces.
    double most_radius = std::numeric_limits<double>::infinity();
};

/// Return the hull of the corners of a box.
ShapeDef hull_of_box(const ShapeDef& box) {
    ShapeDef out = box;
    out.kind = ShapeKind::hull;
    for (int k = 0; k < 8; ++k)
        out.vertices.push_back(box.half_size.cwiseProduct(
            Vec3((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1)));
    return out;
}

/// Return the largest radius of a cylinder that fits along an edge inside the body and touches both
/// faces. The axis of a cylinder of radius r is r/cos(turn/2) inside the middle of the edge. It is
/// one radius from another face if r (1 − n·outward/cos(turn/2)) equals the distance to that face.
/// Faces at the ends of the edge may cut the cylinder.
double max_cylinder_radius(const ShapeData& hull, const Piece& piece) {
    const Vec3 bisector = (piece.normal[0] + piece.normal[1]).normalized();
    const double half_turn = bisector.dot(piece.normal[0]);
    const Vec3 end[2] = {vector_of(hull.vertices[static_cast<std::size_t>(piece.vertex[0])]),
                         vector_of(hull.vertices[static_cast<std::size_t>(piece.vertex[1])])};
    const double length = (end[1] - end[0]).norm();
    double most = std::numeric_limits<double>::infinity();
    for (const HullFace& face : hull.faces) {
        const Vec3 n = vector_of(face.normal);
        const double way[2] = {face.offset - n.dot(end[0]), face.offset - n.dot(end[1])};
        if (std::min(way[0], way[1]) < kSameDirection * length) continue;
        const double grows = 1.0 - n.dot(bisector) / half_turn;
        if (grows > 0.0) most = std::min(most, 0.5 * (way[0] + way[1]) / grows);
    }
    return most;
}

std::vector<Piece> edges_of_hull(const ShapeData& hull) {
    std::vector<Piece> out;
    for (const collide::HullEdge& edge : hull.edges) {
        Piece piece{{edge.vertex[0], edge.vertex[1]},
                    {vector_of(hull.faces[static_cast<std::size_t>(edge.face[0])].normal),
                     vector_of(hull.faces[static_cast<std::size_t>(edge.face[1])].normal)}};
        piece.most_radius = max_cylinder_radius(hull, piece);
        out.push_back(piece);
    }
    return out;
}

std::vector<Piece> edges_of_mesh(const ShapeData& mesh) {
    std::vector<Piece> out;
    std::set<std::pair<int, int>> seen;
    const auto place = [&](int v) { return vector_of(mesh.vertices[static_cast<std::size_t>(v)]); };
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const std::size_t first = k - k % 3;
        const int i = mesh.triangles[k], j = mesh.triangles[first + (k + 1) % 3],
                  own = mesh.triangles[first + (k + 2) % 3], other = mesh.opposite[k];
        if (other < 0 || !seen.insert(std::minmax(i, j)).second) continue;
        const Vec3 a = place(i), b = place(j);
        const Vec3 n = (b - a).cross(place(own) - a).normalized(),
                   m = (a - b).cross(place(other) - b).normalized();
        if (n.dot(place(other) - a) < 0.0) out.push_back({{i, j}, {n, m}});
    }
    return out;
}

/// True if two pieces that meet at a vertex belong to one edge.
bool continues_straight(const ShapeData& data, const Piece& a, const Piece& b, int vertex) {
    const auto other = [&](const Piece& p) {
        const int v = p.vertex[0] == vertex ? p.vertex[1] : p.vertex[0];
        return vector_of(data.vertices[static_cast<std::size_t>(v)]);
    };
    const Vec3 at = vector_of(data.vertices[static_cast<std::size_t>(vertex)]);
    const Vec3 u = (at - other(a)).normalized(), v = (other(b) - at).normalized();
    const auto same = [](const Vec3& x, const Vec3& y) { return (x - y).norm() < kSameDirection; };
    return same(u, v) && ((same(a.normal[0], b.normal[0]) && same(a.normal[1], b.normal[1])) ||
                          (same(a.normal[0], b.normal[1]) && same(a.normal[1], b.normal[0])));
}

/// Join pieces of edges into one edge if they meet at a vertex and continue straight.
void join(const ShapeData& data, std::vector<Piece>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1; j < pieces.size();) {
            std::optional<int> at;
            for (const int v : pieces[i].vertex)
                for (const int w : pieces[j].vertex)
                    if (v == w && continues_straight(data, pieces[i], pieces[j], v)) at = v;
            if (!at) {
                ++j;
                continue;
            }
            int& own = pieces[i].vertex[pieces[i].vertex[0] == *at ? 0 : 1];
            own = pieces[j].vertex[pieces[j].vertex[0] == *at ? 1 : 0];
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;
        }
}

double distance_from_edge(const ShapeEdge& edge, const Vec3& p) noexcept {
    const Vec3 d = edge.to - edge.from;
    const double t = std::clamp((p - edge.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - edge.from - t * d).norm();
}

}  // namespace

std::vector<ShapeEdge> convex_edges(const ShapeDef& shape, double sharper_than) {
    const bool box = shape.kind == ShapeKind::box;
    if (!box && shape.kind != ShapeKind::hull && shape.kind != ShapeKind::mesh)
        throw DefError((shape.name.empty() ? "shape" : "shape '" + shape.name + "'") + ": a " +
                       to_string(shape.kind) + " has no edges; give a box, hull or mesh");
    const std::unique_ptr<ShapeData> data =
        collide::make_shape_data(box ? hull_of_box(shape) : shape);
    std::vector<Piece> pieces =
        shape.kind == ShapeKind::mesh ? edges_of_mesh(*data) : edges_of_hull(*data);
    const auto turn_of = [](const Piece& p) {
        return 2.0 * std::asin(std::min(1.0, 0.5 * (p.normal[0] - p.normal[1]).norm()));
    };
    std::erase_if(pieces, [&](const Piece& p) { return !(turn_of(p) > sharper_than); });
    join(*data, pieces);
    std::vector<ShapeEdge> out;
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    for (const Piece& p : pieces) {
        ShapeEdge& edge = out.emplace_back();
        Vec3 end[2];
        for (const std::size_t k : {0U, 1U})
            end[k] = shape.position +
                     shape.orientation *
                         vector_of(data->vertices[static_cast<std::size_t>(p.vertex[k])]);
        if (before(end[1], end[0])) std::swap(end[0], end[1]);
        edge.from = end[0];
        edge.to = end[1];
        edge.outward = (shape.orientation * (p.normal[0] + p.normal[1])).normalized();
        edge.turn = turn_of(p);
        edge.most_radius = p.most_radius;
    }
    std::sort(out.begin(), out.end(), [&](const ShapeEdge& a, const ShapeEdge& b) {
        return before(a.from, b.from) || (a.from == b.from && before(a.to, b.to));
    });
    return out;
}

EdgeAxis axis_in_edge(const ShapeEdge& edge, double radius) noexcept {
    const Vec3 inside = -radius / std::cos(0.5 * edge.turn) * edge.outward;
    return {edge.from + inside, edge.to + inside};
}

double distance_to_edge(const ShapeEdge& edge, const Vec3& a, const Vec3& b) noexcept {
    return std::max(distance_from_edge(edge, a), distance_from_edge(edge, b));
}

}  // namespace hawser
