// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Boxes around shapes.

#include "collide/geometry.h"

namespace hawser::collide {

/// Axis-aligned box around a placed shape [m]; a plane is unbounded (±1e30).
struct Bounds {
    double low[3], high[3];
};
[[nodiscard]] Bounds bounds(const Geometry& shape, const Placement& placed) noexcept;

}  // namespace hawser::collide
