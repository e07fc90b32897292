// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file collide_function.h
/// Selection of the collision function of two kinds of shapes.

#include "collide/geometry.h"

namespace hawser::collide {

/// Return the function for two kinds in any order.
[[nodiscard]] Collide collide_function(ShapeKind a, ShapeKind b) noexcept;

}  // namespace hawser::collide
