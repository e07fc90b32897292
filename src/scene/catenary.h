// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file catenary.h
/// Initial shape of a hanging cable: a chain of equal rigid elements at rest.
///
/// Divide a chain into n equal straight elements of length l, its weight lumped at the nodes
/// between them. At rest the horizontal tension H is equal in all elements. The vertical tension
/// grows by the weight w of a node from one element to the next. The slope of element i
/// is therefore t_i = t_0 + i k with k = w/H. Two unknowns (t_0, k) meet two end points:
/// l Σ 1/√(1+t_i²) = horizontal distance, l Σ t_i/√(1+t_i²) = height difference.
/// For n → ∞ this is the catenary of parameter a = l/k, the starting point of Newton's method.
/// Unlike points on the smooth curve, the elements keep their length.

#include <hawser/math.h>

#include <optional>
#include <vector>

namespace hawser::scene {

/// Return the n + 1 nodes from `a` to `b`, hanging along `down`.
/// @return null if there is no such shape: length below the distance, or the end points
///         nearly on one vertical.
[[nodiscard]] std::optional<std::vector<Vec3>> hanging_nodes(const Vec3& a, const Vec3& b,
                                                             double length, int n,
                                                             const Vec3& down);

}  // namespace hawser::scene
