// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solids.h
/// Triangles of the bodies of a recording: boxes and outlines of shapes.

#include <hawser/recording.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::record {

/// A closed surface of triangles, counter-clockwise from outside.
struct Triangles {
    std::vector<Vec3> points;  ///< Corners [m].
    std::vector<std::array<std::uint32_t, 3>> corners;
    [[nodiscard]] bool empty() const noexcept { return corners.empty(); }
};

/// Compute the surface of the convex hull of points by the beneath-beyond method. A tetrahedron
/// grows point by point. The faces visible from a new point are replaced by faces from the point to
/// the border of the visible region. Source: F. P. Preparata and M. I. Shamos, *Computational
/// Geometry*, 1985, 3.4.2.
/// @return an empty surface if the points lie in a plane, to 1e-9 of their extent. Points that lie
/// in faces are omitted.
[[nodiscard]] Triangles convex_surface(std::span<const Vec3> points);

/// Return the surface of a box about the origin.
[[nodiscard]] Triangles box_surface(const Vec3& half_size);

/// Return the surface of an outline of the kind "solid", in the frame of its body. Balls about its
/// points become polyhedra of 42 corners, or of 6 if there are many. @return an empty surface if
/// the outline is flat.
[[nodiscard]] Triangles outline_surface(const RecordedOutline& outline);

/// Return the surfaces of a body in its frame: its solid outlines, else the box of its half size,
/// else none. Nodes of wires have none.
[[nodiscard]] std::vector<Triangles> body_surfaces(const Recording& recording, std::size_t body);

}  // namespace hawser::record
