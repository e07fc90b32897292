// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file geometry.h
/// Shapes as input of collision functions, placed in the world, and the manifold of two.

#include <hawser/shapes.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::collide {

struct ShapeData;  ///< Vertices, faces and heights of a hull, mesh or heightfield; immutable.

/// Size of a shape: numbers, and data shared by all copies of it.
struct Geometry {
    ShapeKind kind = ShapeKind::sphere;
    double radius = 0.0;
    double half_length = 0.0;
    double half_size[3] = {0.0, 0.0, 0.0};
    const ShapeData* data = nullptr;  ///< Data of a hull, mesh or heightfield.
};

/// Frame of a shape in the world.
struct Placement {
    double x[3];  ///< Origin [m].
    double r[9];  ///< Rotation matrix from shape to world, row-major.
};

/// One contact point of a manifold.
struct ManifoldPoint {
    double on[2][3];        ///< Points on the surfaces of shape 0 and shape 1, world frame [m].
    double normal[3];       ///< Unit normal from shape 0 to shape 1, world frame.
    double gap;             ///< Gap (on[1] − on[0]) · normal [m]; negative: penetration.
    std::uint32_t feature;  ///< Name of the pair of features in contact; stable from step to step.
};

inline constexpr int kMaxManifold = 8;

struct Manifold {
    int count = 0;
    ManifoldPoint point[kMaxManifold];
};

/// Compute the points at which two shapes are closer than `margin` [m, > 0], in the order of
/// `feature`. There are enough points for friction to support a resting shape (a lying capsule:
/// two, a box on a face: four). One of them has the smallest gap of the two shapes, along the
/// normal of their distance. Two shapes that cannot touch (plane and plane, two without degrees of
/// freedom) have none.
using Collide = void (*)(const Geometry& a, const Placement& pa, const Geometry& b,
                         const Placement& pb, double margin, Manifold& out);

}  // namespace hawser::collide
