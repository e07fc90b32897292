// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edges.h
/// Convex edges of boxes, hulls and meshes, and the cylinder that rounds an edge, so that a wire
/// can run over it as over a bollard (post.h).
///
/// ```
///            outward              A cylinder of radius r lies against both faces, as if the edge
///                ↖ ______         were rounded: its axis is r/cos(turn/2) inside of the edge,
///                 ╱              turn the angle between the normals of the faces.
///        face    ╱ (r)
/// ```
/// Collinear pieces of an edge between the same two planes are merged.
///
/// Limits: triangles of a mesh must be counterclockwise seen from outside. Edges with one triangle,
/// or with more than two, are ignored. For a mesh, no check ensures that the cylinder fits into the
/// solid.

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

/// Return the edges whose `turn` exceeds an angle, sorted by x, y, z of their first ends.
/// @param sharper_than  Angle [rad].
/// @throws DefError if the shape is invalid, or not a box, hull or mesh.
[[nodiscard]] std::vector<ShapeEdge> convex_edges(const ShapeDef& shape, double sharper_than);

/// Axis of a cylinder that lies against both faces of an edge.
struct EdgeAxis {
    Vec3 from, to;  ///< End points in the frame of the body [m].
};
/// Return the axis of the cylinder that touches both faces of an edge from inside.
/// @param radius  Radius of the cylinder [m].
[[nodiscard]] EdgeAxis axis_in_edge(const ShapeEdge& edge, double radius) noexcept;

/// Return the larger one of the distances of two points from an edge [m].
[[nodiscard]] double distance_to_edge(const ShapeEdge& edge, const Vec3& a, const Vec3& b) noexcept;

}  // namespace hawser
