// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_claims.h
/// What the triangles of a surface make of a convex shape, in long double.
///
/// The reference is written from what triangle_contact.h, shapes.h and geometry.h promise:
/// 1. Apart: the least gap is the distance to the nearest triangle, along the normal of the two
///    nearest points.
/// 2. Where shape and triangle overlap, or the triangle is not the nearest one, the normal of its
///    signed distance holds if no vertex of the neighbours rises towards it. Else the normal of
///    the triangle takes its place (on a heightfield: up; on a mesh: the side of the shape's
///    centre, unless the other one is clearly nearer), and only what lies over the triangle along
///    it touches: surely so if the shape's deepest point does. A triangle of a mesh that the shape
///    does not overlap pushes nothing.
/// 3. A heightfield is solid: what is below is pushed up along the normal of the triangle above,
///    of the cells over the box around the shape.
/// 4. What overlaps a surface and is claimed by none of its triangles goes along the normal of the
///    nearest triangle that it cuts (heightfield: or that is above its middle).
/// The deepest point of a manifold must be the deepest claim, or deeper, in a triangle of the
/// second kind whose deepest point lies beside it: then it is on the boundary of the shape and on
/// the triangle, along the triangle's normal. Rules meet within 1e-4: there either one will do.

#include "support/collide/ground_surface.h"

#include <vector>

namespace hawser::test {

inline constexpr reference::Real kBand = 1e-6L;  ///< Verdicts and depths within it are equal [m].

struct Claim {
    reference::Real gap;
    reference::Vec n;  ///< From the shape to the surface.
    const Face* face;
    reference::Real normal_error;
    bool sure;
};

struct Claims {
    std::vector<Claim> nearest;  ///< Signed distances, as they are.
    std::vector<Claim> list;
    std::vector<const Face*> clipped;          ///< Whose normal takes the place of another.
    bool inside = false;                       ///< Overlaps, or is below a solid.
    reference::Real truth = 1e30L;             ///< Least signed distance to a triangle.
    Claim left{-1e30L, {}, nullptr, 0, true};  ///< Of what no triangle claims.
};

/// `middle`: of the shape; what has it below a solid's surface is inside.
Claims claims_on(const Surface& s, const reference::Body& a, reference::Vec middle,
                 reference::Real margin);
/// How far p is beyond the edges of the triangle, seen along its normal.
reference::Real beyond_edges(const Face& f, reference::Vec p);

}  // namespace hawser::test
