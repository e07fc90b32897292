// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edges.h
/// Convex edges of boxes, hulls and meshes, and the cylinder at an edge that carries a wire
/// (post.h).
///
/// ```
///            outward              A cylinder of radius r lies against both faces, as if the edge
///                ↖ ______         were rounded: its axis is r/cos(turn/2) inside of the edge,
///                 ╱              turn the angle between the normals of the faces.
///        face    ╱ (r)
/// ```
/// Collinear pieces of an edge between the same two planes are merged. Limits: triangles of a mesh
/// are counterclockwise seen from outside. Boundaries, and edges with more than two triangles, are
/// ignored. For a mesh, it is not checked that the cylinder fits into the solid.

#include <hawser/math.h>
#include <hawser/shapes.h>

#include <limits>
#include <vector>

namespace hawser {

/// Convex edge in the frame of the shape's body.
struct ShapeEdge {
    Vec3 from{0, 0, 0}, to{0, 0, 0};  ///< End points [m].
    Vec3 outward{0, 0, 1};            ///< Unit bisector of the normals of both faces.
    double turn = 0.0;                ///< Angle between these normals [rad], > 0 and < π.
    /// Largest radius of a cylinder inside the shape against both faces [m]; infinite for a mesh.
    double most_radius = std::numeric_limits<double>::infinity();
};

/// Return the edges with a turn above an angle [rad], in the order of their first ends along x, y,
/// z. Empty: there are none.
/// @throws DefError if the shape is invalid, or not a box, hull or mesh.
[[nodiscard]] std::vector<ShapeEdge> convex_edges(const ShapeDef& shape, double sharper_than);

/// Axis of a cylinder that lies against both faces of an edge.
struct EdgeAxis {
    Vec3 from, to;  ///< End points in the frame of the body [m].
};
/// Return the axis of the cylinder of a radius [m] that lies against both faces of an edge.
[[nodiscard]] EdgeAxis axis_in_edge(const ShapeEdge& edge, double radius) noexcept;

/// Return the distance to an edge of the farther one of two points [m].
[[nodiscard]] double distance_to_edge(const ShapeEdge& edge, const Vec3& a, const Vec3& b) noexcept;

}  // namespace hawser
