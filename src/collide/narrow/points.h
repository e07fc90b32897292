// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file points.h
/// Buffer of contact points of two convex shapes.

#include "collide/narrow/convex.h"

#include <cstdint>

namespace hawser::collide::narrow {

struct Point {
    V3 on0, on1, normal;
    double gap;
    std::uint32_t feature;
};

inline constexpr int kMaxPoints = 64;
struct Points {
    int count = 0;
    Point p[kMaxPoints];
    void add(const Point& point) {
        if (count < kMaxPoints) p[count++] = point;
    }
};

/// Return a number that identifies a contact between feature i of one shape and feature j of the
/// other. Kinds: 0 vertex of shape 0, 1 vertex of shape 1, 2 edge and edge, 3 the deepest point.
inline std::uint32_t feature(unsigned kind, unsigned i, unsigned j) {
    return (kind & 3U) << 30 | (i & 0x7fffU) << 15 | (j & 0x7fffU);
}

}  // namespace hawser::collide::narrow
