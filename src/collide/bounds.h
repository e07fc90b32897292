// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Bounding boxes of shapes.

#include "collide/geometry.h"

namespace hawser::collide {

/// Axis-aligned bounding box of a placed shape [m]. The box of a plane is unbounded (±1e30).
struct Bounds {
    double low[3], high[3];
};
[[nodiscard]] Bounds bounds(const Geometry& shape, const Placement& placed) noexcept;

}  // namespace hawser::collide
