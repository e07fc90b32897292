// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file triangle_contact.h
/// A convex shape against one triangle of a surface.
///
/// Interior edges. A shape that slides over flat ground must not catch on the edges inside it. A
/// contact normal that leans out over an edge is allowed up to the normal of the neighbour where
/// the edge is convex, not at all where it is flat or concave, and freely at the border. Where it
/// is not allowed, the normal of the triangle takes its place, and only what lies over the
/// triangle along it touches; the neighbour has the rest.

#include "collide/narrow/manifold.h"

namespace hawser::collide::narrow {

struct SurfaceTriangle {
    Convex triangle;
    /// Unit normals across edge k (from corner k to the next) on the side of triangle.face; zero:
    /// border.
    V3 neighbour[3];
    bool solid;          ///< Solid below: pushes up whatever the depth. Else both sides touch.
    std::uint32_t name;  ///< Of the triangle in its surface.
};

/// Adds the points closer than `margin`; normals from the shape to the surface.
void touch_triangle(const Convex& shape, const SurfaceTriangle& surface, double margin,
                    Points& out);

/// Makes room in `points` and reduces them to at most kMaxManifold: points of one normal (within
/// 8 degrees) are one group; each keeps up to four, fewer where there are more than two groups.
/// With `last`, sorted and written out.
void finish_surface(Points& points, const double* origin, double size, Manifold& out);
/// Keep at most four points of each normal, once they are many.
void make_room(Points& points, double size);

}  // namespace hawser::collide::narrow
