// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_surface.h
/// Random surfaces of 18 triangles, for the collision code and in long double.

#include "support/collide/random_pairs.h"

#include <array>

namespace hawser::test {

enum class Ground {
    heightfield,  ///< 3 × 3 cells of 4 m, heights within ±1 m.
    terrain,      ///< The heightfield as a mesh; some triangles have the opposite orientation.
    rock,         ///< A closed mesh, about 8 m wide, with convex and concave edges.
};

struct Face {
    std::array<int, 3> vertex;
    std::array<int, 3> beyond;  ///< Third vertex of the neighbour across edge k; −1: none.
    reference::Body body;
    reference::Vec corner[3], normal;  ///< In the world; the normal points up.
};

struct Surface {
    ShapeDef def;
    bool solid = false;
    collide::Placement placed{};
    std::shared_ptr<const collide::ShapeData> data;
    std::vector<Vec3> vertices;  ///< In the surface's frame.
    std::vector<Face> faces;
    std::vector<reference::Vec> world;   ///< Vertices in the world.
    std::vector<std::vector<int>> ring;  ///< Neighbouring vertices of each.
};

/// Make a surface at a random position within 5 m.
Surface random_surface(Random& random, Ground kind);
/// Transform a position from the world to the frame, or a direction from the frame to the world.
reference::Vec local(const collide::Placement& p, reference::Vec x);
reference::Vec turned(const collide::Placement& p, const Vec3& v);

}  // namespace hawser::test
