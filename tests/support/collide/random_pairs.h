// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_pairs.h
/// Random shapes near each other, compared with the reference; shared by the quick and the long
/// test.

#include "collide/geometry.h"
#include "collide/narrow/shape_data.h"
#include "support/collide/reference.h"
#include "support/random.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {

collide::Placement random_placement(Random& random, double reach);
/// A shape with its data, and data for the reference (in the shape's frame).
struct RandomShape {
    collide::Geometry geometry;
    std::shared_ptr<collide::ShapeData> data;
    std::vector<Vec3> points, faces, edges;
};
/// Make a hull of random points, or a mesh of one triangle.
RandomShape random_shape(Random& random, ShapeKind kind);
reference::Body body_of(const RandomShape& shape, const collide::Placement& placed);

struct Score {
    int pairs = 0, touching = 0, separated = 0, ambiguous = 0;
    int wrong_results = 0;                        ///< Wrong results outside a band of 1e-6 m.
    double worst_gap = 0.0, worst_normal = 0.0;   ///< [m], [-].
    std::uint64_t gap_pair = 0, normal_pair = 0;  ///< Seeds of the worst pairs.
    int bad_points = 0;  ///< Not finite, unsorted, not unit length, beyond the margin, or off the
                         ///< surface.
};

/// True if finite, unit length, sorted, closer than the margin, and (on[1] − on[0]) · normal = gap.
bool well_formed(const collide::Manifold& m, double margin);

/// Distribution of pairs.
enum class Draw {
    random,
    aligned,  ///< Rotated by multiples of 45°, sizes and positions on a grid: parallel, touching,
              ///< equal.
    extreme,  ///< Sizes from 1 mm to 100 m.
};

/// Compare `count` pairs from `seed` on.
Score compare_pairs(ShapeKind a, ShapeKind b, int count, std::uint64_t seed,
                    Draw draw = Draw::random);
/// Return pairs of kinds with exact requirements: those in closed form, and cylinders.
std::vector<std::pair<ShapeKind, ShapeKind>> exact_pairs();
/// Return hulls and single triangles with all kinds that touch them.
std::vector<std::pair<ShapeKind, ShapeKind>> vertex_pairs();
std::string kind_name(ShapeKind kind);
std::string describe(ShapeKind a, ShapeKind b, const Score& score);

}  // namespace hawser::test
