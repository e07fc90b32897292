// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file triangle_contact.h
/// A convex shape against one triangle of a surface.
///
/// Interior edges. A shape that slides over flat ground must not catch on interior edges. Let m be
/// a normal out of the surface at an edge or a vertex v. It belongs to a nearest point only if no
/// neighbouring vertex w rises towards it: m · (w − v) ≤ 0. If one does, the normal of the triangle
/// replaces m, and only points over the triangle along its normal touch. The neighbours cover the
/// rest. If a shape overlaps a surface, it has no nearest point; the same rule then applies to the
/// normal of least penetration. A two-sided triangle that a shape does not overlap adds nothing:
/// any point over it lies beyond it.
///
/// A shape may overlap triangles of a surface although none of them accepts a point. Example: its
/// deepest point of each lies over another one. Then it is pushed along the normal of the nearest
/// triangle.

#include "collide/narrow/manifold.h"

namespace hawser::collide::narrow {

/// Maximum number of vertices around a vertex; further ones are ignored.
inline constexpr int kMaxRing = 32;

struct SurfaceTriangle {
    Convex triangle;
    /// Third corner of the neighbour across edge k (from corner k to the next), if there is one.
    V3 opposite[3];
    bool has_neighbour[3];
    bool solid;  ///< True if solid below: pushes up at any depth. Otherwise both sides touch.
    std::uint32_t name;  ///< Name of the triangle in its surface.
    const void* surface;
    int index;
    /// Write the vertices that share an edge with corner k. @return their number.
    int (*ring)(const SurfaceTriangle& triangle, int corner, V3* out);
};

/// Add the points closer than `margin`, with normals from the shape to the surface. @param nearest
/// Deepest point along the normal of the nearest two-sided triangle that the shape has overlapped
/// up to now; gap 0: none.
void touch_triangle(const Convex& shape, const SurfaceTriangle& surface, double margin, Points& out,
                    Point& nearest);

/// Return the deepest point of a shape along the normal n of the triangle. Its gap may be positive.
[[nodiscard]] Point deepest_along_normal(const Convex& shape, const SurfaceTriangle& t,
                                         const V3& n);
/// True if no point is deep.
[[nodiscard]] bool none_overlaps(const Points& points);
/// Return the middle of a shape. For a hull this is the mean of the vertices, because its frame may
/// lie anywhere.
[[nodiscard]] V3 middle_of(const Convex& shape);

/// Return the placement of a shape in the frame of a surface.
[[nodiscard]] Placement view_from(const Placement& shape, const Placement& surface) noexcept;

/// Transform points about `centre` from the frame of the surface to the world, reduce them to at
/// most kMaxManifold, sort and write them. Points with one normal (within 8 degrees) form a group.
/// Each group keeps up to four points, fewer if there are more than two groups. A capsule keeps its
/// ends and the deepest point.
void finish_surface(Points& points, const Placement& surface, const V3& centre, const Convex& shape,
                    Manifold& out);
/// Reduce each group to at most four points if the buffer is nearly full.
void reduce_if_full(Points& points, const Convex& shape);

}  // namespace hawser::collide::narrow
