// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file collide_function.h
/// Which function makes the manifold of two kinds of shapes.

#include "collide/geometry.h"

namespace hawser::collide {

/// The function for two kinds; the kinds may come in any order.
[[nodiscard]] Collide collide_function(ShapeKind a, ShapeKind b) noexcept;

}  // namespace hawser::collide
