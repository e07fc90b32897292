// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shape_data.h
/// Data of hulls, meshes and heightfields that all their copies share.

#include "base/small.h"
#include "collide/geometry.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hawser::collide {

/// Flat face of a hull: vertices loop[first … first + count), counter-clockwise seen from outside.
struct HullFace {
    std::int32_t first, count;
    generic::V3 normal;
    double offset;  ///< Offset normal · x on the face [m].
};
struct HullEdge {
    std::int32_t vertex[2], face[2];
};

/// Box around `count` triangles from `first` on (a leaf), or around two child nodes: the next node
/// and `second`.
struct MeshNode {
    double low[3], high[3];
    std::int32_t first, count, second;
};

struct ShapeData {
    ShapeKind kind = ShapeKind::hull;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  ///< Box in the frame of the shape [m].
    std::vector<generic::V3> vertices;  ///< Vertices; of a hull only those on its surface.
    // Data of a hull.
    generic::V3 middle{0, 0, 0};  ///< Mean of the vertices, within the hull [m].
    std::vector<HullFace> faces;
    std::vector<std::int32_t> loop;       ///< Vertices of the faces.
    std::vector<std::int32_t> loop_edge;  ///< Edge from loop[i] to the next vertex of its face.
    std::vector<HullEdge> edges;
    /// Edges of vertex v: star_edge[star[v]] to star_edge[star[v + 1] − 1].
    std::vector<std::int32_t> star, star_edge;
    // Data of a mesh. Edge k of a triangle runs from corner k to the next.
    /// Three vertices per triangle, in the order of the tree.
    std::vector<std::int32_t> triangles;
    std::vector<std::int32_t> names;  ///< Index in the definition, by triangle.
    /// Third vertex of the neighbour across each edge, by triangle and edge. −1 at the border and
    /// if more than two triangles share the edge.
    std::vector<std::int32_t> opposite;
    std::vector<std::int32_t> ring, ring_first;  ///< Vertices around vertex v, stored like `star`.
    std::vector<MeshNode> nodes;
    // Data of a heightfield.
    int rows = 0, columns = 0;
    double cell[2] = {0, 0};
    std::vector<double> heights;
};

/// Check a hull, mesh or heightfield and prepare its data. @return null for other kinds. Limits:
/// hull: 65,536 points, 4,096 of them on the surface; mesh: 1,048,576 triangles and as many
/// vertices; heightfield: 16,777,216 nodes. @throws DefError that names the field.
[[nodiscard]] std::unique_ptr<ShapeData> make_shape_data(const ShapeDef& def);

namespace narrow {
// Steps of make_shape_data(), in hull.cpp, mesh.cpp, heightfield.cpp.
void make_hull(const ShapeDef& def, ShapeData& out);
void make_mesh(const ShapeDef& def, ShapeData& out);
void make_heightfield(const ShapeDef& def, ShapeData& out);
/// Throw a DefError about a field of the shape.
[[noreturn]] void throw_shape_error(const ShapeDef& def, const std::string& what);
}  // namespace narrow

}  // namespace hawser::collide
