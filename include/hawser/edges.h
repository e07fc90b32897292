// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edges.h
/// Convex edges of boxes, hulls and meshes, and the cylinder that a wire lies on there (post.h).
///
/// ```
///            outward              A cylinder of radius r lies against both faces, as if the edge
///                ↖ ______         were rounded: its axis is r/cos(turn/2) inside of the edge,
///                 ╱              turn the angle between the normals of the faces.
///        face    ╱ (r)
/// ```
/// Pieces of an edge that go on straight between the same two planes are one. Limits: triangles of
/// a mesh are counterclockwise seen from outside; where it ends, and where more than two triangles
/// meet, it has no edge. Of a mesh nobody looks whether the cylinder is thicker than the solid.

#include <hawser/math.h>
#include <hawser/shapes.h>

#include <limits>
#include <vector>

namespace hawser {

/// An edge in the frame of the shape's body.
struct ShapeEdge {
    Vec3 from{0, 0, 0}, to{0, 0, 0};  ///< [m].
    Vec3 outward{0, 0, 1};            ///< Unit, half-way between the normals of both faces.
    double turn = 0.0;                ///< Angle between these normals [rad], above 0, below π.
    /// Of a cylinder that lies within the shape against both faces [m]; of a mesh infinite.
    double most_radius = std::numeric_limits<double>::infinity();
};

/// Edges that turn by more than an angle [rad], in the order of their first ends along x, y, z.
/// Empty: it has none so sharp. @throws DefError where the shape is no box, hull or mesh, or none
/// that can be.
[[nodiscard]] std::vector<ShapeEdge> convex_edges(const ShapeDef& shape, double sharper_than);

/// Ends of the axis of a cylinder that lies against both faces. @param radius  [m].
struct EdgeAxis {
    Vec3 from, to;  ///< In the frame of the body [m].
};
[[nodiscard]] EdgeAxis axis_in_edge(const ShapeEdge& edge, double radius) noexcept;

/// From the farther one of two points to an edge [m].
[[nodiscard]] double distance_to_edge(const ShapeEdge& edge, const Vec3& a, const Vec3& b) noexcept;

}  // namespace hawser
