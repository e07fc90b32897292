// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_pairs.h
/// Random convex shapes on surfaces of 18 triangles, judged by the reference in long double.
/// What is right says ground_claims.h.

#include "support/collide/ground_surface.h"
#include "support/collide/random_pairs.h"

namespace hawser::test {

struct GroundScore : Score {
    int own = 0;  ///< Touching ones whose depth a claim gives (1.–3.).
    /// Touching ones whose deepest point is what lies over a triangle, beside its deepest.
    int beside = 0;
    int left = 0;                  ///< Touching ones that no triangle claims (4.).
    int normals = 0;               ///< Compared.
    std::uint64_t wrong_pair = 0;  ///< Seed of a wrong verdict.
    void wrong(std::uint64_t seed) { ++wrong_verdicts, wrong_pair = seed; }
};

GroundScore judge_ground(ShapeKind a, Ground ground, int count, std::uint64_t seed);
/// Those that touch surfaces.
std::vector<ShapeKind> ground_kinds();
std::vector<Ground> grounds();
std::string describe(ShapeKind a, Ground ground, const GroundScore& score);

}  // namespace hawser::test
