// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file triangle_contact.h
/// A convex shape against one triangle of a surface.
///
/// Interior edges. A shape that slides over flat ground must not catch on the edges inside it. A
/// normal m out of the surface at an edge or a vertex is that of a nearest point only if no
/// neighbouring vertex w rises towards it: m · (w − v) ≤ 0. Where one does, the normal of the
/// triangle takes the place of m, and only what lies over the triangle along it touches; the
/// neighbours have the rest. (Shapes that overlap a surface know no nearest point; they follow the
/// same rule with the normal of least penetration.) A triangle with two sides that a shape does
/// not overlap pushes nothing: what lies over it is beyond it, or nowhere.
///
/// What overlaps triangles of a surface and is claimed by none of them, such as a shape whose
/// deepest point of each lies over another one, goes along the normal of the nearest of them.

#include "collide/narrow/manifold.h"

namespace hawser::collide::narrow {

inline constexpr int kMaxRing = 32;  ///< Vertices around a vertex; more are not looked at.

struct SurfaceTriangle {
    Convex triangle;
    /// Third corner of the neighbour across edge k (from corner k to the next), where there is one.
    V3 opposite[3];
    bool has_neighbour[3];
    bool solid;          ///< Solid below: pushes up whatever the depth. Else both sides touch.
    std::uint32_t name;  ///< Of the triangle in its surface.
    const void* surface;
    int index;
    /// Vertices that share an edge with corner k; @return how many.
    int (*ring)(const SurfaceTriangle& triangle, int corner, V3* out);
};

/// Adds the points closer than `margin`; normals from the shape to the surface. `nearest`: of the
/// triangles with two sides that the shape overlaps so far, its deepest point along the normal of
/// the nearest; a gap of 0: none.
void touch_triangle(const Convex& shape, const SurfaceTriangle& surface, double margin, Points& out,
                    Point& nearest);

/// Deepest point of a shape along the triangle's normal n; its gap may be positive.
[[nodiscard]] Point along_face(const Convex& shape, const SurfaceTriangle& t, const V3& n);
/// Whether no point is deep.
[[nodiscard]] bool none_overlaps(const Points& points);
/// Middle of a shape: of a hull, the mean of its vertices, as its frame may lie anywhere.
[[nodiscard]] V3 middle_of(const Convex& shape);

/// A shape's place in the frame of a surface.
[[nodiscard]] Placement seen_from(const Placement& shape, const Placement& surface) noexcept;

/// Points about `centre` in the surface's frame to the world; reduce to at most kMaxManifold, sort
/// and write: points of one normal (within 8 degrees) are one group; each keeps up to four (of a
/// capsule: its ends and the deepest), fewer where there are more than two groups.
void finish_surface(Points& points, const Placement& surface, const V3& centre, const Convex& shape,
                    Manifold& out);
/// Keep at most four points of each group, once they are many.
void make_room(Points& points, const Convex& shape);

}  // namespace hawser::collide::narrow
