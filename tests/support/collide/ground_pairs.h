// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_pairs.h
/// Random convex shapes on surfaces of 18 triangles, compared with the reference in long double.
/// The rules are in ground_claims.h.

#include "support/collide/ground_surface.h"
#include "support/collide/random_pairs.h"

namespace hawser::test {

struct GroundScore : Score {
    int own = 0;  ///< Touching pairs with the depth of a claim (rules 1-3).
    /// Touching pairs whose deepest point is over a triangle, beside the shape's deepest point.
    int beside = 0;
    int left = 0;                  ///< Touching pairs without a claim of a triangle (rule 4).
    int normals = 0;               ///< Number of compared normals.
    std::uint64_t wrong_pair = 0;  ///< Seed of a pair with a wrong result.
    void wrong(std::uint64_t seed) { ++wrong_results, wrong_pair = seed; }
};

GroundScore check_ground(ShapeKind a, Ground ground, int count, std::uint64_t seed);
/// Return the kinds that touch surfaces.
std::vector<ShapeKind> ground_kinds();
std::vector<Ground> grounds();
std::string describe(ShapeKind a, Ground ground, const GroundScore& score);

}  // namespace hawser::test
