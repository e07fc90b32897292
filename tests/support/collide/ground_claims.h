// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_claims.h
/// Expected contacts of the triangles of a surface with a convex shape, in long double.
///
/// The reference implements the documented rules of triangle_contact.h, shapes.h and geometry.h:
/// 1. Separated: the least gap is the distance to the nearest triangle, along the normal of the two
///    nearest points.
/// 2. If shape and triangle overlap, or the triangle is not the nearest one, the normal of its
///    signed distance is valid if no vertex of the neighbours rises towards it. Otherwise the
///    normal of the triangle replaces it. On a heightfield it points up; on a mesh to the side of
///    the shape's centre, unless the other side is clearly nearer. Then only the part of the shape
///    over the triangle along this normal touches; certainly if the shape's deepest point does. A
///    triangle of a mesh without overlap does not push.
/// 3. A heightfield is solid: a part below it is pushed up along the normal of the triangle above.
///    Only cells over the box around the shape count.
/// 4. A shape that overlaps a surface without a claim of any triangle moves along the normal of the
///    nearest triangle that it cuts (heightfield: or that is above its middle).
/// The deepest point of a manifold must be the deepest claim, or deeper, in a triangle of the
/// second kind whose deepest point lies beside it. Then it is on the boundary of the shape and on
/// the triangle, along the triangle's normal. Within 1e-4 of a bound between rules, either rule is
/// valid.

#include "support/collide/ground_surface.h"

#include <vector>

namespace hawser::test {

inline constexpr reference::Real kBand = 1e-6L;  ///< Results and depths within it are equal [m].

struct Claim {
    reference::Real gap;
    reference::Vec n;  ///< From the shape to the surface.
    const Face* face;
    reference::Real normal_error;
    bool sure;
};

struct Claims {
    std::vector<Claim> nearest;  ///< Signed distances without replaced normals.
    std::vector<Claim> list;
    std::vector<const Face*> clipped;          ///< Triangles whose normal replaces another one.
    bool inside = false;                       ///< Overlaps, or is below a solid.
    reference::Real truth = 1e30L;             ///< Least signed distance to a triangle.
    Claim left{-1e30L, {}, nullptr, 0, true};  ///< Claim of rule 4.
};

/// Compute the claims. `middle`: of the shape; if it is below a solid's surface, the shape is
/// inside.
Claims claims_on(const Surface& s, const reference::Body& a, reference::Vec middle,
                 reference::Real margin);
/// Return how far p is beyond the edges of the triangle, seen along its normal.
reference::Real beyond_edges(const Face& f, reference::Vec p);

}  // namespace hawser::test
