// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ground_surface.h
/// Random surfaces of 18 triangles, for the collision code and in long double.

#include "support/collide/random_pairs.h"

#include <array>

namespace hawser::test {

enum class Ground {
    heightfield,  ///< 3 × 3 cells of 4 m, heights within ±1 m.
    terrain,      ///< The heightfield as a mesh; some triangles the other way around.
    rock,         ///< A closed mesh, about 8 m wide, with edges bent both ways.
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
    std::vector<std::vector<int>> ring;  ///< Vertices around each.
};

/// Placed anywhere within 5 m.
Surface random_surface(Random& random, Ground kind);
/// Transform a point of the world to the frame, or a direction of the frame to the world.
reference::Vec local(const collide::Placement& p, reference::Vec x);
reference::Vec turned(const collide::Placement& p, const Vec3& v);

}  // namespace hawser::test
