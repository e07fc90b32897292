// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_claims.h
/// Contacts of a convex shape with the triangles of a surface, in long double.
///
/// The reference follows the specification in triangle_contact.h, shapes.h and geometry.h:
/// 1. Apart: the smallest gap is the distance to the nearest triangle, along the normal of the two
///    nearest points.
/// 2. If shape and triangle overlap, or the triangle is not the nearest one, the normal of its
///    signed distance holds if no vertex of the neighbours rises towards it. Else the normal of the
///    triangle replaces it: on a heightfield upwards, on a mesh on the side of the centre of the
///    shape, unless the other side is clearly nearer. Then only the part of the shape over the
///    triangle, along that normal, touches; certainly so if the deepest point lies there. A
///    triangle of a mesh that does not overlap the shape has no contact.
/// 3. A heightfield is solid. A shape below it is pushed up along the normal of the triangle above,
///    among the cells over the box around the shape.
/// 4. A shape that overlaps a surface without a claim of any triangle moves along the normal of the
///    nearest triangle that it cuts (heightfield: or that is above its centre).
///
/// The deepest point of a manifold must be the deepest claim, with one exception. It may be deeper
/// in a triangle of the second kind whose deepest point lies beside it. It is then on the boundary
/// of the shape and on the triangle, along the normal of the triangle. Within 1e-4 of the boundary
/// of two rules either one is allowed.

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
    std::vector<Claim> nearest;  ///< Signed distances, unmodified.
    std::vector<Claim> list;
    std::vector<const Face*> clipped;          ///< Their normal replaces another one.
    bool inside = false;                       ///< Overlaps, or is below a solid.
    reference::Real truth = 1e30L;             ///< Least signed distance to a triangle.
    Claim left{-1e30L, {}, nullptr, 0, true};  ///< Claim of a shape that no triangle claims.
};

/// Compute the claims of a shape. `middle`: its centre; a shape with its centre below a solid
/// surface is inside.
Claims claims_on(const Surface& s, const reference::Body& a, reference::Vec middle,
                 reference::Real margin);
/// Return the distance of p beyond the edges of the triangle, as seen along its normal.
reference::Real beyond_edges(const Face& f, reference::Vec p);

}  // namespace hawser::test
