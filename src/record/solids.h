// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solids.h
/// Triangles of what a recording shows of bodies: boxes and outlines of shapes.

#include <hawser/recording.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::record {

/// A closed surface of triangles, counter-clockwise from outside.
struct Triangles {
    std::vector<Vec3> points;  ///< [m]
    std::vector<std::array<std::uint32_t, 3>> corners;
    [[nodiscard]] bool empty() const noexcept { return corners.empty(); }
};

/// Surface of the smallest convex solid around points: a tetrahedron that grows point by point, the
/// faces that a point sees being replaced by those to their rim (the beneath-beyond method: F. P.
/// Preparata and M. I. Shamos, *Computational Geometry*, 1985, 3.4.2). @return nothing where the
/// points lie in a plane, to 1e-9 of their extent. Points that lie in faces are left out.
[[nodiscard]] Triangles convex_surface(std::span<const Vec3> points);

/// Of a box about the origin.
[[nodiscard]] Triangles box_surface(const Vec3& half_size);

/// Of an outline of kind solid, in its body's frame; balls about its points become polyhedra of 42
/// corners, of 6 where there are many. @return nothing where it is flat.
[[nodiscard]] Triangles outline_surface(const RecordedOutline& outline);

/// What a body looks like, in its frame: its solid outlines, else the box of its half size; nothing
/// where it has neither. Lumps of wires have none.
[[nodiscard]] std::vector<Triangles> body_surfaces(const Recording& recording, std::size_t body);

}  // namespace hawser::record
