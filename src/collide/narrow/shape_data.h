// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shape_data.h
/// What hulls, meshes and heightfields share between all their copies.

#include "base/small.h"
#include "collide/geometry.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hawser::collide {

/// Flat face of a hull: vertices loop[first … first + count), counter-clockwise from outside.
struct HullFace {
    std::int32_t first, count;
    generic::V3 normal;
    double offset;  ///< normal · x on the face [m].
};
struct HullEdge {
    std::int32_t vertex[2], face[2];
};

/// Box around `count` triangles from `first` on (a leaf), or around two nodes: the next one and
/// `second`.
struct MeshNode {
    double low[3], high[3];
    std::int32_t first, count, second;
};

struct ShapeData {
    ShapeKind kind = ShapeKind::hull;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  ///< Box in the shape's frame [m].
    std::vector<generic::V3> vertices;               ///< Hull: those on its surface only.
    // Hull.
    generic::V3 middle{0, 0, 0};  ///< Mean of the vertices, within the hull [m].
    std::vector<HullFace> faces;
    std::vector<std::int32_t> loop;       ///< Vertices of the faces.
    std::vector<std::int32_t> loop_edge;  ///< Edge from loop[i] to the next of its face.
    std::vector<HullEdge> edges;
    std::vector<std::int32_t> star, star_edge;  ///< Edges of vertex v: from star[v] to star[v+1].
    // Mesh. Edge k of a triangle runs from corner k to the next.
    std::vector<std::int32_t> triangles;  ///< Three vertices each, in the order of the tree.
    std::vector<std::int32_t> names;      ///< Index in the definition, by triangle.
    /// By triangle and edge: third vertex of the neighbour across it; −1 at the border, or where
    /// more than two triangles meet.
    std::vector<std::int32_t> opposite;
    std::vector<std::int32_t> ring, ring_first;  ///< Vertices around vertex v, as `star`.
    std::vector<MeshNode> nodes;
    // Heightfield.
    int rows = 0, columns = 0;
    double cell[2] = {0, 0};
    std::vector<double> heights;
};

/// Checked and prepared data of a hull, mesh or heightfield; null for other kinds.
/// Limits: hull: 65,536 points, of which 4,096 on the surface; mesh: 1,048,576 triangles and as
/// many vertices; heightfield: 16,777,216 nodes.
/// @throws DefError that names the field.
[[nodiscard]] std::unique_ptr<ShapeData> make_shape_data(const ShapeDef& def);

namespace narrow {
// Parts of it, in hull.cpp, mesh.cpp, heightfield.cpp.
void make_hull(const ShapeDef& def, ShapeData& out);
void make_mesh(const ShapeDef& def, ShapeData& out);
void make_heightfield(const ShapeDef& def, ShapeData& out);
/// Throws a DefError about the shape's field.
[[noreturn]] void refuse(const ShapeDef& def, const std::string& what);
}  // namespace narrow

}  // namespace hawser::collide
