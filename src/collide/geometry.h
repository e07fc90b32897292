// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file geometry.h
/// Shapes as collision code sees them, placed in the world, and the manifold of two.

#include <hawser/shapes.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::collide {

struct ShapeData;  ///< Vertices, faces, heights of a hull, mesh or heightfield; never changes.

/// Size of a shape: plain numbers, and data shared by all copies of it.
struct Geometry {
    ShapeKind kind = ShapeKind::sphere;
    double radius = 0.0;
    double half_length = 0.0;
    double half_size[3] = {0.0, 0.0, 0.0};
    const ShapeData* data = nullptr;  ///< Of hull, mesh, heightfield.
};

/// Frame of a shape in the world.
struct Placement {
    double x[3];  ///< Origin [m].
    double r[9];  ///< Rotation matrix shape to world, row-major.
};

/// One contact point of a manifold.
struct ManifoldPoint {
    double on[2][3];        ///< On the surface of shape 0 and of shape 1, world frame [m].
    double normal[3];       ///< Unit, from shape 0 to shape 1, world frame.
    double gap;             ///< (on[1] − on[0]) · normal [m]; negative: penetration.
    std::uint32_t feature;  ///< Names the pair of features that meet; stable from step to step.
};

inline constexpr int kMaxManifold = 8;

struct Manifold {
    int count = 0;
    ManifoldPoint point[kMaxManifold];
};

/// Points at which two shapes are closer than `margin` [m, > 0]: enough of them for friction to
/// hold what lies there (a lying capsule: two, a box on a face: four), in the order of `feature`.
/// One of them has the smallest gap of the two shapes, along the normal of their distance.
/// Two shapes that cannot touch (plane and plane, two without freedom) give none.
using Collide = void (*)(const Geometry& a, const Placement& pa, const Geometry& b,
                         const Placement& pb, double margin, Manifold& out);

}  // namespace hawser::collide
