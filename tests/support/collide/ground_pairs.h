// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_pairs.h
/// Random convex shapes on surfaces of 18 triangles, judged by the reference in long double.
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
#include "support/collide/random_pairs.h"

namespace hawser::test {

struct GroundScore : Score {
    int own = 0;      ///< Touching ones whose depth a claim gives (1.–3.).
    int beside = 0;   ///< … whose deepest point is what lies over a triangle, beside its deepest.
    int left = 0;     ///< … that no triangle claims (4.).
    int normals = 0;  ///< Compared.
    std::uint64_t wrong_pair = 0;  ///< Seed of a wrong verdict.
    void wrong(std::uint64_t seed) { ++wrong_verdicts, wrong_pair = seed; }
};

GroundScore judge_ground(ShapeKind a, Ground ground, int count, std::uint64_t seed);
/// Those that touch surfaces.
std::vector<ShapeKind> ground_kinds();
std::vector<Ground> grounds();
std::string describe(ShapeKind a, Ground ground, const GroundScore& score);

}  // namespace hawser::test
